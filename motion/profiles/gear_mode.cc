#include "motion/profiles/gear_mode.h"

#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {

static_assert(kFieldsComplete<GearMode> && kFieldsComplete<DirectRatio> &&
              kFieldsComplete<Master> && kFieldsComplete<MasterTravel>);

double GearMode::Direction(const MasterValue& value) const {
  const bool at_once = event == GearEvent::kStart;
  return at_once && MasterTravel{direction}.Counts(value.velocity) ? Ratio() * value.velocity : 0;
}

void GearMode::Start(const Sample& from, const MasterValue& value) {
  running = true;
  direct.held = false;
  base = from.position;
  from_ratio = 0;
  to_ratio = Ratio();
  clutch = slope;
  travel.direction = direction;
  travel.Restart(value.position);
  double position = 0;
  waiting = event != GearEvent::kStart && !EventBetween(value.position, value.position, &position);
}

void GearMode::ChangeRatio(const Sample& now) {
  from_ratio = waiting ? 0 : RatioAt(std::fabs(travel.travel));
  to_ratio = Ratio();
  base = now.position;
  clutch = slope;
  travel.travel = 0;
}

void GearMode::Hold(const Sample& now) {
  direct.held = true;
  base = now.position;
  travel.travel = 0;
}

double GearMode::RatioAt(double engaged) const {
  if (engaged >= clutch) return to_ratio;
  return from_ratio + (to_ratio - from_ratio) * engaged / clutch;
}

bool GearMode::EventBetween(double before, double after, double* position) const {
  if (event == GearEvent::kPass) {
    *position = event_first;
    return before != after && std::min(before, after) <= event_first &&
           event_first <= std::max(before, after);
  }
  const auto low = static_cast<double>(std::min(event_first, event_last));
  const auto high = static_cast<double>(std::max(event_first, event_last));
  if (std::max(before, after) < low || std::min(before, after) > high) return false;
  *position = std::clamp(before, low, high);
  return true;
}

Sample GearMode::At(const Sample& now, const MasterValue& value) {
  if (waiting) {
    double position = 0;
    const bool begins = EventBetween(travel.last, value.position, &position);
    travel.Restart(begins ? position : value.position);
    if (!begins) return {now.position, 0, 0, true};
    waiting = false;
  }
  travel.MoveTo(value.position);
  if (travel.travel != 0) direct.held = false;
  const double sign = travel.travel < 0 ? -1 : 1;
  const double x = std::fabs(travel.travel);
  double moved = 0;
  double bend = 0;  // change of the ratio per pulse of the master
  if (x >= clutch) {
    moved = (from_ratio + to_ratio) / 2 * clutch + to_ratio * (x - clutch);
  } else {
    bend = (to_ratio - from_ratio) / clutch;
    moved = x * (from_ratio + bend / 2 * x);
  }
  const bool follows = travel.Counts(value.velocity);
  const double ratio = follows ? RatioAt(x) : 0;
  return {
      base + sign * moved, ratio * value.velocity,
      ratio * value.acceleration + (follows ? bend * sign * value.velocity * value.velocity : 0),
      true};
}

}  // namespace oncard::motion
