// What stops axes by itself: limit switches, alarms and motion errors, with the events of each.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DiType;

class Gt400Limit : public ::testing::Test {
 protected:
  Gt400Limit() { card_.Enable(1); }

  double Planned() { return card_.motion.profile(0).now.position; }
  void Positive(bool active) { card_.SetInput(DiType::kLimitPositive, 0, active); }
  void Negative(bool active) { card_.SetInput(DiType::kLimitNegative, 0, active); }
  /// Into the positive limit, at 1 pulse/ST.
  void RunIntoLimit() {
    card_.MoveT(1000, 1, 0.1);
    card_.Run(100);
    Positive(true);
  }

  Gt400TestCard card_;
};

// 10 ST and 5 pulses, 90 pulses, and the tick in which the switch becomes active.
TEST_F(Gt400Limit, StopsTheAxisInTheTickInWhichItBecomesActive) {
  RunIntoLimit();
  EXPECT_EQ(Planned(), 96);
  EXPECT_EQ(card_.Read("GT_GetPrfVel"), 0);
  EXPECT_EQ(card_.Status(), 0x0B21u);
  card_.Run(10);
  EXPECT_EQ(Planned(), 96);
}

TEST_F(Gt400Limit, BehindTheAxisIsOnlyAnEvent) {
  card_.MoveT(1000, 1, 0.1);
  card_.Run(100);
  Negative(true);
  EXPECT_EQ(card_.Status(), 0x0F40u);
  EXPECT_EQ(card_.RunToRest(), 1010 - 101);
}

TEST_F(Gt400Limit, OfAnAxisAtRestIsOnlyAnEvent) {
  Positive(true);
  EXPECT_EQ(card_.Status(), 0x0B20u);
}

TEST_F(Gt400Limit, AnUpdateTowardsItSucceedsWithoutMotion) {
  RunIntoLimit();
  card_.Do("GT_ClrSts");
  card_.Run(10);
  EXPECT_EQ(card_.Status(), 0x0B00u) << "cleared bits stay cleared on an active switch";
  for (const char* mode : {"GT_PrflT", "GT_PrflS", "GT_PrflV"}) {
    card_.Do(mode);
    card_.Do("GT_SetPos", {2000});
    card_.Do("GT_SetVel", {1});
    card_.Do("GT_SetMAcc", {0.1});
    card_.Do("GT_SetJerk", {0.01});
    card_.Do("GT_Update");
    EXPECT_EQ(card_.Status(), 0x0B21u) << mode;
    card_.Run(20);
    EXPECT_EQ(Planned(), 96) << mode;
    card_.Do("GT_ClrSts");
  }
}

TEST_F(Gt400Limit, AnUpdateAwayFromItMovesAtOnceBeforeTheEventIsCleared) {
  RunIntoLimit();
  card_.Do("GT_SetPos", {50});
  card_.Do("GT_Update");
  EXPECT_TRUE(card_.StatusBit(kBitMoves));
  card_.RunToRest();
  EXPECT_EQ(Planned(), 50);
  EXPECT_TRUE(card_.StatusBit(kBitPositiveLimit));
}

TEST_F(Gt400Limit, ForbidsItsDirectionUntilTheEventIsCleared) {
  RunIntoLimit();
  Positive(false);
  card_.Do("GT_SetPos", {200});
  card_.Do("GT_Update");
  card_.Run(10);
  EXPECT_EQ(Planned(), 96);
  card_.Do("GT_RstSts", {0xDF});
  card_.Do("GT_Update");
  card_.Run(10);
  EXPECT_EQ(Planned(), 96) << "nothing has been written";
  card_.Do("GT_SetPos", {200});
  card_.Do("GT_Update");
  card_.RunToRest();
  EXPECT_EQ(Planned(), 200);
}

