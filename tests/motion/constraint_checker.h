// Checks a motion by its samples alone: velocity and acceleration within limits, position the
// integral of velocity. Pass it the output of every cycle:
//
//   ConstraintChecker checker({.velocity = 50, .acceleration = 0.25}, 0.25, AtRest(0));
//   EXPECT_TRUE(checker.Next(profile.now));
//
// If the slope of a velocity v stays within +-A, the curve of v over dt is inside a parallelogram
// around the chord from v0 to v1, so that |dp - (v0 + v1) / 2 * dt| <= A * dt^2 / 4: a larger jump
// in position is always detected.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/common/sample.h"

namespace oncard::motion {

struct MotionBounds {
  double velocity = 0;       ///< pulse/ms
  double acceleration = 0;   ///< pulse/ms^2; the larger of acceleration and deceleration
  double velocity_step = 0;  ///< pulse/ms by which velocity may jump (velStart, PT EVEN ...)
  double tolerance = 1e-6;   ///< for rounding, in each of the three checks
};

class ConstraintChecker {
 public:
  ConstraintChecker(const MotionBounds& bounds, double cycle_ms, const Sample& first)
      : bounds_(bounds), cycle_ms_(cycle_ms), last_(first), velocity_(bounds.velocity) {}

  /// Sets other limits for the next samples. A lower velocity limit applies once it has been
  /// reached.
  void SetBounds(const MotionBounds& bounds) {
    velocity_ = std::max(bounds.velocity, std::fabs(last_.velocity));
    bounds_ = bounds;
  }
  /// The same for smoothed motion, whose velocity can still rise up to the old limit.
  void SetBoundsSmoothed(const MotionBounds& bounds) {
    velocity_ = std::max(bounds.velocity, velocity_);
    bounds_ = bounds;
  }
  /// A command has moved the origin: the position continues from here.
  void MoveOrigin(double position) { last_.position = position; }

  /// Checks the sample of the next cycle.
  testing::AssertionResult Next(const Sample& sample) {
    const Sample before = last_;
    last_ = sample;
    const double tolerance = bounds_.tolerance;
    const auto fail = [&](const char* what, double is, double bound) {
      return testing::AssertionFailure()
             << what << " " << is << " exceeds " << bound << ": from p " << before.position << " v "
             << before.velocity << " to p " << sample.position << " v " << sample.velocity << " a "
             << sample.acceleration << " in " << cycle_ms_ << " ms";
    };
    if (!std::isfinite(sample.position)) return fail("position", sample.position, 0);
    const double speed = std::fabs(sample.velocity);
    if (!(speed <= velocity_ + tolerance)) return fail("velocity", speed, velocity_);
    if (speed <= bounds_.velocity) velocity_ = bounds_.velocity;
    if (!(std::fabs(sample.acceleration) <= bounds_.acceleration + tolerance)) {
      return fail("acceleration", std::fabs(sample.acceleration), bounds_.acceleration);
    }
    const double step = bounds_.acceleration * cycle_ms_ + bounds_.velocity_step;
    const double change = std::fabs(sample.velocity - before.velocity);
    if (!(change <= step + tolerance)) return fail("change of velocity", change, step);
    const double area =
        bounds_.acceleration * cycle_ms_ * cycle_ms_ / 4 + bounds_.velocity_step * cycle_ms_;
    const double gap = std::fabs(sample.position - before.position -
                                 (before.velocity + sample.velocity) / 2 * cycle_ms_);
    if (!(gap <= area + tolerance)) return fail("jump of position", gap, area);
    return testing::AssertionSuccess();
  }

 private:
  MotionBounds bounds_;
  double cycle_ms_;
  Sample last_;
  double velocity_;  ///< the current limit: above bounds_.velocity until that has been reached
};

}  // namespace oncard::motion
