// What is between an axis and its motor, for those who set it up: servo controllers, analogue
// outputs, pulse outputs and encoders.
//
// The loop of a controller is closed while an analogue output belongs to it, and no output belongs
// to a controller whose loop is open. What Configure() and its like change shows in the drives when
// MotionCore::RestartDrives() has connected them anew. Tested by tests/motion/handles_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "motion/core_parts.h"

namespace oncard::motion {

class ControlHandle {
 public:
  ControlHandle(CoreParts core, size_t control) : core_(core), index_(control) {}

  /// Whether it monitors the following error, the axis whose positions it compares and the encoder
  /// of its motor (-1: none). Its loop is open then.
  void Configure(bool active, int8_t axis, int8_t encoder) const;
  void SetPidSet(size_t set, const PidSet& values) const { control().sets[set] = values; }
  void SelectPidSet(size_t set) const { control().selected = static_cast<uint8_t>(set); }
  /// The sum of errors begins anew.
  void ClearIntegral() const { control().sum = 0; }
  /// The largest following error, pulses.
  void SetErrorLimit(int64_t limit) const { control().error_limit = limit; }
  /// What the check of the encoder's response takes for a silent one.
  void SetResponseCheck(int16_t threshold, double min_velocity, Micros time) const;
  /// The check begins anew.
  void SwitchResponseCheck(bool on) const;

 private:
  Control& control() const { return core_.Changed().controls[index_]; }

  CoreParts core_;
  size_t index_;
};

class DacHandle {
 public:
  DacHandle(CoreParts core, size_t dac) : core_(core), index_(dac) {}

  /// An output at 0 that belongs to no controller.
  void Configure(bool active, bool reversed, int16_t bias, int16_t limit) const;
  /// From now on the controller writes it, in closed loop.
  void GiveTo(size_t control) const;
  /// Of an output that belongs to no controller.
  void SetValue(double value) const { dac().value = value; }
  void SetBias(int16_t bias) const { dac().bias = bias; }
  void SetLimit(int16_t limit) const { dac().limit = limit; }

 private:
  Dac& dac() const { return core_.Changed().dacs[index_]; }

  CoreParts core_;
  size_t index_;
};

class StepHandle {
 public:
  StepHandle(CoreParts core, size_t step) : core_(core), index_(step) {}

  /// The axis whose planned position it outputs (-1: none), and whether its pins are reversed.
  void Configure(bool active, int8_t axis, bool reversed) const;
  /// An inactive one puts out no pulses.
  void SetActive(bool active) const { core_.Changed().steps[index_].active = active; }
  /// The form of its pulses (Step::mode). No drive tells one from another.
  void SetMode(int16_t mode) const { core_.state.steps[index_].mode = mode; }
  void SetParameter(int16_t parameter) const { core_.state.steps[index_].parameter = parameter; }

 private:
  CoreParts core_;
  size_t index_;
};

class EncoderHandle {
 public:
  EncoderHandle(CoreParts core, size_t encoder) : core_(core), index_(encoder) {}

  /// Sets its position; the axes keep theirs.
  void SetPosition(double position) const;
  /// GT_EncSns, GT_EncOn and GT_EncOff: it continues to count from its position.
  void SetSense(bool reversed) const;
  void SetExternal(bool external) const;
  /// The same for an encoder that is wired for this sense.
  void Configure(bool active, bool reversed, bool external) const;
  /// It counts from the current value of its source.
  void Rebase() const;

 private:
  CoreParts core_;
  size_t index_;
};

}  // namespace oncard::motion
