// What a GTS card is after a reset, and the units in which its commands count time.
#pragma once

#include <cstdint>

#include "motion/common/card_defaults.h"

namespace oncard::gtcalls::gts {

/// Stops: GTS manual 6. Filters: `filterTime` of the vendor's configuration files. Encoders: GTS
/// manual table 4-4. Assumption: exceeding the following error limit switches the drive off and
/// stops abruptly, which the manual does not say.
inline constexpr motion::CardDefaults kDefaults = {
    .smooth_stop = 1,
    .abrupt_stop = 1000,
    .filter_ticks = 3,
    .alarm_on = true,
    .limits_on = true,
    .encoders_external = true,
    .encoders_reversed = true,
    .closed_loop = false,
    .following_error_limit = 32767,
    .following_error_stops = true,
};

/// GT_SetAxisBand and GT_SetDoBitReverse count in profile cycles of 250 us. Assumption:
/// GT_SetEncResponseCheck does too.
inline constexpr int64_t kTimeUnitUs = 250;
/// Whole units in a time, as the commands give it back.
constexpr double TimeUnits(int64_t time_us) {
  const int64_t units = time_us / kTimeUnitUs;
  return static_cast<double>(units);
}
/// GT_GetClockHighPrecision counts servo sub-steps of 125 us.
inline constexpr int64_t kFineClockUs = 125;

}  // namespace oncard::gtcalls::gts
