// The look-ahead of a path card (GT_InitLookAheadEx), and the calculation of velocities only
// (GT_InitLookAhead). Both are windows of the path planner that limit the velocity at corners and
// on arcs. Source: GE manual 6.4 and 6.5. Tested by tests/gtcalls/ge/look_ahead_command_test.cc.
#pragma once

#include <cstddef>

#include "motion/common/rare.h"
#include "motion/paths/coordinates.h"
#include "motion/paths/path_planner.h"

namespace oncard::gtcalls::ges {

/// The figures of both commands, in any units of length and time that fit together.
struct CornerFigures {
  double time = 0;              ///< T
  double acceleration_max = 0;  ///< at corners and on arcs
  double acceleration = 0;      ///< along the path
};

/// A window for that many slots. It is always there; as a rare part it joins the hash as that of a
/// buffer does (motion::PlannerInHash).
using CornerPlanner = motion::Rare<motion::PathPlanner>;
CornerPlanner MakeCornerPlanner(const CornerFigures& figures, size_t capacity);

/// Segments in pulses and ms that wait for their end velocities.
struct LookAhead {
  double scale = 0;         ///< pulses per millimetre
  double acceleration = 0;  ///< pulse/ms^2
  CornerPlanner window;
  motion::Coordinates tail{};  ///< where the newest segment ends
  double handed_feed = 0;      ///< of the segment that has entered the list last

  auto Fields(auto visit) const {
    return visit(scale, acceleration, motion::PlannerInHash{window}, tail, handed_feed);
  }
};

/// Segments in millimetres and seconds whose end velocities a host reads.
struct VelocityTable {
  double acceleration = 0;
  double velocity = 0;  ///< the largest
  CornerPlanner window;
  motion::Coordinates tail{};  ///< assumption: the path begins at 0

  auto Fields(auto visit) const {
    return visit(acceleration, velocity, motion::PlannerInHash{window}, tail);
  }
};

}  // namespace oncard::gtcalls::ges
