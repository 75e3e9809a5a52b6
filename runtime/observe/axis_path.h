// Where the path of a coordinate system goes on, as its axes are seen: in their units. Tested by
// tests/session/host_calls_test.cc.
#pragma once

#include <cstddef>
#include <vector>

#include "runtime/sim/controller.h"

namespace oncard::runtime {

struct AxisPath {
  std::vector<size_t> axes;  ///< from 1, by their coordinates X, Y, Z, A
  /// Of each point the positions of `axes`. The first one is where they are; none if nothing waits.
  std::vector<std::vector<double>> points;
  bool whole = true;  ///< false: the path goes on after the last point
};

/// The next points of the path that is planned (motion/paths/path_ahead.h), `most` of them. `crd`
/// counts from 0.
AxisPath PathAhead(const Controller& controller, size_t crd, size_t most);

}  // namespace oncard::runtime
