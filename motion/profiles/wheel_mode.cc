#include "motion/profiles/wheel_mode.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<WheelMode> && kFieldsComplete<MoveLimits>);

}  // namespace

void WheelMode::Start(const Sample& from, const MasterValue& value) {
  travel.Restart(value.position);
  base = from.position;
  running = true;
}

Sample WheelMode::At(const Sample& from, const MasterValue& value) {
  travel.MoveTo(value.position);
  const double target = base + ratio * travel.travel;
  Sample next = PlanToPosition(from.position, from.velocity, target, limits).At(cycle);
  next.moving = true;  // it waits for the wheel
  return next;
}

}  // namespace oncard::motion
