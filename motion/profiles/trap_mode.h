// Point-to-point motion (mode Trap): a trapezoidal velocity profile, smoothed by a moving average.
//
// GT_SetPos, GT_SetVel and GT_SetTrapPrm write registers; Start() commits them, at rest or in
// motion. A smoothing time of T ms replaces the plan's position by its mean over the last T ms, so
// that acceleration takes T to change and the move lasts T longer. The mean is computed in closed
// form from the pieces of the plan, also after replanning. Source: GTS manual 7.2. Tested by
// tests/motion/trap_mode_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "motion/common/sample.h"
#include "motion/common/sizes.h"
#include "motion/profiles/plan.h"

namespace oncard::motion {

/// TTrapPrm. The defaults are assumptions: the manual gives none, and a card must not divide by 0.
struct TrapParameters {
  double acc = 1;        ///< pulse/ms^2, > 0
  double dec = 0;        ///< pulse/ms^2, > 0, or 0: not set, as acc
  double vel_start = 0;  ///< pulse/ms, >= 0
  int16_t smooth_time = 0;

  auto Fields(auto visit) const { return visit(acc, dec, vel_start, smooth_time); }
  bool operator==(const TrapParameters&) const = default;
};

struct TrapMode {
  // Registers.
  TrapParameters parameters;
  int32_t target = 0;   ///< GT_SetPos
  double velocity = 0;  ///< GT_SetVel, pulse/ms; its sign does not matter

  // The run.
  bool running = false;
  Plan plan;          ///< from `begin` on
  Sample unplanned;   ///< at `begin`, before the plan's start velocity; without the mean
  Micros begin = 0;   ///< of the plan
  double smooth = 0;  ///< ms, of this run
  /// Pieces of earlier plans that the mean still needs, oldest first; before them the profile was
  /// at rest or had their first velocity.
  std::vector<Piece> past;

  /// Plans from `from` to the registers' target; a running move is replanned. No motion if the
  /// profile rests at the target, or if the velocity is 0.
  void Start(Micros now, const Sample& from);
  /// The profile's output; ends the run when the mean has reached the target.
  Sample At(Micros now);
  /// Something else has taken over; the registers stay.
  void Halt();
  /// Without what is left of a run that has ended, which nothing reads any more.
  void ForgetRun();
  /// The plan that the output follows; nullptr if it is smoothed.
  const Plan* FollowedPlan() const { return running && smooth == 0 ? &plan : nullptr; }

  auto Fields(auto visit) const {
    return visit(parameters, target, velocity, running, plan, unplanned, begin, smooth, past);
  }
};

}  // namespace oncard::motion
