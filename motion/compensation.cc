#include "motion/compensation.h"

#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Backlash> && kFieldsComplete<PitchTable> &&
              kFieldsComplete<Compensation>);

}  // namespace

double PitchTable::At(double position, bool moving_positive) const {
  const double way = position - start;
  if (way < 0 || way > length) return 0;
  const std::vector<int32_t>& points = moving_positive ? positive : negative;
  const double place = way * static_cast<double>(points.size() - 1) / length;
  const size_t first = std::min(static_cast<size_t>(place), points.size() - 2);
  const double begin = points[first];
  return begin + (place - static_cast<double>(first)) * (points[first + 1] - begin);
}

void Compensation::SetBacklash(const Backlash& registers) {
  backlash = registers;
  ramp_to = backlash_error;
}

void Compensation::Advance(Micros begin, Micros end, double position, double velocity) {
  if (velocity != 0) direction = velocity > 0 ? 1 : -1;
  AdvanceBacklash(begin, end);
  pitch_error = PitchErrorAt(position);
}

void Compensation::MoveOrigin(double from, double to) {
  const double change = PitchErrorAt(to) - PitchErrorAt(from);
  origin += change;
  pitch_error += change;
}

void Compensation::AdvanceBacklash(Micros begin, Micros end) {
  const double side = backlash.positive ? 1 : -1;
  const double wanted = direction == side ? side * backlash.value : 0;
  if (wanted != ramp_to) {
    ramp_from = backlash_error;
    ramp_to = wanted;
    ramp_begin = begin;
  }
  if (backlash_error == wanted) return;
  const double way = wanted - ramp_from;
  const bool at_once = backlash.change == 0 || backlash.change >= backlash.value;
  const double done = backlash.change * MsBetween(ramp_begin, end);
  if (at_once || done >= std::fabs(way)) {
    backlash_error = wanted;
  } else {
    backlash_error = ramp_from + (way > 0 ? done : -done);
  }
}

}  // namespace oncard::motion
