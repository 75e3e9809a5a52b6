#include "motion/jog_mode.h"

#include <cmath>

#include "motion/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<JogMode> && kFieldsComplete<JogParameters>);

/// base^(microseconds / 1000) for whole multiples of 125 us: square roots and products, which are
/// the same on every machine.
double PowerOfMs(double base, Micros microseconds) {
  double factor = std::sqrt(std::sqrt(std::sqrt(base)));
  double result = 1;
  for (Micros eighths = microseconds / 125; eighths > 0; eighths /= 2) {
    if (eighths % 2 != 0) result *= factor;
    factor *= factor;
  }
  return result;
}

}  // namespace

void JogMode::Start(Micros now, const Sample& from) {
  // The filter goes on from what came out; the plan goes on from what it planned.
  const double planned = running ? plan.At(MsBetween(begin, now)).velocity : from.velocity;
  output = from;
  plan = PlanToVelocity(from.position, planned, velocity,
                        {std::fabs(velocity), parameters.acc, parameters.dec, 0});
  begin = now;
  last = now;
  smooth = parameters.smooth;
  filtered = smooth > 0;
  running = plan.count > 0 || velocity != 0 || from.velocity != 0;
}

Sample JogMode::At(Micros now) {
  Sample planned = plan.At(MsBetween(begin, now));
  if (!filtered) {
    running = planned.moving;
    return planned;
  }
  const double dt = MsBetween(last, now);
  if (dt > 0) {
    const double k = PowerOfMs(smooth, now - last);
    double v = k * output.velocity + (1 - k) * planned.velocity;
    const bool settled = std::fabs(v - planned.velocity) < kJogSettled;
    if (settled) v = planned.velocity;
    output = {output.position + (output.velocity + v) / 2 * dt, v, (v - output.velocity) / dt,
              true};
    last = now;
    if (settled && !(MsBetween(begin, now) < plan.duration)) {
      // From here on the plan can be followed directly, from where the filter got to.
      plan = PlanToVelocity(output.position, v, v, {std::fabs(v), 1, 1, 0});
      begin = now;
      filtered = false;
      running = v != 0;
      output.moving = running;
    }
  }
  return output;
}

}  // namespace oncard::motion
