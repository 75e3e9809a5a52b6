// Rounding on the path that every motor and encoder takes in every cycle.
#pragma once

#include <cstdint>

namespace oncard::motion {

/// The nearest whole number, halves away from 0; |value| < 2^62. Unlike std::round() it is no call
/// of a library.
inline double Whole(double value) {
  return static_cast<double>(static_cast<int64_t>(value + (value < 0 ? -0.5 : 0.5)));
}

}  // namespace oncard::motion
