// How many of each resource a card has, and the units in which the motion core counts.
#pragma once

#include <cstddef>
#include <cstdint>

namespace oncard::motion {

/// Axes, profiles, encoders, servo controllers, DACs and pulse outputs of the largest card. A
/// smaller card uses the first MotionConfig::axis_count of each.
inline constexpr size_t kAxisMax = 12;
/// Encoders that belong to no axis, on cards of up to 8 axes: auxiliary encoders 9 and 10, the hand
/// wheel 11, counted from 0 here (assumption: the vendor's configuration files name encoder 9 on
/// a card of 8 axes and 9 to 11 on one of 4, public hosts read 9 and 11).
inline constexpr size_t kAuxiliaryFirst = 8;
inline constexpr size_t kAuxiliaryCount = 3;
/// Coordinate systems (GT_SetCrdPrm).
inline constexpr size_t kCrdCount = 2;
/// Axes of a coordinate system: X, Y, Z, A.
inline constexpr size_t kCrdDimensionMax = 4;
/// PVT tables and points of each (GT_PvtTable).
inline constexpr size_t kPvtTableCount = 32;
inline constexpr size_t kPvtPointMax = 1024;

/// Largest absolute position a command may name, pulses (GTS manual, GT_SetPos).
inline constexpr int32_t kPositionMax = 1'073'741'823;
/// Assumption: the smallest velocity, acceleration, time or ratio that a command may ask for where
/// the manuals say "> 0". Products of two of them, and the time of the longest distance at this
/// velocity, are still representable in planning.
inline constexpr double kRateMin = 1e-9;
/// The velocity that planning uses for a register: values below kRateMin mean standstill.
constexpr double PlannedVelocityOf(double velocity) {
  return velocity < kRateMin && velocity > -kRateMin ? 0 : velocity;
}

/// Virtual time in microseconds since power-on. All events of the motion core are at whole
/// microseconds.
using Micros = int64_t;

/// Milliseconds from one instant to a later one; the unit of all planning.
constexpr double MsBetween(Micros from, Micros to) { return static_cast<double>(to - from) / 1000; }

}  // namespace oncard::motion
