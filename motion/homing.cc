#include "motion/homing.h"

#include <algorithm>
#include <cmath>

#include "motion/common/rounding.h"
#include "motion/common/state_hash.h"
#include "motion/motion_core.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<HomeParameters> && kFieldsComplete<Homing>);

double DistanceOf(int32_t distance) { return distance == 0 ? kSearchDistanceMax : distance; }

int32_t Reachable(double position) {
  return static_cast<int32_t>(
      std::clamp(Whole(position), -double{kPositionMax}, double{kPositionMax}));
}

bool IsForced(HomeMode mode) {
  return mode == HomeMode::kForcedHome || mode == HomeMode::kForcedHomeIndex;
}

}  // namespace

bool SearchesLimit(HomeMode mode) {
  return mode >= HomeMode::kLimit && mode <= HomeMode::kLimitHomeIndex;
}

bool SearchesHome(HomeMode mode) {
  return mode == HomeMode::kLimitHome || mode == HomeMode::kLimitHomeIndex ||
         mode == HomeMode::kHome || mode == HomeMode::kHomeIndex || IsForced(mode);
}

bool SearchesIndex(HomeMode mode) {
  return mode == HomeMode::kLimitIndex || mode == HomeMode::kLimitHomeIndex ||
         mode == HomeMode::kHomeIndex || mode == HomeMode::kIndex ||
         mode == HomeMode::kForcedHomeIndex;
}

size_t MotionCore::HomingTrigger(size_t index) const {
  const int16_t chosen = state_.homing[index].parameters.trigger_index;
  return chosen == 0 ? index : static_cast<size_t>(chosen - 1);
}

HomeError MotionCore::CheckHoming(size_t index, HomeMode mode) const {
  if (state_.profiles[index].mode != ProfileMode::kTrap) return HomeError::kNotTrap;
  if (!state_.axes[index].servo_on) return HomeError::kDisabled;
  if ((state_.axes[index].latched & kAlarmBit) != 0) return HomeError::kAlarm;
  return mode == HomeMode::kNone ? HomeError::kMode : HomeError::kNone;
}

void MotionCore::BeginHoming(size_t index, const HomeParameters& parameters) {
  Homing& homing = state_.homing[index];
  homing = {.parameters = parameters, .running = true, .prepared = homing.prepared};
  homing.ahead = PlannedAhead(index);
  homing.direction = parameters.move_direction;
  state_.homing_runs = true;
  TrapMode& trap = state_.profiles[index].trap;
  trap.parameters = {parameters.acc, parameters.dec, 0, parameters.smooth_time};
  // Replanning with a smoothing time stores pieces; reserved here, so that a cycle does not
  // allocate.
  trap.past.reserve(4 * Plan::kPieceMax);
  homing.stage = HomeStage::kStart;
  if (!parameters.check_start) return BeginHomingSearch(index);
  const Axis& axis = state_.axes[index];
  int8_t away = 0;
  if (SearchesHome(parameters.mode) && InputActive({DiType::kHome, static_cast<int16_t>(index)})) {
    away = static_cast<int8_t>(-parameters.move_direction);
  }
  if (InputActive(axis.positive_limit)) away = -1;
  if (InputActive(axis.negative_limit)) away = 1;
  if (away == 0) return BeginHomingSearch(index);
  MoveHoming(index, HomeStage::kEscape, away * static_cast<double>(parameters.escape),
             parameters.high);
}

void MotionCore::BeginSimpleHoming(size_t index, HomeKind kind, int32_t position, double velocity,
                                   double acceleration, int32_t offset) {
  Homing& homing = state_.homing[index];
  homing.running = true;
  homing.kind = kind;
  homing.error = HomeError::kNone;
  homing.found = false;
  homing.stopping = false;
  homing.ahead = PlannedAhead(index);
  homing.parameters.trigger_index = 0;
  homing.simple_velocity = velocity;
  homing.simple_acc = acceleration;
  homing.simple_offset = offset;
  state_.homing_runs = true;
  state_.profiles[index].trap.parameters = {acceleration, acceleration, 0, 0};
  state_.capture.Arm(index, CaptureSource::kHome);
  MoveHoming(index, HomeStage::kSearchHome, position - state_.profiles[index].now.position,
             velocity);
}

void MotionCore::SetIndexSearch(size_t index, int32_t distance, int32_t offset) {
  Homing& homing = state_.homing[index];
  homing.index_follows = true;
  homing.index_distance = distance;
  homing.index_offset = offset;
  if (homing.running || homing.kind != HomeKind::kHome || !homing.found) return;
  homing.running = true;
  state_.homing_runs = true;
  SearchIndexSimply(index);
}

void MotionCore::SearchIndexSimply(size_t index) {
  Homing& homing = state_.homing[index];
  homing.kind = HomeKind::kIndex;
  homing.found = false;
  homing.index_follows = false;
  homing.simple_velocity /= 2;
  homing.simple_offset = homing.index_offset;
  state_.capture.Arm(index, CaptureSource::kIndex);
  MoveHoming(index, HomeStage::kSearchIndex, homing.index_distance, homing.simple_velocity);
}

