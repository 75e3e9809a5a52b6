#include "motion/common/trigonometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace oncard::motion {
namespace {

/// The distance of a double from the exact value, in units of its last place.
double UlpError(double value, long double exact) {
  const auto rounded = static_cast<double>(exact);
  const double ulp = std::nextafter(std::fabs(rounded), HUGE_VAL) - std::fabs(rounded);
  return std::fabs(static_cast<double>((static_cast<long double>(value) - exact) / ulp));
}

TEST(Trigonometry, SineAndCosineErrAtMostTwoUlp) {
  for (int i = -200000; i <= 200000; ++i) {
    const double angle = i * 0.000517;
    const auto [sine, cosine] = SineAndCosine(angle);
    ASSERT_LE(UlpError(sine, std::sin(static_cast<long double>(angle))), 2) << angle;
    ASSERT_LE(UlpError(cosine, std::cos(static_cast<long double>(angle))), 2) << angle;
  }
}

TEST(Trigonometry, QuartersOfACircle) {
  EXPECT_EQ(SineAndCosine(0).sine, 0);
  EXPECT_EQ(SineAndCosine(0).cosine, 1);
  EXPECT_EQ(SineAndCosine(kPi / 2).sine, 1);
  EXPECT_EQ(SineAndCosine(kPi).cosine, -1);
}

TEST(Trigonometry, AngleErrsAtMostTwoUlp) {
  for (int i = 0; i < 100000; ++i) {
    const double angle = i * 0.0000628;
    const double scale = 1 + (i % 1000) * 1000.0;
    const double x = scale * std::cos(angle);
    const double y = scale * std::sin(angle);
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    ASSERT_LE(UlpError(AngleOf(y, x), exact), 2) << x << ' ' << y;
  }
}

TEST(Trigonometry, AnglesOfTheAxes) {
  EXPECT_EQ(AngleOf(0, 0), 0);
  EXPECT_EQ(AngleOf(0, 2), 0);
  EXPECT_EQ(AngleOf(2, 0), kPi / 2);
  EXPECT_EQ(AngleOf(0, -2), kPi);
  EXPECT_EQ(AngleOf(-2, 0), -kPi / 2);
}

}  // namespace
}  // namespace oncard::motion
