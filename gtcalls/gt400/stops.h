// What stops axes by itself: limit switches, alarms, motion errors, the probe; and what that means
// for gears. The motion core stops an axis at a limit and after an alarm in the tick in which the
// input becomes active; here are the events that follow, and which directions stay forbidden.
// Source: GT manual 4.1.4.3, chapters 7 and 9. Tested by tests/gtcalls/gt400/stop_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"

namespace oncard::gtcalls::gt400 {

/// The events of limit switches that are active and have not been noticed yet.
uint8_t NewLimits(const CardView& card, size_t axis);
void NoticeLimits(Card& card, size_t axis);
/// An axis may not move towards a limit whose switch is active or whose event the host has not
/// cleared, as long as its limits are watched. To be called when one of these may have changed.
void ForbidDirections(Card& card, size_t axis);
/// True if a limit forbids an axis at rest to begin a motion in a direction, given by its sign:
/// one of its own, or one of a slave that it would lead there. The motion has ended then, and the
/// limit is an event again.
bool RefuseAtLimit(Card& card, size_t axis, double direction);

/// In the tick: what was captured, and what has stopped axes.
void NoticeStops(Card& card);
/// In the tick, after all stops: the ends of motions, and which directions are forbidden from now
/// on.
void NoticeEnds(Card& card);
/// GT_AbptStp of one axis.
void StopAbruptly(Card& card, size_t axis);

}  // namespace oncard::gtcalls::gt400
