// The limits of GT400 commands: GT manual chapters 3, 4 and 11, unless noted. The motion core has
// capacities of its own, into which they must fit (family.cc).
#pragma once

#include <cstdint>

namespace oncard::gtcalls::gt400 {

/// Cards of a computer, which are numbered from 0.
inline constexpr int kCardMax = 16;
/// Axes are numbered from 1. All cards have as many.
inline constexpr int kAxisMax = 4;
/// Auxiliary encoders, which belong to no axis.
inline constexpr int kAuxiliaryMax = 2;
/// Masters of gears: the axes, then the auxiliary encoders.
inline constexpr int kMasterMax = kAxisMax + kAuxiliaryMax;
inline constexpr int32_t kPositionMin = -1073741824;
inline constexpr int32_t kPositionMax = 1073741823;
/// Of velocities, of accelerations in modes T and V and of gear ratios; below 0 the same.
inline constexpr double kRateMax = 16384;
/// The acceleration and the jerk of the S curve are below this.
inline constexpr double kSCurveEnd = 0.5;
/// Gains, the limits of the servo controller and the following error limit.
inline constexpr int kServoMax = 32767;
/// Coordinates of a path.
inline constexpr int kCoordinateMax = 4;
inline constexpr int kAdcMax = 8;
/// The sample time in microseconds: 200 at power-on, at most 65536 steps of 30 ns.
inline constexpr double kSampleTime = 200;
inline constexpr double kSampleTimeMin = 48;
inline constexpr double kSampleTimeMax = 1966.08;
/// Of time interrupts, sample times.
inline constexpr int kInterruptPeriodMax = 32767;
/// Of a set of background commands, bytes. Assumption: the manual gives none.
inline constexpr int kBackgroundSizeMax = 65536;
inline constexpr double kNsPerUs = 1000;

}  // namespace oncard::gtcalls::gt400
