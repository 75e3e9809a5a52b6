#include "gtcalls/gt400/events.h"

namespace oncard::gtcalls::gt400 {
namespace {

struct ConditionEvent {
  motion::AxisCondition condition;
  EventBit event;
  /// True if the event occurs when the condition begins, and not as long as it lasts.
  bool begins;
};

constexpr ConditionEvent kConditionEvents[] = {
    {motion::kAlarmBit, kAlarmEventBit, false},
    {motion::kFollowingErrorBit, kMotionErrorBit, false},
    {motion::kPositiveLimitBit, kPositiveLimitEventBit, true},
    {motion::kNegativeLimitBit, kNegativeLimitEventBit, true},
};

uint32_t LatchedBy(const motion::MotionCore& core, size_t axis) {
  return core.part<&motion::MotionState::axes, &motion::Axis::latched>(axis);
}

/// The events that this family keeps itself.
constexpr uint32_t kOwnEvents = 0xFF & ~uint32_t{kCapturedBit};

/// The conditions without whose events the motion core need not know them.
uint32_t ConditionsWithout(uint32_t events) {
  uint32_t conditions = 0;
  for (const ConditionEvent& row : kConditionEvents) {
    if ((events & row.event) == 0) conditions |= row.condition;
  }
  return conditions;
}

}  // namespace

uint8_t EventsOf(const CardView& card, size_t axis) {
  const Gt400Axis& state = card.state<Gt400State>().axes[axis];
  const uint32_t latched = LatchedBy(card.motion, axis);
  uint32_t events = state.events;
  for (const ConditionEvent& row : kConditionEvents) {
    const uint32_t counts = row.begins ? latched & ~state.noticed : latched;
    if ((counts & row.condition) != 0) events |= row.event;
  }
  if (card.motion.part<&motion::MotionState::capture>().capture(axis).captured) {
    events |= kCapturedBit;
  }
  return static_cast<uint8_t>(events);
}

void ClearEvents(Card& card, size_t axis, uint32_t kept) {
  Gt400Axis& state = card.state<Gt400State>().axes[axis];
  state.events = static_cast<uint8_t>(EventsOf(card.view(), axis) & kept & kOwnEvents);
  if (LatchedBy(card.motion, axis) != 0) {
    card.motion.AxisAt(axis).ClearConditions(ConditionsWithout(state.events));
  }
  state.noticed = LatchedBy(card.motion, axis);
  if ((kept & kCapturedBit) == 0) card.motion.capture().Clear(axis);
}

void NoticeEvents(Card& card) {
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    Gt400Axis& state = card.state<Gt400State>().axes[axis];
    if ((LatchedBy(card.motion, axis) | state.noticed) != 0) {
      state.events = static_cast<uint8_t>(EventsOf(card.view(), axis) & kOwnEvents);
      // A limit that the host has cleared is one only as long as its switch is active.
      card.motion.AxisAt(axis).ClearConditions(ConditionsWithout(state.events));
      state.noticed = LatchedBy(card.motion, axis);
    }
    NoticeMotion(card, axis);
  }
}

bool Moves(const CardView& card, size_t axis) {
  const motion::Profile& profile = card.motion.profile(axis);
  return profile.now.moving && !profile.gear.direct.held;
}

void NoticeMotion(Card& card, size_t axis) {
  Gt400Axis& state = card.state<Gt400State>().axes[axis];
  const motion::Profile& profile = card.motion.profile(axis);
  const bool ended = state.moved && !profile.now.moving;
  state.moved = profile.now.moving;
  if (ended && profile.mode != motion::ProfileMode::kGear) state.events |= kCompleteBit;
}

}  // namespace oncard::gtcalls::gt400
