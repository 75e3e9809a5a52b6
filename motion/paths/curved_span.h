// How fast an arc can be passed when the velocities and accelerations of its axes are limited. The
// directions of the axes change along an arc, and with them what its path may do: the arc is
// divided into cells of constant path acceleration u, and in each cell
//
//   |u t_i + x k_i| <= aMax_i,   x t_i^2 <= vMax_i^2,   |u| <= acceleration,   x <= top
//
// must hold, where x is the square of the speed, linear along a cell, t the tangent and k its
// change along the path. The rows are linear in (x, u) and are required at both ends and in the
// middle of each cell. A pass backward finds the largest x from which the end can still be reached,
// a pass forward the fastest motion below it: time-optimal path parameterisation on a grid.
//
// Any consistent units. Pure functions; deterministic: only basic arithmetic, square roots and
// SineAndCosine. Nothing is allocated but by PlanCurve, if the vector has no capacity for
// kCurveNodeMax numbers. Source: manual of the multi-axis look-ahead module, aMax and vMax of
// TLookAheadParameter. Tested by tests/motion/path_optimum_test.cc and planned_run_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/paths/segment.h"

namespace oncard::motion {

/// An arc with what limits it.
struct CurvedSpan {
  const Segment& segment;
  double top = 0;           ///< the largest square of the speed
  double acceleration = 0;  ///< along the path
  const Coordinates& axis_velocity;
  const Coordinates& axis_acceleration;
};

/// Cells of a full circle; an arc has its share, at least kCurveCellMin.
inline constexpr size_t kCurveCellMax = 256;
inline constexpr size_t kCurveCellMin = 4;
inline constexpr size_t kCurveNodeMax = kCurveCellMax + 1;

/// True if the limits of the axes can hold back a motion along the arc that keeps the others.
bool IsHeldBack(const CurvedSpan& span);

/// The largest square of the speed at the arc's start from which `end_square` at its end, or less,
/// can be reached.
double CurveReach(const CurvedSpan& span, double end_square);

/// The fastest motion from `begin` to the end of the arc: squares of the speed at the ends of equal
/// cells. It begins with `begin_square`; if that is too fast, the speed falls as quickly as the
/// axes allow. The last element is at most `end_square` if that can be reached.
void PlanCurve(const CurvedSpan& span, double begin, double begin_square, double end_square,
               std::vector<double>* squares);

/// The square of the speed at the end of PlanCurve from the arc's start.
double CurveEnd(const CurvedSpan& span, double begin_square, double end_square);

/// The motion along an arc that is being executed.
struct CurveRun {
  double begin = 0;  ///< position on the path where the motion begins
  double step = 0;   ///< length of a cell
  uint32_t cell = 0;
  std::vector<double> squares;

  bool in_use() const { return !squares.empty(); }
  bool AtLast() const { return cell + size_t{2} >= squares.size(); }
  auto Fields(auto visit) const { return visit(begin, step, cell, squares); }
};

}  // namespace oncard::motion
