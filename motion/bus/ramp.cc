#include "motion/bus/ramp.h"

#include <algorithm>
#include <cmath>

namespace oncard::motion::bus {

void Ramp::TowardsVelocity(double target, double acceleration, double ms) {
  const double change = target - velocity;
  const double time = std::fabs(change) / acceleration;
  if (time >= ms) {
    const double end = velocity + std::copysign(acceleration * ms, change);
    position += (velocity + end) / 2 * ms;
    velocity = end;
    return;
  }
  position += (velocity + target) / 2 * time + target * (ms - time);
  velocity = target;
}

bool Ramp::TowardsPosition(double target, double speed, double acceleration, double ms) {
  const double distance = target - position;
  const double length = std::fabs(distance);
  const double step = acceleration * ms;
  if (length <= std::min(step, speed) * ms && std::fabs(velocity) <= 2 * step) {
    Rest(target);
    return true;
  }
  // The velocity after this cycle from which the rest of the distance is just enough to brake:
  // (v + v') / 2 ms + v'^2 / 2a = length.
  const double along = distance < 0 ? -velocity : velocity;
  const double root = step * step / 4 + 2 * acceleration * length - step * along;
  const double braking = root > 0 ? std::sqrt(root) - step / 2 : 0;
  const double allowed = std::clamp(braking, 0.0, speed);
  TowardsVelocity(std::copysign(allowed, distance), acceleration, ms);
  return false;
}

}  // namespace oncard::motion::bus
