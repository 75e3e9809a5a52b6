// The arithmetic of `double`, with numbers calculated by hand: 1.0 is 65536.
#include "vm/fixed_point.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/random.h"
#include "tests/vm/raw_doubles.h"

namespace oncard::vm {
namespace {

constexpr int kNarrow = WrapShift(DoubleFormat::k16_16);
constexpr int64_t kWideMax = (int64_t{1} << 47) - 1;
constexpr int64_t kWideMin = -(int64_t{1} << 47);
constexpr int64_t kNarrowMax = (int64_t{1} << 31) - 1;
constexpr int64_t kNarrowMin = -(int64_t{1} << 31);

TEST(FixedPointTest, RangesAre48And32Bits) {
  EXPECT_EQ(FixedMin(DoubleFormat::k32_16), kWideMin);
  EXPECT_EQ(FixedMax(DoubleFormat::k32_16), kWideMax);
  EXPECT_EQ(FixedMin(DoubleFormat::k16_16), kNarrowMin);
  EXPECT_EQ(FixedMax(DoubleFormat::k16_16), kNarrowMax);
}

struct Case {
  int64_t a;
  int64_t b;
  int64_t wide;
  int64_t narrow;
};

TEST(FixedPointTest, SumsWrap) {
  for (const Case& c :
       {Case{kOne, kOne / 2, 98304, 98304}, Case{kNarrowMax, 1, kNarrowMax + 1, kNarrowMin},
        Case{kNarrowMin, -1, kNarrowMin - 1, kNarrowMax}}) {
    EXPECT_EQ(AddFixed(c.a, c.b, kWide), c.wide);
    EXPECT_EQ(AddFixed(c.a, c.b, kNarrow), c.narrow);
  }
  EXPECT_EQ(AddFixed(kWideMax, 1, kWide), kWideMin);
  EXPECT_EQ(AddFixed(kWideMin, -1, kWide), kWideMax);
}

TEST(FixedPointTest, DifferencesWrap) {
  for (const Case& c :
       {Case{kOne, 3 * kOne, -131072, -131072}, Case{kNarrowMin, 1, kNarrowMin - 1, kNarrowMax},
        Case{0, kNarrowMin, -kNarrowMin, kNarrowMin}}) {
    EXPECT_EQ(SubtractFixed(c.a, c.b, kWide), c.wide);
    EXPECT_EQ(SubtractFixed(c.a, c.b, kNarrow), c.narrow);
  }
  EXPECT_EQ(SubtractFixed(0, kWideMin, kWide), kWideMin);
}

TEST(FixedPointTest, ProductsAreTruncatedTowardZero) {
  for (const Case& c : {
           Case{3 * kOne / 2, -2 * kOne, -3 * kOne, -3 * kOne},
           Case{1, 1, 0, 0},         // 2^-32
           Case{1, -1, 0, 0},        // -2^-32
           Case{65535, -1, 0, 0},    // just less than 2^-16 in magnitude
           Case{-65537, 1, -1, -1},  // just more
           Case{98304, 3, 4, 4},     // 1.5 * 3 units = 4.5 units
           Case{-98304, 3, -4, -4},
           Case{200 * kOne, 200 * kOne, 40000 * kOne, (40000 - 65536) * kOne},
       }) {
    EXPECT_EQ(MultiplyFixed(c.a, c.b, kWide), c.wide) << c.a << " * " << c.b;
    EXPECT_EQ(MultiplyFixed(c.a, c.b, kNarrow), c.narrow) << c.a << " * " << c.b;
  }
  // (-2^31) * (-2^31) = 2^62, a multiple of 2^32.
  EXPECT_EQ(MultiplyFixed(kWideMin, kWideMin, kWide), 0);
  EXPECT_EQ(MultiplyFixed(kWideMin, 1, kWide), kWideMin / kOne);
  // (2^31 - 2^-16)^2 = 2^62 - 2^16 + 2^-32: truncated and modulo 2^32 it is -2^16.
  EXPECT_EQ(MultiplyFixed(kWideMax, kWideMax, kWide), -65536 * kOne);
}

// The definition, with numbers of 128 bits.
int64_t ExactProduct(int64_t a, int64_t b, int wrap_shift) {
  __extension__ using Wide = __int128;
  return WrapFixed(static_cast<int64_t>(static_cast<Wide>(a) * b / kOne), wrap_shift);
}

TEST(FixedPointTest, ProductsAreThoseOfWideNumbers) {
  uint64_t random = 1;
  const auto raw = [&random](int wrap_shift) {
    // Numbers of all lengths, including the ends of the range.
    const auto bits = static_cast<int64_t>(NextRandom(random)) >> NextRandom(random) % 64;
    return WrapFixed(bits, wrap_shift);
  };
  for (const int wrap_shift : {kWide, kNarrow}) {
    for (int i = 0; i < 100000; ++i) {
      const int64_t a = raw(wrap_shift);
      const int64_t b = raw(wrap_shift);
      ASSERT_EQ(MultiplyFixed(a, b, wrap_shift), ExactProduct(a, b, wrap_shift)) << a << " * " << b;
    }
  }
}

TEST(FixedPointTest, QuotientsAreTruncatedTowardZero) {
  for (const Case& c : {
           Case{kOne, 3 * kOne, 21845, 21845},  // 65536 / 3 = 21845.3
           Case{-kOne, 3 * kOne, -21845, -21845},
           Case{kOne, -3 * kOne, -21845, -21845},
           Case{7 * kOne, 2 * kOne, 7 * kOne / 2, 7 * kOne / 2},
           Case{1, 2 * kOne, 0, 0},
           Case{-1, 2 * kOne, 0, 0},
           Case{1, 1, kOne, kOne},
           Case{1, -1, -kOne, -kOne},
           Case{kOne, 1, int64_t{1} << 32, 0},
           Case{kNarrowMin, -kOne, -kNarrowMin, kNarrowMin},
       }) {
    EXPECT_EQ(DivideFixed(c.a, c.b, kWide), c.wide) << c.a << " / " << c.b;
    EXPECT_EQ(DivideFixed(c.a, c.b, kNarrow), c.narrow) << c.a << " / " << c.b;
  }
  EXPECT_EQ(DivideFixed(kWideMin, -kOne, kWide), kWideMin);
  EXPECT_EQ(DivideFixed(kWideMin, -1, kWide), 0);     // 2^47 * 2^16 = 2^63, modulo 2^48
  EXPECT_EQ(DivideFixed(kWideMax, -1, kWide), kOne);  // -(2^47 - 1) * 2^16, modulo 2^48
}

TEST(FixedPointTest, CastsFromIntAreExactOrWrap) {
  EXPECT_EQ(FixedFromInt(-5, kWide), -5 * kOne);
  EXPECT_EQ(FixedFromInt(INT32_MIN, kWide), kWideMin);
  EXPECT_EQ(FixedFromInt(INT32_MAX, kWide), kWideMax - 65535);
  EXPECT_EQ(FixedFromInt(32767, kNarrow), 32767 * kOne);
  EXPECT_EQ(FixedFromInt(32768, kNarrow), -32768 * kOne);
  EXPECT_EQ(FixedFromInt(65537, kNarrow), kOne);
}

TEST(FixedPointTest, CastsToIntAreTruncatedTowardZero) {
  EXPECT_EQ(IntFromFixed(2 * kOne - 1), 1);
  EXPECT_EQ(IntFromFixed(-2 * kOne + 1), -1);
  EXPECT_EQ(IntFromFixed(-1), 0);
  EXPECT_EQ(IntFromFixed(-2 * kOne), -2);
  EXPECT_EQ(IntFromFixed(kWideMax), INT32_MAX);
  EXPECT_EQ(IntFromFixed(kWideMin), INT32_MIN);
}

TEST(FixedPointTest, HostValuesAreTruncatedAndChecked) {
  int64_t raw = 77;
  EXPECT_TRUE(FixedFromDouble(-0.25, DoubleFormat::k32_16, &raw));
  EXPECT_EQ(raw, -16384);
  EXPECT_TRUE(FixedFromDouble(1.99 / 65536, DoubleFormat::k32_16, &raw));
  EXPECT_EQ(raw, 1);
  EXPECT_TRUE(FixedFromDouble(-1.99 / 65536, DoubleFormat::k32_16, &raw));
  EXPECT_EQ(raw, -1);
  EXPECT_TRUE(FixedFromDouble(-32768, DoubleFormat::k16_16, &raw));
  EXPECT_EQ(raw, kNarrowMin);
  EXPECT_TRUE(FixedFromDouble(2147483647.75, DoubleFormat::k32_16, &raw));
  EXPECT_EQ(raw, (int64_t{2147483647} << 16) + 49152);
  raw = 77;
  EXPECT_FALSE(FixedFromDouble(32768, DoubleFormat::k16_16, &raw));
  EXPECT_FALSE(FixedFromDouble(2147483648.0, DoubleFormat::k32_16, &raw));
  EXPECT_FALSE(FixedFromDouble(-2147483649.0, DoubleFormat::k32_16, &raw));
  EXPECT_FALSE(
      FixedFromDouble(std::numeric_limits<double>::quiet_NaN(), DoubleFormat::k32_16, &raw));
  EXPECT_FALSE(
      FixedFromDouble(std::numeric_limits<double>::infinity(), DoubleFormat::k32_16, &raw));
  EXPECT_EQ(raw, 77);
}

TEST(FixedPointTest, RawNumbersAreExactDoubles) {
  EXPECT_EQ(DoubleFromFixed(98304), 1.5);
  EXPECT_EQ(DoubleFromFixed(kWideMin), -2147483648.0);
  EXPECT_EQ(DoubleFromFixed(kWideMax), 2147483647.0 + 65535.0 / 65536.0);
}

}  // namespace
}  // namespace oncard::vm
