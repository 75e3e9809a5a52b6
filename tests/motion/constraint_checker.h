// Judges a motion from its samples alone: velocity and acceleration within bounds, position the
// integral of velocity. Feed it the output of every cycle:
//
//   ConstraintChecker checker({.velocity = 50, .acceleration = 0.25}, 0.25, AtRest(0));
//   EXPECT_TRUE(checker.Next(profile.now));
//
// For a velocity v whose slope stays within +-A, v over dt lies inside a parallelogram on the chord
// from v0 to v1, so that |dp - (v0 + v1) / 2 * dt| <= A * dt^2 / 4: a jump in position larger than
// that cannot hide.
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
  double tolerance = 1e-6;   ///< for rounding, in each of the three
};

class ConstraintChecker {
 public:
  ConstraintChecker(const MotionBounds& bounds, double cycle_ms, const Sample& first)
      : bounds_(bounds), cycle_ms_(cycle_ms), last_(first), velocity_(bounds.velocity) {}

  /// Other bounds from the next sample on. A lower velocity counts once it has been reached.
  void SetBounds(const MotionBounds& bounds) {
    velocity_ = std::max(bounds.velocity, std::fabs(last_.velocity));
    bounds_ = bounds;
  }
  /// The same for smoothed motion, whose velocity can still rise towards the old bound.
  void SetBoundsSmoothed(const MotionBounds& bounds) {
    velocity_ = std::max(bounds.velocity, velocity_);
    bounds_ = bounds;
  }
  /// A command has moved the origin: the position is continuous from here.
  void MoveOrigin(double position) { last_.position = position; }

  /// Judges the sample of the next cycle.
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
  double velocity_;  ///< the bound in force: above bounds_.velocity until that has been reached
};

}  // namespace oncard::motion
