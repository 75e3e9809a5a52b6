// Between planned positions and measured ones: servo controllers, pulse outputs, drives, motors and
// encoders. Sees the axes' planned positions and whether their drives are enabled; changes their
// measured positions. Tested by tests/motion/control_test.cc, plant_test.cc and encoder_test.cc.
#pragma once

#include <cstddef>

#include "motion/motion_state.h"
#include "motion/readings.h"

namespace oncard::motion {

class DriveTrain {
 public:
  DriveTrain(MotionState& state, const MotionConfig& config)
      : state_(state), config_(config), readings_(state, config) {}

  /// Sets all registers to their defaults. The motors stay where they are, and their encoders count
  /// from there.
  void Reset();
  /// Connects motors, pulse outputs and controllers according to the configuration.
  void Wire();
  /// The pulse outputs continue from their current positions.
  void KeepPulses();
  /// GT_CtrlMode: closed loop through the DAC of the same number, or pulses.
  void SetClosedLoop(size_t axis, bool closed);
  /// The drive of an axis has been enabled, or disabled.
  void Enable(size_t axis);
  void Disable(size_t axis);
  /// Adapts to a planned position that was changed by -difference without motion.
  void Keep(size_t axis, double difference);
  /// Makes an encoder count from the current value of its source.
  void Rebase(size_t encoder) {
    state_.encoders[encoder].source = readings_.EncoderSource(encoder);
  }
  /// One cycle.
  void Advance();
  /// True if the controlled encoder has not counted for too long while its motor was driven.
  bool EncoderSilent(Control& control);

 private:
  void AdvancePlant(size_t index);
  /// One cycle of a motor that is turned by hand, without a drive or with the drive off.
  void TurnByHand(Plant& plant);
  void AdvanceClosedLoop(size_t index);
  void AdvanceAuxiliary();
  void MapEncoders();
  /// Applies the fault of an encoder for one cycle.
  void AdvanceEncoderFault(size_t index);
  /// What its source has done in the cycle, after AdvanceEncoderFault(); `bus`: the card has a bus.
  void CountEncoder(size_t index, bool bus);
  /// The axis position from the controller's encoder now, between two ticks.
  double MeasuredPosition(const Control& control) const;

  size_t axis_count() const { return static_cast<size_t>(config_.axis_count); }
  Micros now() const { return state_.cycle * config_.cycle_us; }

  MotionState& state_;
  const MotionConfig& config_;
  Readings readings_;
};

}  // namespace oncard::motion
