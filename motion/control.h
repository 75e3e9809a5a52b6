// Servo controllers: they compare an axis' planned and measured position and output a voltage.
//
//   U = kp E + ki sum(E) / 256 + kd (E - E_before) + kvff v + kaff a
//
// once in every servo sub-step; sum and difference are limited, then U. E in pulses, v in pulse/ms,
// a in pulse/ms^2, U in DAC units. The bias is added and the output limited at the DAC (analog.h).
// Source: GT-400 manual (servo filter); public header for TPid. Tested by
// tests/motion/control_test.cc.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/common/card_defaults.h"
#include "motion/common/sizes.h"

namespace oncard::motion {

/// The integral gain counts 256ths (GT-400 manual).
inline constexpr double kIntegralUnit = 1.0 / 256;
inline constexpr size_t kPidSetCount = 3;
/// Assumption: the limits of a set after reset, as in the GE manual: the largest output.
inline constexpr int16_t kPidLimit = 32767;
/// Gains and limits. Assumption: after reset all gains are 0, as in the GE manual.
struct PidSet {
  double kp = 0;
  double ki = 0;
  double kd = 0;
  double kvff = 0;
  double kaff = 0;
  int32_t integral_limit = kPidLimit;
  int32_t derivative_limit = kPidLimit;
  int16_t limit = kPidLimit;
  /// The fed-forward velocity takes a 2^n-th of its difference in each sub-step (assumption).
  int16_t kvff_filter = 0;
  double kvff_acc_max = 0;  ///< largest rate of change, pulse/ms^2; 0: no limit (assumption)

  /// The velocity to feed forward, one servo sub-step after `feed`.
  double FeedForward(double feed, double velocity, double servo_ms) const {
    if (kvff_filter == 0 && kvff_acc_max <= 0) return velocity;
    double change = (velocity - feed) / (1 << kvff_filter);
    if (kvff_acc_max > 0) {
      change = std::clamp(change, -kvff_acc_max * servo_ms, kvff_acc_max * servo_ms);
    }
    return feed + change;
  }

  auto Fields(auto visit) const {
    return visit(kp, ki, kd, kvff, kaff, integral_limit, derivative_limit, limit, kvff_filter,
                 kvff_acc_max);
  }
};

/// GT_SetEncResponseCheck: a voltage without motion means a broken encoder. Assumption: the time
/// counts steps of 250 us, and the reaction is that of the following error.
struct ResponseCheck {
  bool on = false;
  int16_t threshold = 0;    ///< DAC units
  double min_velocity = 0;  ///< pulse/ms
  Micros time = 0;
  bool silent = false;
  Micros silent_since = 0;

  auto Fields(auto visit) const {
    return visit(on, threshold, min_velocity, time, silent, silent_since);
  }
};

struct Control {
  // Configuration.
  bool active = true;   ///< an inactive controller does not monitor the following error
  int8_t axis = -1;     ///< the axis whose positions it compares, from 0; -1: none
  int8_t encoder = -1;  ///< the encoder that its motor turns, from 0; -1: none
  bool closed = false;  ///< it commands the drive through a DAC

  // Registers.
  std::array<PidSet, kPidSetCount> sets;
  uint8_t selected = 0;
  int64_t error_limit = CardDefaults{}.following_error_limit;  ///< GT_SetPosErr, pulses
  ResponseCheck check;

  // State.
  double reference = 0;  ///< commanded position at the last tick
  double sum = 0;
  double error_before = 0;
  double feed = 0;  ///< the fed-forward velocity, pulse/ms

  const PidSet& pid() const { return sets[selected]; }
  /// Clears the integral; the drive has just been enabled at `position`.
  void Begin(double position);
  /// One servo sub-step of this length; the output within the set's limit.
  double Advance(double error, double velocity, double acceleration, double servo_ms) {
    const PidSet& set = pid();
    const auto limited = [](double value, double limit) {
      return std::clamp(value, -limit, limit);
    };
    sum = limited(sum + error, set.integral_limit);
    const double difference = limited(error - error_before, set.derivative_limit);
    error_before = error;
    feed = set.FeedForward(feed, velocity, servo_ms);
    const double output = set.kp * error + set.ki * (sum * kIntegralUnit) + set.kd * difference +
                          set.kvff * feed + set.kaff * acceleration;
    return limited(output, set.limit);
  }

  auto Fields(auto visit) const {
    return visit(active, axis, encoder, closed, sets, selected, error_limit, check, reference, sum,
                 error_before, feed);
  }
};

/// Controller `number` (from 0) after reset: axis and encoder of the same number, not closed.
Control DefaultControl(int number);

}  // namespace oncard::motion
