// Electronic gears: when a slave follows, which masters there are, and what stops slaves and their
// masters. All masters here move at 1 pulse/ST with 0.1 pulse/ST^2: 10 ST and 5 pulses.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DiType;

/// Four axes with pulses, all enabled. Axis 1 is the current one.
class Gt400Gear : public ::testing::Test {
 protected:
  Gt400Gear() {
    for (const int axis : {4, 3, 2, 1}) card_.Enable(axis);
  }

  void Choose(int axis) { card_.Do("GT_Axis", {static_cast<double>(axis)}); }
  /// Makes the current axis follow a master.
  void Follow(int master, double ratio) {
    card_.Do("GT_PrflG", {static_cast<double>(master)});
    card_.Do("GT_SetRatio", {ratio});
    card_.Do("GT_Update");
  }
  void MoveTo(int axis, double target) {
    Choose(axis);
    card_.MoveT(target, 1, 0.1);
  }
  double Planned(int axis) {
    return card_.motion.profile(static_cast<size_t>(axis - 1)).now.position;
  }
  uint32_t StatusOf(int axis) {
    Choose(axis);
    return card_.Status();
  }

  Gt400TestCard card_;
};

TEST_F(Gt400Gear, FollowsFromTheUpdateThatMakesARatioValid) {
  card_.Do("GT_PrflG", {2});
  EXPECT_EQ(card_.Read("GT_GetMode"), 0x1800);
  card_.Do("GT_SetRatio", {-1.5});
  EXPECT_EQ(card_.Read("GT_GetRatio"), -1.5);
  MoveTo(2, 1000);
  card_.Run(20);
  EXPECT_EQ(Planned(1), 0);
  EXPECT_EQ(StatusOf(1), 0x0B00u);
  card_.Do("GT_Update");
  EXPECT_EQ(StatusOf(1), 0x0F00u);
  const double begin = Planned(2);
  card_.Run(2000);
  EXPECT_EQ(Planned(2), 1000);
  EXPECT_DOUBLE_EQ(Planned(1), -1.5 * (1000 - begin));
  EXPECT_EQ(StatusOf(1), 0x0F00u) << "it moves, and no motion ends";
}

TEST_F(Gt400Gear, AnUpdateWithoutARatioDoesNotBeginIt) {
  card_.Do("GT_PrflG", {2});
  card_.Do("GT_SetPos", {50});
  card_.Do("GT_Update");
  EXPECT_EQ(StatusOf(1), 0x0B00u);
}

TEST_F(Gt400Gear, AnotherRatioHoldsFromItsUpdateOn) {
  Follow(2, 2);
  MoveTo(2, 1000);
  card_.Run(15);  // at 10
  Choose(1);
  card_.Do("GT_SetRatio", {0.5});
  card_.Do("GT_Update");  // at 11
  card_.Run(10);
  EXPECT_DOUBLE_EQ(Planned(1), 22 + 5);
}

// The chain of the manual: axis 4 leads axis 1, which leads axis 3.
TEST_F(Gt400Gear, SlavesLeadOtherSlavesWithoutALag) {
  Follow(4, -1.5);
  Choose(3);
  Follow(1, 0.5);
  MoveTo(4, 1000);
  card_.Run(15);
  EXPECT_DOUBLE_EQ(Planned(4), 10);
  EXPECT_DOUBLE_EQ(Planned(1), -15);
  EXPECT_DOUBLE_EQ(Planned(3), -7.5);
}

TEST_F(Gt400Gear, AuxiliaryEncodersLead) {
  Follow(5, 3);
  Choose(2);
  Follow(6, -1);
  motion::MotionState& state = ChangeState(card_.motion);
  state.plants[motion::kAuxiliaryFirst].hand = 2;
  state.plants[motion::kAuxiliaryFirst + 1].hand = 1;
  card_.Run(11);  // encoders are read as of the tick before
  EXPECT_DOUBLE_EQ(Planned(1), 60);
  EXPECT_DOUBLE_EQ(Planned(2), -10);
}

TEST_F(Gt400Gear, AMasterInOpenLoopLeadsWithItsEncoder) {
  Choose(2);
  card_.Do("GT_AxisOff");
  card_.Do("GT_CtrlMode", {0});
  card_.Do("GT_OpenLp");
  Choose(1);
  Follow(2, 2);
  ChangeState(card_.motion).plants[1].hand = 3;
  card_.Run(11);
  EXPECT_DOUBLE_EQ(Planned(1), 60);
}

