#include "motion/homing_sequence.h"

#include <algorithm>
#include <cmath>

#include "motion/common/rounding.h"
#include "motion/io/digital_io.h"

namespace oncard::motion {
namespace {

double DistanceOf(int32_t distance) { return distance == 0 ? kSearchDistanceMax : distance; }

int32_t Reachable(double position) {
  return static_cast<int32_t>(
      std::clamp(Whole(position), -double{kPositionMax}, double{kPositionMax}));
}

}  // namespace

size_t HomingSequence::trigger() const {
  const int16_t chosen = homing_.parameters.trigger_index;
  return chosen == 0 ? axis_.axis() : static_cast<size_t>(chosen - 1);
}

void HomingSequence::Begin(const HomeParameters& parameters) {
  any_runs_ = true;
  homing_ = {.parameters = parameters, .running = true, .prepared = homing_.prepared};
  homing_.ahead = axis_.PlannedAhead();
  homing_.direction = parameters.move_direction;
  axis_.SetRamps({parameters.acc, parameters.dec, 0, parameters.smooth_time});
  homing_.stage = HomeStage::kStart;
  if (!parameters.check_start) return BeginSearch();
  int8_t away = 0;
  if (SearchesHome(parameters.mode) && axis_.HomeActive()) {
    away = static_cast<int8_t>(-parameters.move_direction);
  }
  if (axis_.LimitActive(1)) away = -1;
  if (axis_.LimitActive(-1)) away = 1;
  if (away == 0) return BeginSearch();
  Move(HomeStage::kEscape, away * static_cast<double>(parameters.escape), parameters.high);
}

void HomingSequence::BeginSimple(HomeKind kind, int32_t position, double velocity,
                                 double acceleration, int32_t offset) {
  SetUpSimple(kind, velocity, acceleration, offset);
  axis_.Arm(axis_.axis(), CaptureSource::kHome);
  Move(HomeStage::kSearchHome, position - axis_.now().position, velocity);
}

void HomingSequence::BeginWithin(int32_t bound, double velocity, double acceleration, bool index) {
  SetUpSimple(HomeKind::kWithin, velocity, acceleration, 0);
  homing_.bound = {true, bound};
  homing_.index_follows = index;
  homing_.direction = bound < axis_.now().position ? -1 : 1;
  if (!axis_.AtHome()) return SearchWithin(HomeStage::kSearchHome, CaptureSource::kHome);
  Move(HomeStage::kEscape, -homing_.direction * double{kSearchDistanceMax}, velocity);
}

void HomingSequence::SetUpSimple(HomeKind kind, double velocity, double acceleration,
                                 int32_t offset) {
  any_runs_ = true;
  homing_.running = true;
  homing_.kind = kind;
  homing_.error = HomeError::kNone;
  homing_.found = false;
  homing_.stopping = false;
  homing_.ahead = axis_.PlannedAhead();
  homing_.parameters.trigger_index = 0;
  homing_.simple_velocity = velocity;
  homing_.simple_acc = acceleration;
  homing_.simple_offset = offset;
  axis_.SetRamps({acceleration, acceleration, 0, 0});
}

void HomingSequence::SearchWithin(HomeStage stage, CaptureSource source) {
  homing_.found = false;
  axis_.Arm(axis_.axis(), source);
  Move(stage, homing_.bound.position - axis_.now().position, homing_.simple_velocity);
}

void HomingSequence::Abandon() {
  if (!homing_.running) return;
  axis_.Disarm(trigger());
  End();
}

void HomingSequence::SetIndexSearch(int32_t distance, int32_t offset) {
  homing_.index_follows = true;
  homing_.index_distance = distance;
  homing_.index_offset = offset;
  if (homing_.running || homing_.kind != HomeKind::kHome || !homing_.found) return;
  any_runs_ = true;
  homing_.running = true;
  SearchIndexSimply();
}

void HomingSequence::Prepare() {
  homing_.prepared = true;
  homing_.index_follows = false;
  if (homing_.running || homing_.kind == HomeKind::kSmart) return;
  homing_.kind = HomeKind::kSmart;
  homing_.error = HomeError::kNone;
  homing_.found = false;
}

void HomingSequence::Refuse(HomeError error) {
  if (!homing_.running) homing_.error = error;
}

void HomingSequence::SearchIndexSimply() {
  homing_.kind = HomeKind::kIndex;
  homing_.found = false;
  homing_.index_follows = false;
  homing_.simple_velocity /= 2;
  homing_.simple_offset = homing_.index_offset;
  axis_.Arm(axis_.axis(), CaptureSource::kIndex);
  Move(HomeStage::kSearchIndex, homing_.index_distance, homing_.simple_velocity);
}

void HomingSequence::Advance() {
  const HomeParameters& p = homing_.parameters;
  const Sample now = axis_.now();
  if (homing_.failing) {
    homing_.running = homing_.failing = now.moving;
    return;
  }
  if (!axis_.enabled()) return Fail(HomeError::kStop);
  if (homing_.stopping) {
    if (!now.moving) Continue();
    return;
  }
  const bool limit = axis_.LimitReached(homing_.direction);
  if (limit &&
      (homing_.stage == HomeStage::kSearchLimit || homing_.stage == HomeStage::kLimitReturn)) {
    // Rounded away from the limit: the move to the origin must not reach the limit again.
    homing_.captured = homing_.direction > 0 ? std::floor(now.position) : std::ceil(now.position);
    homing_.origin = homing_.captured;
    homing_.stage = homing_.stage == HomeStage::kSearchLimit ? HomeStage::kSearchLimitStop
                                                             : HomeStage::kLimitReturnStop;
    homing_.stopping = true;
    return axis_.Stop();
  }
  const bool searching =
      homing_.stage == HomeStage::kSearchHome || homing_.stage == HomeStage::kSearchIndex;
  if (const auto captured = axis_.Captured(trigger()); searching && captured) {
    return TakeCapture(*captured);
  }
  if (limit && homing_.stage == HomeStage::kSearchHome && homing_.kind == HomeKind::kSmart &&
      IsForced(p.mode) && !homing_.turned) {
    homing_.turned = true;
    homing_.stopping = true;
    return axis_.Stop();
  }
  if (homing_.stage == HomeStage::kEscape && homing_.kind == HomeKind::kWithin && !axis_.AtHome()) {
    return SearchWithin(HomeStage::kSearchHome, CaptureSource::kHome);
  }
  const bool arrived = !now.moving && now.position == homing_.target;
  if (axis_.stopping() || (!now.moving && !arrived)) {
    return Fail(HomeError::kStop);
  }
  if (arrived) Arrive();
}

void HomingSequence::TakeCapture(double captured) {
  homing_.captured = captured;
  homing_.origin = axis_.ProfilePositionOf(trigger(), captured, homing_.ahead);
  if (homing_.kind != HomeKind::kSmart && homing_.kind != HomeKind::kStop) {
    homing_.found = true;
    return Move(HomeStage::kGoHome, homing_.origin + homing_.simple_offset - axis_.now().position,
                homing_.simple_velocity);
  }
  if (homing_.stage == HomeStage::kSearchHome) homing_.stage = HomeStage::kSearchHomeStop;
  homing_.stopping = true;
  axis_.Stop(homing_.kind == HomeKind::kStop ? homing_.simple_acc : homing_.parameters.dec);
}

void HomingSequence::Continue() {
  const HomeParameters& p = homing_.parameters;
  const double position = axis_.now().position;
  homing_.stopping = false;
  switch (homing_.stage) {
    case HomeStage::kSearchLimitStop:
      if (p.mode == HomeMode::kLimit) {
        return Move(HomeStage::kLimitEscape, -homing_.direction * static_cast<double>(p.escape),
                    p.high);
      }
      homing_.direction = static_cast<int8_t>(-homing_.direction);
      return SearchesHome(p.mode) ? SearchHome() : SearchIndex();
    case HomeStage::kSearchHome:
      homing_.direction = static_cast<int8_t>(-homing_.direction);
      return SearchHome();
    case HomeStage::kSearchHomeStop:
      if (homing_.kind == HomeKind::kStop) {
        homing_.found = true;
        return End();
      }
      if (SearchesIndex(p.mode)) {
        return Move(HomeStage::kHomeReturn, homing_.origin - position, p.low);
      }
      break;
    default:
      break;
  }
  Move(HomeStage::kGoHome, homing_.origin + p.offset - position, p.final_fast ? p.high : p.low);
}

void HomingSequence::Arrive() {
  switch (homing_.stage) {
    case HomeStage::kEscape:
      return BeginSearch();
    case HomeStage::kLimitEscape:
      if (axis_.LimitActive(homing_.direction)) return Fail(HomeError::kStage);
      return Move(HomeStage::kLimitReturn, homing_.direction * double{kSearchDistanceMax},
                  homing_.parameters.low);
    case HomeStage::kHomeReturn:
      return SearchIndex();
    case HomeStage::kGoHome:
      if (!homing_.index_follows) return End();
      if (homing_.kind == HomeKind::kHome) return SearchIndexSimply();
      if (homing_.kind != HomeKind::kWithin) return End();
      homing_.index_follows = false;
      return SearchWithin(HomeStage::kSearchIndex, CaptureSource::kIndex);
    case HomeStage::kSearchIndex:
      return Fail(HomeError::kNoIndex);
    default:
      return Fail(HomeError::kNoHome);
  }
}

void HomingSequence::BeginSearch() {
  const HomeParameters& p = homing_.parameters;
  if (SearchesLimit(p.mode)) {
    return Move(HomeStage::kSearchLimit, p.move_direction * double{kSearchDistanceMax}, p.high);
  }
  if (SearchesHome(p.mode)) return SearchHome();
  SearchIndex();
}

void HomingSequence::SearchHome() {
  homing_.stage = HomeStage::kSearchHome;
  if (trigger() >= static_cast<size_t>(DiWidth(DiType::kHome))) {
    return Fail(HomeError::kSetCaptureHome);
  }
  axis_.ArmOnce(trigger(), CaptureSource::kHome, homing_.parameters.rising);
  Move(HomeStage::kSearchHome, homing_.direction * DistanceOf(homing_.parameters.home_distance),
       homing_.parameters.high);
}

void HomingSequence::SearchIndex() {
  homing_.stage = HomeStage::kSearchIndex;
  homing_.direction = homing_.parameters.index_direction;
  if (!axis_.HasEncoder(trigger())) {
    return Fail(HomeError::kSetCaptureIndex);
  }
  axis_.ArmOnce(trigger(), CaptureSource::kIndex, homing_.parameters.rising);
  Move(HomeStage::kSearchIndex, homing_.direction * DistanceOf(homing_.parameters.index_distance),
       homing_.parameters.low);
}

void HomingSequence::Move(HomeStage stage, double distance, double velocity) {
  homing_.stage = stage;
  // The limit that the search has left must not stop the move back.
  if (homing_.kind == HomeKind::kSmart) axis_.ForgetLimit(distance > 0 ? 1 : -1);
  const int32_t target = Reachable(axis_.now().position + distance);
  homing_.target = target;
  axis_.Move(target, velocity);
}

void HomingSequence::End() {
  homing_.running = false;
  homing_.stage = HomeStage::kEnd;
}

void HomingSequence::Fail(HomeError error) {
  homing_.running = homing_.failing = axis_.now().moving;
  homing_.error = error;
  axis_.Disarm(trigger());
}

}  // namespace oncard::motion
