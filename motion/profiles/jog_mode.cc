#include "motion/profiles/jog_mode.h"

#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<JogMode> && kFieldsComplete<JogParameters>);

constexpr Micros kStepUs = 1000;

}  // namespace

/// The plan's velocity as the input of the filter: linear between its steps, like the output. So
/// the difference between the two never exceeds that for a constant acceleration.
double JogMode::PlannedVelocity(Micros now) const {
  if (!filtered) return plan.At(MsBetween(begin, now)).velocity;
  const double last = plan.At(MsBetween(begin, step_at)).velocity;
  const double next = plan.At(MsBetween(begin, step_at + kStepUs)).velocity;
  return last + MsBetween(step_at, now) * (next - last);
}

void JogMode::Start(Micros now, const Sample& from) {
  // The filter continues from the last output, the plan from the last planned state.
  const double planned = running ? PlannedVelocity(now) : from.velocity;
  const double target = PlannedVelocityOf(velocity);
  plan = PlanToVelocity(
      from.position, planned, target,
      {std::fabs(target), parameters.acc, DecelerationOf(parameters.acc, parameters.dec), 0});
  begin = now;
  smooth = parameters.smooth;
  filtered = smooth > 0;
  step = from;
  step_at = now;
  if (filtered) PrepareStep();
  running = plan.count > 0 || target != 0 || from.velocity != 0;
}

/// Computes the filter's output 1 ms after its last step.
void JogMode::PrepareStep() {
  const double t = MsBetween(begin, step_at + kStepUs);
  const double planned = plan.At(t).velocity;
  next_velocity = smooth * step.velocity + (1 - smooth) * planned;
  if (t >= plan.duration && std::fabs(next_velocity - planned) < kJogSettled) {
    next_velocity = planned;
  }
}

void JogMode::Step() {
  step.position += (step.velocity + next_velocity) / 2;
  step.velocity = next_velocity;
  step_at += kStepUs;
  if (MsBetween(begin, step_at) >= plan.duration && step.velocity == plan.end_velocity) {
    // From here on the plan is followed directly, starting at the filter's output.
    plan = PlanToVelocity(step.position, step.velocity, step.velocity,
                          {std::fabs(step.velocity), 1, 1, 0});
    begin = step_at;
    filtered = false;
  } else {
    PrepareStep();
  }
}

Sample JogMode::At(Micros now) {
  while (filtered && now >= step_at + kStepUs) Step();
  if (!filtered) {
    const Sample planned = plan.At(MsBetween(begin, now));
    running = planned.moving;
    return planned;
  }
  const double t = MsBetween(step_at, now);
  const double acceleration = next_velocity - step.velocity;  // in 1 ms
  return {step.position + t * (step.velocity + t * (acceleration / 2)),
          step.velocity + t * acceleration, acceleration, true};
}

}  // namespace oncard::motion
