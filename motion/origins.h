// Positions that get other values without motion: commands that set them, synchronise them with an
// encoder, or change a scale. Slaves of the position, the drives behind it, compensation and gantry
// go along, so that nothing moves. Tested by tests/motion/axis_test.cc.
#pragma once

#include <cstddef>

#include "motion/drive_train.h"
#include "motion/motion_state.h"
#include "motion/readings.h"

namespace oncard::motion {

class Origins {
 public:
  Origins(MotionState& state, const MotionConfig& config)
      : state_(state),
        axis_count_(static_cast<size_t>(config.axis_count)),
        readings_(state, config),
        drives_(state, config) {}

  /// Sets the position of a profile at rest; the axes keep theirs.
  void SetProfilePosition(size_t profile, double position);
  /// Sets an encoder's position; the axes keep theirs.
  void SetEncoderPosition(size_t encoder, double position);
  /// Sets the axis positions to the mapped sums.
  void SynchAxis(size_t axis);
  /// Sets profile, encoder and both positions of an axis to 0.
  void ZeroAxis(size_t axis);
  /// Sets a scale; the axis position is computed again.
  void SetProfileScale(size_t axis, Scale scale);
  void SetEncoderScale(size_t axis, Scale scale);
  /// The map or scale of an axis has changed: its planned position stays.
  void KeepPlanned(size_t axis);
  /// Sets the planned position to the measured position.
  void AlignWithEncoder(size_t axis);

 private:
  /// Keeps the slaves of a master still whose position was changed.
  void ShiftSlaves(const Master& master, double shift);
  /// Changes the measured position of an axis.
  void MoveMeasured(size_t axis, double position);
  /// Changes the planned position of an axis; the second function also relative to the profiles.
  void MovePlanned(size_t axis, double position);
  void MoveAxis(size_t axis, double position);
  /// The input shaper of an axis continues from another value of the commanded position.
  void RenameShaped(size_t axis);
  /// It forgets what it has not yet passed: the motion ends where the drive is now.
  void EndShaping(size_t axis);

  MotionState& state_;
  size_t axis_count_;
  Readings readings_;
  DriveTrain drives_;
};

}  // namespace oncard::motion
