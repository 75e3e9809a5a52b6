// The input shaper of an axis through its command.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/gtcalls/axis_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(InputShapingCommand, ChecksItsParameters) {
  AxisCommandCard card;
  const struct {
    int axis, enable, count;
    double k;
    int code;
  } cases[] = {
      {1, 1, 1, 1, 0},      {8, 1, 1000, 1e-9, 0}, {1, 0, 0, 0, 0},      {1, 0, 1000, 1, 0},
      {0, 1, 10, 1, 7},     {9, 1, 10, 1, 7},      {-1, 1, 10, 1, 7},    {1, 2, 10, 1, 7},
      {1, -1, 10, 1, 7},    {1, 1, 0, 1, 7},       {1, 1, -1, 1, 7},     {1, 1, 1001, 1, 7},
      {1, 0, -1, 1, 7},     {1, 0, 1001, 1, 7},    {1, 1, 10, 0, 7},     {1, 1, 10, -0.5, 7},
      {1, 1, 10, 1.001, 7}, {1, 0, 10, -0.5, 7},   {1, 0, 10, 1.001, 7},
  };
  for (const auto& c : cases) {
    card.Expect(static_cast<int16_t>(c.code), "GT_SetAxisInputShaping",
                {c.axis, c.enable, c.count, c.k});
  }
  card.Expect(7, "GT_SetAxisInputShaping", {1, 1, 10, std::nan("")});
}

TEST(InputShapingCommand, DelaysThePulsesAndNotTheProfile) {
  constexpr int kCount = 30;
  AxisCommandCard card;
  card.Expect(0, "GT_AxisOn", {1});
  card.Expect(0, "GT_SetAxisInputShaping", {1, 1, kCount, 1});
  card.MoveTo(1, 1000, 10);
  card.Cycles(50);
  // At 10 pulse/ms half of the pulses are 30 ms late.
  EXPECT_NEAR(card.Read("GT_GetPrfPos") - card.Read("GT_GetEncPos"), 150, 1);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos"), card.Read("GT_GetPrfPos"));
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000);
  EXPECT_LT(card.Read("GT_GetEncPos"), 990);
  card.Cycles(kCount);
  EXPECT_EQ(card.Read("GT_GetEncPos"), 1000);
}

TEST(InputShapingCommand, IsRefusedUntilTheWholeMotionIsOutput) {
  constexpr int kCount = 30;
  AxisCommandCard card;
  card.Expect(0, "GT_AxisOn", {1});
  card.Expect(0, "GT_SetAxisInputShaping", {1, 1, kCount, 1});
  card.MoveTo(1, 1000, 10);
  card.Expect(1, "GT_SetAxisInputShaping", {1, 0, 0, 0});
  card.Expect(0, "GT_SetAxisInputShaping", {2, 1, kCount, 1});
  card.CyclesToRest();
  for (int i = 0; i < kCount; ++i) {
    card.Expect(1, "GT_SetAxisInputShaping", {1, i % 2, 10, 1});
    card.Cycle();
  }
  card.Expect(0, "GT_SetAxisInputShaping", {1, 1, 10, 1});
  card.Expect(0, "GT_SetAxisInputShaping", {1, 0, 0, 0});
}

TEST(InputShapingCommand, AnAxisThatIsSwitchedOffIsAsBefore) {
  AxisCommandCard card;
  const uint64_t before = card.motion.Hash();
  card.Expect(0, "GT_SetAxisInputShaping", {3, 1, 100, 0.5});
  EXPECT_NE(card.motion.Hash(), before);
  card.Expect(0, "GT_SetAxisInputShaping", {3, 0, 0, 0});
  EXPECT_EQ(card.motion.Hash(), before);
}

TEST(InputShapingCommand, ResetSwitchesItOff) {
  AxisCommandCard card;
  card.Expect(0, "GT_SetAxisInputShaping", {3, 1, 100, 0.5});
  card.motion.Reset();
  EXPECT_FALSE(card.motion.state().shapers);
}

TEST(InputShapingCommand, ZeroPosSetsBothPositionsInTheMiddleOfTheRest) {
  AxisCommandCard card;
  card.Expect(0, "GT_AxisOn", {1});
  card.Expect(0, "GT_SetAxisInputShaping", {1, 1, 40, 0.9});
  card.MoveTo(1, 1000, 10);
  card.CyclesToRest();
  card.Cycles(5);
  card.Expect(0, "GT_ZeroPos", {1, 1});
  card.Cycles(50);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 0);
  EXPECT_EQ(card.Read("GT_GetEncPos"), 0);
  // The next move is exact again.
  card.MoveTo(1, 500, 10);
  card.CyclesToRest();
  card.Cycles(40);
  EXPECT_EQ(card.Read("GT_GetEncPos"), 500);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
