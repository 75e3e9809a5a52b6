// An axis: which profiles and encoders it combines, its inputs, limits, in-position band and
// conditions. The motion core evaluates it once per profile cycle (motion_core.h).
//
// An axis position is the sum of the mapped profiles (or encoders), each times beta/alpha, plus an
// offset. GT_SetPrfPos and GT_SetEncPos change a profile or encoder and the offset against it, so
// that the axis keeps its position until GT_SynchAxisPos sets the offset to 0.
// Source: GTS manual 4.3, 4.4, 6, 9 and 11. Tested by tests/motion/axis_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "motion/common/sizes.h"
#include "motion/io/digital_io.h"

namespace oncard::motion {

/// Conditions of an axis. A set of conditions is a sum of these bits. Their positions have no
/// meaning outside: the card's family assembles its status word from them (gtcalls/family.h).
enum AxisCondition : uint32_t {
  kAlarmBit = 1u << 0,
  kFollowingErrorBit = 1u << 1,
  kPositiveLimitBit = 1u << 2,
  kNegativeLimitBit = 1u << 3,
  kSmoothStopBit = 1u << 4,
  kAbruptStopBit = 1u << 5,
  kServoOnBit = 1u << 6,
  kMovingBit = 1u << 7,
  kInPositionBit = 1u << 8
};

/// A digital input that an axis listens to; bit -1: none.
struct InputChoice {
  DiType type = DiType::kGpi;
  int16_t bit = -1;

  auto Fields(auto visit) const { return visit(type, bit); }
  bool operator==(const InputChoice&) const = default;
};

/// P_axis = P_profile * beta / alpha (GTS manual 4.3.1); |alpha| >= |beta| > 0.
struct Scale {
  int16_t alpha = 1;
  int16_t beta = 1;

  /// A profile's or encoder's value in units of the axis; exact if the quotient is.
  double Apply(double value) const { return alpha == beta ? value : value * beta / alpha; }
  /// Whether the axis counts in the opposite direction to the profile.
  bool reverses() const { return (alpha < 0) != (beta < 0); }
  auto Fields(auto visit) const { return visit(alpha, beta); }
  bool operator==(const Scale&) const = default;
};

/// GT_SetSoftLimit: these values mean no limit.
inline constexpr int32_t kNoPositiveLimit = std::numeric_limits<int32_t>::max();
inline constexpr int32_t kNoNegativeLimit = std::numeric_limits<int32_t>::min();

/// The mean of a velocity over the last 2^exponent profile cycles, for reading only (assumption:
/// the public header calls the parameter `filterNumExp` and says no more).
struct VelocityFilter {
  int16_t exponent = 0;
  uint32_t next = 0;           ///< index of the next velocity
  std::vector<double> window;  ///< empty: no filter

  /// Chooses the length; the window is filled with the current velocity.
  void Set(int16_t new_exponent, double velocity);
  void Add(double velocity) {
    if (window.empty()) return;
    window[next] = velocity;
    next = (next + 1) % static_cast<uint32_t>(window.size());
  }
  /// The mean; the current velocity without a filter.
  double Mean(double velocity) const;

  auto Fields(auto visit) const { return visit(exponent, next, window); }
};

/// Position, velocity, acceleration of an axis, from its profiles or from its encoders.
struct AxisValue {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  double offset = 0;  ///< axis position minus the mapped sum
  VelocityFilter filter;

  /// The velocity as commands read it.
  double FilteredVelocity() const { return filter.Mean(velocity); }
  auto Fields(auto visit) const { return visit(position, velocity, acceleration, offset, filter); }
};

struct Axis {
  // Configuration.
  bool active = true;  ///< an inactive axis computes and monitors nothing
  InputChoice alarm;
  InputChoice positive_limit;
  InputChoice negative_limit;
  InputChoice smooth_stop;
  InputChoice abrupt_stop;
  uint32_t profile_map = 0;  ///< bit n-1: profile n
  uint32_t encoder_map = 0;
  Scale profile_scale;
  Scale encoder_scale;

  // Registers.
  bool alarm_on = true;
  bool positive_limit_on = true;
  bool negative_limit_on = true;
  int32_t soft_positive = kNoPositiveLimit;
  int32_t soft_negative = kNoNegativeLimit;
  int32_t band = 0;  ///< pulses
  Micros band_time = 0;
  bool band_set = false;  ///< GT_SetAxisBand has been called; only then is it judged

  // State.
  AxisValue profile;  ///< planned
  AxisValue encoder;  ///< measured
  /// Alarm, following error, limits and stops that have occurred. They stay until ClearStatus(),
  /// which keeps those whose cause still exists.
  uint32_t latched = 0;
  bool servo_on = false;
  bool in_band = false;      ///< at rest, and the error is inside the band
  Micros in_band_since = 0;  ///< the tick at which that began
  bool in_position = false;

  auto Fields(auto visit) const {
    return visit(active, alarm, positive_limit, negative_limit, smooth_stop, abrupt_stop,
                 profile_map, encoder_map, profile_scale, encoder_scale, alarm_on,
                 positive_limit_on, negative_limit_on, soft_positive, soft_negative, band,
                 band_time, band_set, profile, encoder, latched, servo_on, in_band, in_band_since,
                 in_position);
  }
};

/// Axis `number` (from 0) after reset: inputs, profile and encoder of the same number, no stop
/// inputs (GTS manual table 4-4).
Axis DefaultAxis(int number);

}  // namespace oncard::motion
