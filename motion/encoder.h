// Encoders: what they count, and their faults.
//
// An encoder counts the motion of the motor with the same number or, if its source is the pulse
// counter (GT_EncOff), the pulses sent to the drive. It counts whole pulses. With a reversed sense
// (GT_EncSns) it counts against the direction for which the mechanics are wired. A change of source
// or sense does not change the position. Source: GTS manual 8.1, 4.3.2, 4.4. Tested by
// tests/motion/encoder_test.cc.
#pragma once

#include <cstdint>

#include "motion/common/sizes.h"

namespace oncard::motion {

struct Encoder {
  bool active = true;    ///< configuration: an inactive encoder counts nothing
  bool external = true;  ///< false: counts the pulse output
  bool reversed = false;
  /// How the encoder is wired: with this sense it counts in the direction of motion. Assumption:
  /// the wiring fits the configuration, so that reset and GT_LoadConfig set it and GT_EncSns does
  /// not.
  bool wired_reversed = false;
  double position = 0;  ///< what GT_GetEncPos reads: whole pulses
  double source = 0;    ///< whole pulses of the source, whose changes are counted
  double velocity = 0;
  double acceleration = 0;

  /// It has counted nothing in the last two cycles.
  bool resting() const { return velocity == 0 && acceleration == 0; }
  auto Fields(auto visit) const {
    return visit(active, external, reversed, wired_reversed, position, source, velocity,
                 acceleration);
  }
};

/// A fault of an encoder or its wiring. It is outside the card, so GT_Reset does not change it.
struct EncoderFault {
  bool held = false;    ///< disconnected: it does not count
  double drift = 0;     ///< slip on its shaft, pulse/ms
  int32_t noise = 0;    ///< largest error of a reading, pulses
  double slip = 0;      ///< pulses lost or slipped since power-on
  int32_t error = 0;    ///< error of the current reading, within +-noise
  uint64_t random = 0;  ///< state of the noise generator

  bool any() const { return held || drift != 0 || noise != 0 || error != 0; }
  /// The next error within +-noise (splitmix64: the same sequence on every machine).
  int32_t NextError();

  auto Fields(auto visit) const { return visit(held, drift, noise, slip, error, random); }
};

}  // namespace oncard::motion
