// The rows of the catalogue of path cards as constants, and the notation that only they need.
#pragma once

#include <limits>

#include "gtcalls/ge/words.h"

namespace oncard::gtcalls::ges {

/// AXIS_NUM.
inline constexpr int kWatchedAxes = 4;

namespace words {

using namespace ge::words;
using ge::kPositionMax;
using ge::kPositionMin;

inline constexpr std::string_view kPublicHeader = "public header";

constexpr Spec WatchWords() { return UShort("config").Input().In(Unit::kBits).Array(kWatchedAxes); }
constexpr Spec Char(std::string_view name) { return Scalars(Scalar::kChar, name); }
/// Greater than 0.
constexpr Spec Positive(std::string_view name) {
  return Double(name).Range(std::numeric_limits<double>::min(), kUnbounded);
}
constexpr Spec Coordinate(std::string_view name) {
  return Double(name).In(Unit::kPulse).Range(kPositionMin, -kPositionMin);
}
constexpr Spec Millimetres(std::string_view name) { return Double(name).In(Unit::kMillimetre); }
// Code 4 outside of their ranges, for which the commands themselves care.
constexpr Spec PathVelocity(std::string_view name) { return Double(name).In(Unit::kPulsePerMs); }
constexpr Spec PathAcceleration(std::string_view name) {
  return Double(name).In(Unit::kPulsePerMs2);
}
constexpr Spec Ratio() { return Double("override").Range(0, 2); }
/// Degrees.
constexpr Spec Angle() { return Double("angle").Range(-360, 360); }
constexpr Spec Direction() { return Short("direction"); }
constexpr Spec Point() { return Double("point").Output().In(Unit::kPulse).PerAxis(); }
constexpr Spec Delay(std::string_view name) {
  return Long(name).In(Unit::kMillisecond).Range(1, 8191);
}
constexpr Spec OutputBit(std::string_view name) {
  return UShort(name).In(Unit::kIndex).Range(0, 15);
}
constexpr Spec Level(std::string_view name) { return Short(name).Range(0, 1); }
constexpr Spec AuxiliaryEncoder() { return UShort("encoder").In(Unit::kIndex).Range(1, 2); }

}  // namespace words
}  // namespace oncard::gtcalls::ges

#define FAMILY_COMMANDS "gtcalls/ge/ges_catalogue.def"
#define FAMILY_STRUCTURES "gtcalls/ge/ges_structures.def"
namespace oncard::gtcalls::ges {
#include "gtcalls/rows/rows.inc"
}  // namespace oncard::gtcalls::ges
#undef FAMILY_COMMANDS
#undef FAMILY_STRUCTURES
