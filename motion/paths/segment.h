// The geometry of a path's segments: lines in up to four coordinates, arcs in a plane or in space,
// helices. A segment runs from its start (the end of the one before) to its end.
//
// Units: pulses, radians. The direction of an arc is seen from the positive third axis:
// counter-clockwise turns the first axis of the plane (XY, YZ, ZX) towards the second. Pure
// functions; deterministic. Source: GTS manuals' segment commands. Tested by
// tests/motion/segment_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "motion/paths/coordinates.h"

namespace oncard::motion {

/// Assumption: by how much an arc's two radii, or half the chord and the radius, may differ, unless
/// the caller says otherwise.
inline constexpr double kArcTolerance = 1;

enum class SegmentShape : uint8_t { kLine, kArc };

/// The plane of an arc: two axes, and the one from which the arc's direction is seen.
struct ArcPlane {
  uint8_t first = 0;
  uint8_t second = 1;
  uint8_t normal = 2;
};
inline constexpr ArcPlane kXyPlane = {0, 1, 2};
inline constexpr ArcPlane kYzPlane = {1, 2, 0};
inline constexpr ArcPlane kZxPlane = {2, 0, 1};

struct Segment {
  SegmentShape shape = SegmentShape::kLine;
  Coordinates start{};
  Coordinates end{};
  double length = 0;
  /// Line: end - start. Arc: the part that is linear in the angle (helix).
  Coordinates travel{};
  // Arcs only.
  Coordinates centre{};
  Coordinates toward_start{};  ///< unit vector from the centre to the start
  Coordinates sideways{};      ///< unit vector of the motion at the start of a circle
  double radius = 0;           ///< at the start
  double radius_change = 0;    ///< change from start to end, distributed evenly
  double sweep = 0;            ///< angle, > 0

  /// The point `path` pulses from the start; exact at the end.
  Coordinates PointAt(double path) const;
  /// The change of the point per pulse of path.
  Coordinates TangentAt(double path) const;
  /// The change of the tangent per pulse of path.
  Coordinates CurvatureAt(double path) const;

  auto Fields(auto visit) const {
    return visit(shape, start, end, length, travel, centre, toward_start, sideways, radius,
                 radius_change, sweep);
  }
};

/// Empty if start and end coincide.
std::optional<Segment> MakeLine(const Coordinates& start, const Coordinates& end);

/// An arc or helix of a radius: a positive one sweeps at most 180 degrees, a negative one more.
/// Empty when the chord is 0 or does not fit a circle of the radius.
std::optional<Segment> MakeArcWithRadius(const Coordinates& start, const Coordinates& end,
                                         ArcPlane plane, double radius, bool counter_clockwise,
                                         double tolerance = kArcTolerance);

/// An arc or helix around start + (first, second) in its plane; a full turn if start and end
/// coincide. Empty when the radius is 0, or start and end differ in their distances from the
/// centre.
std::optional<Segment> MakeArcAroundCentre(const Coordinates& start, const Coordinates& end,
                                           ArcPlane plane, double first, double second,
                                           bool counter_clockwise,
                                           double tolerance = kArcTolerance);

/// An arc around start + (first, second) in its plane that sweeps an angle in (0, 2 pi], which
/// gives its end. Empty when the radius is 0, or the arc too short for a double.
std::optional<Segment> MakeArcWithSweep(const Coordinates& start, ArcPlane plane, double first,
                                        double second, double sweep, bool counter_clockwise);

/// The arc in X, Y, Z from start through `between` to end. Empty if the three points are not on a
/// circle.
std::optional<Segment> MakeArcThroughPoint(const Coordinates& start, const Coordinates& end,
                                           const std::array<double, 3>& between);

}  // namespace oncard::motion
