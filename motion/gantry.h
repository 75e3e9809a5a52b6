// Two axes that carry one beam: the slave follows the planned motion of the master, and everything
// that stops one of them stops both.
//
// In closed loop the skew multiplied by a separate gain is added to the output of each of the two
// controllers, so that the side that is ahead waits for the other. When the skew exceeds its limit
// both drives are switched off. While the gantry is on, the slave axis is mapped to the profiles of
// the master, so that stops and limits of either axis act on the profiles of both. Source: the
// public header names the commands; the rest is assumption (docs/assumptions.md). Tested by
// tests/motion/gantry_test.cc and tests/gtcalls/gantry_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "motion/axis.h"

namespace oncard::motion {

/// The default limit of GT_SetGantryErrLmt: a larger skew switches the drives off, pulses
/// (assumption: the default limit of the following error).
inline constexpr int32_t kGantryErrorLimit = 32767;

struct Gantry {
  bool on = false;
  uint8_t master = 0;  ///< axes, from 0
  uint8_t slave = 0;
  double master_kp = 0;  ///< DAC units per pulse of skew
  double slave_kp = 0;
  int32_t error_limit = kGantryErrorLimit;
  double skew_origin = 0;  ///< slave - master at the start of the gantry, in current coordinates
  // The previous mapping of the slave axis.
  uint32_t slave_map = 0;
  Scale slave_scale;

  /// Connects two axes at rest, or ends that; `axes` are all axes. The caller computes the offset
  /// of the slave's planned position again, so that it keeps this position.
  void Begin(size_t new_master, size_t new_slave, double new_master_kp, double new_slave_kp,
             std::span<Axis> axes);
  void End(std::span<Axis> axes);
  /// How far the measured slave is ahead of the master since the gantry began, pulses.
  double Skew(std::span<const Axis> axes) const;
  /// The part of an axis' controller output that the gantry adds, DAC units.
  double Correction(size_t axis, std::span<const Axis> axes) const;
  /// True if the skew exceeds its limit while a drive is enabled.
  bool Exceeded(std::span<const Axis> axes) const;

  auto Fields(auto visit) const {
    return visit(on, master, slave, master_kp, slave_kp, error_limit, skew_origin, slave_map,
                 slave_scale);
  }
};

}  // namespace oncard::motion
