// Where the path of a coordinate system goes on: what a picture of the machine shows ahead of the
// tool.
//
// The path is that of the FIFO in use, from where it is: the segment in progress, the line back to
// a breakpoint, and the segments that wait. What is still in the window of a look-ahead is not
// planned and does not belong to it. Lines give their ends, arcs chords. For reading only: nothing
// of a run depends on it. Tested by tests/motion/path_ahead_test.cc.
#pragma once

#include <cstddef>
#include <vector>

#include "motion/paths/crd.h"

namespace oncard::motion {

/// A chord of an arc turns by so much at most, radians.
inline constexpr double kChordAngle = 0.2;

struct PathAhead {
  std::vector<size_t> profiles;  ///< by their coordinates X, Y, Z, A; those of a map by number
  /// Of each point of the path the positions of `profiles`, pulses. The first one is `here`; none
  /// if nothing waits.
  std::vector<std::vector<double>> points;
  bool whole = true;  ///< false: the path goes on after the last point
};

/// The first points of the path, `most` of them, at least 2. `here`: where the profiles are, in
/// coordinates of the path (MotionCore::CrdPosition).
PathAhead FindPathAhead(const Crd& crd, const Coordinates& here, size_t most);

}  // namespace oncard::motion
