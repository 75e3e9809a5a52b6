// The part of the family in a cycle of the card (Family::after_tick). Tested by
// tests/gtcalls/gt400/stop_test.cc, update_command_test.cc and breakpoint_command_test.cc.
#pragma once

#include <cstdint>

#include "gtcalls/card.h"

namespace oncard::gtcalls::gt400 {

void AfterTick(Card& card);
/// Family::cycles_before_act.
int64_t CyclesBeforeAct(const CardView& card);

}  // namespace oncard::gtcalls::gt400