TEST_F(Gt400Gear, RefusesMastersThatItDoesNotHave) {
  for (const double master : {0.0, 7.0, 1.0}) card_.RefusesParameter("GT_PrflG", {master});
}

TEST_F(Gt400Gear, IsChosenAtRestOrOutOfAnotherGear) {
  card_.MoveT(1000, 1, 0.1);
  card_.Refuses(kModeInUse, "GT_PrflG", {2});
  card_.RunToRest();
  Follow(2, 1);
  card_.Do("GT_PrflG", {3});
  EXPECT_FALSE(card_.StatusBit(kBitMoves));
}

TEST_F(Gt400Gear, RatiosHaveARange) {
  for (const double ratio : {16384.0, -16384.0, 0.0}) card_.Do("GT_SetRatio", {ratio});
  for (const double ratio : {16384.5, -16384.5}) card_.Refuses(kOverflow, "GT_SetRatio", {ratio});
}

TEST_F(Gt400Gear, PositionsOfASlaveCannotBeSet) {
  Follow(2, 1);
  card_.Refuses(kInMotion, "GT_ZeroPos");
  card_.Refuses(kInMotion, "GT_SetAtlPos", {5});
}

TEST_F(Gt400Gear, AnotherModeLeavesItAtRest) {
  Follow(2, 1);
  MoveTo(2, 1000);
  card_.Run(15);
  Choose(1);
  card_.Do("GT_PrflT");
  EXPECT_EQ(card_.Status(), 0x0B00u);
  card_.Run(10);
  EXPECT_EQ(Planned(1), 10);
  EXPECT_EQ(Planned(2), 20);
}

TEST_F(Gt400Gear, AnAbruptStopAndADriveThatIsSwitchedOffEndItUntilTheNextRatio) {
  for (const char* command : {"GT_AbptStp", "GT_AxisOff"}) {
    Gt400TestCard card;
    card.Enable(2);
    card.Enable(1);
    card.Do("GT_PrflG", {2});
    card.Do("GT_SetRatio", {1});
    card.Do("GT_Update");
    card.Do("GT_Axis", {2});
    card.MoveT(1000, 1, 0.1);
    card.Run(15);
    card.Do("GT_Axis", {1});
    card.Do(command);
    EXPECT_FALSE(card.StatusBit(kBitMoves)) << command;
    card.Do("GT_AxisOn");
    card.Run(10);
    EXPECT_EQ(card.motion.profile(0).now.position, 10) << command;
    EXPECT_TRUE(card.motion.profile(1).now.moving) << "the master goes on";
    card.Do("GT_SetRatio", {1});
    card.Do("GT_Update");
    EXPECT_TRUE(card.StatusBit(kBitMoves)) << command;
  }
}

// --- Slaves that are stopped -------------------------------------------------------------------

TEST_F(Gt400Gear, ALimitOfTheSlaveStopsItsMaster) {
  Follow(2, -2);
  MoveTo(2, 1000);
  card_.Run(15);
  card_.SetInput(DiType::kLimitNegative, 0, true);
  EXPECT_EQ(Planned(2), 11);
  EXPECT_EQ(Planned(1), -22);
  EXPECT_EQ(StatusOf(2), 0x1B01u);
  EXPECT_EQ(StatusOf(1), 0x0B40u) << "no motion of a slave ends";
  card_.Run(10);
  EXPECT_EQ(Planned(2), 11);
}

TEST_F(Gt400Gear, TheMasterCannotGoOnTowardsTheLimitOfItsSlave) {
  Follow(2, -2);
  MoveTo(2, 1000);
  card_.Run(15);
  card_.SetInput(DiType::kLimitNegative, 0, true);
  for (const int axis : {1, 2}) {
    Choose(axis);
    card_.Do("GT_ClrSts");
  }
  card_.MoveT(500, 1, 0.1);
  EXPECT_EQ(StatusOf(2), 0x1B01u);
  EXPECT_EQ(StatusOf(1), 0x0B40u);
  card_.Run(10);
  EXPECT_EQ(Planned(2), 11);
}