double MotionCore::PlannedAhead(size_t index) const {
  // A closed loop holds the axis at its planned position.
  if (InClosedLoop(index)) return 0;
  const Axis& axis = state_.axes[index];
  double fraction = 0;
  for (size_t i = 0; i < axis_count(); ++i) {
    if ((axis.encoder_map >> i & 1) != 0)
      fraction += CountedPosition(i) - state_.encoders[i].position;
  }
  const double measured = axis.encoder.position + axis.encoder_scale.Apply(fraction);
  return CommandedPosition(index) - measured;
}

double MotionCore::ProfilePositionOf(size_t index, double captured) const {
  const Axis& axis = state_.axes[index];
  const Encoder& encoder = state_.encoders[HomingTrigger(index)];
  const double measured =
      axis.encoder.position + axis.encoder_scale.Apply(captured - encoder.position);
  const double planned =
      measured + state_.homing[index].ahead - state_.compensations[index].Amount();
  const Scale& scale = axis.profile_scale;
  const double way = planned - (MappedProfiles(axis) + axis.profile.offset);
  const Scale inverse = {scale.beta, scale.alpha};
  return state_.profiles[index].now.position + inverse.Apply(way);
}

void MotionCore::AdvanceHomings() {
  state_.homing_runs = false;
  for (size_t i = 0; i < axis_count(); ++i) {
    if (!state_.homing[i].running) continue;
    AdvanceHoming(i);
    state_.homing_runs |= state_.homing[i].running;
  }
}

void MotionCore::AdvanceHoming(size_t index) {
  Homing& homing = state_.homing[index];
  const HomeParameters& p = homing.parameters;
  const Sample& now = state_.profiles[index].now;
  if (homing.failing) {
    homing.running = homing.failing = now.moving;
    return;
  }
  if (!state_.axes[index].servo_on) return FailHoming(index, HomeError::kStop);
  if (homing.stopping) {
    if (!now.moving) ContinueHoming(index);
    return;
  }
  const bool limit = LimitReached(index, homing.direction);
  if (limit &&
      (homing.stage == HomeStage::kSearchLimit || homing.stage == HomeStage::kLimitReturn)) {
    // Rounded away from the limit: the move to the origin must not reach the limit again.
    homing.captured = homing.direction > 0 ? std::floor(now.position) : std::ceil(now.position);
    homing.origin = homing.captured;
    homing.stage = homing.stage == HomeStage::kSearchLimit ? HomeStage::kSearchLimitStop
                                                           : HomeStage::kLimitReturnStop;
    homing.stopping = true;
    return StopProfile(index, true);
  }
  const bool searching =
      homing.stage == HomeStage::kSearchHome || homing.stage == HomeStage::kSearchIndex;
  if (searching && state_.capture.capture(HomingTrigger(index)).captured) {
    return TakeHomingCapture(index);
  }
  if (limit && homing.stage == HomeStage::kSearchHome && homing.kind == HomeKind::kSmart &&
      IsForced(p.mode) && !homing.turned) {
    homing.turned = true;
    homing.stopping = true;
    return StopProfile(index, true);
  }
  const bool arrived = !now.moving && now.position == homing.target;
  if (state_.profiles[index].stopping || (!now.moving && !arrived)) {
    return FailHoming(index, HomeError::kStop);
  }
  if (arrived) ArriveHoming(index);
}

void MotionCore::TakeHomingCapture(size_t index) {
  Homing& homing = state_.homing[index];
  homing.captured = state_.capture.capture(HomingTrigger(index)).value;
  homing.origin = ProfilePositionOf(index, homing.captured);
  if (homing.kind == HomeKind::kHome || homing.kind == HomeKind::kIndex) {
    homing.found = true;
    return MoveHoming(index, HomeStage::kGoHome,
                      homing.origin + homing.simple_offset - state_.profiles[index].now.position,
                      homing.simple_velocity);
  }
  if (homing.stage == HomeStage::kSearchHome) homing.stage = HomeStage::kSearchHomeStop;
  homing.stopping = true;
  state_.profiles[index].Stop(
      now(), homing.kind == HomeKind::kStop ? homing.simple_acc : homing.parameters.dec);
}

void MotionCore::ContinueHoming(size_t index) {
  Homing& homing = state_.homing[index];
  const HomeParameters& p = homing.parameters;
  const double position = state_.profiles[index].now.position;
  homing.stopping = false;
  switch (homing.stage) {
    case HomeStage::kSearchLimitStop:
      if (p.mode == HomeMode::kLimit) {
        return MoveHoming(index, HomeStage::kLimitEscape,
                          -homing.direction * static_cast<double>(p.escape), p.high);
      }
      homing.direction = static_cast<int8_t>(-homing.direction);
      return SearchesHome(p.mode) ? SearchHome(index) : SearchIndex(index);
    case HomeStage::kSearchHome:
      homing.direction = static_cast<int8_t>(-homing.direction);
      return SearchHome(index);
    case HomeStage::kSearchHomeStop:
      if (homing.kind == HomeKind::kStop) {
        homing.found = true;
        return EndHoming(index);
      }
      if (SearchesIndex(p.mode)) {
        return MoveHoming(index, HomeStage::kHomeReturn, homing.origin - position, p.low);
      }
      break;
    default:
      break;
  }
  MoveHoming(index, HomeStage::kGoHome, homing.origin + p.offset - position,
             p.final_fast ? p.high : p.low);
}

