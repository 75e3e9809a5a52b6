// The capacities of the motion core: how much of each resource it has room for. How much a card has
// is configured or decided by its family. And the units in which the core counts.
#pragma once

#include <cstddef>
#include <cstdint>

namespace oncard::motion {

/// Capacity: axes, profiles, encoders, servo controllers, DACs and pulse outputs. A card uses the
/// first MotionConfig::axis_count of each.
inline constexpr size_t kAxisMax = 12;
/// Auxiliary encoders, which belong to no axis. They have the places behind the first eight, which
/// a card of more axes needs itself (docs/assumptions.md says what is connected to them).
inline constexpr size_t kAuxiliaryFirst = 8;
inline constexpr size_t kAuxiliaryCount = 3;
/// Capacity: coordinate systems.
inline constexpr size_t kCrdCount = 2;
/// Capacity: axes of a coordinate system, X, Y, Z, A.
inline constexpr size_t kCrdDimensionMax = 4;
/// Capacity: PVT tables.
inline constexpr size_t kPvtTableCount = 32;

/// Capacity: largest absolute position to move to, pulses. The distance between two fits an
/// int32_t.
inline constexpr int32_t kPositionMax = 1'073'741'823;
/// Assumption: the smallest velocity, acceleration, time or ratio with which motion is planned.
/// Products of two of them, and the time of the longest distance at this velocity, are still
/// representable.
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
