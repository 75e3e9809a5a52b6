// Motion of single axes in modes T, V and S. Times and places are those of the examples of the GT
// manual, 4.1.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

TEST(Gt400ModeT, AcceleratesCruisesAndDecelerates) {
  Gt400TestCard card;
  card.Enable(1);
  card.MoveT(80000, 1, 0.01);
  card.Run(50);
  EXPECT_NEAR(card.Read("GT_GetPrfVel"), 0.5, 1e-12);
  card.Run(50);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 50);
  // 100 ST and 50 pulses up, the same down, and 79900 ST between them.
  EXPECT_EQ(card.RunToRest(), 80100 - 100);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 80000);
  EXPECT_EQ(card.Status(), 0x0B01u);
}

TEST(Gt400ModeT, TargetAndVelocityMayChangeInMotion) {
  Gt400TestCard card;
  card.Enable(1);
  card.MoveT(10000, 1, 0.01);
  card.Run(200);  // at 150
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 150);
  card.Do("GT_SetPos", {-50});
  card.Do("GT_SetVel", {0.5});
  card.Do("GT_Update");  // at 151: 100 ST to rest at 201; then 251 pulses back
  // 50 ST and 12.5 pulses up, the same down, 226 pulses and 452 ST between them.
  EXPECT_EQ(card.RunToRest(), 100 + 50 + 452 + 50);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), -50);
}

TEST(Gt400ModeV, VelocityGrowsAndShrinksThroughZero) {
  Gt400TestCard card;
  card.Enable(1);
  card.Do("GT_PrflV");
  card.Do("GT_SetVel", {1});
  card.Do("GT_SetAcc", {0.01});
  card.Do("GT_Update");
  card.Run(100);
  EXPECT_EQ(card.Read("GT_GetPrfVel"), 1);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 50);
  card.Do("GT_SetVel", {-2});
  card.Do("GT_Update");
  card.Run(100);
  EXPECT_NEAR(card.Read("GT_GetPrfVel"), 0, 1e-12);
  EXPECT_TRUE(card.StatusBit(10));
  card.Run(200);
  EXPECT_EQ(card.Read("GT_GetPrfVel"), -2);
  card.Do("GT_SetVel", {0});
  card.Do("GT_Update");
  EXPECT_EQ(card.RunToRest(), 200);
  EXPECT_EQ(card.Status(), 0x0B01u);
}

TEST(Gt400ModeS, KeepsToItsJerk) {
  // GT manual example 4-1: the distance is too short for the acceleration and for the velocity, so
  // that jerk is all that limits. T = 4 (D / 2J)^(1/3), the quarter is passed at D / 12.
  Gt400TestCard card;
  card.Enable(1);
  card.Do("GT_PrflS");
  card.Do("GT_SetPos", {80000});
  card.Do("GT_SetVel", {4});
  card.Do("GT_SetMAcc", {0.004});
  card.Do("GT_SetJerk", {2e-8});
  card.Do("GT_Update");
  card.Run(12599);
  EXPECT_NEAR(card.motion.profile(0).now.position, 6666.332526, 1e-5);
  EXPECT_EQ(card.RunToRest(), 50397 - 12599);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 80000);
  EXPECT_EQ(card.Status(), 0x0B01u);
}

/// Cruises in mode S, at 95: the ramp took 1 / 0.01 + 0.01 / 0.001 = 110 ST and 55 pulses.
void CruiseInModeS(Gt400TestCard& card) {
  card.Enable(1);
  card.Do("GT_PrflS");
  card.Do("GT_SetPos", {200});
  card.Do("GT_SetVel", {1});
  card.Do("GT_SetMAcc", {0.01});
  card.Do("GT_SetJerk", {0.001});
  card.Do("GT_Update");
  card.Run(150);
  EXPECT_NEAR(card.motion.profile(0).now.position, 95, 1e-9);
}

TEST(Gt400ModeS, TargetMayChangeInMotion) {
  // The update is at 96. Ahead: a cruise, then 110 ST and 55 pulses. Behind: a stop as long, at
  // 151, and the way back to 0, with a cruise of 151 - 2 * 55 pulses.
  const struct {
    double target;
    int time;
  } cases[] = {{300, 204 - 55 + 110}, {0, 110 + 110 + 41 + 110}};
  for (const auto& c : cases) {
    Gt400TestCard card;
    CruiseInModeS(card);
    card.Do("GT_SetPos", {c.target});
    card.Do("GT_Update");
    EXPECT_EQ(card.RunToRest(), c.time);
    EXPECT_EQ(card.Read("GT_GetPrfPos"), c.target);
  }
}

TEST(Gt400Mode, ChangesAtRestOnly) {
  Gt400TestCard card;
  card.Enable(1);
  card.MoveT(1000, 1, 0.1);
  for (const char* mode : {"GT_PrflT", "GT_PrflS", "GT_PrflV"}) card.Refuses(kModeInUse, mode);
  card.RunToRest();
  for (const char* mode : {"GT_PrflS", "GT_PrflV", "GT_PrflT"}) card.Do(mode);
}

TEST(Gt400Stop, AtOnceForgetsTheVelocity) {
  for (const char* mode : {"GT_PrflT", "GT_PrflS", "GT_PrflV"}) {
    Gt400TestCard card;
    card.Enable(1);
    card.Do(mode);
    card.Do("GT_SetPos", {10000});
    card.Do("GT_SetVel", {1});
    card.Do("GT_SetAcc", {0.01});
    card.Do("GT_SetMAcc", {0.01});
    card.Do("GT_SetJerk", {0.001});
    card.Do("GT_Update");
    card.Run(200);
    card.Do("GT_AbptStp");
    EXPECT_EQ(card.Status(), 0x0B01u) << mode;
    EXPECT_EQ(card.Read("GT_GetPrfVel"), 0);
    EXPECT_EQ(card.Read("GT_GetVel"), 0);
    const double position = card.Read("GT_GetPrfPos");
    card.Run(10);
    EXPECT_EQ(card.Read("GT_GetPrfPos"), position);
  }
}

TEST(Gt400Stop, OnlyTheOneAtOnceMakesAVelocityNecessary) {
  for (const bool at_once : {true, false}) {
    Gt400TestCard card;
    card.Enable(1);
    card.MoveT(10000, 1, 0.01);
    card.Run(200);
    card.Do(at_once ? "GT_AbptStp" : "GT_SmthStp");
    card.Do("GT_Update");
    card.RunToRest();
    card.Do("GT_SetPos", {10000});
    card.Do("GT_Update");
    EXPECT_EQ(card.StatusBit(10), !at_once);
  }
}

TEST(Gt400Stop, AtOnceIsAnEventAtRestToo) {
  Gt400TestCard card;
  card.Do("GT_AbptStp");
  EXPECT_EQ(card.Status(), 0x0901u);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