void MotionCore::ArriveHoming(size_t index) {
  Homing& homing = state_.homing[index];
  switch (homing.stage) {
    case HomeStage::kEscape:
      return BeginHomingSearch(index);
    case HomeStage::kLimitEscape:
      if (LimitActive(index, homing.direction)) return FailHoming(index, HomeError::kStage);
      return MoveHoming(index, HomeStage::kLimitReturn,
                        homing.direction * double{kSearchDistanceMax}, homing.parameters.low);
    case HomeStage::kHomeReturn:
      return SearchIndex(index);
    case HomeStage::kGoHome:
      return homing.kind == HomeKind::kHome && homing.index_follows ? SearchIndexSimply(index)
                                                                    : EndHoming(index);
    case HomeStage::kSearchIndex:
      return FailHoming(index, HomeError::kNoIndex);
    default:
      return FailHoming(index, HomeError::kNoHome);
  }
}

void MotionCore::BeginHomingSearch(size_t index) {
  Homing& homing = state_.homing[index];
  const HomeParameters& p = homing.parameters;
  if (SearchesLimit(p.mode)) {
    return MoveHoming(index, HomeStage::kSearchLimit, p.move_direction * double{kSearchDistanceMax},
                      p.high);
  }
  if (SearchesHome(p.mode)) return SearchHome(index);
  SearchIndex(index);
}

void MotionCore::SearchHome(size_t index) {
  Homing& homing = state_.homing[index];
  const size_t trigger = HomingTrigger(index);
  homing.stage = HomeStage::kSearchHome;
  if (trigger >= static_cast<size_t>(DiWidth(DiType::kHome))) {
    return FailHoming(index, HomeError::kSetCaptureHome);
  }
  ArmHoming(trigger, CaptureSource::kHome, homing.parameters.rising);
  MoveHoming(index, HomeStage::kSearchHome,
             homing.direction * DistanceOf(homing.parameters.home_distance),
             homing.parameters.high);
}

void MotionCore::SearchIndex(size_t index) {
  Homing& homing = state_.homing[index];
  const size_t trigger = HomingTrigger(index);
  homing.stage = HomeStage::kSearchIndex;
  homing.direction = homing.parameters.index_direction;
  if (!state_.encoders[trigger].active) {
    return FailHoming(index, HomeError::kSetCaptureIndex);
  }
  ArmHoming(trigger, CaptureSource::kIndex, homing.parameters.rising);
  MoveHoming(index, HomeStage::kSearchIndex,
             homing.direction * DistanceOf(homing.parameters.index_distance),
             homing.parameters.low);
}

void MotionCore::ArmHoming(size_t trigger, CaptureSource source, bool rising) {
  Capture& capture = state_.capture.capture(trigger);
  const auto bit = static_cast<uint16_t>(1u << static_cast<unsigned>(source));
  capture.rising = static_cast<uint16_t>(rising ? capture.rising | bit : capture.rising & ~bit);
  capture.repeat = 1;
  state_.capture.Arm(trigger, source);
}

void MotionCore::MoveHoming(size_t index, HomeStage stage, double distance, double velocity) {
  Homing& homing = state_.homing[index];
  Profile& profile = state_.profiles[index];
  homing.stage = stage;
  // The limit that the search has left must not stop the move back.
  if (homing.kind == HomeKind::kSmart) ForgetLimit(index, distance > 0 ? 1 : -1);
  profile.trap.target = Reachable(profile.now.position + distance);
  profile.trap.velocity = velocity;
  homing.target = profile.trap.target;
  StartProfile(index);
}

bool MotionCore::LimitActive(size_t index, int direction) const {
  const Axis& axis = state_.axes[index];
  return InputActive(direction > 0 ? axis.positive_limit : axis.negative_limit);
}

bool MotionCore::LimitReached(size_t index, int direction) const {
  const uint32_t bit = direction > 0 ? kPositiveLimitBit : kNegativeLimitBit;
  return (state_.axes[index].latched & bit) != 0 || LimitActive(index, direction);
}

void MotionCore::ForgetLimit(size_t index, int direction) {
  Axis& axis = state_.axes[index];
  const uint32_t bit = direction > 0 ? kPositiveLimitBit : kNegativeLimitBit;
  axis.latched &= ~bit | ActiveCauses(axis);
}

void MotionCore::EndHoming(size_t index) {
  state_.homing[index].running = false;
  state_.homing[index].stage = HomeStage::kEnd;
}

void MotionCore::FailHoming(size_t index, HomeError error) {
  Homing& homing = state_.homing[index];
  homing.running = homing.failing = state_.profiles[index].now.moving;
  homing.error = error;
  state_.capture.Disarm(HomingTrigger(index));
}

}  // namespace oncard::motion
