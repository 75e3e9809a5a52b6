// PVT tables: motions over time that any profile can run, computed once from a description.
//
// All descriptions result in pieces of constant jerk: points with velocities (one, or one for each
// side), points of a smooth curve, points with the percentage of each interval in which the
// acceleration changes, points with limits of velocity and acceleration, from which the times are
// computed. A filled table never changes, so runs and snapshots share it.
//
// Units: ms, pulse, pulse/ms, pulse/ms^2. Pure functions; the describing arrays are equally long.
// Source: GTS manual 7.7 and its examples 6-17 to 6-20. Tested by tests/motion/pvt_mode_test.cc.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "motion/common/sample.h"

namespace oncard::motion {

/// Constant jerk from `begin` to the next piece.
struct PvtPiece {
  double begin = 0;     ///< in the time of the table, ms
  double position = 0;  ///< from the first point, as are the next two at the piece's begin
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;

  auto Fields(auto visit) const { return visit(begin, position, velocity, acceleration, jerk); }
};

struct PvtTable {
  double begin = 0;   ///< time of the first point: the start of a run waits for it
  double end = 0;     ///< time of the last point
  double travel = 0;  ///< from the first point to the last
  std::vector<PvtPiece> pieces;

  /// Assumption: storage that the description takes, a piece each and one for the last point.
  size_t slots() const { return pieces.size() + 1; }
  double period() const { return end - begin; }
  /// The direction of the first motion, as a sign; 0: there is none.
  double Direction() const;
  /// The motion at a time in [0, end], positions counting from the first point.
  Sample At(double t) const;

  auto Fields(auto visit) const { return visit(begin, end, travel, pieces); }
};

/// A shared table in profiles and snapshots; nullptr for a table that is not filled.
using PvtTablePointer = std::shared_ptr<const PvtTable>;

/// Times at least this far apart; assumption: shorter intervals cannot be distinguished from 0, and
/// the number of passes in a profile cycle stays bounded.
inline constexpr double kPvtIntervalMin = 0.001;

/// GT_PvtTableEx: a cubic for every interval, which begins with begin_velocities[i] and ends with
/// end_velocities[i + 1]. GT_PvtTable is the same with one array. Times increase.
PvtTable PvtFromVelocities(std::span<const double> times, std::span<const double> positions,
                           std::span<const double> begin_velocities,
                           std::span<const double> end_velocities);

/// Position after t ms in an interval: p + t (c + t (b + t a)).
struct CubicCoefficients {
  double a = 0;
  double b = 0;
  double c = 0;
};

/// GT_PvtTableComplete: the cubic spline with continuous acceleration and the given end velocities.
/// One element per point; the last one has the end velocity and half of the end acceleration.
std::vector<CubicCoefficients> SplineCoefficients(std::span<const double> times,
                                                  std::span<const double> positions,
                                                  double begin_velocity, double end_velocity);
PvtTable PvtFromCubics(std::span<const double> times, std::span<const double> positions,
                       std::span<const CubicCoefficients> cubics);

/// GT_PvtPercentCalculate: velocities of the points when acceleration in every interval is
/// symmetric, so that its mean velocity lies halfway between those of its ends.
std::vector<double> PercentVelocities(std::span<const double> times,
                                      std::span<const double> positions, double begin_velocity);
/// GT_PvtTablePercent: acceleration grows in the first half of percents[i] of interval i (0..100)
/// and vanishes in the second half of it.
PvtTable PvtFromPercents(std::span<const double> times, std::span<const double> positions,
                         std::span<const double> percents, double begin_velocity);

/// Row i describes the interval from point i to point i + 1; the last row only its velocity.
struct ContinuousRow {
  double position = 0;
  double velocity = 0;      ///< at the point; its direction is that of the motion
  double percent = 0;       ///< of every change of velocity: acceleration changes; 0..100
  double velocity_max = 0;  ///< absolute
  double acceleration = 0;  ///< peak, > 0
  double deceleration = 0;  ///< peak, > 0
};

/// The first impossible interval: without a distance, with a velocity against the motion or above
/// the maximum, or too short for the velocities at its ends. The number of intervals if all are
/// possible.
size_t FirstImpossibleInterval(std::span<const ContinuousRow> rows);
/// GT_PvtTableContinuous: in every interval from its start velocity to the maximum, or as close as
/// the distance allows, and to its end velocity. All intervals must be possible.
PvtTable PvtFromLimits(std::span<const ContinuousRow> rows, double begin_time);
/// GT_PvtContinuousCalculate: the times of the points, the first at 0.
std::vector<double> ContinuousTimes(std::span<const ContinuousRow> rows);

}  // namespace oncard::motion
