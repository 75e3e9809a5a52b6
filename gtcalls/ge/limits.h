// The limits of GE commands: GE manual chapter 12, unless noted. The motion core has capacities of
// its own, into which they must fit (gep_family.cc).
#pragma once

#include <cstdint>

namespace oncard::gtcalls::ge {

/// Axes are numbered from 1 to at most this; a card may have fewer, which the commands check.
inline constexpr int kAxisMax = 8;
inline constexpr int kAdcMax = 8;
inline constexpr double kPositionMin = -1073741824;
inline constexpr double kPositionMax = 1073741823;
/// Velocities below 0 are for the velocity mode only.
inline constexpr double kVelocityMin = -40958;
inline constexpr double kVelocityMax = 40957;
inline constexpr double kAccelerationMax = 102400;
inline constexpr double kJerkMax = 256000;
inline constexpr double kGainMax = 32767;
/// The integral limit, the output limit and the following error limit.
inline constexpr int kServoLimitMax = 32767;

}  // namespace oncard::gtcalls::ge
