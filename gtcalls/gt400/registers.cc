#include "gtcalls/gt400/registers.h"

#include <algorithm>
#include <cmath>

#include "gtcalls/gt400/axis_state.h"
#include "gtcalls/gt400/drives.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/gears.h"
#include "gtcalls/gt400/stops.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::ProfileMode;

constexpr uint16_t kMotionRegisters = 0
#define REGISTER(name, member, check, kind) \
  | (RegisterKind::kind == RegisterKind::kMotion ? BitOf(Register::k##name) : 0)
#include "gtcalls/gt400/registers.def"
    ;

/// True if a value waits that must not change in motion.
bool HasFixedChange(ProfileMode mode, const Gt400Axis& axis) {
  const AxisRegisters& waiting = axis.waiting;
  const AxisRegisters& valid = axis.valid;
  switch (mode) {
    case ProfileMode::kSCurve:
      return waiting.velocity != valid.velocity ||
             waiting.max_acceleration != valid.max_acceleration || waiting.jerk != valid.jerk;
    case ProfileMode::kTrap:
      return waiting.acceleration != valid.acceleration;
    default:
      return false;
  }
}

bool IsZero(double rate) { return std::fabs(rate) < motion::kRateMin; }

/// True if an axis at rest is where a motion with its valid registers would end.
bool IsThere(const motion::Profile& profile, const AxisRegisters& valid) {
  switch (profile.mode) {
    case ProfileMode::kTrap:
    case ProfileMode::kSCurve:
      return profile.now.position == valid.position;
    case ProfileMode::kJog:
      return IsZero(valid.velocity);
    default:
      return false;
  }
}

/// Begins or replans the motion in mode T or V.
void StartWithAcceleration(Card& card, size_t axis) {
  const AxisRegisters& valid = AxisState(card, axis).valid;
  if (IsZero(valid.acceleration)) return;
  const motion::ProfileHandle profile = card.motion.ProfileAt(axis);
  profile.SetVelocity(valid.velocity);
  if (card.motion.profile(axis).mode == ProfileMode::kJog) {
    profile.SetParameters(motion::JogParameters{valid.acceleration, valid.acceleration, 0});
  } else {
    profile.SetParameters(motion::TrapParameters{valid.acceleration, valid.acceleration, 0, 0});
    profile.SetTarget(valid.position);
  }
  profile.Start();
}

void StartMotion(Card& card, size_t axis) {
  const AxisRegisters& valid = AxisState(card, axis).valid;
  const motion::ProfileHandle profile = card.motion.ProfileAt(axis);
  switch (card.motion.profile(axis).mode) {
    case ProfileMode::kTrap:
    case ProfileMode::kJog:
      return StartWithAcceleration(card, axis);
    case ProfileMode::kSCurve:
      profile.SetSCurve({valid.velocity, valid.max_acceleration, valid.jerk}, valid.position);
      return profile.Start();
    default:
      return;
  }
}

/// The direction, as a sign, in which a motion with the valid registers would begin; 0: none would.
double DirectionOf(const motion::Profile& profile, const AxisRegisters& valid) {
  switch (profile.mode) {
    case ProfileMode::kTrap:
      if (IsZero(valid.acceleration) || IsZero(valid.velocity)) return 0;
      return valid.position - profile.now.position;
    case ProfileMode::kSCurve:
      if (IsZero(valid.max_acceleration) || IsZero(valid.jerk) || IsZero(valid.velocity)) return 0;
      return valid.position - profile.now.position;
    case ProfileMode::kJog:
      return IsZero(valid.acceleration) ? 0 : valid.velocity;
    default:
      return 0;
  }
}

/// An axis in motion has an acceleration, unless mode V has been given none since.
void StopSmoothly(Card& card, size_t axis) {
  const double deceleration = AxisState(card, axis).valid.acceleration;
  const motion::Profile& profile = card.motion.profile(axis);
  if (profile.mode != ProfileMode::kSCurve) {
    if (IsZero(deceleration)) return;
    card.motion.ProfileAt(axis).SetStopDecelerations(deceleration, profile.abrupt_stop);
  }
  card.motion.ProfileAt(axis).Stop(false);
}

/// The target and the planned position become the actual one.
void SynchPosition(Card& card, size_t axis) {
  const double actual = card.motion.encoder(axis).position;
  PlaceAxis(card, axis,
            static_cast<int32_t>(std::clamp<double>(actual, kPositionMin, kPositionMax)));
}

void Apply(Card& card, size_t axis, const TakenUpdate& update) {
  Gt400Axis& state = AxisState(card, axis);
  state.valid = update.registers;
  UpdateServo(card, axis);
  if (update.request.synch_position) return SynchPosition(card, axis);
  const bool stops = update.request.smooth_stop;
  if (!stops && (update.request.written & kMotionRegisters) == 0) return;
  if (!CanPlan(card, axis)) return;
  card.motion.HomingAt(axis).Abandon();
  const bool rested = !Moves(card.view(), axis);
  if (stops) {
    StopSmoothly(card, axis);
  } else if (card.motion.profile(axis).mode == ProfileMode::kGear) {
    if ((update.request.written & BitOf(Register::kRatio)) != 0) Engage(card, axis);
  } else {
    const double direction = DirectionOf(card.motion.profile(axis), state.valid);
    if (rested && RefuseAtLimit(card, axis, direction)) return;
    StartMotion(card, axis);
  }
  // Otherwise a host that waits for the end of a motion without length would wait for ever.
  const motion::Profile& profile = card.motion.profile(axis);
  if (rested && !profile.now.moving && (stops || IsThere(profile, state.valid))) {
    SetEvents(card, axis, kCompleteBit);
  }
  NoticeMotion(card, axis);
}

TakenUpdate Take(Gt400Axis* axis) {
  const TakenUpdate update = {axis->waiting, axis->request};
  axis->request = {};
  return update;
}

/// Why an Update of the axis would be refused now; nothing if it would not.
std::optional<Message> WhyNoUpdate(const CardView& card, size_t axis) {
  const Gt400Axis& state = AxisState(card, axis);
  const ProfileMode mode = card.motion.profile(axis).mode;
  const bool geared = mode == ProfileMode::kGear;
  const bool moves = Moves(card, axis);
  const auto number = axis + 1;
  if (state.request.synch_position && (moves || geared || mode == ProfileMode::kJog)) {
    return MakeMessage(
        "GT_SynchPos waits, which is for axis {0} at rest in mode T or S; it is dropped",
        "轴 {0} 有等待的 GT_SynchPos，仅可在 T 或 S 模式下静止时生效；该指令已取消", number);
  }
  if (state.request.smooth_stop && geared) {
    return MakeMessage("GT_SmthStp waits, and axis {0} is a gear slave; it is dropped",
                       "轴 {0} 有等待的 GT_SmthStp，但该轴为电子齿轮从轴；该指令已取消", number);
  }
  if (moves && HasFixedChange(mode, state)) {
    return MakeMessage(
        "axis {0} is moving: in mode S only the target position may change, in mode T also the "
        "velocity",
        "轴 {0} 正在运动：S 模式下只能修改目标位置，T 模式下还可修改速度", number);
  }
  return std::nullopt;
}

/// Updates the axes of a mask, all of them or none.
std::optional<Message> UpdateAxes(Card& card, uint32_t axes, void (*update)(Card&, size_t)) {
  const size_t count = card.motion.axis_count();
  std::optional<Message> refusal;
  motion::ForEachBit(axes, count, [&](size_t axis) {
    if (!refusal) refusal = WhyNoUpdate(card.view(), axis);
  });
  motion::ForEachBit(axes, count, [&](size_t axis) {
    if (refusal) {
      UpdateRequest& request = AxisState(card, axis).request;
      request.smooth_stop = request.synch_position = false;
    } else {
      update(card, axis);
    }
  });
  return refusal;
}

}  // namespace

std::optional<Message> TakeUpdate(Card& card, uint32_t axes) {
  return UpdateAxes(card, axes, [](Card& updated, size_t axis) {
    Gt400Axis& state = AxisState(updated, axis);
    state.taken.Emplace(Take(&state));
  });
}

std::optional<Message> UpdateAtOnce(Card& card, uint32_t axes) {
  return UpdateAxes(card, axes, [](Card& updated, size_t axis) {
    Apply(updated, axis, Take(&AxisState(updated, axis)));
  });
}

void ApplyTakenUpdates(Card& card) {
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    auto& taken = AxisState(card, axis).taken;
    if (!taken) continue;
    Apply(card, axis, *taken);
    taken.Reset();
  }
}

}  // namespace oncard::gtcalls::gt400
