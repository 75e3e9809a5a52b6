// What an Update does, and when it is refused. Source: GT manual 4.1, 4.3, 4.4.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

TEST(Gt400Update, ActsAtTheNextTickWithWhatWaited) {
  Gt400TestCard card;
  card.Enable(1);
  card.Do("GT_PrflV");
  card.Do("GT_SetVel", {1});
  card.Do("GT_SetAcc", {0.01});
  const int64_t before = card.motion.cycle();
  card.Do("GT_Update");
  EXPECT_EQ(card.motion.cycle(), before + 1);
  EXPECT_TRUE(card.StatusBit(10)) << "the plan begins at that instant";
  EXPECT_EQ(card.Read("GT_GetPrfVel"), 0);
  card.Do("GT_SetVel", {2});  // waits
  card.Run(200);
  EXPECT_EQ(card.Read("GT_GetPrfVel"), 1);
  card.Do("GT_Update");
  card.Run(100);
  EXPECT_EQ(card.Read("GT_GetPrfVel"), 2);
}

TEST(Gt400Update, MovesOnlyTheCurrentAxis) {
  Gt400TestCard card;
  for (const int axis : {1, 2}) {
    card.Enable(axis);
    card.Do("GT_SetPos", {100});
    card.Do("GT_SetVel", {1});
    card.Do("GT_SetAcc", {0.1});
  }
  card.Do("GT_Update");
  EXPECT_TRUE(card.StatusBit(10));
  card.Do("GT_Axis", {1});
  EXPECT_FALSE(card.StatusBit(10));
}

TEST(Gt400Update, MovesTheAxesOfAMaskTogether) {
  Gt400TestCard card;
  for (const int axis : {1, 2, 4}) {
    card.Enable(axis);
    card.Do("GT_SetPos", {100});
    card.Do("GT_SetVel", {1});
    card.Do("GT_SetAcc", {0.1});
  }
  const int64_t before = card.motion.cycle();
  card.Do("GT_MltiUpdt", {0xFFF9});  // of the bits those of axes count: 1 and 4
  EXPECT_EQ(card.motion.cycle(), before + 1);
  card.Run(5);
  for (const int axis : {1, 2, 4}) {
    card.Do("GT_Axis", {static_cast<double>(axis)});
    EXPECT_EQ(card.StatusBit(10), axis != 2);
    EXPECT_NEAR(card.Read("GT_GetPrfVel"), axis != 2 ? 0.5 : 0, 1e-12);
  }
  card.Refuses(kEmptyMask, "GT_MltiUpdt", {0});
  card.Refuses(kEmptyMask, "GT_MltiUpdt", {0xFFF0});
}

TEST(Gt400Update, OfAMaskIsRefusedForAllAxesOrNone) {
  Gt400TestCard card;
  card.Enable(1);
  card.MoveT(1000, 1, 0.1);
  card.Do("GT_SetAcc", {0.2});
  card.Enable(2);
  card.Do("GT_SetPos", {100});
  card.Do("GT_SetVel", {1});
  card.Do("GT_SetAcc", {0.1});
  card.Do("GT_SmthStp");
  card.Refuses(kInMotion, "GT_MltiUpdt", {3});
  EXPECT_FALSE(card.StatusBit(10));
  card.Do("GT_MltiUpdt", {2});
  EXPECT_TRUE(card.StatusBit(10)) << "the stop that waited has been dropped";
}

// --- What must not change in motion ----------------------------------------------------------

