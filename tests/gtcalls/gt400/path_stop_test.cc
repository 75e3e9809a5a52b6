// Axes that cannot follow a path: they stop it, or stop alone. Source: GT manual 5.4.5.
#include <gtest/gtest.h>

#include <vector>

#include "tests/gtcalls/gt400/path_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DiType;

struct Cause {
  const char* name;
  void (*act)(PathTestCard& card);
};

/// What can happen to axis 2.
const Cause kCauses[] = {
    {"it is switched off",
     [](PathTestCard& card) {
       card.Do("GT_Axis", {2});
       card.Do("GT_AxisOff");
     }},
    {"its drive reports an alarm",
     [](PathTestCard& card) { card.SetInput(DiType::kAlarm, 1, true); }},
    {"its loop is opened",
     [](PathTestCard& card) {
       card.Do("GT_Axis", {2});
       card.Do("GT_CtrlMode", {0});
       card.Do("GT_OpenLp");
     }},
    {"it runs into a limit",
     [](PathTestCard& card) { card.SetInput(DiType::kLimitPositive, 1, true); }},
    {"it is stopped", [](PathTestCard& card) {
       card.Do("GT_Axis", {2});
       card.Do("GT_AbptStp");
     }}};

/// A list to (3000, 3000) that is still open, on its way.
void StartOpenList(PathTestCard& card) {
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {0, 0, 2, 0.01});
  card.Do("GT_LnXY", {3000, 3000});
  card.Do("GT_StrtMtn");
  card.Run(500);
}

TEST(GtAutoStop, OfAnyAxisStopsThePathAtOnce) {
  for (const Cause& cause : kCauses) {
    SCOPED_TRACE(cause.name);
    PathTestCard card;
    StartOpenList(card);
    for (int axis = 1; axis <= kAxisMax; ++axis) {
      card.Do("GT_Axis", {static_cast<double>(axis)});
      card.Do("GT_ClrSts");
    }
    cause.act(card);
    card.Cycle();
    // Stopped by an axis, at rest, closed; the segment is kept.
    EXPECT_EQ(card.PathStatus() & 0x2203, 0x0203);
    EXPECT_EQ(card.Velocity(), 0);
    for (int axis = 1; axis <= kAxisMax; ++axis) {
      card.Do("GT_Axis", {static_cast<double>(axis)});
      EXPECT_FALSE(card.StatusBit(10)) << axis;
      EXPECT_TRUE(card.StatusBit(0)) << axis;
    }
    EXPECT_EQ(card.Point("GT_GetBrkPnt"), card.Point());
    EXPECT_GT(card.Planned(1), 100);
    EXPECT_LT(card.Planned(1), 1000);
    card.Do("GT_StrtList");
    EXPECT_FALSE(card.PathBit(9));
  }
}

// The host has commanded a stop already, whose end the path does not reach.
TEST(GtAutoStop, OfAnyAxisIsToldOfAPathThatDeceleratesByCommand) {
  for (const Cause& cause : kCauses) {
    SCOPED_TRACE(cause.name);
    PathTestCard card;
    StartOpenList(card);
    card.Do("GT_StpMtn");
    card.Run(50);
    EXPECT_GT(card.Velocity(), 1);
    EXPECT_FALSE(card.PathBit(9));
    cause.act(card);
    card.Cycle();
    EXPECT_EQ(card.PathStatus() & 0x2203, 0x0203);
    EXPECT_EQ(card.Velocity(), 0);
    EXPECT_EQ(card.Point("GT_GetBrkPnt"), card.Point());
    // The next single segment has not been stopped.
    card.Do("GT_CrdAuStpOff");
    card.Do("GT_LnXY", {0, 0});
    EXPECT_FALSE(card.PathBit(9));
  }
}

TEST(GtAutoStop, IsSeenDirectlyAfterTheCommandThatCausesIt) {
  for (const char* name : {"GT_AbptStp", "GT_AxisOff"}) {
    PathTestCard card;
    card.SetRates(2, 0.01);
    card.Do("GT_LnXY", {3000, 3000});
    card.Run(500);
    card.Do(name);
    EXPECT_EQ(card.PathBit(0), card.PathBit(9)) << name;
    card.Cycle();
    EXPECT_EQ(card.PathStatus() & 0x201, 0x201) << name;
  }
}

TEST(GtAutoStop, SwitchedOffLeavesTheAxisAlone) {
  for (const Cause& cause : kCauses) {
    SCOPED_TRACE(cause.name);
    PathTestCard card;
    card.Do("GT_CrdAuStpOff");
    EXPECT_FALSE(card.PathBit(6));
    card.SetRates(2, 0.01);
    card.Do("GT_LnXY", {3000, 3000});
    card.Run(500);
    cause.act(card);
    card.Cycle();
    EXPECT_FALSE(card.PathBit(0));
    const double at = card.Planned(2);
    EXPECT_LT(at, 1000);
    card.RunPath();
    EXPECT_FALSE(card.PathBit(9));
    EXPECT_EQ(card.Planned(1), 3000);
    EXPECT_EQ(card.Planned(2), at);
    card.Do("GT_CrdAuStpOn");
    EXPECT_TRUE(card.PathBit(6));
  }
}

// An axis that the path does not move is pushed to its switch.
TEST(GtAutoStop, ActsAtALimitThatAnAxisReachesByItself) {
  PathTestCard card;
  card.SetRates(2, 0.01);
  card.Do("GT_LnXY", {3000, 0});
  card.Run(500);
  card.SetInput(DiType::kLimitNegative, 2, true);
  EXPECT_TRUE(card.PathBit(9));
  EXPECT_TRUE(card.PathBit(0));
}

TEST(GtAutoStop, StopsAPathThatBeginsWithAnAxisOff) {
  PathTestCard card;
  card.Do("GT_Axis", {2});
  card.Do("GT_AxisOff");
  card.Do("GT_ClrSts");
  card.SetRates(2, 0.01);
  card.Do("GT_LnXY", {3000, 3000});
  EXPECT_TRUE(card.PathBit(0));
  EXPECT_TRUE(card.PathBit(9));
  EXPECT_TRUE(card.StatusBit(0));
  card.Run(10);
  EXPECT_EQ(card.Planned(1), 0);
  // The segment is dropped, and the next one is refused no more than it.
  card.Do("GT_AxisOn");
  card.Do("GT_LnXY", {100, 100});
  card.RunPath();
  EXPECT_EQ(card.Planned(2), 100);
  EXPECT_FALSE(card.PathBit(9));
}

TEST(GtAutoStop, LetsAPathLeaveALimit) {
  PathTestCard card;
  card.SetInput(DiType::kLimitPositive, 0, true);
  card.SetRates(2, 0.01);
  card.Do("GT_ClrSts");
  card.Do("GT_LnXY", {100, 0});
  EXPECT_TRUE(card.PathBit(0));
  EXPECT_TRUE(card.PathBit(9));
  // The limit and the end of the motion are events again.
  EXPECT_EQ(card.Status() & 0x61, 0x21u);
  card.Run(5);
  EXPECT_EQ(card.Planned(1), 0);
  card.Do("GT_LnXY", {-100, 0});
  card.RunPath();
  EXPECT_EQ(card.Planned(1), -100);
  EXPECT_FALSE(card.PathBit(9));
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
