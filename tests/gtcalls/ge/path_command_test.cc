// Paths of GE cards that begin at once, their parameters and geometry. Source: GE manual 6.1, 6.2
// and tables 2-1, 2-4; times and lengths by hand from v^2 = v0^2 + 2 a s.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/path_test_card.h"

namespace oncard::gtcalls::ges {
namespace {

using ge::kIllegal;
using ge::kModeInUse;
using ge::kNotOnCard;
using ge::kPathState;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

TEST(GePath, BeginsAtOnceWhileTheListIsClosed) {
  PathTestCard card;
  card.SetRates(100, 1.8);
  card.Do("GT_SetStrtVel", {0.3});
  EXPECT_EQ(card.PathStatus(), 0x2093);
  card.Do("GT_LnXY", {30000, 40000});
  EXPECT_EQ(card.PathStatus(), 0x2082);
  EXPECT_FALSE(card.StatusBit(1, 10));  // it follows the first cycle
  card.Cycle();
  EXPECT_TRUE(card.StatusBit(3, 10));
  // (100 - 0.3) / 1.8 = 55.389 ms and 2777.75 pulses up and down, 444.445 ms between.
  EXPECT_NEAR(card.RunPath() + 0.25, 555.22, 0.5);
  EXPECT_THAT(card.Point(), ElementsAre(30000, 40000, 0));
  EXPECT_EQ(card.PathStatus(), 0x2093);
}

TEST(GePath, ReachesNoFeedOnAShortLine) {
  PathTestCard card;
  card.SetRates(100, 1.8);
  card.Do("GT_SetStrtVel", {0.3});
  card.Do("GT_LnXY", {10, 10});
  // sqrt(0.09 + 1.8 * 14.1421) = 5.0543, after (5.0543 - 0.3) / 1.8 = 2.6413 ms.
  double most = 0;
  for (int i = 0; i < 22; ++i) {
    card.Cycle();
    most = std::max(most, card.Read("GT_GetPrfVel"));
  }
  EXPECT_NEAR(most, 5.0543, 0.45);
  EXPECT_THAT(card.Point(), ElementsAre(10, 10, 0));
}

TEST(GePath, ArcsLieInThreePlanes) {
  const struct {
    const char* command;
    std::vector<double> values;
    std::vector<double> end;
    double length;
  } cases[] = {
      {"GT_ArcXY", {40000, 30000, 180}, {80000, 60000, 0}, 157079.633},
      {"GT_ArcYZ", {40000, 30000, 180}, {0, 80000, 60000}, 157079.633},
      {"GT_ArcZX", {40000, 30000, 180}, {60000, 0, 80000}, 157079.633},
      {"GT_ArcXY", {0, 1000, 90}, {1000, 1000, 0}, 1570.796},
      {"GT_ArcXY", {0, 1000, -90}, {-1000, 1000, 0}, 1570.796},
      {"GT_ArcXY", {0, 1000, 360}, {0, 0, 0}, 6283.185},
      {"GT_ArcXYP", {40000, 0, 20000, -1}, {40000, 0, 0}, 62831.853},
      {"GT_ArcXYP", {20000, 0, -20000, 1}, {20000, 0, 0}, 104719.755},
      {"GT_ArcYZP", {40000, 0, 20000, 1}, {0, 40000, 0}, 62831.853},
      {"GT_ArcZXP", {40000, 0, 20000, 1}, {0, 0, 40000}, 62831.853},
  };
  for (const auto& c : cases) {
    PathTestCard card;
    card.SetRates(200, 10'000);
    card.Do(c.command, c.values);
    EXPECT_NEAR(CrdOf(card.card).fifos[kImmediateFifo].slots.front().segment.length, c.length, 1e-3)
        << c.command;
    card.RunPath();
    EXPECT_THAT(card.Point(), Pointwise(DoubleNear(1e-6), c.end)) << c.command;
  }
}

TEST(GePath, RefusesWhatCannotBe) {
  PathTestCard card("GE-200-SG");
  card.Refuses(4, kPathState, "GT_LnXY", {10, 10});  // no feed
  card.SetRates(10, 1);
  const struct {
    int16_t code;
    uint16_t cause;
    const char* command;
    std::vector<double> values;
  } cases[] = {
      {3, kPathState, "GT_LnXY", {0, 0}},
      {7, kIllegal, "GT_LnXY", {1073741825.0, 0}},
      {1, kNotOnCard, "GT_LnXYZ", {1, 2, 3}},
      {1, kNotOnCard, "GT_ArcYZ", {1, 2, 90}},
      {2, kPathState, "GT_ArcXY", {0, 0, 90}},
      {2, kPathState, "GT_ArcXY", {10, 0, 0}},
      {7, kIllegal, "GT_ArcXY", {10, 0, 361}},
      {2, kPathState, "GT_ArcXYP", {10, 0, 0, 1}},
      {2, kPathState, "GT_ArcXYP", {0, 0, 10, 1}},
      {5, kPathState, "GT_ArcXYP", {40000, 0, 19999, 1}},
      {7, kIllegal, "GT_ArcXYP", {10, 0, 10, 0}},
      {4, kPathState, "GT_SetSynVel", {0}},
      {4, kPathState, "GT_SetSynVel", {32768}},
      {4, kPathState, "GT_SetSynAcc", {-1}},
      {4, kPathState, "GT_SetStrtVel", {-0.1}},
      {4, kPathState, "GT_SetMaxVel", {0}},
      {7, kIllegal, "GT_Override", {2.1}},
      {1, kModeInUse, "GT_MapCnt", {1, 1073741825.0}},
      {1, kNotOnCard, "GT_GantryMode", {1, 2}},
  };
  for (const auto& c : cases) card.Refuses(c.code, c.cause, c.command, c.values);
  card.Do("GT_ArcXYP", {40000, 0, 19999.6, 1});  // up to a pulse
}

TEST(GePath, LeavesNothingWhenItIsStopped) {
  PathTestCard card;
  card.SetRates(10, 1);
  card.Do("GT_LnXY", {1000, 0});
  card.Run(20);
  card.Do("GT_EStpMtn");
  card.RunPath();
  EXPECT_TRUE(CrdOf(card.card).fifos[kImmediateFifo].idle());
  EXPECT_THAT(card.Point("GT_GetBrkPnt"), ElementsAre(0, 0, 0));
  card.Refuses(1, ge::kListState, "GT_RestoreMtn");
}

TEST(GePath, ForbidsInMotionWhatTable24Says) {
  PathTestCard card;
  card.SetRates(10, 1);
  card.Do("GT_LnXY", {1000, 0});
  card.Run(10);
  for (const char* command :
       {"GT_SetSynAcc", "GT_SetStrtVel", "GT_SetMaxVel", "GT_SetStpAcc", "GT_SetEStpAcc"}) {
    card.Refuses(1, kPathState, command, {2});
  }
  card.Refuses(1, kPathState, "GT_LnXY", {0, 0});
  card.Refuses(1, kModeInUse, "GT_MapCnt", {1, 5});
  card.Refuses(1, ge::kInMotion, "GT_ZeroPos", {3});
  card.Do("GT_SetSynVel", {5});
}

TEST(GePath, IsNoFasterThanTheLargestVelocity) {
  PathTestCard card;
  card.SetRates(100, 100);
  card.Do("GT_SetMaxVel", {20});
  card.Do("GT_LnXY", {10000, 0});
  card.Run(50);
  EXPECT_NEAR(card.Read("GT_GetPrfVel"), 20, 1e-9);
}

TEST(GePath, IsHeldByAnOverrideOfZero) {
  PathTestCard card;
  card.SetRates(10, 1);
  card.Do("GT_LnXY", {1000, 0});
  card.Run(20);
  card.Do("GT_OverrideG0", {0});  // for G0 lines
  card.Do("GT_Override", {0.5});
  card.Run(20);
  EXPECT_NEAR(card.Read("GT_GetPrfVel"), 5, 1e-9);
  card.Do("GT_Override", {0});
  card.Run(50);
  EXPECT_EQ(card.Read("GT_GetPrfVel"), 0);
  EXPECT_EQ(card.PathStatus() & 1, 0);
  card.Do("GT_Override", {1});
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(1000, 0, 0));
}

TEST(GePath, BeginsAtTheWorkCoordinatesOfMapCnt) {
  PathTestCard card;
  card.SetRates(100, 100);
  card.Do("GT_MapCnt", {1, 250});
  card.Do("GT_LnXY", {1000, 0});
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(1250, 0, 0));
}

TEST(GePath, StopsAtALimitAndLeavesItTheOtherWay) {
  PathTestCard card;
  card.SetRates(10, 1);
  card.Do("GT_SetStpAcc", {5});
  card.Do("GT_LnXY", {-10000, 0});
  card.Run(100);
  card.SetInput(motion::DiType::kLimitNegative, 0, true);
  card.RunPath();
  EXPECT_TRUE(card.StatusBit(1, 6));
  EXPECT_EQ(card.PathStatus(), 0x2293);
  const std::vector<double> stopped = card.Point();
  card.Do("GT_LnXY", {-20000, 0});  // taken, and does not move
  EXPECT_EQ(card.PathStatus(), 0x2293);
  card.Run(5);
  EXPECT_EQ(card.Point(), stopped);
  card.Do("GT_LnXY", {0, 0});
  EXPECT_EQ(card.PathStatus(), 0x2082);
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(0, 0, 0));
}

TEST(GePath, NeedsAxesWithoutAlarm) {
  PathTestCard card("GE-300-SV");
  card.SetRates(10, 1);
  card.Do("GT_LnXY", {1000, 0});
  card.Run(20);
  card.SetInput(motion::DiType::kAlarm, 1, true);
  card.RunPath();
  EXPECT_EQ(card.PathStatus() & 0x200, 0x200);
  card.Refuses(1, kIllegal, "GT_LnXY", {0, 0});
  card.Refuses(1, kIllegal, "GT_StrtMtn");
  card.SetInput(motion::DiType::kAlarm, 1, false);
  card.Do("GT_ClrSts", {2});
  EXPECT_EQ(card.PathStatus() & 0x200, 0);
  card.Do("GT_LnXY", {0, 0});
}

}  // namespace
}  // namespace oncard::gtcalls::ges
