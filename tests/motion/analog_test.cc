// Analogue converters: scales, bias, limit, filter.
#include "motion/io/analog.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "motion/common/rounding.h"

namespace oncard::motion {
namespace {

TEST(Whole, RoundsHalvesAwayFromZeroAndKeepsWhatIsNoInteger) {
  const double infinite = std::numeric_limits<double>::infinity();
  struct {
    double value, whole;
  } const cases[] = {{0.5, 1},
                     {-0.5, -1},
                     {2.4, 2},
                     {-2.6, -3},
                     {4503599627370495.5, 4503599627370496},
                     {4503599627370497, 4503599627370497},
                     {9.3e18, 9.3e18},
                     {-1e300, -1e300},
                     {infinite, infinite}};
  for (const auto& c : cases) EXPECT_EQ(Whole(c.value), c.whole) << c.value;
  EXPECT_TRUE(std::isnan(Whole(std::nan(""))));
}

TEST(Dac, AddsTheBiasThenLimitsThenRounds) {
  struct {
    double value;
    int16_t bias, limit, output;
  } const cases[] = {{0, 0, 32767, 0},         {1000, -300, 32767, 700},
                     {32767, 1, 32767, 32767}, {-32767, -1, 32767, -32767},
                     {5000, 0, 4000, 4000},    {-5000, 500, 4000, -4000},
                     {10.4, 0, 32767, 10},     {10.5, 0, 32767, 11},
                     {-10.5, 0, 32767, -11},   {77, 0, 0, 0}};
  for (const auto& c : cases) {
    Dac dac;
    dac.value = c.value;
    dac.bias = c.bias;
    dac.limit = c.limit;
    EXPECT_EQ(dac.Output(), c.output) << c.value << " " << c.bias << " " << c.limit;
  }
}

TEST(Dac, FullScaleIsTenVolts) {
  Dac dac;
  dac.value = 32767;
  EXPECT_EQ(dac.Volts(), 10);
  dac.reversed = true;
  EXPECT_EQ(dac.Volts(), -10);
  EXPECT_EQ(dac.Output(), 32767);
  dac.active = false;
  EXPECT_EQ(dac.Output(), 0);
  EXPECT_EQ(dac.Volts(), 0);
}

TEST(Adc, TwelveAndAHalfVoltsAreFullScale) {
  struct {
    double volts;
    int value;
  } const cases[] = {{0, 0},        {5, 13107},      {-5, -13107}, {10, 26214},
                     {12.5, 32767}, {-12.5, -32768}, {99, 32767},  {-99, -32768},
                     {0.00019, 0},  {0.0002, 1}};  // half a step is 0.000190735 V
  for (const auto& c : cases) {
    Adc adc;
    adc.volts = c.volts;
    adc.Sample();
    EXPECT_EQ(adc.Value(), c.value) << c.volts;
    EXPECT_DOUBLE_EQ(adc.Volts(), c.value * 12.5 / 32768) << c.volts;
  }
}

TEST(Adc, AFilterOfNCyclesTakesAnNthOfTheDifferenceInEach) {
  Adc adc;
  adc.filter = 4;
  adc.volts = 8;
  for (const double expected : {2.0, 3.5, 4.625}) {
    adc.Sample();
    EXPECT_DOUBLE_EQ(adc.filtered, expected);
  }
  for (int i = 0; i < 100; ++i) adc.Sample();
  EXPECT_EQ(adc.filtered, 8);
}

}  // namespace
}  // namespace oncard::motion
