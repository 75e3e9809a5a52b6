#include "motion/common/cube_root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace oncard::motion {
namespace {

TEST(CubeRoot, ErrsAtMostOneUlp) {
  // Mantissas over three octaves, whose exponents leave each remainder modulo 3.
  for (int exponent = -996; exponent <= 996; exponent += 83) {
    for (int i = 0; i < 2000; ++i) {
      const double value = std::ldexp(1 + 0.0035 * i, exponent);
      const double root = CubeRoot(value);
      const long double exact = std::cbrt(static_cast<long double>(value));
      const double ulp = std::nextafter(root, HUGE_VAL) - root;
      ASSERT_LE(std::fabs(static_cast<double>((root - exact) / ulp)), 1) << value;
    }
  }
}

TEST(CubeRoot, OfNothingIsNothing) { EXPECT_EQ(CubeRoot(0), 0); }

}  // namespace
}  // namespace oncard::motion