TEST(Gt400Update, IsRefusedWhenAValueChangesThatMustNot) {
  const struct {
    const char* mode;
    const char* setter;
    bool refused;
  } cases[] = {
      {"GT_PrflT", "GT_SetAcc", true},  {"GT_PrflT", "GT_SetVel", false},
      {"GT_PrflT", "GT_SetPos", false}, {"GT_PrflT", "GT_SetMAcc", false},
      {"GT_PrflS", "GT_SetVel", true},  {"GT_PrflS", "GT_SetMAcc", true},
      {"GT_PrflS", "GT_SetJerk", true}, {"GT_PrflS", "GT_SetPos", false},
      {"GT_PrflS", "GT_SetAcc", false}, {"GT_PrflV", "GT_SetVel", false},
      {"GT_PrflV", "GT_SetAcc", false},
  };
  for (const auto& c : cases) {
    Gt400TestCard card;
    card.Enable(1);
    card.Do(c.mode);
    card.Do("GT_SetPos", {10000});
    card.Do("GT_SetVel", {1});
    card.Do("GT_SetAcc", {0.01});
    card.Do("GT_SetMAcc", {0.01});
    card.Do("GT_SetJerk", {0.001});
    card.Do("GT_Update");
    card.Run(20);
    card.Do("GT_Update");  // the same values again
    card.Do(c.setter, {0.25});
    if (!c.refused) {
      card.Do("GT_Update");
      continue;
    }
    card.Refuses(kInMotion, "GT_Update");
    EXPECT_TRUE(card.StatusBit(7));
    EXPECT_EQ(card.Read(std::string("GT_Get") + (c.setter + 6)), 0.25) << "it goes on waiting";
    card.RunToRest();
    card.Do("GT_Update");
  }
}

// --- When an Update begins a motion ----------------------------------------------------------

TEST(Gt400Update, BeginsNoMotionWithoutAWrittenMotionRegister) {
  Gt400TestCard card;
  card.Enable(1);
  card.MoveT(100, 1, 0.1);
  card.RunToRest();
  card.Do("GT_ZeroPos");
  card.Do("GT_ClrSts");
  card.Do("GT_Update");
  EXPECT_EQ(card.Status(), 0x0B00u);
  card.Do("GT_SetPos", {100});
  card.Do("GT_Update");
  EXPECT_TRUE(card.StatusBit(10));
}

TEST(Gt400Update, OfAnAxisThatIsOffMakesValuesValidAndPlansNothing) {
  Gt400TestCard card;
  card.MoveT(100, 1, 0.1);
  EXPECT_EQ(card.Status(), 0x0900u);
  EXPECT_EQ(card.state().axes[0].valid.position, 100);
  card.Enable(1);
  card.Do("GT_Update");
  EXPECT_FALSE(card.StatusBit(10)) << "nothing has been written since";
}

TEST(Gt400Update, OfAnOpenLoopPlansNothing) {
  Gt400TestCard card;
  card.Do("GT_OpenLp");
  card.Do("GT_AxisOn");
  card.Do("GT_ClrSts");
  card.MoveT(100, 1, 0.1);
  EXPECT_EQ(card.Status(), 0x0A00u);
}

TEST(Gt400Update, WithoutLengthIsCompleteAtOnce) {
  const struct {
    const char* mode;
    double position;
    double velocity;
    bool complete;
  } cases[] = {
      {"GT_PrflT", 0, 1, true},  {"GT_PrflS", 0, 1, true},  {"GT_PrflV", 0, 0, true},
      {"GT_PrflT", 5, 0, false}, {"GT_PrflS", 5, 0, false},
  };
  for (const auto& c : cases) {
    Gt400TestCard card;
    card.Enable(1);
    card.Do(c.mode);
    card.Do("GT_SetPos", {c.position});
    card.Do("GT_SetVel", {c.velocity});
    for (const char* setter : {"GT_SetAcc", "GT_SetMAcc", "GT_SetJerk"}) card.Do(setter, {0.01});
    card.Do("GT_Update");
    EXPECT_EQ(card.Status(), c.complete ? 0x0B01u : 0x0B00u) << c.mode;
  }
}

TEST(Gt400Update, WithoutAnAccelerationOrAJerkMovesNothing) {
  for (const char* left_out : {"GT_SetAcc", "GT_SetMAcc", "GT_SetJerk"}) {
    for (const char* mode : {"GT_PrflT", "GT_PrflS", "GT_PrflV"}) {
      const bool needed =
          (left_out == std::string("GT_SetAcc")) != (mode == std::string("GT_PrflS"));
      Gt400TestCard card;
      card.Enable(1);
      card.Do(mode);
      card.Do("GT_SetPos", {50});
      card.Do("GT_SetVel", {1});
      for (const char* setter : {"GT_SetAcc", "GT_SetMAcc", "GT_SetJerk"}) {
        if (setter != std::string(left_out)) card.Do(setter, {0.01});
      }
      card.Do("GT_Update");
      EXPECT_EQ(card.Status(), needed ? 0x0B00u : 0x0F00u) << mode << ' ' << left_out;
    }
  }
}

