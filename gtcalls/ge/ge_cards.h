// What both families of GE cards have in common: codes, and what a card is after a reset. Source:
// GE manual, table 2-1, 3.2.2, 6.7.2.1 and chapter 12.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "gtcalls/ge/limits.h"
#include "motion/common/card_defaults.h"

namespace oncard::gtcalls::ge {

/// GE manual table 2-1: "communication failed". The manual has no other code for GT_Open.
inline constexpr int16_t kNotOpen = -1;

inline constexpr std::string_view kResetCommands[] = {"GT_Reset", "GT_HardRst"};

/// The cycle in which a motion has ended is the last one: the axis rests where it is.
inline constexpr double kAtOnce = std::numeric_limits<double>::infinity();

/// After a reset of a card with voltages.
inline constexpr motion::CardDefaults kAnalogueDefaults = {.smooth_stop = 1,
                                                           .abrupt_stop = kAtOnce,
                                                           .filter_ticks = 3,
                                                           .alarm_on = true,
                                                           .limits_on = true,
                                                           .encoders_external = true,
                                                           .encoders_reversed = false,
                                                           .closed_loop = true,
                                                           .following_error_limit = kServoLimitMax,
                                                           .following_error_stops = false};
/// The same with pulses only: no motor is in closed loop, whose following error counts.
inline constexpr motion::CardDefaults kPulseDefaults = {
    .smooth_stop = 1,
    .abrupt_stop = kAtOnce,
    .filter_ticks = 3,
    .alarm_on = false,
    .limits_on = true,
    .encoders_external = false,
    .encoders_reversed = false,
    .closed_loop = false,
    .following_error_limit = std::numeric_limits<int64_t>::max(),
    .following_error_stops = false};

}  // namespace oncard::gtcalls::ge
