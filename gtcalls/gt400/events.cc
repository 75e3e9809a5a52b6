#include "gtcalls/gt400/events.h"

#include "gtcalls/gt400/axis_state.h"
#include "gtcalls/gt400/stops.h"

namespace oncard::gtcalls::gt400 {

uint8_t EventsOf(const CardView& card, size_t axis) {
  const Gt400Axis& state = AxisState(card, axis);
  return static_cast<uint8_t>(state.events | NewLimits(card, axis));
}

void SetEvents(Card& card, size_t axis, uint8_t events) {
  Gt400Axis& state = AxisState(card, axis);
  state.events = static_cast<uint8_t>(state.events | events);
  state.new_events = static_cast<uint8_t>(state.new_events | events);
}

void ClearEvents(Card& card, size_t axis, uint32_t kept) {
  NoticeLimits(card, axis);
  Gt400Axis& state = AxisState(card, axis);
  state.events = static_cast<uint8_t>(state.events & kept);
  ForbidDirections(card, axis);
}

bool Moves(const CardView& card, size_t axis) {
  const motion::Profile& profile = card.motion.profile(axis);
  return profile.now.moving && !profile.gear.direct.held;
}

void NoticeMotion(Card& card, size_t axis) {
  const motion::Profile& profile = card.motion.profile(axis);
  Gt400Axis& state = AxisState(card, axis);
  const bool ended = state.moved && !profile.now.moving;
  state.moved = profile.now.moving;
  if (ended && profile.mode != motion::ProfileMode::kGear) SetEvents(card, axis, kCompleteBit);
}

void NoticeCommand(Card& card) {
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    NoticeLimits(card, axis);
    ForbidDirections(card, axis);
    AxisState(card, axis).moved = card.motion.profile(axis).now.moving;
  }
}

}  // namespace oncard::gtcalls::gt400