TEST_F(Gt400Limit, ForbidsItsDirectionWhileItsSwitchIsActive) {
  RunIntoLimit();
  card_.Do("GT_ClrSts");
  card_.Do("GT_SetPos", {50});
  card_.Do("GT_Update");
  card_.RunToRest();
  card_.Do("GT_SetPos", {200});
  card_.Do("GT_Update");
  card_.Run(10);
  EXPECT_EQ(Planned(), 50);
  Positive(false);
  card_.Do("GT_ClrSts");
  card_.Do("GT_SetPos", {200});
  card_.Do("GT_Update");
  card_.RunToRest();
  EXPECT_EQ(Planned(), 200);
}

// The switch is left before the host clears its event; it clears it, and nothing forbids any more.
TEST_F(Gt400Limit, AClearedEventForbidsNothingBehindTheSwitch) {
  RunIntoLimit();
  card_.Do("GT_ClrSts");
  Positive(false);
  card_.Do("GT_SetPos", {200});
  card_.Do("GT_Update");
  card_.RunToRest();
  EXPECT_EQ(Planned(), 200);
}

TEST_F(Gt400Limit, StopsAMotionThatTurnsTowardsIt) {
  card_.Do("GT_PrflV");
  card_.Do("GT_SetAcc", {0.1});
  card_.Do("GT_SetVel", {1});
  card_.Do("GT_Update");
  card_.Run(20);
  Negative(true);
  card_.Do("GT_ClrSts");
  card_.Do("GT_SetVel", {-1});
  card_.Do("GT_Update");
  card_.RunToRest();
  // 22 ST: 17 pulses; 5 more until it turns; the tick in which it turns has no way back, or one.
  EXPECT_NEAR(Planned(), 22, 0.1);
  EXPECT_EQ(card_.Status(), 0x0B41u);
}

TEST_F(Gt400Limit, DoesNothingWhileItIsNotWatched) {
  card_.Do("GT_LmtsOff");
  RunIntoLimit();
  EXPECT_EQ(card_.Status(), 0x0700u);
  card_.RunToRest();
  EXPECT_EQ(Planned(), 1000);
  card_.Do("GT_LmtsOn");
  EXPECT_EQ(card_.Status(), 0x0B21u) << "it is active for the card now";
}

TEST_F(Gt400Limit, IsForgottenWhileItIsNotWatchedAndThenCountsAgain) {
  RunIntoLimit();
  Positive(false);
  card_.Do("GT_LmtsOff");
  EXPECT_EQ(card_.Status(), 0x0321u) << "the event stays";
  card_.Do("GT_SetPos", {200});
  card_.Do("GT_Update");
  card_.RunToRest();
  EXPECT_EQ(Planned(), 200);
  card_.Do("GT_LmtsOn");
  card_.Do("GT_SetPos", {300});
  card_.Do("GT_Update");
  card_.Run(10);
  EXPECT_EQ(Planned(), 200);
}

TEST_F(Gt400Limit, ASenseThatMakesItActiveIsAnEvent) {
  Positive(false);
  card_.Do("GT_LmtSns", {0b0001});
  EXPECT_EQ(card_.Status(), 0x0B20u);
  card_.Do("GT_ClrSts");
  card_.Run(5);
  EXPECT_EQ(card_.Status(), 0x0B00u);
  card_.Do("GT_LmtSns", {0});
  card_.Do("GT_LmtSns", {0b0001});
  EXPECT_EQ(card_.Status(), 0x0B20u) << "active anew";
}

TEST(Gt400LimitAtPowerOn, IsAnEventAtOnceThatCanBeCleared) {
  for (const bool first_command : {true, false}) {
    Gt400TestCard card;
    ChangeState(card.motion).io.SetPin(DiType::kLimitNegative, 0, true);
    card.motion.PowerOn(nullptr);
    if (first_command) {
      EXPECT_EQ(card.Status(), 0x0940u);
    }
    card.Do("GT_ClrSts");
    EXPECT_EQ(card.Status(), 0x0900u);
    card.Run(3);
    EXPECT_EQ(card.Status(), 0x0900u);
  }
}

