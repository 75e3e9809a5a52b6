// The motion along a segment in closed form: a ramp to a velocity, that velocity, a ramp to the
// velocity at the end.
//
// Units: ms, pulse, pulse/ms, pulse/ms^2. Pure functions; only basic arithmetic and square roots.
// Tested by tests/motion/crd_test.cc.
#pragma once

#include "motion/profiles/plan.h"

namespace oncard::motion {

/// Parameters of the motion along the rest of a segment.
struct PathSpan {
  double begin = 0;         ///< position on the path where the motion begins
  double end = 0;           ///< the segment's length
  double velocity = 0;      ///< at `begin`
  double target = 0;        ///< velocity to reach, > 0
  double end_velocity = 0;  ///< at `end`; the nearest reachable one is taken
  double acceleration = 0;
  double even_time = 0;      ///< minimum time of the constant velocity, ms
  double rest_velocity = 0;  ///< a stop ends at once from this velocity
};

/// Plans velocity -> target -> end_velocity. A velocity above the target is reduced to it first.
Plan PlanSpan(const PathSpan& span);

/// Decelerates to span.rest_velocity and rests, or to the segment's end, where the stop continues
/// in the next segment. The deceleration is at least what is needed to reach span.end_velocity at
/// the end.
Plan PlanSpanStop(const PathSpan& span, double deceleration);

/// Appends a change of the velocity from `from` to `to` over `distance` with constant acceleration;
/// nothing if both are 0.
void AppendRamp(double from, double to, double distance, Plan* plan);

}  // namespace oncard::motion
