// The lines and arcs that path commands ask for, read by the names of their parameters: x, y, z, a
// and x_end ... are an end, x_center ... a centre, with angle, r and direction. Tested by
// tests/gtcalls/ge/path_command_test.cc and tests/gtcalls/gt400/path_command_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "gtcalls/card.h"
#include "motion/paths/segment.h"

namespace oncard::gtcalls {

struct SegmentRequest {
  size_t dimension = 2;  ///< the coordinates that must be there: two in XY, three in YZ
  motion::Coordinates end{};
  uint32_t given = 0;  ///< bit n: coordinate n of the end is given
  // Arcs.
  motion::ArcPlane plane = motion::kXyPlane;
  std::optional<std::array<double, 2>> centre;
  double angle = 0;  ///< degrees, with a centre
  std::optional<double> radius;
  int direction = 1;  ///< with a radius: 1 counter-clockwise, -1 clockwise

  bool is_arc() const { return centre.has_value() || radius.has_value(); }
  /// The end of the segment; coordinates that are not given are those of its start.
  motion::Coordinates EndFrom(const motion::Coordinates& start) const;
};

/// Reads the arguments of a line or an arc; lengths are multiplied by `scale`.
SegmentRequest ReadSegment(const Call& call, double scale);

/// 0, or 7 unless an arc turns in one of the two directions.
int16_t CheckDirection(Call& call, const SegmentRequest& request);

/// What is wrong with a segment.
enum class SegmentFault : uint8_t {
  kNone,
  kNoLength,     ///< of a line
  kNoRadius,     ///< the start of an arc is its centre
  kNoAngle,      ///< of an arc around a centre
  kNoChord,      ///< the radius of an arc is 0, or it ends where it starts
  kChordTooLong  ///< for its radius
};

struct SegmentResult {
  std::optional<motion::Segment> segment;
  SegmentFault fault = SegmentFault::kNone;
};
/// The segment from a point on. Half of a chord may be longer than the radius by `tolerance`.
SegmentResult MakeSegment(const motion::Coordinates& start, const SegmentRequest& request,
                          double tolerance);

}  // namespace oncard::gtcalls
