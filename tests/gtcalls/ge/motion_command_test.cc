// Modes, registers, updates and stops of GE axes. Times and distances follow from the trapezoids of
// the GE manual, chapter 5: v/a to the velocity, v^2/2a on the way.
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/ge_test_card.h"

namespace oncard::gtcalls::ge {
namespace {

constexpr double kCycle = 0.25;

TEST(GeModeT, MovesAsTheManualsExample) {
  GeTestCard card;
  card.MoveT(1, 200000, 166.7, 4);
  card.Run(600);
  // 41.675 ms and 3473.611 pulses up, then 558.325 ms at 166.7.
  EXPECT_NEAR(card.Read("GT_GetPrfPos", {1}), 3473.611 + 558.325 * 166.7, 1);
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 166.7);
  EXPECT_NEAR(600 + card.RunToRest(1), 1241.435, kCycle);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 200000);
  EXPECT_EQ(card.Read("GT_GetAtlPos", {1}), 200000);
}

TEST(GeModeT, TakesAnotherTargetAndVelocityOnTheWay) {
  const struct {
    const char* what;
    double register_value;
    double total_ms;
    double end;
  } cases[] = {
      // v 20, a 0.5, from 0 to 20000; 40 ms and 400 pulses up. At 500 ms:
      {"GT_SetPos", 40000, 2040, 40000},
      // At 9600: 40 ms and 400 pulses to rest at 10000, then 290 ms back over 5000.
      {"GT_SetPos", 5000, 830, 5000},
      // 40 ms and 1200 pulses to 40, and 80 ms and 1600 down: 10400 - 2800 are left at 40.
      {"GT_SetVel", 40, 500 + 40 + 80 + 7600 / 40.0, 20000},
  };
  for (const auto& c : cases) {
    GeTestCard card;
    card.MoveT(1, 20000, 20, 0.5);
    card.Run(500);
    card.Do(c.what, {1, c.register_value});
    card.Do("GT_Update", {1});
    EXPECT_NEAR(500 + card.RunToRest(1), c.total_ms, kCycle) << c.what;
    EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), c.end) << c.what;
  }
}

TEST(GeModeT, ReachesBothEndsOfItsRange) {
  GeTestCard card;
  card.MoveT(1, 1073741823, 40957, 102400);
  card.RunToRest(1);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 1073741823);
  card.MoveT(1, -1073741824, 40957, 102400);
  card.RunToRest(1);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), -1073741824);
}

TEST(GeModeS, MovesAsTheManualsExample) {
  GeTestCard card;
  card.Do("GT_PrflS", {1});
  card.Do("GT_SetPos", {1, 200000});
  card.Do("GT_SetVel", {1, 166.7});
  card.Do("GT_SetMAcc", {1, 4});
  card.Do("GT_SetJerk", {1, 0.001});
  card.Do("GT_Update", {1});
  // The acceleration never reaches 4: the ramp is 2 sqrt(166.7 / 0.001) = 816.578 ms long.
  card.Run(400);
  EXPECT_NEAR(card.Read("GT_GetPrfPos", {1}), 0.001 * 400 * 400 * 400 / 6, 1);
  EXPECT_NEAR(400 + card.RunToRest(1), 2016.338, kCycle);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 200000);
}

/// Mode S, 50 pulse/ms, 0.5 pulse/ms^2, 0.01 pulse/ms^3: ramps of 150 ms and 3750 pulses.
void MoveS(GeTestCard* card, double position) {
  card->Do("GT_PrflS", {1});
  card->Do("GT_SetPos", {1, position});
  card->Do("GT_SetVel", {1, 50});
  card->Do("GT_SetMAcc", {1, 0.5});
  card->Do("GT_SetJerk", {1, 0.01});
  card->Do("GT_Update", {1});
}

TEST(GeModeS, StopsSmoothlyAndAtOnce) {
  GeTestCard card;
  MoveS(&card, 100000);
  card.Run(250);
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 50);
  card.Do("GT_SmthStp", {1});
  card.Refuses(1, kInMotion, "GT_Update", {1});
  EXPECT_NEAR(card.RunToRest(1), 150, kCycle);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 3750 + 5000 + 3750);
  card.Do("GT_Update", {1});
  card.Run(200);
  card.Do("GT_AbptStp", {1});
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 0);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 12500 + 3750 + 2500);
}

