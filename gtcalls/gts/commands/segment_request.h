// Internal to gtcalls: what a segment command asks for. The names of a command's parameters say
// which numbers it takes; its own name says in which plane it is, and whether it ends at rest (G0)
// or uses the second override. Tested by tests/gtcalls/segment_command_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "gtcalls/card.h"
#include "motion/paths/segment.h"

namespace oncard::gtcalls::gts {

/// The data of a segment command.
struct SegmentRequest {
  motion::Coordinates end{};
  size_t dimension = 2;  ///< coordinates it needs
  double velocity = 0;
  double acceleration = 0;
  double end_velocity = 0;
  bool ends_at_rest = false;
  bool second_override = false;
  int32_t given_number = 0;
  std::optional<double> radius;
  std::array<double, 2> centre{};
  size_t centre_count = 0;  ///< 0: no centre
  std::array<double, 3> between{};
  bool has_between = false;
  bool counter_clockwise = false;
  motion::ArcPlane plane;
};

/// Reads the arguments; coordinates that are not parameters of the command keep the value in
/// `start`.
SegmentRequest ReadSegment(const Call& call, const motion::Coordinates& start);

/// The segment from `start`; empty if there is none. `tolerance`: by how much an arc's radii may
/// differ.
std::optional<motion::Segment> ShapeOf(const motion::Coordinates& start,
                                       const SegmentRequest& request,
                                       double tolerance = motion::kArcTolerance);

}  // namespace oncard::gtcalls::gts
