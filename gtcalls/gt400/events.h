// Events of axes: what has happened since the host cleared the bits of the status word. Source: GT
// manual 4.5.1. Tested by tests/gtcalls/gt400/stop_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "gtcalls/gt400/gt400_state.h"
#include "gtcalls/gt400/status_word.h"

namespace oncard::gtcalls::gt400 {

/// What the family keeps of an axis.
inline Gt400Axis& AxisState(Card& card, size_t axis) { return card.state<Gt400State>().axes[axis]; }

/// Bits 0 to 7 of the status word now. A limit switch that has become active counts before the next
/// tick notices it.
uint8_t EventsOf(const CardView& card, size_t axis);
/// Something happened.
void SetEvents(Card& card, size_t axis, uint8_t events);
/// Forgets the events whose bits are not kept. What causes an alarm or a motion error sets them
/// again at the next tick; what causes a limit must occur anew.
void ClearEvents(Card& card, size_t axis, uint32_t kept);

/// True if the axis moves, as bit 10 says it: a slave that a limit holds does not.
bool Moves(const CardView& card, size_t axis);
/// To be called when a motion may have ended: the end is an event, but not of a gear slave.
void NoticeMotion(Card& card, size_t axis);
/// What a command has changed is no event, but that a limit switch is active now (GT_LmtSns,
/// GT_LmtsOn).
void NoticeCommand(Card& card);

}  // namespace oncard::gtcalls::gt400
