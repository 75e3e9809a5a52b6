// The notation of the GT400 catalogue in addition to rows/words.h: common parameters, and a name
// for the source of its rows. Values that the card itself judges have no range here: it refuses
// them with 1 and says why in the command register.
#pragma once

#include <string_view>

#include "gtcalls/gt400/limits.h"
#include "gtcalls/rows/words.h"

namespace oncard::gtcalls::gt400::words {

using namespace gtcalls::words;

inline constexpr std::string_view kManual = "GT manual ch. 11";
/// Commands that the manual lacks.
inline constexpr std::string_view kHeader = "public GT400.h";

constexpr Spec AxisNumber(std::string_view name) {
  return UShort(name).In(Unit::kIndex).Range(1, kAxisMax);
}
/// One bit per axis, or two for its limits.
constexpr Spec Sense() { return UShort("sense").In(Unit::kMask); }
constexpr Spec Position(std::string_view name) { return Long(name).In(Unit::kPulse); }
constexpr Spec Velocity(std::string_view name) { return Double(name).In(Unit::kPulsePerSt); }
constexpr Spec Acceleration(std::string_view name) { return Double(name).In(Unit::kPulsePerSt2); }
constexpr Spec Jerk(std::string_view name) { return Double(name).In(Unit::kPulsePerSt3); }
constexpr Spec AuxiliaryEncoder(std::string_view name) {
  return UShort(name).In(Unit::kIndex).Range(1, kAuxiliaryMax);
}
constexpr Spec Coordinate(std::string_view name) { return Double(name).In(Unit::kLengthUnit); }
constexpr Spec PathVelocity(std::string_view name) {
  return Double(name).In(Unit::kLengthUnitPerSt);
}
constexpr Spec PathAcceleration(std::string_view name) {
  return Double(name).In(Unit::kLengthUnitPerSt2);
}
/// The coordinates x, y, z, a.
constexpr Spec Point() {
  return Double("point").Output().In(Unit::kLengthUnit).Array(kCoordinateMax);
}
constexpr Spec Angle() { return Double("angle").Range(-360, 360); }
constexpr Spec Word(std::string_view name) { return UShort(name).In(Unit::kBits); }

}  // namespace oncard::gtcalls::gt400::words
