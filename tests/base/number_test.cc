// Numbers in the notations of users and files (base/number.h).
#include "base/number.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace oncard {
namespace {

struct NumberCase {
  const char* text;
  double value;
};

class ANumber : public testing::TestWithParam<NumberCase> {};

TEST_P(ANumber, IsRead) { EXPECT_EQ(ReadNumber(GetParam().text), GetParam().value); }

INSTANTIATE_TEST_SUITE_P(ReadNumber, ANumber,
                         testing::Values(NumberCase{"0", 0}, NumberCase{"12", 12},
                                         NumberCase{"-1.5", -1.5}, NumberCase{"+3", 3},
                                         NumberCase{".5", 0.5}, NumberCase{"2e3", 2000},
                                         NumberCase{"1e-3", 0.001}, NumberCase{"0e-999", 0},
                                         NumberCase{"5e-324", 5e-324}, NumberCase{"007", 7},
                                         NumberCase{"0x10", 16}, NumberCase{"-0XfF", -255},
                                         NumberCase{"0xFFFFFFFF", 4294967295.0}));

class NoNumber : public testing::TestWithParam<const char*> {};

TEST_P(NoNumber, IsRefused) { EXPECT_FALSE(ReadNumber(GetParam()).has_value()); }

INSTANTIATE_TEST_SUITE_P(ReadNumber, NoNumber,
                         testing::Values("", "-", "+", ".", "x", "1x", " 1", "1 ", "--1", "+-1",
                                         "inf", "-inf", "INF", "infinity", "nan", "-nan", "nan(1)",
                                         "e5", "1e", "1e999", "1e-999", "0x", "0x-1", "0x100000000",
                                         "0x1p3", "1,5", "1.2.3"));

TEST(ReadLeadingNumber, EndsWhereTheNumberEnds) {
  EXPECT_EQ(ReadLeadingNumber("12.5"), 12.5);
  EXPECT_EQ(ReadLeadingNumber("12.5f"), 12.5);
  EXPECT_EQ(ReadLeadingNumber("f"), 0);
  EXPECT_EQ(ReadLeadingNumber("1e999"), 0);
}

// A little more than 1 + 2^-24, which is halfway between two floats. The nearest double is exactly
// halfway, and would be rounded again, to 1.
TEST(ReadLeadingFloat, IsRoundedOnce) {
  constexpr const char* kText = "1.000000059604644776280f";
  EXPECT_EQ(static_cast<float>(ReadLeadingNumber(kText)), 1.0F);
  EXPECT_EQ(ReadLeadingFloat(kText), 1.0F + 0x1p-23F);
}

TEST(ReadLeadingFloat, IsZeroWithoutANumberThatFits) {
  EXPECT_EQ(ReadLeadingFloat("f"), 0);
  EXPECT_EQ(ReadLeadingFloat("1e39"), 0);
  EXPECT_EQ(ReadLeadingFloat("1e-50"), 0);
}

TEST(ReadWhole, TakesWhatFitsTheType) {
  EXPECT_EQ(ReadWhole<int>("-12"), -12);
  EXPECT_EQ(ReadWhole<uint8_t>("255"), 255);
  EXPECT_EQ(ReadWhole<uint64_t>("ffffffffffffffff", 16), UINT64_MAX);
  EXPECT_FALSE(ReadWhole<uint8_t>("256").has_value());
  EXPECT_FALSE(ReadWhole<uint32_t>("-1").has_value());
  EXPECT_FALSE(ReadWhole<int>("+1").has_value());
  EXPECT_FALSE(ReadWhole<int>("1.0").has_value());
  EXPECT_FALSE(ReadWhole<int>("").has_value());
}

}  // namespace
}  // namespace oncard
