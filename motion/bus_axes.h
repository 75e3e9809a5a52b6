// Connects the axes of a card with the drives on its bus: control words and target positions go
// out, measured positions and status words come in, once in every profile cycle. In mode 8 the
// planned position of an axis is its drive's target; in any other mode the drive moves by itself,
// and the planned position is set to the measured one when the mode returns to 8, so that nothing
// jumps.
//
// Functions that take an axis need one that is on the bus. Tested by
// tests/motion/bus/bus_axes_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion/motion_state.h"
#include "motion/origins.h"
#include "motion/readings.h"

namespace oncard::motion {

/// Homing by the drive: speeds in pulse/ms, acceleration in pulse/ms^2, offset in pulses.
struct BusHomingParameters {
  int method = 0;
  double search_speed = 0;
  double index_speed = 0;
  double acceleration = 0;
  int32_t offset = 0;
};

class BusAxes {
 public:
  BusAxes(MotionState& state, const MotionConfig& config)
      : state_(state), config_(config), readings_(state, config) {}

  /// Numbers the axes after the configured drives.
  void NumberAxes();
  /// Switches the drives on, with their motors where they are.
  void PowerOn();
  /// The card is reset: registers of the axes, not the communication.
  void Reset();

  // --- The cycle ---------------------------------------------------------------------------------

  /// Before encoders count: outputs, drives with their motors, inputs.
  void Exchange();
  /// After it: enables and disables axes as their drives report. Returns the axes to stop abruptly,
  /// one bit each.
  uint32_t Follow();

  /// True if the cycles from now on only move drives, each to what is planned for its axis or not
  /// at all, as long as nothing else changes. The exchange in the last of such cycles then leaves
  /// the bus as those of all would.
  bool OnlyMove() const;

  // --- Commands ----------------------------------------------------------------------------------

  void Enable(size_t axis, bool on);
  /// Resets a fault of the drive.
  void ResetFault(size_t axis);
  /// Sets the mode of operation, by process data or by the mailbox.
  void SetMode(size_t axis, bus::DriveMode mode);
  /// GT_SetPosScale, for an axis at rest: nothing moves, and its positions stay.
  void SetScale(size_t axis, uint8_t exponent);
  /// The parameters as downloads; what does not fit an object counts as its limit. The first abort
  /// code, after which the rest is not downloaded.
  bus::SdoAbort PrepareHoming(size_t axis, const BusHomingParameters& parameters);
  void StartHoming(size_t axis);
  void StopHoming(size_t axis);

 private:
  uint16_t ControlWordOf(size_t axis) const;
  void SendOutputs(size_t axis);
  void AdvanceDrive(size_t number);
  /// The surroundings of a slave that moves a motor, without edges of its probes.
  bus::DriveWorld WorldOf(size_t number) const;
  bool OnlyMoves(size_t axis) const;
  /// The axis whose motor a slave moves; empty for one that is no drive of this card.
  std::optional<size_t> MotorOf(size_t number) const;
  void ReadFeedback(size_t axis);
  void JudgeHoming(BusAxis& link, uint16_t status);
  void Align(size_t axis);
  /// Edges of the probe inputs of a slave in the present cycle.
  std::vector<bus::ProbeEdge> ProbeEdgesOf(size_t number) const;
  uint16_t StatusWordOf(size_t axis) const;
  Micros now() const { return state_.cycle * config_.cycle_us; }
  size_t axis_count() const { return static_cast<size_t>(config_.axis_count); }
  BusAxis& link(size_t axis) { return state_.bus->axes[axis]; }
  const BusAxis& link(size_t axis) const { return state_.bus->axes[axis]; }
  size_t SlaveOf(size_t axis) const { return static_cast<size_t>(link(axis).slave); }

  MotionState& state_;
  const MotionConfig& config_;
  Readings readings_;
};

}  // namespace oncard::motion