TEST_F(Gt400Limit, OfAnotherAxisIsNoEvent) {
  card_.SetInput(DiType::kLimitPositive, 1, true);
  EXPECT_EQ(card_.Status(), 0x0B00u);
  card_.Do("GT_Axis", {2});
  EXPECT_EQ(card_.Status(), 0x1920u);
}

// --- Alarms ------------------------------------------------------------------------------------

TEST(Gt400Alarm, StopsTheAxisAndSwitchesItsDriveOff) {
  Gt400TestCard card;
  card.Enable(1);
  card.MoveT(1000, 1, 0.1);
  card.Run(100);
  card.SetInput(DiType::kAlarm, 0, true);
  EXPECT_EQ(card.Status(), 0x0903u);
  EXPECT_EQ(card.motion.profile(0).now.position, 96);
  card.Do("GT_ClrSts");
  EXPECT_EQ(card.Status(), 0x0900u);
  card.Cycle();
  EXPECT_EQ(card.Status(), 0x0902u) << "again while it is active, but nothing ends any more";
  card.SetInput(DiType::kAlarm, 0, false);
  card.Do("GT_ClrSts");
  card.Run(3);
  EXPECT_EQ(card.Status(), 0x0900u);
  card.Do("GT_AxisOn");
  EXPECT_EQ(card.Status(), 0x0B01u);
}

// --- Motion errors -----------------------------------------------------------------------------

/// An axis in closed loop whose motor is blocked.
class Gt400MotionError : public ::testing::Test {
 protected:
  Gt400MotionError() {
    card_.Do("GT_SetPosErr", {50});
    card_.Do("GT_Update");
    card_.Do("GT_AxisOn");
    card_.Do("GT_ClrSts");
    ChangeState(card_.motion).plants[0].stalled = true;
  }
  bool Exceeded() { return card_.StatusBit(kBitMotionError); }

  Gt400TestCard card_;
};

// 10 ST and 5 pulses, then 45 pulses: the error is 50 after 55 ST, which does not exceed the limit.
TEST_F(Gt400MotionError, IsAnEventInEachTickInWhichItExceedsItsLimit) {
  card_.MoveT(1000, 1, 0.1);
  card_.Run(55);
  EXPECT_FALSE(Exceeded());
  card_.Run(1);
  EXPECT_EQ(card_.Status(), 0x0F10u);
  card_.Do("GT_ClrSts");
  card_.Cycle();
  EXPECT_TRUE(Exceeded());
  EXPECT_EQ(card_.RunToRest(), 1010 - 57);
}

TEST_F(Gt400MotionError, StopsTheAxisAndSwitchesItsDriveOffIfTheHostWantsThat) {
  card_.Do("GT_AuStpOn");
  card_.MoveT(1000, 1, 0.1);
  card_.Run(60);
  EXPECT_EQ(card_.Status(), 0x0911u);
  EXPECT_EQ(card_.motion.profile(0).now.position, 51);
  card_.Do("GT_ClrSts");
  card_.Run(5);
  EXPECT_EQ(card_.Status(), 0x0900u) << "it is not judged while the drive is off";
  card_.Do("GT_AuStpOff");
  card_.Do("GT_AxisOn");
  card_.Cycle();
  EXPECT_EQ(card_.Status(), 0x0B11u);
}

TEST_F(Gt400MotionError, TakesTheValidLimit) {
  card_.MoveT(1000, 1, 0.1);
  card_.Do("GT_SetPosErr", {100});
  card_.Run(60);
  EXPECT_TRUE(Exceeded());
}

TEST_F(Gt400MotionError, IsNotJudgedWithPulses) {
  card_.Do("GT_CtrlMode", {1});
  ChangeState(card_.motion).plants[0].stalled = true;
  card_.MoveT(1000, 1, 0.1);
  card_.Run(200);
  EXPECT_FALSE(Exceeded());
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
