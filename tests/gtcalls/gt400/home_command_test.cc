// GT_Home: the way to the home switch and, with GT_Index, to the index mark behind it. All ways are
// at 4 pulse/ST with 1 pulse/ST^2: 4 ST and 8 pulses.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DiType;

/// The home switch is low from 600 to 700, the index marks are at 50, 1050 ...
class Gt400Home : public ::testing::Test {
 protected:
  Gt400Home() {
    card_.motion.SetIndexMarks(0, {.offset = 50, .period = 1000});
    card_.Enable(1);
    card_.Do("GT_SetVel", {4});
    card_.Do("GT_SetAcc", {1});
    card_.Do("GT_Update");
    card_.Do("GT_ClrSts");
  }

  void AddSwitch(double first = 600, double last = 700) {
    card_.motion.AddSwitch(
        {.axis = 0, .type = DiType::kHome, .first = first, .last = last, .active_low = true});
    card_.Cycle();
  }
  double Planned() { return card_.motion.profile(0).now.position; }

  Gt400TestCard card_;
};

TEST_F(Gt400Home, ReturnsToThePlaceOfTheSwitch) {
  AddSwitch();
  card_.Do("GT_Home", {5000});
  EXPECT_EQ(card_.Status(), 0x4F00u) << "it moves when the call returns, with its capture armed";
  card_.RunToRest();
  EXPECT_EQ(Planned(), 600);
  EXPECT_EQ(card_.Read("GT_GetCapt"), 600);
  EXPECT_EQ(card_.Status(), 0x0B09u);
}

TEST_F(Gt400Home, LeavesTheSwitchFirst) {
  AddSwitch(-100, 100);
  card_.Do("GT_Home", {5000});
  card_.Run(20);
  EXPECT_LT(Planned(), -60) << "away from the position";
  card_.RunToRest();
  EXPECT_EQ(Planned(), -100);
}

TEST_F(Gt400Home, GoesOnToTheNextIndexMarkIfTheHostWantsThat) {
  AddSwitch();
  card_.Do("GT_Index", {1});
  card_.Do("GT_Home", {5000});
  card_.RunToRest();
  EXPECT_EQ(Planned(), 1050);
  EXPECT_EQ(card_.Status(), 0x0B09u);
  card_.Do("GT_Index", {0});
  card_.Do("GT_ClrSts");
  card_.Do("GT_Home", {-5000});
  card_.RunToRest();
  EXPECT_EQ(Planned(), 700);
}

TEST_F(Gt400Home, EndsAtItsPositionWithoutASwitch) {
  card_.Do("GT_Home", {500});
  EXPECT_EQ(card_.RunToRest(), 4 + 121 + 4);
  EXPECT_EQ(Planned(), 500);
  EXPECT_EQ(card_.Status(), 0x0B01u) << "no capture remains armed";
}

TEST_F(Gt400Home, WithoutAWayEndsAtOnce) {
  card_.Do("GT_Home", {0});
  EXPECT_EQ(card_.Status(), 0x0B01u);
}

TEST_F(Gt400Home, UsesValidRatesInModeT) {
  card_.Do("GT_PrflV");
  card_.Do("GT_SetVel", {50});  // waits
  card_.Do("GT_Home", {500});
  EXPECT_EQ(card_.Read("GT_GetMode"), 0);
  card_.Run(10);
  EXPECT_EQ(card_.Read("GT_GetPrfVel"), 4);
}

TEST_F(Gt400Home, DoesNotMoveADriveThatIsOff) {
  AddSwitch();
  card_.Do("GT_AxisOff");
  card_.Do("GT_Home", {5000});
  card_.Run(10);
  EXPECT_EQ(card_.Status(), 0x0900u);
  EXPECT_EQ(Planned(), 0);
}

TEST_F(Gt400Home, EndsAtALimitInTheWay) {
  AddSwitch();
  card_.Do("GT_Home", {5000});
  card_.Run(100);
  card_.SetInput(DiType::kLimitPositive, 0, true);
  card_.Run(10);
  EXPECT_EQ(card_.Status(), 0x0B21u);
}

TEST_F(Gt400Home, AnotherUpdateOrAStopEndsTheSearch) {
  for (const char* command : {"GT_Update", "GT_AbptStp"}) {
    Gt400TestCard card;
    card.motion.AddSwitch(
        {.axis = 0, .type = DiType::kHome, .first = 600, .last = 700, .active_low = true});
    card.Cycle();
    card.Enable(1);
    card.Do("GT_SetVel", {4});
    card.Do("GT_SetAcc", {1});
    card.Do("GT_Update");
    card.Do("GT_Home", {5000});
    card.Run(10);
    card.Do("GT_SetPos", {900});
    card.Do(command);
    card.Run(400);
    EXPECT_EQ(card.Status(), 0x0B01u) << command << ": nothing is captured";
    const double end = card.motion.profile(0).now.position;
    EXPECT_EQ(end, std::string_view(command) == "GT_Update" ? 900 : 32) << command;
  }
}

TEST_F(Gt400Home, IsRefusedInMotionAndForPositionsThatNoRegisterHolds) {
  card_.Refuses(kOverflow, "GT_Home", {1073741824});
  card_.MoveT(1000, 4, 1);
  card_.Refuses(kModeInUse, "GT_Home", {500});
  card_.RefusesParameter("GT_Index", {2});
  card_.RefusesParameter("GT_Index", {-1});
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
