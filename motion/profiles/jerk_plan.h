// Motion along one coordinate as pieces of constant jerk, computed in closed form like the pieces
// of constant acceleration in plan.h: the acceleration is continuous (S curve).
//
// Units: ms, pulse, pulse/ms, pulse/ms^2, pulse/ms^3, or the same with another unit of time.
// Positions are absolute. Pure functions of their arguments; only basic arithmetic and square
// roots, which IEEE 754 rounds the same everywhere. Each half of a piece is evaluated from its own
// end, so that a motion from rest to rest never goes back by rounding, and ends exactly.
// Source: GE manual 5.2 and 5.5, GT400 manual 4.1.1. Tested by tests/motion/jerk_plan_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/common/sample.h"

namespace oncard::motion {

/// Constant jerk for a while.
struct JerkPiece {
  double duration = 0;
  double position = 0;  ///< at the begin of the piece, like the next three
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;

  double PositionAt(double t) const {
    return position + t * (velocity + t * (acceleration / 2 + t * (jerk / 6)));
  }
  double VelocityAt(double t) const { return velocity + t * (acceleration + t * (jerk / 2)); }
  double AccelerationAt(double t) const { return acceleration + t * jerk; }

  auto Fields(auto visit) const { return visit(duration, position, velocity, acceleration, jerk); }
  bool operator==(const JerkPiece&) const = default;
};

/// Pieces one after the other. After the last one the plan rests at `end_position`, or continues
/// with `end_velocity`.
struct JerkPlan {
  /// Reversing takes three pieces to stop, and three, a cruise and three to return.
  static constexpr size_t kPieceMax = 10;

  std::array<JerkPiece, kPieceMax> pieces;
  uint32_t count = 0;
  double duration = 0;      ///< of all pieces
  double end_position = 0;  ///< exact, without the rounding errors of the pieces
  double end_velocity = 0;

  /// Adds a piece of `time` that begins where the last one ended, at the given velocity and
  /// acceleration. Nothing is added when `time` is not positive.
  void Append(double time, double velocity, double acceleration, double jerk);
  /// Position, velocity and acceleration at the time `t` >= 0 after the plan's begin. Moving until
  /// the last piece is over, or for ever when end_velocity is not 0.
  Sample At(double t) const;

  auto Fields(auto visit) const {
    return visit(pieces, count, duration, end_position, end_velocity);
  }
  bool operator==(const JerkPlan&) const = default;
};

/// The largest velocity, acceleration (and deceleration) and jerk; all positive, or 0 as the
/// velocity for standstill.
struct JerkLimits {
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;

  auto Fields(auto visit) const { return visit(velocity, acceleration, jerk); }
  bool operator==(const JerkLimits&) const = default;
};

/// From a state of motion to rest at `target`: to the largest velocity from which the target can
/// still be reached, and from there to rest. A motion away from the target, or one that cannot stop
/// before it, stops first and returns (assumption: the manuals only show that it does). What
/// exceeds the limits at the begin is brought back with the jerk.
JerkPlan PlanToPosition(const Sample& from, double target, const JerkLimits& limits);

/// From a state of motion to the signed velocity `target`, which is then kept, in the shortest
/// time. With a target of 0: the smooth stop. limits.velocity does not matter.
JerkPlan PlanToVelocity(const Sample& from, double target, const JerkLimits& limits);

}  // namespace oncard::motion
