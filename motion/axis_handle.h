// An axis of a card, for those who command it: its drive, its conditions, its positions, its inputs
// and limits, and what is added to its command.
//
// What changes a position, a scale, a map or a compensation is for an axis at rest, and nothing
// moves by it: slaves, drives and compensations go along (origins.h). An axis on a bus is enabled
// and disabled through its drive. Tested by tests/motion/handles_test.cc, the verbs by the tests of
// what they act on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/core_parts.h"

namespace oncard::motion {

/// The inputs that an axis listens to.
struct AxisInputs {
  InputChoice alarm = {};
  InputChoice positive_limit = {};
  InputChoice negative_limit = {};
  InputChoice smooth_stop = {};
  InputChoice abrupt_stop = {};
};

/// The profiles and encoders of an axis, one bit each, and their scales.
struct AxisMaps {
  uint32_t profiles = 0;
  uint32_t encoders = 0;
  Scale profile_scale = {};
  Scale encoder_scale = {};
};

class AxisHandle {
 public:
  AxisHandle(CoreParts core, size_t axis) : core_(core), index_(axis) {}

  // --- Drive, stops, conditions ----------------------------------------------------------------

  /// Sets the enable output and the condition (GT_AxisOn).
  void ServoOn() const;
  /// Clears both (GT_AxisOff); profiles of the axis stop abruptly.
  void ServoOff() const;
  /// The drive of an enabled axis continues from the axis' current position.
  void RestartDrive() const;
  /// GT_CtrlMode for an axis whose drive is off: closed loop through the DAC of the same number, or
  /// pulses.
  void SetClosedLoop(bool closed) const;
  /// Forgets the latched conditions whose cause is gone (GT_ClrSts).
  void ClearStatus() const;
  /// The same of a sum of conditions, following errors left aside.
  void ClearConditions(uint32_t conditions) const;
  /// Latches these conditions and those whose causes exist, and forgets all others: for an owner
  /// that keeps events of its own.
  void LatchConditions(uint32_t conditions) const;
  /// GT_Stop of one axis: stops the profile of the same number or, for the slave of a gantry, the
  /// master.
  void Stop(bool abrupt) const;
  /// Stops every profile that the axis maps.
  void StopProfiles(bool abrupt) const;
  /// The same at a limit: abruptly, unless its coordinate system stops smoothly there or it is a
  /// slave that stays engaged.
  void StopProfilesAtLimit() const;

  // --- Positions -------------------------------------------------------------------------------

  /// Sets the axis positions to the mapped sums (GT_SynchAxisPos).
  void SynchPosition() const;
  /// Sets profile, encoder and both positions of the axis to 0 (GT_ZeroPos).
  void ZeroPosition() const;
  /// Sets a scale; the axis position is computed again.
  void SetProfileScale(Scale scale) const;
  void SetEncoderScale(Scale scale) const;
  /// The mean of 2^exponent cycles for reading velocities; it begins with the current one.
  void SetProfileVelocityFilter(int16_t exponent) const;
  void SetEncoderVelocityFilter(int16_t exponent) const;

  // --- Inputs, limits, in-position band --------------------------------------------------------

  void SwitchAlarm(bool on) const { core_.Changed().axes[index_].alarm_on = on; }
  void SwitchPositiveLimit(bool on) const { core_.Changed().axes[index_].positive_limit_on = on; }
  void SwitchNegativeLimit(bool on) const { core_.Changed().axes[index_].negative_limit_on = on; }
  /// GT_SetSoftLimit; kNoPositiveLimit and kNoNegativeLimit: none.
  void SetSoftLimits(int32_t positive, int32_t negative) const;
  void SetSmoothStopInput(InputChoice input) const {
    core_.Changed().axes[index_].smooth_stop = input;
  }
  void SetAbruptStopInput(InputChoice input) const {
    core_.Changed().axes[index_].abrupt_stop = input;
  }
  /// GT_SetAxisBand: pulses, and how long the error must be within them. Only from then on is the
  /// band judged.
  void SetBand(int32_t band, Micros time) const;

  // --- Configuration ---------------------------------------------------------------------------

  /// An inactive axis computes and monitors nothing.
  void SetActive(bool active) const { core_.Changed().axes[index_].active = active; }
  void SetInputs(const AxisInputs& inputs) const;
  /// If one of them is new, the axis positions are set to the mapped sums.
  void SetMaps(const AxisMaps& maps) const;

  // --- What is added to the command ------------------------------------------------------------

  /// GT_SetBacklash.
  void SetBacklash(const Backlash& backlash) const;
  /// GT_SetLeadScrewComp; a table in use is replaced.
  void SetPitchTable(PitchTablePointer table) const;
  /// GT_EnableLeadScrewComp; the axis must have a table to switch it on.
  void EnablePitchCompensation(bool on) const;
  /// GT_SetAxisInputShaping, for an axis at rest whose shaper has settled: `count` in
  /// [1, kShaperCyclesMax], or 0 to switch it off.
  void SetInputShaper(size_t count, double k) const;

 private:
  Axis& axis() const { return core_.state.axes[index_]; }
  bool OnBus() const { return core_.readings().OnBus(index_); }
  /// The enable outputs that follow the axis.
  uint32_t EnableOutputs() const;

  CoreParts core_;
  size_t index_;
};

}  // namespace oncard::motion
