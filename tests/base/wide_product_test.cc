#include "base/wide_product.h"

#include <gtest/gtest.h>

#include "base/random.h"

namespace oncard {
namespace {

struct Case {
  uint64_t a;
  uint64_t b;
  uint64_t upper;
};

TEST(WideProductTest, GivesTheUpperHalf) {
  constexpr uint64_t kMax = UINT64_MAX;
  constexpr uint64_t kHalf = UINT64_C(1) << 32;
  for (const Case& c : {
           Case{0, kMax, 0},
           Case{1, kMax, 0},
           Case{2, kMax, 1},                          // 2^65 - 2
           Case{kMax, kMax, kMax - 1},                // 2^128 - 2^65 + 1
           Case{kHalf, kHalf, 1},                     // 2^64
           Case{kHalf - 1, kHalf + 1, 0},             // 2^64 - 1
           Case{kHalf, kMax, kHalf - 1},              // 2^96 - 2^32
           Case{kMax - kHalf, kHalf + 1, kHalf - 1},  // (2^64 - 2^32 - 1)(2^32 + 1)
                                                      // = 2^96 - 2^33 - 1
           Case{UINT64_C(1) << 63, 6, 3},
       }) {
    EXPECT_EQ(UpperProductByHalves(c.a, c.b), c.upper) << c.a << " * " << c.b;
    EXPECT_EQ(UpperProductByHalves(c.b, c.a), c.upper) << c.b << " * " << c.a;
    EXPECT_EQ(UpperProduct(c.a, c.b), c.upper) << c.a << " * " << c.b;
  }
}

TEST(WideProductTest, IsTheSameWithAndWithoutWideNumbers) {
  uint64_t random = 1;
  for (int i = 0; i < 100000; ++i) {
    // Numbers of all lengths.
    const uint64_t a = NextRandom(random) >> NextRandom(random) % 64;
    const uint64_t b = NextRandom(random) >> NextRandom(random) % 64;
    ASSERT_EQ(UpperProductByHalves(a, b), UpperProduct(a, b)) << a << " * " << b;
  }
}

}  // namespace
}  // namespace oncard
