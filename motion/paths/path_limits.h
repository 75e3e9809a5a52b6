// What limits the speed along a path whose segments are planned together (path_planner.h).
//
// Any consistent units of length and time: a card uses pulses and ms; kUnlimited where there is no
// limit. The corner and curvature formulas are assumptions (docs/assumptions.md). Source: manual of
// the multi-axis look-ahead module, chapters 1 and 2 (GT_InitLookAheadEx). Tested by
// tests/motion/path_planner_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "motion/paths/segment.h"

namespace oncard::motion {

inline constexpr double kUnlimited = std::numeric_limits<double>::max();
/// Profiles that can have limits as followers (GT_SetFollowAxisParaLa).
inline constexpr size_t kFollowerMax = 8;
/// Assumption: 2 sin(15 degrees). Two lines that turn by less than 30 degrees are chords of a
/// curve, whose radius is that of the circle through their three points; a larger turn is a corner.
inline constexpr double kCurveTurnMax = 0.51763809020504152;

/// What one axis may do.
struct AxisLimits {
  double velocity = kUnlimited;
  double acceleration = kUnlimited;
  double jump = kUnlimited;  ///< change of the velocity at once

  auto Fields(auto visit) const { return visit(velocity, acceleration, jump); }
};

/// What decides how fast a path passes from a segment to the next one.
enum class JointRule : uint8_t {
  kGiven,  ///< PathSlot::end_velocity
  /// The lower of both feeds, at most PathSlot::end_velocity, and so that the path can brake into
  /// all later joints, and to rest behind the last segment of the buffer. A segment that is
  /// appended raises the velocities before it.
  kFeeds,
  /// Corners and curves, with an acceleration of their own (GT_InitLookAhead). The window holds
  /// slots, and the oldest leaves before another one enters.
  kCorners,
  /// Corners and curves with the acceleration of the segments, and what each axis may do
  /// (GT_InitLookAheadEx). The window holds segments, and the oldest leaves when another one has
  /// entered.
  kAxes,
  /// As kFeeds, but at a joint no axis of the map may change its velocity at once by more than
  /// CoordinateMap::jumps. PathSlot::end_velocity follows from that.
  kAxisJumps
};

/// The rule of a window.
struct WindowRule {
  JointRule joints = JointRule::kAxes;
  double acceleration = 0;  ///< at corners and on curves, if kCorners

  bool in_use() const { return joints != JointRule::kAxes; }
  auto Fields(auto visit) const { return visit(joints, acceleration); }
};

struct PathLimits {
  /// At a corner between the unit tangents t and u: v |u - t| <= acceleration * corner_time.
  double corner_time = 0;
  /// On a curve of radius R: v^2 <= radius_ratio * acceleration * R.
  double radius_ratio = 1;
  bool geometric = true;  ///< corners and curves limit the speed
  /// Bit n: coordinate n counts in the length of the path. A segment that moves none of them is
  /// measured with all coordinates.
  uint32_t length_axes = kAllCoordinates;
  std::array<AxisLimits, kCrdDimensionMax> axes;
  std::array<AxisLimits, kFollowerMax> followers;  ///< of profiles that follow segments
  WindowRule rule{};

  auto Fields(auto visit) const {
    return visit(corner_time, radius_ratio, geometric, length_axes, axes, followers, rule);
  }
};

/// Measures the length of a segment with the coordinates of the set `axes`. A circle counts as a
/// whole if any of its axes counts.
void MeasureLength(uint32_t axes, Segment* segment);

/// The largest speed at a corner between two unit tangents, at which it changes by at most
/// `acceleration` * `time`, measured with the coordinates of `axes`; kUnlimited without a corner.
double CornerSpeed(uint32_t axes, const Coordinates& before, const Coordinates& after,
                   double acceleration, double time);
/// The radius of the circle through a, b and c, measured with the coordinates of `axes`; kUnlimited
/// for a straight line, and where the path turns by more than a curve does.
double RadiusThrough(uint32_t axes, const Coordinates& a, const Coordinates& b,
                     const Coordinates& c);

}  // namespace oncard::motion
