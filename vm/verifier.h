// Decides whether an object may run. After it has accepted an object, execution needs no checks
// beyond variable indices, division, and the commands' own ranges.
#pragma once

#include "base/result.h"
#include "vm/command_table.h"
#include "vm/object.h"

namespace oncard::vm {

/// Checks sizes, ids, operators, operand types, storage bounds, jump targets, and commands with
/// their argument shapes. Code 2008 with the place (function, record, source line) and the reason;
/// 7 for more than 32 functions.
Result<void> Verify(const Object& object, const CommandTable& commands);

}  // namespace oncard::vm
