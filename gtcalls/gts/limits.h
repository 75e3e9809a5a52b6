// The limits of GTS commands: GTS manual chapter 13 and table 4-4, unless noted. The motion core
// has capacities of its own, into which they must fit (family.cc).
#pragma once

namespace oncard::gtcalls::gts {

/// Axes, profiles, controllers, encoders and outputs are numbered from 1 to at most this; a card
/// may have fewer, which the commands check.
inline constexpr int kAxisMax = 12;
/// Elements that one call of GT_GetEncPos or GT_GetSts reads.
inline constexpr int kReadMax = 8;
/// Assumption: the analogue inputs of an 8-axis card.
inline constexpr int kAdcMax = 8;
inline constexpr int kCrdMax = 2;
inline constexpr int kThreadLast = 31;
inline constexpr int kPageLast = 31;
/// Variables per call of GT_GetVarValue.
inline constexpr int kVariableMax = 6;
/// Words per call of GT_LoadPlcCommand.
inline constexpr int kLoadMax = 24;
inline constexpr double kPositionMax = 1073741823;
/// Assumption: the smallest value where the manuals say "> 0".
inline constexpr double kAboveZero = 1e-9;
/// Velocities, accelerations and times of coordinate systems are below this.
inline constexpr double kRateBound = 32767;
/// The open end of such a range: the nearest double below.
inline constexpr double kBelow32767 = kRateBound - 0x1p-38;
/// Assumption: the manual has GT_SetPosErr take 2147483648 too, which its type long does not hold.
inline constexpr double kPositionErrorMax = 2147483647;
/// Assumption: the largest exponent of GT_SetKvffFilter.
inline constexpr int kKvffFilterMax = 8;
/// Assumption: the largest exponent of GT_SetAxisPrfVelFilter; the header names no range.
inline constexpr int kVelocityFilterMax = 8;
/// Assumption: the largest count of GT_SetAxisInputShaping, profile cycles.
inline constexpr int kShaperCyclesMax = 1000;
/// TTrapPrm.smoothTime, ms.
inline constexpr int kSmoothTimeMax = 50;
/// Positions captured in a row (GT_SetCaptureRepeat).
inline constexpr int kCaptureRepeatMax = 256;
/// PVT tables and the points of one (GTS manual chapter 7).
inline constexpr int kPvtTableMax = 32;
inline constexpr int kPvtPointMax = 1024;
/// Assumption: numbers of GT_SetLongVar and GT_SetDoubleVar.
inline constexpr int kUserVariableLast = 1023;
/// Assumption: extension modules are numbered from 0.
inline constexpr int kModuleLast = 15;
/// Assumption: analogue channels of an extension module.
inline constexpr int kModuleChannelLast = 7;
/// Capacity: bytes of one access to the process image or to an object of a slave.
inline constexpr int kBusBytesMax = 1486;
/// Assumption: the largest exponent of GT_SetPosScale; the manual's example is 6.
inline constexpr int kPosScaleMax = 30;

}  // namespace oncard::gtcalls::gts