// The slave follows back from the first tick on, without an Update of its own.
TEST_F(Gt400Gear, TheSlaveFollowsItsMasterBackFromTheLimit) {
  Follow(2, -2);
  MoveTo(2, 1000);
  card_.Run(15);
  card_.SetInput(DiType::kLimitNegative, 0, true);
  Choose(2);
  card_.MoveT(0, 1, 0.1);
  card_.Cycle();
  EXPECT_TRUE(card_.StatusBit(kBitMoves));
  EXPECT_EQ(StatusOf(1), 0x0F40u);
  card_.Run(100);
  EXPECT_EQ(Planned(2), 0);
  EXPECT_NEAR(Planned(1), 0, 1e-12);
}

TEST_F(Gt400Gear, TheLimitOfASlaveOfASlaveStopsTheFirstMaster) {
  Follow(4, -1.5);
  Choose(3);
  Follow(1, 0.5);
  MoveTo(4, 1000);
  card_.Run(15);
  card_.SetInput(DiType::kLimitNegative, 2, true);
  EXPECT_EQ(Planned(4), 11);
  EXPECT_EQ(StatusOf(4), 0x3B01u);
  EXPECT_EQ(StatusOf(3), 0x2B40u);
  card_.Run(5);
  EXPECT_EQ(Planned(4), 11);
  EXPECT_EQ(Planned(1), -16.5);
  Choose(4);
  card_.MoveT(500, 1, 0.1);
  card_.Run(5);
  EXPECT_EQ(Planned(4), 11);
}

// An encoder cannot be stopped: the slave rests at its limit until the encoder turns back.
TEST_F(Gt400Gear, AnEncoderLeadsOnWhileALimitHoldsTheSlave) {
  Follow(5, 1);
  motion::Plant& wheel = ChangeState(card_.motion).plants[motion::kAuxiliaryFirst];
  wheel.hand = 4;
  card_.Run(11);
  card_.SetInput(DiType::kLimitPositive, 0, true);
  EXPECT_EQ(Planned(1), 44);
  EXPECT_EQ(StatusOf(1), 0x0B20u);
  card_.Run(20);
  EXPECT_EQ(Planned(1), 44);
  ChangeState(card_.motion).plants[motion::kAuxiliaryFirst].hand = -4;
  card_.Run(2);
  EXPECT_TRUE(card_.StatusBit(kBitMoves));
  EXPECT_EQ(Planned(1), 40);
}

TEST_F(Gt400Gear, AnAlarmOfTheSlaveStopsItsMasterAndEndsTheGear) {
  Follow(2, -2);
  MoveTo(2, 1000);
  card_.Run(15);
  card_.SetInput(DiType::kAlarm, 0, true);
  EXPECT_EQ(Planned(2), 11);
  EXPECT_EQ(StatusOf(2), 0x1B01u);
  EXPECT_EQ(StatusOf(1), 0x0903u);
  Choose(2);
  card_.MoveT(0, 1, 0.1);
  card_.Run(10);
  EXPECT_EQ(Planned(1), -22);
}

TEST_F(Gt400Gear, AMotionErrorOfTheSlaveDoesTheSameIfTheHostWantsThat) {
  for (const bool stops : {false, true}) {
    Gt400TestCard card;
    card.Enable(2);
    card.Do("GT_Axis", {1});  // in closed loop
    card.Do("GT_SetPosErr", {10});
    card.Do("GT_AxisOn");
    if (stops) card.Do("GT_AuStpOn");
    card.Do("GT_PrflG", {2});
    card.Do("GT_SetRatio", {1});
    card.Do("GT_Update");
    card.Do("GT_ClrSts");
    ChangeState(card.motion).plants[0].stalled = true;
    card.Do("GT_Axis", {2});
    card.MoveT(1000, 1, 0.1);
    card.Run(30);
    EXPECT_EQ(card.Status(), stops ? 0x1B01u : 0x1F00u);
    card.Do("GT_Axis", {1});
    EXPECT_EQ(card.Status(), stops ? 0x0911u : 0x0F10u);
  }
}

TEST_F(Gt400Gear, ARingOfGearsRests) {
  Follow(2, 1);
  Choose(2);
  Follow(1, 1);
  card_.Run(10);
  card_.SetInput(DiType::kAlarm, 0, true);
  EXPECT_EQ(Planned(1), 0);
  EXPECT_EQ(Planned(2), 0);
  EXPECT_EQ(StatusOf(2), 0x1F00u);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
