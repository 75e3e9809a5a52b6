// What the interrupt unit of a GT400 card does: at the end of a tick it requests an interrupt,
// unless one is in service. A handler of the host ends the service; a driver of the host ends it at
// once. Source: GT manual chapter 8. Tested by tests/gtcalls/gt400/interrupt_command_test.cc.
#pragma once

#include <cstdint>

#include "gtcalls/card.h"
#include "gtcalls/gt400/interrupt_unit.h"

namespace oncard::gtcalls::gt400 {

/// Requests the interrupt of this tick, if there is one, and does what a driver does with it.
void RequestInterrupt(Card& card);
/// Family::cycles_before_interrupt.
int64_t CyclesBeforeInterrupt(const CardView& card);

/// To be called before the host answers interrupts in another way. A request that nobody has
/// answered is made anew.
void ChangeAnswers(InterruptUnit* unit);

}  // namespace oncard::gtcalls::gt400
