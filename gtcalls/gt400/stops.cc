#include "gtcalls/gt400/stops.h"

#include <optional>

#include "gtcalls/gt400/axis_state.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/gears.h"
#include "gtcalls/gt400/gt400_state.h"

namespace oncard::gtcalls::gt400 {
namespace {

constexpr uint32_t kLimitConditions = motion::kPositiveLimitBit | motion::kNegativeLimitBit;

struct Limit {
  motion::AxisCondition condition;
  EventBit event;
};
constexpr Limit kPositiveLimit = {motion::kPositiveLimitBit, kPositiveLimitEventBit};
constexpr Limit kNegativeLimit = {motion::kNegativeLimitBit, kNegativeLimitEventBit};

void ForEachAxis(Card& card, void (*act)(Card&, size_t)) {
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) act(card, axis);
}

uint32_t CausesOf(const CardView& card, size_t axis) {
  return card.motion.readings().ActiveCauses(card.motion.axis(axis));
}

uint32_t LatchedBy(const CardView& card, size_t axis) {
  return card.motion.part<&motion::MotionState::axes, &motion::Axis::latched>(axis);
}

/// From now on the present causes of these conditions are not new.
void Notice(Card& card, size_t axis, uint32_t conditions) {
  uint32_t& noticed = AxisState(card, axis).noticed;
  noticed = (noticed & ~conditions) | (CausesOf(card.view(), axis) & conditions);
}

/// The limits in a set of conditions, as events.
uint8_t EventsOfLimits(uint32_t conditions) {
  uint32_t events = 0;
  for (const Limit& limit : {kPositiveLimit, kNegativeLimit}) {
    if ((conditions & limit.condition) != 0) events |= limit.event;
  }
  return static_cast<uint8_t>(events);
}

/// The limit that forbids a direction, as an event; 0: none does.
uint8_t LimitAgainst(const CardView& card, size_t axis, double direction) {
  const uint32_t latched = LatchedBy(card, axis);
  if (direction > 0) return EventsOfLimits(latched & motion::kPositiveLimitBit);
  if (direction < 0) return EventsOfLimits(latched & motion::kNegativeLimitBit);
  return 0;
}

/// An axis that may not move towards one of its limits, which is an event.
struct HeldAxis {
  size_t axis;
  uint8_t limit;
};

/// The axis that would be held if this one moved in a direction: itself, or one that it leads.
/// `links`: how many gears are between it and the one that the search began with.
std::optional<HeldAxis> FindHeld(const CardView& card, size_t axis, double direction,
                                 int links = 0) {
  if (const uint8_t limit = LimitAgainst(card, axis, direction)) return HeldAxis{axis, limit};
  // Gears can form a ring.
  for (size_t slave = 0; slave < card.motion.axis_count() && links < kAxisMax; ++slave) {
    if (!IsEngaged(card, slave) || MasterAxis(card, slave) != axis) continue;
    const double ratio = card.motion.profile(slave).gear.direct.value;
    if (const auto held = FindHeld(card, slave, direction * ratio, links + 1)) return held;
  }
  return std::nullopt;
}

/// The direction, as a sign, in which the plan of an axis leads from where it is.
double PlannedDirection(const motion::Profile& profile) {
  switch (profile.mode) {
    case motion::ProfileMode::kTrap:
      return profile.trap.target - profile.now.position;
    case motion::ProfileMode::kSCurve:
      return profile.s_curve.target - profile.now.position;
    case motion::ProfileMode::kJog:
      return profile.jog.velocity;
    default:
      return 0;
  }
}

/// An axis that was in motion rests: if a limit has stopped it, that is an event.
void NoticeLimitStop(Card& card, size_t axis) {
  const motion::Profile& profile = card.motion.profile(axis);
  if (!AxisState(card, axis).moved || profile.now.moving) return;
  const double velocity = card.motion.axis(axis).profile.velocity;
  const double direction = velocity != 0 ? velocity : PlannedDirection(profile);
  if (const uint8_t limit = LimitAgainst(card.view(), axis, direction))
    SetEvents(card, axis, limit);
}

/// The way of a master towards the limit of its slave is an event of the slave, and ends.
void NoticeHeldSlaves(Card& card) {
  uint32_t led = 0;
  for (size_t slave = 0; slave < card.motion.axis_count(); ++slave) {
    const motion::GearMode& gear = card.motion.profile(slave).gear;
    if (!gear.direct.held) continue;
    const double direction = gear.direct.value * card.motion.ReadMaster(gear.master).velocity;
    const uint8_t limit = LimitAgainst(card.view(), slave, direction);
    if (limit == 0) continue;
    SetEvents(card, slave, limit);
    led |= 1u << slave;
  }
  motion::ForEachBit(led, card.motion.axis_count(), [&](size_t slave) { StopMaster(card, slave); });
}

/// Ends the motion of an axis whose drive is off or has a fault, and that of its master.
void EndAbnormally(Card& card, size_t axis) {
  const bool led =
      AxisState(card, axis).moved && card.motion.profile(axis).mode == motion::ProfileMode::kGear;
  card.motion.AxisAt(axis).ServoOff();
  SetEvents(card, axis, kCompleteBit);
  if (led) StopMaster(card, axis);
}

/// The motion core has switched the drive off already.
void NoticeAlarm(Card& card, size_t axis) {
  const bool alarm = (CausesOf(card.view(), axis) & motion::kAlarmBit) != 0;
  const bool begins = alarm && (AxisState(card, axis).noticed & motion::kAlarmBit) == 0;
  if (alarm) SetEvents(card, axis, kAlarmEventBit);
  if (begins) EndAbnormally(card, axis);
  Notice(card, axis, motion::kAlarmBit);
}

void JudgePositionError(Card& card, size_t axis) {
  if (!card.motion.axis(axis).servo_on || !card.motion.FollowingErrorExceeded(axis)) return;
  SetEvents(card, axis, kMotionErrorBit);
  if (AxisState(card, axis).auto_stop) EndAbnormally(card, axis);
}

/// The event is the family's: the motion core forgets what it has captured, but not where.
bool TakeCapture(Card& card, size_t axis) {
  const motion::Capture& capture = card.motion.part<&motion::MotionState::capture>().capture(axis);
  if (!capture.captured) return false;
  const bool by_probe = capture.source == motion::CaptureSource::kProbe;
  SetEvents(card, axis, kCapturedBit);
  card.motion.capture().Clear(axis);
  return by_probe;
}

void NoticeCaptures(Card& card) {
  bool probed = false;
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) probed |= TakeCapture(card, axis);
  if (!probed || !card.state<Gt400State>().probe_stops) return;
  ForEachAxis(card, StopAbruptly);
}

}  // namespace

