#include "gtcalls/gt400/homing.h"

#include <cmath>

#include "gtcalls/gt400/axis_state.h"
#include "gtcalls/gt400/drives.h"
#include "gtcalls/gt400/events.h"

namespace oncard::gtcalls::gt400 {
namespace {

/// Assumption: with the valid velocity and acceleration, as a motion of mode T; without them, or
/// with the drive off, nothing moves.
void Begin(Card& card, size_t axis, int32_t bound) {
  Gt400Axis& state = AxisState(card, axis);
  const double velocity = std::fabs(state.valid.velocity);
  const double acceleration = state.valid.acceleration;
  if (velocity < motion::kRateMin || acceleration < motion::kRateMin || !CanPlan(card, axis))
    return;
  motion::HomingSequence homing = card.motion.HomingAt(axis);
  homing.BeginWithin(bound, velocity, acceleration, state.homes_to_index);
  state.moved = card.motion.profile(axis).now.moving;
  if (state.moved) return;
  homing.Abandon();
  SetEvents(card, axis, kCompleteBit);
}

}  // namespace

void TakeHoming(Card& card, size_t axis, int32_t bound) {
  card.motion.ProfileAt(axis).SelectMode(motion::ProfileMode::kTrap);
  AxisState(card, axis).taken_homing.Emplace({bound});
}

void BeginTakenHomings(Card& card) {
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    auto& taken = AxisState(card, axis).taken_homing;
    if (!taken) continue;
    Begin(card, axis, taken->bound);
    taken.Reset();
  }
}

}  // namespace oncard::gtcalls::gt400
