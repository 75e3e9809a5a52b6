// Determines where within a cycle a motor passes switches, index marks and compare points; and
// where encoders are at an edge inside the cycle, for captures. Only cycles in which something
// depends on it need a Crossings. Tested by tests/motion/marks_test.cc and, in tests/gtcalls, by
// capture_command_test.cc and compare_command_test.cc.
#pragma once

#include <array>
#include <cstddef>

#include "motion/motion_state.h"
#include "motion/readings.h"

namespace oncard::motion {

class Crossings {
 public:
  /// True if something depends on the positions that a motor passes inside a cycle.
  static bool Wanted(const MotionState& state);

  /// Notes where motors and encoders are before the motion of a cycle.
  Crossings(MotionState& state, const MotionConfig& config);
  /// After the motion: operates switches, captures and compare outputs on its way.
  void Finish();

 private:
  /// Applies the input edges that occur inside the cycle.
  void PassWorldEdges();
  void PassComparePoints();
  void OperateSwitch(const PositionSwitch& contact);
  void PassIndexMarks();
  /// An encoder's position at a fraction of the cycle, and at a position on a motor's way.
  double PositionAt(size_t encoder, double fraction) const;
  double PositionWhere(size_t encoder, size_t motor, double place) const;
  Micros now() const { return state_.cycle * config_.cycle_us; }

  MotionState& state_;
  const MotionConfig& config_;
  Readings readings_;
  std::array<double, kAxisMax> motors_{};  ///< positions of motors before the motion
  EncoderWay encoders_;
};

}  // namespace oncard::motion
