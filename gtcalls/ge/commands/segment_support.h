// Internal to gtcalls: what the lines and arcs of path cards ask for, and their geometry.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "gtcalls/card.h"
#include "motion/paths/segment.h"

namespace oncard::gtcalls::ges {

struct SegmentRequest {
  size_t dimension = 2;  ///< the coordinates that must be there: two in XY, three in YZ
  motion::Coordinates end{};
  uint32_t given = 0;  ///< bit n: coordinate n of the end is given
  // Arcs.
  motion::ArcPlane plane = motion::kXyPlane;
  std::optional<std::array<double, 2>> centre;
  double angle = 0;  ///< degrees, with a centre
  std::optional<double> radius;
  int direction = 1;
  // Lines.
  bool rests = false;  ///< G0

  bool is_arc() const { return centre.has_value() || radius.has_value(); }
};

/// Reads the arguments of a line or an arc; lengths are multiplied by `scale`.
SegmentRequest ReadSegment(const Call& call, double scale);

/// The segment, or the code of GE manual table 2-1 that says what is wrong with it.
struct SegmentResult {
  std::optional<motion::Segment> segment;
  int16_t code = 0;
};
SegmentResult MakeSegment(const motion::Coordinates& start, const SegmentRequest& request);

}  // namespace oncard::gtcalls::ges
