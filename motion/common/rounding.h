// Rounding on the path that every motor and encoder takes in every cycle.
#pragma once

#include <cmath>
#include <cstdint>

namespace oncard::motion {

/// The nearest whole number, halves away from 0; unlike std::round() it is no call of a library.
/// From 2^52 on every double is one already; what is none stays what it is.
inline double Whole(double value) {
  constexpr double kAllWhole = 4'503'599'627'370'496;
  if (!(std::fabs(value) < kAllWhole)) return value;
  return static_cast<double>(static_cast<int64_t>(value + (value < 0 ? -0.5 : 0.5)));
}

}  // namespace oncard::motion
