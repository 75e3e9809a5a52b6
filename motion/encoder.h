// Encoders, and the machine that turns them.
//
// An encoder counts what the machine of the same number does, or, when the pulse counter is its
// source (GT_EncOff), the pulses sent to the drive. It counts whole pulses. A reversed sense
// (GT_EncSns) counts the other way than the machine is wired for. Source: GTS manual 8.1, 4.4.
// Tested by tests/motion/encoder_test.cc.
#pragma once

#include <cstdint>
#include <tuple>

#include "motion/sizes.h"

namespace oncard::motion {

/// The motor and what it drives. In an ideal world it follows an enabled axis exactly.
struct Plant {
  double position = 0;  ///< pulses since power-on
  double velocity = 0;  ///< pulse/ms
  /// Distance to the planned axis position while the drive follows it.
  double lead = 0;

  auto Fields() const { return std::tie(position, velocity, lead); }
};

struct Encoder {
  bool external = true;  ///< false: counts the pulse output
  bool reversed = true;  ///< GT_EncSns; counters are reversed by default (GTS manual table 4-4)
  /// How the machine is wired: with this sense, counting goes with the motion. Assumption: a
  /// machine fits its configuration, so reset and GT_LoadConfig set it and GT_EncSns does not.
  bool wired_reversed = true;
  double position = 0;  ///< what GT_GetEncPos reads: whole pulses
  double source = 0;    ///< whole pulses of the source, of which changes are counted
  double velocity = 0;
  double acceleration = 0;

  auto Fields() const {
    return std::tie(external, reversed, wired_reversed, position, source, velocity, acceleration);
  }
};

}  // namespace oncard::motion
