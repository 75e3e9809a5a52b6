// Events of axes: what has happened since the host cleared the bits of the status word. Source: GT
// manual 4.5.1. Tested by tests/gtcalls/gt400/stop_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"

namespace oncard::gtcalls::gt400 {

/// Bits 0 to 7 of the status word: they stay until they are cleared.
enum EventBit : uint8_t {
  kCompleteBit = 1u << 0,    ///< a motion has ended
  kAlarmEventBit = 1u << 1,  ///< the alarm input has become active
  kBreakpointBit = 1u << 2,
  kCapturedBit = 1u << 3,
  kMotionErrorBit = 1u << 4,  ///< the position error has exceeded its limit
  kPositiveLimitEventBit = 1u << 5,
  kNegativeLimitEventBit = 1u << 6,
  kRefusedBit = 1u << 7,  ///< a command has been refused
};

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
