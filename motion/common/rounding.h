// Fast rounding, used for every motor and encoder in every cycle.
#pragma once

#include <cmath>
#include <cstdint>

namespace oncard::motion {

/// The nearest whole number, halves away from 0; unlike std::round(), without a library call. From
/// 2^52 on every double is a whole number; infinities and NaN are returned unchanged.
inline double Whole(double value) {
  constexpr double kAllWhole = 4'503'599'627'370'496;
  if (!(std::fabs(value) < kAllWhole)) return value;
  return static_cast<double>(static_cast<int64_t>(value + std::copysign(0.5, value)));
}

}  // namespace oncard::motion
