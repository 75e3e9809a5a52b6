// Decides whether an object may run. After it has accepted an object, execution needs no checks
// beyond variable indices, division, and the commands' own ranges.
#pragma once

#include <cstdint>

#include "base/result.h"
#include "vm/command_table.h"
#include "vm/object.h"

namespace oncard::vm {

/// Whether the object declares its variables. A download by words (GT_LoadPlc) carries records
/// only: then types are taken from the records, and every slot of a page or of the globals may be
/// used.
enum class Symbols : uint8_t { kRequired, kAbsent };

/// Checks symbols, sizes, ids, operators, operand types, storage bounds, jump targets, and commands
/// with their argument shapes. Code 2008 with the place (function, instruction, source line) and
/// the reason; 7 for more than 32 functions. With Symbols::kAbsent names, lines and symbol tables
/// are not checked.
Result<void> Verify(const Object& object, const CommandTable& commands,
                    Symbols symbols = Symbols::kRequired);

/// How many slots belong to the variable from the given slot on: the rest of an array or of a
/// structure, 1 for a scalar, 0 for a slot that is not declared. If nothing is declared
/// (Symbols::kAbsent), the last slot of the storage is the limit. `function` must be one of
/// `object`, and the symbols must be ones that Verify() accepts.
uint16_t StorageExtent(const Object& object, const Function& function, const Variable& variable);

}  // namespace oncard::vm
