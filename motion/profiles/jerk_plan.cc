#include "motion/profiles/jerk_plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "motion/common/cube_root.h"

namespace oncard::motion {
namespace {

/// A change of velocity: the acceleration goes to its peak, stays there, and goes to 0. Only the
/// positions of the pieces are missing.
using Ramp = std::array<JerkPiece, 3>;

/// The velocity that is left when the acceleration goes to 0 at once.
double SettledVelocity(double velocity, double acceleration, double jerk) {
  return velocity + acceleration * std::fabs(acceleration) / (2 * jerk);
}

/// The fastest change to the velocity `to`.
Ramp RampTo(double to, double velocity, double acceleration, const JerkLimits& limits) {
  const double settled = SettledVelocity(velocity, acceleration, limits.jerk);
  const double sign = to < settled || (to == settled && acceleration < 0) ? -1 : 1;
  const double first = sign * acceleration;
  const double gain = sign * (to - velocity);
  double peak = std::sqrt(std::max(0.0, limits.jerk * gain + first * first / 2));
  double hold = 0;
  if (peak > limits.acceleration) {
    peak = limits.acceleration;
    // What is gained while the acceleration goes to the peak, from above if it exceeds the limit.
    const double rise = (peak - first) * (peak + first) / (2 * limits.jerk);
    const double fall = peak * peak / (2 * limits.jerk);
    hold = (gain - (first > peak ? -rise : rise) - fall) / peak;
  }
  const double before_fall = to - sign * peak * peak / (2 * limits.jerk);
  const double jerk = sign * limits.jerk;
  return {{{std::fabs(peak - first) / limits.jerk, 0, velocity, acceleration,
            first > peak ? -jerk : jerk},
           {hold, 0, before_fall - sign * peak * hold, sign * peak, 0},
           {peak / limits.jerk, 0, before_fall, sign * peak, -jerk}}};
}

double LengthOf(const Ramp& ramp) {
  double length = 0;
  for (const JerkPiece& piece : ramp) length += piece.PositionAt(piece.duration);
  return length;
}

/// The length of the ramp between rest and a velocity.
double LengthFromRest(double velocity, const JerkLimits& limits) {
  const double acceleration = limits.acceleration;
  const double jerk = limits.jerk;
  const double time = velocity * jerk >= acceleration * acceleration
                          ? velocity / acceleration + acceleration / jerk
                          : 2 * std::sqrt(velocity / jerk);
  return velocity * time / 2;
}

/// The largest velocity of a move from rest to rest over a distance > 0.
double PeakFromRest(double distance, const JerkLimits& limits) {
  if (2 * LengthFromRest(limits.velocity, limits) <= distance) return limits.velocity;
  const double acceleration = limits.acceleration;
  const double rise = acceleration / limits.jerk;
  const double peak =
      distance >= 2 * acceleration * rise * rise
          ? acceleration / 2 * (std::sqrt(rise * rise + 4 * distance / acceleration) - rise)
          : CubeRoot(distance * distance * limits.jerk / 4);
  return std::min(peak, limits.velocity);
}

/// What is left of a move; positive is towards its target.
struct Remaining {
  double distance = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// The largest velocity of a move that has begun; nothing if it must stop first. A stop that ends
/// at the target but for `slack` is the whole move.
std::optional<double> PeakInMotion(const Remaining& left, const JerkLimits& limits, double slack) {
  const auto length = [&](double peak) {
    return LengthOf(RampTo(peak, left.velocity, left.acceleration, limits)) +
           LengthFromRest(peak, limits);
  };
  const double stop = length(0);
  if (left.velocity < 0 || stop > left.distance + slack) return std::nullopt;
  if (stop > left.distance - slack) return 0;
  if (length(limits.velocity) <= left.distance) return limits.velocity;
  // Above the settled velocity the length grows with the peak. Just below it, the length is larger:
  // the velocity must fall twice.
  double low = 0;
  double high = limits.velocity;
  const double settled = SettledVelocity(left.velocity, left.acceleration, limits.jerk);
  if (settled > low && settled < high) (length(settled) <= left.distance ? low : high) = settled;
  // The interval that remains is smaller than the rounding errors of the lengths.
  constexpr int kBisections = 60;
  for (int step = 0; step < kBisections; ++step) {
    const double middle = low + (high - low) / 2;
    (length(middle) <= left.distance ? low : high) = middle;
  }
  return low;
}

/// Appends a ramp, mirrored for a motion in negative direction.
void AppendPieces(const Ramp& ramp, double direction, JerkPlan* plan) {
  for (const JerkPiece& piece : ramp) {
    plan->Append(piece.duration, direction * piece.velocity, direction * piece.acceleration,
                 direction * piece.jerk);
  }
}

/// Appends the ramp to the peak, a cruise over what the ramps leave, and the ramp to rest.
void AppendMove(const Remaining& left, double peak, double direction, const JerkLimits& limits,
                JerkPlan* plan) {
  const Ramp first = RampTo(peak, left.velocity, left.acceleration, limits);
  AppendPieces(first, direction, plan);
  if (peak == 0) return;
  const double cruise = left.distance - LengthOf(first) - LengthFromRest(peak, limits);
  plan->Append(cruise / peak, direction * peak, 0, 0);
  AppendPieces(RampTo(0, peak, 0, limits), direction, plan);
}

/// The sign of the first of the values that has one.
double FirstSign(double first, double second, double third) {
  const double value = first != 0 ? first : second != 0 ? second : third;
  return value < 0 ? -1 : 1;
}

}  // namespace

void JerkPlan::Append(double time, double velocity, double acceleration, double jerk) {
  if (!(time > 0)) return;
  assert(count < kPieceMax);
  pieces[count] = {time, end_position, velocity, acceleration, jerk};
  end_position = pieces[count].PositionAt(time);
  duration += time;
  ++count;
}

Sample JerkPlan::At(double t) const {
  if (t >= duration) {
    return {end_position + (t - duration) * end_velocity, end_velocity, 0, end_velocity != 0};
  }
  uint32_t i = 0;
  while (i + 1 < count && t >= pieces[i].duration) t -= pieces[i++].duration;
  JerkPiece piece = pieces[i];
  if (2 * t > piece.duration) {
    t -= piece.duration;
    const double jerk = piece.jerk;
    piece = i + 1 < count ? pieces[i + 1] : JerkPiece{0, end_position, end_velocity, 0, 0};
    piece.jerk = jerk;
  }
  return {piece.PositionAt(t), piece.VelocityAt(t), piece.AccelerationAt(t), true};
}

JerkPlan PlanToPosition(const Sample& from, double target, const JerkLimits& limits) {
  assert(limits.acceleration > 0 && limits.jerk > 0);
  // Without a velocity a motion stops, wherever that ends.
  if (limits.velocity == 0) return PlanToVelocity(from, 0, limits);
  JerkPlan plan;
  plan.end_position = from.position;
  double distance = target - from.position;
  double direction = FirstSign(distance, from.velocity, from.acceleration);
  Remaining left = {std::fabs(distance), direction * from.velocity, direction * from.acceleration};
  std::optional<double> peak;
  if (from.velocity != 0 || from.acceleration != 0) {
    // Rounding must not cause a reversal if the stop just fits.
    constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
    const double slack = kRounding * (1 + std::fabs(from.position) + std::fabs(target));
    peak = PeakInMotion(left, limits, slack);
    if (!peak) {
      AppendPieces(RampTo(0, from.velocity, from.acceleration, limits), 1, &plan);
      distance = target - plan.end_position;
      direction = distance < 0 ? -1 : 1;
      left = {std::fabs(distance), 0, 0};
    }
  }
  if (!peak && distance != 0) peak = PeakFromRest(left.distance, limits);
  if (peak) AppendMove(left, *peak, direction, limits, &plan);
  plan.end_position = target;
  return plan;
}

JerkPlan PlanToVelocity(const Sample& from, double target, const JerkLimits& limits) {
  assert(limits.acceleration > 0 && limits.jerk > 0);
  JerkPlan plan;
  plan.end_position = from.position;
  AppendPieces(RampTo(target, from.velocity, from.acceleration, limits), 1, &plan);
  plan.end_velocity = target;
  return plan;
}

}  // namespace oncard::motion
