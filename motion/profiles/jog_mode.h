// Constant velocity (mode Jog): GT_SetVel and GT_SetJogPrm write registers, Start() commits them.
//
// Without smoothing the motion is a plan in closed form. With a smoothing factor k in (0, 1) the
// plan's velocity goes through a first-order filter that keeps k of itself per millisecond. The
// filter steps at whole milliseconds after the start, whatever the profile cycle is; between its
// steps velocity is linear, and position is its integral (assumptions: the manual only says
// that the factor makes velocity changes smoother). Source: GTS manual 7.3. Tested by
// tests/motion/jog_mode_test.cc.
#pragma once

#include <cstdint>

#include "motion/common/sample.h"
#include "motion/common/sizes.h"
#include "motion/profiles/plan.h"

namespace oncard::motion {

/// TJogPrm; the defaults are assumptions, as in TrapParameters.
struct JogParameters {
  double acc = 1;     ///< pulse/ms^2, > 0
  double dec = 0;     ///< pulse/ms^2, > 0, or 0: not set, as acc
  double smooth = 0;  ///< in [0, 1)

  auto Fields(auto visit) const { return visit(acc, dec, smooth); }
  bool operator==(const JogParameters&) const = default;
};

/// The filter has caught up with the plan if the difference is smaller than this, pulse/ms.
inline constexpr double kJogSettled = 1e-6;

struct JogMode {
  // Registers.
  JogParameters parameters;
  double velocity = 0;  ///< signed, pulse/ms

  // The run.
  bool running = false;
  Plan plan;
  Micros begin = 0;       ///< of the plan
  double smooth = 0;      ///< of this run
  bool filtered = false;  ///< the output still lags behind the plan
  Sample step;            ///< output at the filter's last step
  Micros step_at = 0;
  double next_velocity = 0;  ///< 1 ms later

  /// Plans from `from` to the velocity of the register; a running motion is replanned.
  void Start(Micros now, const Sample& from);
  /// The profile's output. Ends the run when the velocity has reached 0.
  Sample At(Micros now);
  /// Something else has taken over; the registers stay.
  void Halt() { running = false; }
  /// The plan that the output follows; nullptr while it is filtered.
  const Plan* FollowedPlan() const { return running && !filtered ? &plan : nullptr; }

  auto Fields(auto visit) const {
    return visit(parameters, velocity, running, plan, begin, smooth, filtered, step, step_at,
                 next_velocity);
  }

 private:
  double PlannedVelocity(Micros now) const;
  void PrepareStep();
  void Step();
};

}  // namespace oncard::motion
