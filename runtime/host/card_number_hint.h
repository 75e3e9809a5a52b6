// A host that was compiled with the vendor's gts.h for several cards, `GT_AxisOn(card, axis)`,
// links the functions of one card, which have the same names: nothing stops the linker. What can be
// seen at run time is said on standard error, once: a card's number where an axis or a pointer
// belongs, or a second GT_Open for another card. A host that never does so cannot be told from one
// of one card. Thread-safe. Tested by tests/tools/exec_command_test.cc.
#pragma once

#include <cstdint>
#include <span>

#include "gtcalls/catalogue.h"
#include "runtime/host/host_api.h"

namespace oncard::runtime {

/// To be called with the outcome of a call through an entry point of one card.
void HintAtCardNumber(const gtcalls::Command& command, std::span<const HostArgument> host,
                      int16_t code);

}  // namespace oncard::runtime
