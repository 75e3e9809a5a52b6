// The backward pass over a queue of segments in amortised constant time.
//
// From the end of a queue to its start v_in^2 = min(junction^2, v_out^2 + 2 a L) is a chain of
// functions min(J, x + C). Their composition has the same form, so that a queue made of two stacks
// gives the velocity before the oldest segment without accumulating rounding errors.
//
// Any consistent units. Only basic arithmetic. Tested by tests/motion/look_ahead_test.cc.
#pragma once

#include <limits>
#include <vector>

namespace oncard::motion {

/// x -> min(bound, x + gain), squares of velocities.
struct SpeedLink {
  double bound = std::numeric_limits<double>::max();
  double gain = 0;

  double At(double x) const { return x + gain < bound ? x + gain : bound; }
  /// The composition: this function after `inner`.
  SpeedLink After(const SpeedLink& inner) const { return {At(inner.bound), gain + inner.gain}; }

  auto Fields(auto visit) const { return visit(bound, gain); }
};

/// The links of the segments in a queue, oldest first.
struct SpeedChain {
  std::vector<SpeedLink> front;  ///< compositions from a segment to the last of `front`
  std::vector<SpeedLink> back;   ///< single links, newer than those of `front`
  SpeedLink back_total;

  bool empty() const { return front.empty() && back.empty(); }
  void Push(const SpeedLink& link);
  /// Removes the oldest link.
  void Pop();
  /// The square of the velocity at the start of the oldest segment if the newest ends at rest.
  double SpeedSquare() const;

  auto Fields(auto visit) const { return visit(front, back, back_total); }
};

}  // namespace oncard::motion