uint8_t NewLimits(const CardView& card, size_t axis) {
  return EventsOfLimits(CausesOf(card, axis) & ~AxisState(card, axis).noticed);
}

void NoticeLimits(Card& card, size_t axis) {
  if (const uint8_t limits = NewLimits(card.view(), axis)) SetEvents(card, axis, limits);
  Notice(card, axis, kLimitConditions);
}

void ForbidDirections(Card& card, size_t axis) {
  const Gt400Axis& state = AxisState(card, axis);
  uint32_t conditions = (state.events & kAlarmEventBit) != 0 ? motion::kAlarmBit : uint32_t{0};
  if ((state.events & kMotionErrorBit) != 0) conditions |= motion::kFollowingErrorBit;
  for (const Limit& limit : {kPositiveLimit, kNegativeLimit}) {
    const bool watched = card.motion.axis(axis).positive_limit_on;
    if (watched && (state.events & limit.event) != 0) conditions |= limit.condition;
  }
  conditions |= CausesOf(card.view(), axis);
  if (conditions != LatchedBy(card.view(), axis))
    card.motion.AxisAt(axis).LatchConditions(conditions);
}

bool RefuseAtLimit(Card& card, size_t axis, double direction) {
  const std::optional<HeldAxis> held = FindHeld(card.view(), axis, direction);
  if (!held) return false;
  SetEvents(card, held->axis, held->limit);
  SetEvents(card, axis, kCompleteBit);
  return true;
}

void StopAbruptly(Card& card, size_t axis) {
  Gt400Axis& state = AxisState(card, axis);
  card.motion.ProfileAt(axis).Stop(true);
  NoticeMotion(card, axis);
  SetEvents(card, axis, kCompleteBit);
  state.waiting.velocity = state.valid.velocity = 0;
}

void NoticeStops(Card& card) {
  ForEachAxis(card, NoticeLimits);
  NoticeHeldSlaves(card);
  ForEachAxis(card, NoticeLimitStop);
  ForEachAxis(card, NoticeAlarm);
  ForEachAxis(card, JudgePositionError);
  NoticeCaptures(card);
}

void NoticeEnds(Card& card) {
  ForEachAxis(card, NoticeMotion);
  ForEachAxis(card, ForbidDirections);
}

}  // namespace oncard::gtcalls::gt400
