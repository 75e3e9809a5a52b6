// Points and directions in the space of a coordinate system. Pure functions; each sum has a fixed
// order, so that results are the same on every computer.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "motion/common/sizes.h"

namespace oncard::motion {

/// Coordinates X, Y, Z, A; unused ones are 0.
using Coordinates = std::array<double, kCrdDimensionMax>;

/// The set of all coordinates: bit n is coordinate n.
inline constexpr uint32_t kAllCoordinates = (1u << kCrdDimensionMax) - 1;

/// The way from a to b.
inline Coordinates Between(const Coordinates& a, const Coordinates& b) {
  Coordinates way;
  for (size_t i = 0; i < way.size(); ++i) way[i] = b[i] - a[i];
  return way;
}

/// A length that is measured with the coordinates of a set.
inline double LengthIn(uint32_t axes, const Coordinates& way) {
  double square = 0;
  for (size_t i = 0; i < way.size(); ++i) {
    if ((axes >> i & 1) != 0) square += way[i] * way[i];
  }
  return std::sqrt(square);
}

}  // namespace oncard::motion
