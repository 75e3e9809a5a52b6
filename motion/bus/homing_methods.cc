#include "motion/bus/homing_methods.h"

namespace oncard::motion::bus {
namespace {

using enum Sensor;

/// Methods 1 to 14. The same without index marks are 17 to 30.
constexpr HomingMethod kMethods[] = {
    {kNegativeLimit, false, +1, -1, true},  // 1: right of the negative limit
    {kPositiveLimit, true, -1, +1, true},   // 2: left of the positive limit
    {kHome, true, -1, +1, true},            // 3: left of a positive home switch
    {kHome, true, +1, +1, true},            // 4: inside of a positive home switch
    {kHome, false, +1, -1, true},           // 5: right of a negative home switch
    {kHome, false, -1, -1, true},           // 6: inside of a negative home switch
    {kHome, true, -1, +1, true},            // 7: left of the left edge
    {kHome, true, +1, +1, true},            // 8: right of the left edge
    {kHome, false, -1, +1, true},           // 9: left of the right edge
    {kHome, false, +1, +1, true},           // 10: right of the right edge
    {kHome, false, +1, -1, true},           // 11: right of the right edge
    {kHome, false, -1, -1, true},           // 12: left of the right edge
    {kHome, true, +1, -1, true},            // 13: right of the left edge
    {kHome, true, -1, -1, true},            // 14: left of the left edge
};
constexpr int64_t kIndexMethods = static_cast<int64_t>(std::size(kMethods));
constexpr int64_t kFirstWithoutIndex = 17;

}  // namespace

std::optional<HomingMethod> FindHomingMethod(int64_t number) {
  if (number >= 1 && number <= kIndexMethods) return kMethods[number - 1];
  if (number >= kFirstWithoutIndex && number < kFirstWithoutIndex + kIndexMethods) {
    HomingMethod method = kMethods[number - kFirstWithoutIndex];
    method.index = false;
    return method;
  }
  if (number == 33) return HomingMethod{std::nullopt, false, -1, -1, true};
  if (number == 34) return HomingMethod{std::nullopt, false, +1, +1, true};
  if (number == 35 || number == 37) return HomingMethod{};
  return std::nullopt;
}

void HomingRun::Begin(int8_t number, const std::array<bool, kSwitchCount>& operated, double at) {
  const HomingMethod row = *FindHomingMethod(number);
  *this = {HomingPhase::kSearch, number, row.begin, 0, at};
  if (!row.contact) {
    phase = row.index ? HomingPhase::kIndex : HomingPhase::kReturn;
  } else if (operated[static_cast<size_t>(*row.contact)]) {
    direction = row.left_edge ? -1 : +1;
    if (direction == row.direction) phase = HomingPhase::kLeave;
  }
  if (phase == HomingPhase::kReturn) return;
  const Sensor ahead = direction > 0 ? kPositiveLimit : kNegativeLimit;
  if (operated[static_cast<size_t>(ahead)] && row.contact != ahead) MeetLimit();
}

bool HomingRun::Advance(Ramp& ramp, const HomingSpeeds& speeds, double ms) const {
  if (phase == HomingPhase::kReturn) {
    return ramp.TowardsPosition(home, speeds.leave, speeds.acceleration, ms);
  }
  const double speed = phase == HomingPhase::kSearch ? speeds.search : speeds.leave;
  ramp.TowardsVelocity(direction * speed, speeds.acceleration, ms);
  return false;
}

void HomingRun::Pass(const std::vector<Passage>& passages, bool forward) {
  const HomingMethod row = *FindHomingMethod(method);
  for (const Passage& passage : passages) {
    // While it turns round the drive looks at nothing.
    if (!running() || phase == HomingPhase::kReturn || forward != (direction > 0)) return;
    PassOne(passage, row);
  }
}

void HomingRun::PassOne(const Passage& passage, const HomingMethod& row) {
  const Sensor ahead = direction > 0 ? kPositiveLimit : kNegativeLimit;
  if (phase == HomingPhase::kIndex) {
    if (passage.sensor == kIndex) {
      home = passage.place;
      phase = HomingPhase::kReturn;
    } else if (passage.sensor == ahead && passage.rises) {
      phase = HomingPhase::kFailed;
    }
    return;
  }
  const bool at_left_edge = passage.rises == (direction > 0);
  if (passage.sensor == row.contact && at_left_edge == row.left_edge) {
    if (direction == row.direction) {
      home = passage.place;
      phase = row.index ? HomingPhase::kIndex : HomingPhase::kReturn;
    } else {
      direction = row.direction;
      phase = HomingPhase::kLeave;
    }
  } else if (passage.sensor == ahead && passage.rises) {
    MeetLimit();
  }
}

void HomingRun::MeetLimit() {
  ++limits;
  if (phase != HomingPhase::kSearch || limits > 1) {
    phase = HomingPhase::kFailed;
  } else {
    direction = static_cast<int8_t>(-direction);
  }
}

}  // namespace oncard::motion::bus
