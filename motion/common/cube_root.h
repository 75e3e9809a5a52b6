// The cube root, the same bits on every machine: only basic arithmetic, no library function.
// Tested by tests/motion/cube_root_test.cc.
#pragma once

#include <bit>
#include <cstdint>

namespace oncard::motion {

/// Of `value` in [1e-300, 1e300], or 0; error at most 1 ulp.
inline double CubeRoot(double value) {
  if (value == 0) return 0;
  // A third of the exponent errs by less than 6 %; each of Newton's steps squares the error.
  constexpr uint64_t kTwoThirdsOfTheBias = 0x2A9F7893'00000000;
  auto root = std::bit_cast<double>(std::bit_cast<uint64_t>(value) / 3 + kTwoThirdsOfTheBias);
  for (int step = 0; step < 4; ++step) {
    root -= (root * root * root - value) / (3 * root * root);
  }
  return root;
}

}  // namespace oncard::motion
