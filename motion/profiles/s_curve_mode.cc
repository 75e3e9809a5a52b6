#include "motion/profiles/s_curve_mode.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<SCurveMode> && kFieldsComplete<SCurveRun>);
static_assert(kFieldsComplete<JerkPlan> && kFieldsComplete<JerkPiece> &&
              kFieldsComplete<JerkLimits>);

}  // namespace

void SCurveMode::Start(Micros now, const Sample& from) {
  if (limits.acceleration < kRateMin || limits.jerk < kRateMin) return;
  Sample begin = from;
  // The deceleration of a stop in progress ends like it began, at once.
  if (!running) begin.acceleration = 0;
  if (!run) run.Emplace();
  run->limits = limits;
  run->limits.velocity = PlannedVelocityOf(limits.velocity);
  run->plan = PlanToPosition(begin, target, run->limits);
  run->begin = now;
  running = run->plan.count > 0;
}

void SCurveMode::StopSmoothly(Micros now, const Sample& from) {
  run->plan = PlanToVelocity(from, 0, run->limits);
  run->begin = now;
  running = run->plan.count > 0;
}

Sample SCurveMode::At(Micros now) {
  const Sample sample = run->plan.At(MsBetween(run->begin, now));
  running = sample.moving;
  return sample;
}

}  // namespace oncard::motion