TEST(GeModeS, TakesOnlyAnotherTargetOnTheWay) {
  GeTestCard card;
  MoveS(&card, 20000);
  card.Run(200);
  const struct {
    const char* set;
    double value;
    double working;
  } cases[] = {{"GT_SetVel", 60, 50}, {"GT_SetMAcc", 1, 0.5}, {"GT_SetJerk", 0.02, 0.01}};
  for (const auto& c : cases) {
    card.Do(c.set, {1, c.value});
    card.Refuses(1, kInMotion, "GT_Update", {1});
    card.Do(c.set, {1, c.working});
  }
  card.Do("GT_SetAcc", {1, 3});  // not of this mode
  card.Do("GT_SetPos", {1, 40000});
  card.Do("GT_Update", {1});
  // Two ramps of 3750 pulses, 32500 at 50.
  EXPECT_NEAR(200 + card.RunToRest(1), 150 + 650 + 150, kCycle);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 40000);
}

TEST(GeModeV, PassesThroughRestWhenTheVelocityChangesItsSign) {
  GeTestCard card;
  card.Do("GT_PrflV", {1});
  card.Do("GT_SetVel", {1, 10});
  card.Do("GT_SetAcc", {1, 0.1});
  card.Do("GT_Update", {1});
  card.Run(200);
  // 100 ms and 500 pulses up.
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 10);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 1500);
  card.Do("GT_SetVel", {1, -5});
  card.Do("GT_Update", {1});
  card.Run(100);
  EXPECT_NEAR(card.Read("GT_GetPrfVel", {1}), 0, 1e-9);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 2000);
  card.Run(100);
  // 50 ms and 125 pulses back to -5, then 50 ms.
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), -5);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 1625);
}

TEST(GeRegisters, AreReadAsLastSetAndWorkAfterAnUpdate) {
  GeTestCard card("GE-800-PV");
  const struct {
    const char* set;
    const char* get;
    double start;
    double lowest;
    double highest;
    double below;
    double above;
  } registers[] = {
      {"GT_SetPos", "GT_GetPos", 0, -1073741824, 1073741823, -1073741825, 1073741824},
      {"GT_SetVel", "GT_GetVel", 0, 0, 40957, -1, 40957.5},
      {"GT_SetAcc", "GT_GetAcc", 0, 0, 102400, -0.5, 102400.5},
      {"GT_SetMAcc", "GT_GetMAcc", 0, 0, 102400, -0.5, 102400.5},
      {"GT_SetJerk", "GT_GetJerk", 0, 0, 256000, -0.5, 256001},
      {"GT_SetKp", "GT_GetKp", 0, 0, 32767, -0.5, 32768},
      {"GT_SetKi", "GT_GetKi", 0, 0, 32767, -0.5, 32768},
      {"GT_SetKd", "GT_GetKd", 0, 0, 32767, -0.5, 32768},
      {"GT_SetKvff", "GT_GetKvff", 0, 0, 32767, -0.5, 32768},
      {"GT_SetKaff", "GT_GetKaff", 0, 0, 32767, -0.5, 32768},
      {"GT_SetILmt", "GT_GetILmt", 32767, 0, 32767, -1, 32768},
      {"GT_SetMtrLmt", "GT_GetMtrLmt", 32767, 0, 32767, -1, 32768},
      {"GT_SetMtrBias", "GT_GetMtrBias", 0, -32768, 32767, -32769, 32768},
      {"GT_SetPosErr", "GT_GetPosErr", 32767, 0, 32767, -1, 32768},
  };
  for (const auto& r : registers) {
    EXPECT_EQ(card.Read(r.get, {2}), r.start) << r.get;
    for (const double value : {r.lowest, r.highest}) {
      card.Do(r.set, {2, value});
      EXPECT_EQ(card.Read(r.get, {2}), value) << r.get;
    }
    for (const double value : {r.below, r.above}) {
      EXPECT_EQ(card.Call(r.set, {2, value}), 7) << r.set << ' ' << value;
      EXPECT_EQ(card.Read(r.get, {2}), r.highest) << r.get;
    }
    // Other axes have their own.
    EXPECT_EQ(card.Read(r.get, {1}), r.start) << r.get;
  }
}

TEST(GeRegisters, BelowZeroIsAVelocityOfTheVelocityModeOnly) {
  GeTestCard card;
  card.Refuses(7, kOverflow, "GT_SetVel", {1, -1});
  card.Do("GT_PrflV", {1});
  card.Do("GT_SetVel", {1, -40958});
  card.Refuses(7, kOverflow, "GT_SetVel", {1, -40958.5});
}

