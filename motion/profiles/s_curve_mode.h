// Point-to-point motion whose acceleration is continuous (mode S): velocity, acceleration and jerk
// have limits.
//
// Start() commits the registers, at rest or in motion: target and limits may all have changed.
// StopSmoothly() ends the motion within the limits of its run; the registers stay, and the next
// start goes on to the target. Source: GE manual 5.2, 5.5, GT400 manual 4.1.1; GTS cards do not
// have the mode. Tested by tests/motion/s_curve_mode_test.cc.
#pragma once

#include <cstdint>

#include "motion/common/rare.h"
#include "motion/common/sample.h"
#include "motion/common/sizes.h"
#include "motion/profiles/jerk_plan.h"

namespace oncard::motion {

/// What a run of mode S follows.
struct SCurveRun {
  JerkPlan plan;
  Micros begin = 0;   ///< of the plan
  JerkLimits limits;  ///< of this run

  auto Fields(auto visit) const { return visit(plan, begin, limits); }
};

struct SCurveMode {
  // Registers.
  JerkLimits limits;  ///< pulse/ms, pulse/ms^2, pulse/ms^3, >= 0
  int32_t target = 0;

  // The run.
  bool running = false;
  Rare<SCurveRun> run;  ///< the newest one; few cards have it

  /// Plans from `from` to the registers' target; a running move is planned again. No motion if the
  /// profile rests at the target, or if the velocity is 0. Without an acceleration or a jerk
  /// nothing begins and nothing changes.
  void Start(Micros now, const Sample& from);
  /// Plans from `from` to rest; only while the mode runs.
  void StopSmoothly(Micros now, const Sample& from);
  /// The profile's output; ends the run at the target.
  Sample At(Micros now);
  /// Something else has taken over; the registers stay.
  void Halt() { running = false; }

  /// False on a card on which nothing of the mode has ever been set.
  bool in_use() const { return run || target != 0 || limits != JerkLimits{}; }
  auto Fields(auto visit) const { return visit(limits, target, running, run); }
};

}  // namespace oncard::motion
