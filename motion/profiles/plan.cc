#include "motion/profiles/plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace oncard::motion {
namespace {

double Sign(double value) { return value < 0 ? -1 : 1; }

/// A motion from speed `from` in `direction` over `distance` to the speed `last`, from which it
/// stops at once. 0 <= last <= from, and the distance is sufficient to brake from `from` to `last`.
struct Approach {
  double direction = 1;
  double from = 0;
  double last = 0;
  double distance = 0;
};

/// Appends acceleration, or deceleration to the velocity limit; cruise; deceleration.
void AppendApproach(const Approach& approach, const MoveLimits& limits, Plan* plan) {
  const double v0 = approach.from;
  const double last = approach.last;
  const double acc = limits.acceleration;
  const double dec = limits.deceleration;
  const double dir = approach.direction;
  if (v0 > limits.velocity) {
    const double v = limits.velocity;
    const double fall = (v0 - v) / dec;
    const double stop = (v - last) / dec;
    const double cruised = approach.distance - (v0 * v0 - last * last) / (2 * dec);
    plan->Append(fall, dir * v0, -dir * dec);
    if (v > 0) plan->Append(std::max(0.0, cruised) / v, dir * v, 0);
    plan->Append(stop, dir * v, -dir * dec);
    return;
  }
  double v = limits.velocity;
  double rise_distance = (v * v - v0 * v0) / (2 * acc);
  double fall_distance = (v * v - last * last) / (2 * dec);
  if (rise_distance + fall_distance > approach.distance) {
    // Without cruise: v^2 = v0^2 + 2 acc s1 = last^2 + 2 dec s2 with s1 + s2 = distance.
    v = std::sqrt((2 * acc * dec * approach.distance + dec * v0 * v0 + acc * last * last) /
                  (acc + dec));
    v = std::max({v, v0, last});
    rise_distance = (v * v - v0 * v0) / (2 * acc);
    fall_distance = approach.distance - rise_distance;
  }
  const double cruise = approach.distance - rise_distance - fall_distance;
  plan->Append((v - v0) / acc, dir * v0, dir * acc);
  if (v > 0) plan->Append(cruise / v, dir * v, 0);
  plan->Append((v - last) / dec, dir * v, -dir * dec);
}

Plan BeginAt(double position) {
  Plan plan;
  plan.end_position = position;
  return plan;
}

}  // namespace

void Plan::Append(double time, double velocity, double acceleration) {
  if (!(time > 0)) return;
  assert(count < kPieceMax);
  pieces[count] = {time, end_position, velocity, acceleration};
  end_position = pieces[count].PositionAt(time);
  duration += time;
  ++count;
}

Sample Plan::At(double t) const {
  if (t >= duration) {
    return {end_position + (t - duration) * end_velocity, end_velocity, 0, end_velocity != 0};
  }
  uint32_t i = 0;
  while (i + 1 < count && t >= pieces[i].duration) t -= pieces[i++].duration;
  return {pieces[i].PositionAt(t), pieces[i].VelocityAt(t), pieces[i].acceleration, true};
}

Plan PlanToPosition(double position, double velocity, double target, const MoveLimits& limits) {
  assert(limits.acceleration > 0 && limits.deceleration > 0);
  Plan plan = BeginAt(position);
  double distance = target - position;
  double from = velocity;
  const double start = std::min(limits.start_velocity, limits.velocity);
  const double last = std::min(start, std::fabs(velocity));
  const double stop_distance = (velocity * velocity - last * last) / (2 * limits.deceleration);
  // Rounding must not cause a reversal if the stop just fits.
  const double slack = 1e-9 * (1 + std::fabs(distance));
  if (velocity != 0 &&
      (velocity * distance < 0 || distance == 0 || stop_distance > std::fabs(distance) + slack)) {
    plan.Append(std::fabs(velocity) / limits.deceleration, velocity,
                -Sign(velocity) * limits.deceleration);
    distance = target - plan.end_position;
    from = 0;
  }
  if (distance != 0 && limits.velocity > 0) {
    const double speed = from == 0 ? start : std::fabs(from);
    AppendApproach({Sign(distance), speed, std::min(start, speed), std::fabs(distance)}, limits,
                   &plan);
    plan.end_position = target;
  } else if (from != 0) {
    // A velocity limit of 0 while moving: stop with the deceleration, wherever that ends.
    plan.Append(std::fabs(from) / limits.deceleration, from, -Sign(from) * limits.deceleration);
  }
  plan.end_velocity = 0;
  return plan;
}

Plan PlanToVelocity(double position, double velocity, double target, const MoveLimits& limits) {
  assert(limits.acceleration > 0 && limits.deceleration > 0);
  Plan plan = BeginAt(position);
  double from = velocity;
  const bool reverses = from * target < 0;
  if (reverses || std::fabs(from) > std::fabs(target)) {
    const double to = reverses ? 0 : target;
    plan.Append(std::fabs(from - to) / limits.deceleration, from,
                -Sign(from) * limits.deceleration);
    from = to;
  }
  plan.Append(std::fabs(target - from) / limits.acceleration, from,
              Sign(target) * limits.acceleration);
  plan.end_velocity = target;
  return plan;
}

Plan PlanStop(double position, double velocity, double deceleration) {
  assert(deceleration > 0);
  Plan plan = BeginAt(position);
  plan.Append(std::fabs(velocity) / deceleration, velocity, -Sign(velocity) * deceleration);
  return plan;
}

}  // namespace oncard::motion
