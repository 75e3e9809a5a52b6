// The notation of the GE catalogues in addition to rows/words.h: parameters with the limits of GE,
// and a name for the source of their rows.
#pragma once

#include <string_view>

#include "gtcalls/ge/limits.h"
#include "gtcalls/rows/words.h"

namespace oncard::gtcalls::ge::words {

using namespace gtcalls::words;

inline constexpr std::string_view kManual = "GE manual ch. 12";

constexpr Spec Axis() {
  Spec spec = UShort("axis").In(Unit::kIndex).Range(1, kAxisMax);
  spec.parameter.axis_number = true;
  return spec;
}
constexpr Spec AdcChannel() { return UShort("channel").In(Unit::kIndex).Range(1, kAdcMax); }
/// One bit per axis, or two for its limits.
constexpr Spec Sense() { return UShort("sense").In(Unit::kMask); }
constexpr Spec Position() { return Long("pos").In(Unit::kPulse).Range(kPositionMin, kPositionMax); }
constexpr Spec Velocity() {
  return Double("vel").In(Unit::kPulsePerMs).Range(kVelocityMin, kVelocityMax);
}
constexpr Spec Acceleration(std::string_view name) {
  return Double(name).In(Unit::kPulsePerMs2).Range(0, kAccelerationMax);
}
constexpr Spec Jerk() { return Double("jerk").In(Unit::kPulsePerMs3).Range(0, kJerkMax); }
constexpr Spec Gain(std::string_view name) { return Double(name).Range(0, kGainMax); }
constexpr Spec ServoLimit(std::string_view name) { return UShort(name).Range(0, kServoLimitMax); }
constexpr Spec OutputPosition() { return Long("pos").Output().In(Unit::kPulse); }
constexpr Spec OutputVelocity() { return Double("vel").Output().In(Unit::kPulsePerMs); }

}  // namespace oncard::gtcalls::ge::words
