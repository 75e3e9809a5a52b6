// Motion along one coordinate as pieces of constant acceleration, computed in closed form: the
// result for an instant does not depend on how often a plan is evaluated.
//
// Units: ms, pulse, pulse/ms, pulse/ms^2. Positions are absolute. Pure functions of their
// arguments; only basic arithmetic and square roots, which IEEE 754 rounds the same everywhere.
// Source: GTS manual 7.2 to 7.4 and 9.4; replanning on the fly as chapter 5.1.3 of the GE manual
// describes it. Tested by tests/motion/plan_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/common/sample.h"

namespace oncard::motion {

/// Constant acceleration for a while.
struct Piece {
  double duration = 0;
  double position = 0;  ///< at the begin of the piece, like the next two
  double velocity = 0;
  double acceleration = 0;

  double PositionAt(double t) const { return position + t * (velocity + t * (acceleration / 2)); }
  double VelocityAt(double t) const { return velocity + t * acceleration; }

  auto Fields(auto visit) const { return visit(duration, position, velocity, acceleration); }
  bool operator==(const Piece&) const = default;
};

/// Pieces one after the other. After the last one the plan rests at `end_position`, or continues
/// with `end_velocity`.
struct Plan {
  /// Reversing takes one piece to stop and three to return; a starting velocity adds none.
  static constexpr size_t kPieceMax = 5;

  std::array<Piece, kPieceMax> pieces;
  uint32_t count = 0;
  double duration = 0;      ///< of all pieces
  double end_position = 0;  ///< exact, without the rounding errors of the pieces
  double end_velocity = 0;

  /// Adds a piece of `time` ms that begins where the last one ended, at the given velocity. Nothing
  /// is added when `time` is not positive.
  void Append(double time, double velocity, double acceleration);
  /// Position, velocity and acceleration `t` ms after the plan's begin; `t` >= 0. Moving until the
  /// last piece is over, or for ever when end_velocity is not 0.
  Sample At(double t) const;

  auto Fields(auto visit) const {
    return visit(pieces, count, duration, end_position, end_velocity);
  }
  bool operator==(const Plan&) const = default;
};

/// The deceleration of a mode whose registers are `acc` and `dec`: 0 for `dec` that was not set.
inline double DecelerationOf(double acc, double dec) { return dec == 0 ? acc : dec; }

/// Velocity, acceleration, deceleration; all positive, or 0 as the velocity for standstill.
struct MoveLimits {
  double velocity = 0;
  double acceleration = 0;
  double deceleration = 0;
  /// Reached at once at the start of a move from rest, and left at once at its end; below
  /// `velocity`.
  double start_velocity = 0;

  auto Fields(auto visit) const {
    return visit(velocity, acceleration, deceleration, start_velocity);
  }
};

/// The fastest motion from (position, velocity) to rest at `target`. If it moves away from the
/// target, or is too fast to stop there, it decelerates to 0 and returns. If it is faster than
/// limits.velocity, it decelerates to that velocity first.
Plan PlanToPosition(double position, double velocity, double target, const MoveLimits& limits);

/// From (position, velocity) to the signed velocity `target`, which is then kept. |v| grows with
/// limits.acceleration and shrinks with limits.deceleration; a change of sign goes through 0.
Plan PlanToVelocity(double position, double velocity, double target, const MoveLimits& limits);

/// From (position, velocity) to rest with a constant deceleration > 0.
Plan PlanStop(double position, double velocity, double deceleration);

}  // namespace oncard::motion
