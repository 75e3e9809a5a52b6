// Events of axes: what has happened since the host cleared the bits of the status word. Source: GT
// manual 4.5.1. Tested by tests/gtcalls/gt400/axis_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "gtcalls/gt400/status_word.h"

namespace oncard::gtcalls::gt400 {

/// Bits 0 to 7 of the status word now.
uint8_t EventsOf(const CardView& card, size_t axis);
/// Forgets the events whose bits are not kept. What causes an alarm or a motion error sets them
/// again at the next tick; what causes a limit must occur anew.
void ClearEvents(Card& card, size_t axis, uint32_t kept);
/// Notices what happened in a tick.
void NoticeEvents(Card& card);

/// True if the axis moves, as bit 10 says it: a slave that a limit holds does not.
bool Moves(const CardView& card, size_t axis);
/// To be called when a motion may have begun or ended: the end is an event, but not of a gear
/// slave.
void NoticeMotion(Card& card, size_t axis);

}  // namespace oncard::gtcalls::gt400
