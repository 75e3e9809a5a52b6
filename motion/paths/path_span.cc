#include "motion/paths/path_span.h"

#include <algorithm>
#include <cmath>

namespace oncard::motion {
namespace {

/// Rounding must not make an end velocity unreachable that can just be reached.
constexpr double kReachSlack = 1 + 1e-9;

}  // namespace

void AppendRamp(double from, double to, double distance, Plan* plan) {
  if (!(from + to > 0)) return;
  plan->Append(2 * distance / (from + to), from, (to * to - from * from) / (2 * distance));
}

Plan PlanSpan(const PathSpan& span) {
  Plan plan;
  plan.end_position = span.begin;
  const double distance = span.end - span.begin;
  const double acc = span.acceleration;
  const double from = span.velocity;
  double last = std::min(span.end_velocity, span.target);
  if (distance > 0) {
    const double square = from * from;
    const double gain = 2 * acc * distance;
    if (square - last * last >= gain) {
      // Decelerate along the whole distance.
      if (square - last * last > gain * kReachSlack) last = std::sqrt(square - gain);
      AppendRamp(from, last, distance, &plan);
    } else if (last * last - square >= gain) {
      if (last * last - square > gain * kReachSlack) last = std::sqrt(square + gain);
      AppendRamp(from, last, distance, &plan);
    } else {
      double peak = span.target;
      if (from <= peak) {
        // Ramps to the peak, even_time at it, a ramp to the end: v^2/a + v te = energy / a.
        const double energy = acc * distance + (square + last * last) / 2;
        const double te = span.even_time;
        const double half = acc * te / 2;
        const double root = std::sqrt(half * half + energy);
        // root - half, which would lose precision for a short distance and a long even_time.
        peak = std::min(peak, half == 0 ? root : energy / (root + half));
        peak = std::max({peak, from, last});
      }
      const double rise = std::fabs(peak * peak - square) / (2 * acc);
      const double fall = (peak * peak - last * last) / (2 * acc);
      const double slope = from <= peak ? acc : -acc;
      plan.Append(std::fabs(peak - from) / acc, from, slope);
      if (peak > 0) plan.Append((distance - rise - fall) / peak, peak, 0);
      plan.Append((peak - last) / acc, peak, -acc);
    }
  } else {
    last = from;
  }
  plan.end_position = span.end;
  plan.end_velocity = last;
  return plan;
}

Plan PlanSpanStop(const PathSpan& span, double deceleration) {
  Plan plan;
  plan.end_position = span.begin;
  const double distance = span.end - span.begin;
  const double square = span.velocity * span.velocity;
  if (!(distance > 0)) {
    plan.end_velocity = span.velocity;
    return plan;
  }
  const double rest = std::min(span.rest_velocity, span.velocity);
  const double last = std::max(std::min(span.end_velocity, span.velocity), rest);
  const double needed = (square - last * last) / (2 * distance);
  const double dec = std::max(deceleration, needed);
  if (square - rest * rest <= 2 * dec * distance) {
    plan.Append((span.velocity - rest) / dec, span.velocity, -dec);
    plan.end_position = std::min(plan.end_position, span.end);
    return plan;
  }
  plan.end_velocity = std::sqrt(square - 2 * dec * distance);
  AppendRamp(span.velocity, plan.end_velocity, distance, &plan);
  plan.end_position = span.end;
  return plan;
}

}  // namespace oncard::motion
