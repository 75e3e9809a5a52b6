// Encoders: what they count, and what the world can do to them.
//
// An encoder counts what the machine of the same number does, or, when the pulse counter is its
// source (GT_EncOff), the pulses sent to the drive. It counts whole pulses. A reversed sense
// (GT_EncSns) counts the other way than the machine is wired for. A change of source or sense
// leaves the position alone. Source: GTS manual 8.1, 4.3.2, 4.4.
// Tested by tests/motion/encoder_test.cc.
#pragma once

#include <cstdint>
#include <tuple>

#include "motion/common/sizes.h"

namespace oncard::motion {

struct Encoder {
  bool active = true;    ///< configuration: an inactive encoder counts nothing
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
    return std::tie(active, external, reversed, wired_reversed, position, source, velocity,
                    acceleration);
  }
};

/// What is wrong with an encoder or its wiring; part of the world, GT_Reset leaves it alone.
struct EncoderFault {
  bool held = false;    ///< cut off: its signal stands still
  double drift = 0;     ///< pulse/ms it slips on its shaft
  int32_t noise = 0;    ///< it reads up to so many pulses too much or too little
  double slip = 0;      ///< pulses it has lost or slipped since power-on
  int32_t error = 0;    ///< of the present reading, within +-noise
  uint64_t random = 0;  ///< state of the noise

  bool any() const { return held || drift != 0 || noise != 0 || error != 0; }
  /// The next number within +-noise (splitmix64: the same sequence on every machine).
  int32_t NextError();

  auto Fields() const { return std::tie(held, drift, noise, slip, error, random); }
};

}  // namespace oncard::motion
