// How the axes of a card follow a path that has coordinates of its own: axis n is at
// M_n q + c_n, where q are the coordinates and M_n is a row of numbers that a host gives to the
// axis.
//
// The rows need not determine the coordinates, nor agree with each other. Where the coordinates are
// found from the positions of the axes, each row that is independent of those of lower numbers is
// an equation; a dependent one is ignored, and its axis jumps when the path moves on. Coordinates
// that the equations leave open stay where they are; where there is a choice, those of higher
// numbers.
//
// Units: positions of axes in pulses; coordinates in any unit of length. Deterministic: basic
// arithmetic and square roots only. Nothing is allocated. Source: GT manual 5.1. Tested by
// tests/motion/coordinate_map_test.cc.
#pragma once

#include <array>
#include <cstddef>

#include "motion/paths/coordinates.h"
#include "motion/paths/path_limits.h"

namespace oncard::motion {

/// Axes that can be mapped: the first ones of a card.
inline constexpr size_t kMappedAxisMax = 4;
using MappedPositions = std::array<double, kMappedAxisMax>;

/// An axis: the sum of each coordinate with its coefficient, and the offset.
struct MapRow {
  Coordinates coefficients{};
  double offset = 0;

  auto Fields(auto visit) const { return visit(coefficients, offset); }
};

struct CoordinateMap {
  std::array<MapRow, kMappedAxisMax> rows{};  ///< without coefficients: the axis is not mapped
  /// By how much the velocity of each axis may change at once, > 0.
  std::array<double, kMappedAxisMax> jumps = {kUnlimited, kUnlimited, kUnlimited, kUnlimited};
  /// An axis that is stopped stops the path; otherwise it leaves the map, and the path goes on.
  bool stops_together = true;
  bool held = false;  ///< an axis has stopped the path since its owner has forgotten that

  /// True if the axis is mapped.
  bool Has(size_t axis) const;
  /// Where a point of the path puts an axis.
  double PositionOf(size_t axis, const Coordinates& point) const;
  /// What a direction of the path is for an axis.
  double Along(size_t axis, const Coordinates& direction) const;
  /// The largest speed with which the direction of the path may turn at once by `turn`;
  /// kUnlimited if that moves no axis.
  double SpeedAtTurn(const Coordinates& turn) const;
  /// The point at which the axes are. Coordinates that they do not determine are those of
  /// `present`, which is the result if it puts all of them where they are.
  Coordinates PointOf(const MappedPositions& axes, const Coordinates& present) const;

  auto Fields(auto visit) const { return visit(rows, jumps, stops_together, held); }
};

}  // namespace oncard::motion
