// Analogue outputs and inputs of the card.
//
// A converter's value and the voltage: outputs +-32767 are +-10 V, inputs +-32768 are +-12.5 V
// (assumption for the inputs, the public headers' comments). The terminal of an output carries
// value + bias, limited. Tested by tests/motion/analog_test.cc.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "motion/common/rounding.h"

namespace oncard::motion {

inline constexpr double kDacFull = 32767;
inline constexpr double kDacFullVolts = 10;
inline constexpr double kAdcFull = 32768;
inline constexpr double kAdcFullVolts = 12.5;

/// Assumption: the analogue inputs of an 8-axis card.
inline constexpr size_t kAdcCount = 8;

struct Dac {
  bool active = true;     ///< configuration: an inactive output stays at 0 V
  bool reversed = false;  ///< configuration: the voltage has the opposite sign
  int8_t control = -1;    ///< the servo controller that writes it, from 0; -1: GT_SetDac does
  int16_t bias = 0;       ///< GT_SetMtrBias
  int16_t limit = static_cast<int16_t>(kDacFull);  ///< GT_SetMtrLmt
  double value = 0;                                ///< what was written

  /// What GT_GetDac reads: value + bias, rounded, within +-limit. Assumption: a drive is wired so
  /// that this sign is its direction of motion.
  int16_t Output() const {
    if (!active) return 0;
    const double bound = limit;
    return static_cast<int16_t>(Whole(std::clamp(value + bias, -bound, bound)));
  }
  /// At the terminal.
  double Volts() const;

  auto Fields(auto visit) const { return visit(active, reversed, control, bias, limit, value); }
};

struct Adc {
  double volts = 0;     ///< volts at the terminal, from outside the card
  int16_t filter = 0;   ///< GT_SetAdcFilter
  double filtered = 0;  ///< volts after the filter

  /// One profile cycle. Assumption: a filter time of n cycles takes an n-th of the difference in
  /// each; 0 and 1 pass everything.
  void Sample();
  /// True if Sample() changes nothing as long as the voltage stays.
  bool settled() const { return filtered == volts; }
  /// The converter's value: -32768 to 32767.
  int16_t Value() const;
  /// The same in volts.
  double Volts() const { return Value() * kAdcFullVolts / kAdcFull; }

  auto Fields(auto visit) const { return visit(volts, filter, filtered); }
};

}  // namespace oncard::motion