TEST(GeUpdate, IsRefusedInMotionForWhatMayNotChange) {
  for (const char* mode : {"GT_PrflT", "GT_PrflV"}) {
    GeTestCard card;
    card.Do(mode, {1});
    card.Do("GT_SetPos", {1, 100000});
    card.Do("GT_SetVel", {1, 10});
    card.Do("GT_SetAcc", {1, 1});
    card.Do("GT_Update", {1});
    card.Run(20);
    card.Do("GT_SetAcc", {1, 2});
    card.Do("GT_SetVel", {1, 20});
    card.Refuses(1, kInMotion, "GT_Update", {1});
    EXPECT_TRUE(card.StatusBit(1, 7)) << mode;
    // Nothing has been taken over, also not the velocity.
    card.Run(50);
    EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 10) << mode;
    card.Do("GT_SetAcc", {1, 1});
    card.Do("GT_Update", {1});
    card.Run(50);
    EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 20) << mode;
  }
}

TEST(GeUpdate, OfNothingToDoSucceeds) {
  const struct {
    double position;
    double velocity;
    double acceleration;
  } cases[] = {{0, 10, 1}, {1000, 0, 1}, {1000, 10, 0}};
  for (const auto& c : cases) {
    GeTestCard card;
    card.MoveT(1, c.position, c.velocity, c.acceleration);
    card.Run(10);
    EXPECT_EQ(card.Status(1), 0x900) << c.position;
    EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 0) << c.position;
  }
}

TEST(GeUpdate, OfSeveralAxesIsAllOrNothing) {
  GeTestCard card("GE-400-PG");
  card.Refuses(1, kEmptyMask, "GT_MltiUpdt", {0});
  for (const double axis : {1.0, 2.0, 3.0}) {
    card.Do("GT_PrflV", {axis});
    card.Do("GT_SetVel", {axis, 10});
    card.Do("GT_SetAcc", {axis, 0.1});
  }
  card.Do("GT_MltiUpdt", {0xFF05});  // axes that the card does not have are ignored
  card.Run(50);
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 5);
  EXPECT_EQ(card.Read("GT_GetPrfVel", {2}), 0);
  EXPECT_EQ(card.Read("GT_GetPrfVel", {3}), 5);
  card.Do("GT_SetAcc", {3, 0.2});
  card.Refuses(1, kInMotion, "GT_MltiUpdt", {6});
  EXPECT_FALSE(card.StatusBit(2, 10));
  EXPECT_TRUE(card.StatusBit(3, 7));
}

TEST(GeModes, ChangeAtRestOnly) {
  GeTestCard card;
  EXPECT_EQ(card.Read("GT_GetMode", {1}), 0);
  card.Do("GT_PrflV", {1});
  EXPECT_EQ(card.Read("GT_GetMode", {1}), 0x800);
  card.Do("GT_AuStpOn", {1});
  EXPECT_EQ(card.Read("GT_GetMode", {1}), 0x880);
  card.Do("GT_PrflS", {1});
  EXPECT_EQ(card.Read("GT_GetMode", {1}), 0x1080);
  card.Do("GT_AuStpOff", {1});
  card.MoveT(1, 1000, 1, 0.1);
  EXPECT_EQ(card.Read("GT_GetMode", {1}), 0);
  for (const char* mode : {"GT_PrflT", "GT_PrflS", "GT_PrflV"})
    card.Refuses(1, kModeInUse, mode, {1});
}

TEST(GeStops, DecelerateOrEndAtOnce) {
  GeTestCard card;
  card.Do("GT_PrflV", {1});
  card.Do("GT_SetVel", {1, 50});
  card.Do("GT_SetAcc", {1, 0.5});
  card.Do("GT_Update", {1});
  card.Run(300);
  card.Do("GT_SmthStp", {1});
  card.Refuses(1, kInMotion, "GT_Update", {1});
  // 100 ms and 2500 pulses up and down, 200 ms at 50.
  EXPECT_NEAR(card.RunToRest(1), 100, kCycle);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 15000);
  // The registers stay: the next update moves on.
  EXPECT_EQ(card.Read("GT_GetVel", {1}), 50);
  card.Do("GT_Update", {1});
  card.Run(100);
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 50);
  card.Do("GT_AbptStp", {1});
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 0);
  EXPECT_FALSE(card.StatusBit(1, 10));
  card.Run(10);
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 17500);
}

TEST(GeStops, OfAnAxisAtRestDoNothing) {
  GeTestCard card;
  const uint64_t before = card.motion.Hash();
  card.Do("GT_SmthStp", {1});
  card.Do("GT_AbptStp", {1});
  EXPECT_EQ(card.motion.Hash(), before);
}

}  // namespace
}  // namespace oncard::gtcalls::ge