TEST(Gt400Update, AStartDoesNotClearTheEventOfTheEnd) {
  Gt400TestCard card;
  card.Do("GT_CtrlMode", {1});
  card.Do("GT_AxisOn");
  card.MoveT(100, 1, 0.1);
  EXPECT_EQ(card.Status(), 0x0F01u);
  card.Do("GT_ClrSts");
  EXPECT_EQ(card.Status(), 0x0F00u);
  card.RunToRest();
  EXPECT_EQ(card.Status(), 0x0B01u);
}

// --- Commands that wait ----------------------------------------------------------------------

TEST(Gt400Update, StopsSmoothlyWithTheAccelerationOfTheMode) {
  // From 1 pulse/ST with 0.01 pulse/ST^2 it takes 100 ST and 50 pulses. In mode S 1/0.01 + 0.01 /
  // 0.001 = 110 ST and 55 pulses.
  const struct {
    const char* mode;
    int time;
    double way;
  } cases[] = {{"GT_PrflT", 100, 50}, {"GT_PrflV", 100, 50}, {"GT_PrflS", 110, 55}};
  for (const auto& c : cases) {
    Gt400TestCard card;
    card.Enable(1);
    card.Do(c.mode);
    card.Do("GT_SetPos", {10000});
    card.Do("GT_SetVel", {1});
    card.Do("GT_SetAcc", {0.01});
    card.Do("GT_SetMAcc", {0.01});
    card.Do("GT_SetJerk", {0.001});
    card.Do("GT_Update");
    card.Run(200);
    card.Do("GT_SmthStp");
    card.Run(10);
    EXPECT_EQ(card.Read("GT_GetPrfVel"), 1) << "it waits";
    const double position = card.motion.profile(0).now.position;
    card.Do("GT_Update");
    EXPECT_EQ(card.RunToRest(), c.time) << c.mode;
    EXPECT_NEAR(card.motion.profile(0).now.position, position + 1 + c.way, 1e-9) << c.mode;
    EXPECT_EQ(card.Status(), 0x0B01u);
    card.Do("GT_Update");
    EXPECT_EQ(card.Status(), 0x0B01u) << "the old target is not written anew";
  }
}

TEST(Gt400Update, SynchronisesPlanAndTargetWithTheActualPosition) {
  Gt400TestCard card;  // in closed loop without gains: nothing moves the motor
  card.Do("GT_SetPos", {500});
  ChangeState(card.motion).plants[0].hand = 2;
  card.Run(100);
  ChangeState(card.motion).plants[0].hand = 0;
  card.Do("GT_SynchPos");
  EXPECT_EQ(card.Read("GT_GetAtlErr"), -200) << "it waits";
  card.Do("GT_Update");
  EXPECT_EQ(card.Read("GT_GetAtlErr"), 0);
  for (const char* read : {"GT_GetPrfPos", "GT_GetAtlPos", "GT_GetPos"}) {
    EXPECT_EQ(card.Read(read), 200) << read;
  }
}

TEST(Gt400Update, SynchronisesAtRestInModesTAndSOnly) {
  Gt400TestCard card;
  card.Enable(1);
  card.Do("GT_PrflV");
  card.Do("GT_SynchPos");
  card.Refuses(kInMotion, "GT_Update");
  card.Do("GT_Update");  // without the command, which has been dropped
  card.MoveT(1000, 1, 0.1);
  card.Do("GT_SynchPos");
  card.Refuses(kInMotion, "GT_Update");
  card.RunToRest();
  card.Do("GT_PrflS");
  card.Do("GT_SynchPos");
  card.Do("GT_Update");
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
