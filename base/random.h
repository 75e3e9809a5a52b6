// Random numbers that are the same everywhere: SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
#pragma once

#include <cstdint>

#include "base/wide_product.h"

namespace oncard {

/// The next number of the generator; every state is a good seed.
inline uint64_t NextRandom(uint64_t& state) {
  uint64_t z = state += 0x9e3779b97f4a7c15;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  return z ^ z >> 31;
}

/// A number below `bound`, which is not 0.
inline uint64_t RandomBelow(uint64_t& state, uint64_t bound) {
  return UpperProduct(NextRandom(state), bound);
}

}  // namespace oncard
