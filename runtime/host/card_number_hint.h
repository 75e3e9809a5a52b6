// Detects a host that was compiled with the vendor's multi-card header, `GT_AxisOn(card, axis)`,
// but linked with the single-card functions, which have the same names, so that the linker cannot
// notice. Symptoms at run time are reported once on standard error: a card number in place of an
// axis or a pointer, or a second opening for another card. A host without such calls cannot be
// distinguished from a single-card host. For libraries with functions of both kinds, whose opening
// has two parameters. Thread-safe. Tested by tests/tools/exec_command_test.cc.
#pragma once

#include <cstdint>
#include <span>

#include "gtcalls/catalogue.h"
#include "runtime/host/host_api.h"

namespace oncard::runtime {

/// HostLibrary::notice_result.
void HintAtCardNumber(const gtcalls::Command& command, std::span<const HostArgument> host,
                      int16_t code);

}  // namespace oncard::runtime
