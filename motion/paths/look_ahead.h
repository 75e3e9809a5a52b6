// Look-ahead: how fast a path may pass from one segment to the next, given the segments that
// follow.
//
// At a corner with the unit tangents p before and q after it, the change of velocity v |q - p| must
// not exceed accMax * T; |q - p| = 2 sin(angle / 2). A curve of radius R is passed at most at
// sqrt(accMax * R). Segments wait in a ring of n; the last is assumed to end at rest. Over the ring
// v_in^2 = min(junction^2, v_out^2 + 2 a L) is a chain of functions min(J, x + C); their
// composition has the same form, so that a queue made of two stacks gives the velocity after the
// oldest segment in amortised constant time, without accumulating rounding errors.
//
// Units: ms, pulse. Only basic arithmetic. The formulas are assumptions (docs/assumptions.md).
// Tested by tests/motion/look_ahead_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "motion/paths/path_slot.h"

namespace oncard::motion {

/// x -> min(bound, x + gain), squares of velocities.
struct SpeedLink {
  double bound = std::numeric_limits<double>::max();
  double gain = 0;

  double At(double x) const { return x + gain < bound ? x + gain : bound; }
  /// The composition: this function after `inner`.
  SpeedLink After(const SpeedLink& inner) const { return {At(inner.bound), gain + inner.gain}; }

  auto Fields() const { return std::tie(bound, gain); }
};

/// The links of the segments in the ring, oldest first.
struct SpeedChain {
  std::vector<SpeedLink> front;  ///< compositions from a segment to the last of `front`
  std::vector<SpeedLink> back;   ///< single links, newer than those of `front`
  SpeedLink back_total;

  void Push(const SpeedLink& link);
  /// Removes the oldest link.
  void Pop();
  /// The square of the velocity at the start of the oldest segment if the newest ends at rest.
  double SpeedSquare() const;

  auto Fields() const { return std::tie(front, back, back_total); }
};

struct LookAhead {
  double time = 0;          ///< T, ms
  double acceleration = 0;  ///< accMax, pulse/ms^2
  size_t capacity = 0;      ///< n; 0: off
  SlotQueue ring;
  SpeedChain chain;
  double speed = 0;  ///< planned at the begin of the oldest segment
  // The newest segment.
  bool has_newest = false;
  bool newest_rests = false;
  double newest_velocity = 0;
  Coordinates newest_tangent{};

  bool on() const { return capacity > 0; }
  /// The largest velocity of the corner between the newest segment and one that begins with this
  /// tangent.
  double CornerBefore(const Coordinates& tangent) const;
  bool full() const { return ring.size() >= capacity; }
  void Push(const PathSlot& pushed);
  /// The oldest slot with its end velocity planned; the ring must not be empty.
  PathSlot Take();
  void Clear();

  auto Fields() const {
    return std::tie(time, acceleration, capacity, ring, chain, speed, has_newest, newest_rests,
                    newest_velocity, newest_tangent);
  }
};

}  // namespace oncard::motion
