// The list of GE cards for paths. Source: GE manual 6.3, 6.4 and table 2-4; velocities and times by
// hand from v^2 = v0^2 + 2 a s.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/path_test_card.h"

namespace oncard::gtcalls::ges {
namespace {

using ge::kBufferFull;
using ge::kListState;
using ge::kPathState;
using ::testing::ElementsAre;

TEST(GeList, HasTheStatusOfTheManualsExample) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {0, 0, 10, 1});
  card.Do("GT_LnXY", {100, 0});
  EXPECT_EQ(card.PathStatus(), 0x0011);
  card.Do("GT_EndList");
  EXPECT_EQ(card.PathStatus(), 0x0093);
  card.Do("GT_StrtMtn");
  EXPECT_EQ(card.PathStatus(), 0x0002);
  card.RunPath();
  EXPECT_EQ(card.PathStatus(), 0x2093);
  EXPECT_EQ(card.Read("GT_GetMtnNm"), 1);
}

TEST(GeList, RefusesWhatComesAtTheWrongTime) {
  PathTestCard card;
  card.Refuses(1, kPathState, "GT_MvXY", {0, 0, 1, 1});
  card.Refuses(1, kPathState, "GT_SetDccVel", {1});
  card.Refuses(1, kPathState, "GT_Delay", {100});
  card.Refuses(-1, kPathState, "GT_BufIO", {1});
  card.Refuses(-1, kPathState, "GT_BufIOBit", {1, 1});
  card.Refuses(1, kListState, "GT_RestoreMtn");
  card.Do("GT_StrtMtn");  // there is nothing to do
  card.Do("GT_StrtList");
  card.Refuses(1, kListState, "GT_StrtList");
  card.Refuses(1, kListState, "GT_AddList");
  card.Refuses(1, kPathState, "GT_LnXY", {10, 0});
  card.Refuses(1, kPathState, "GT_SetSynVel", {10});
  card.Refuses(1, kPathState, "GT_SetSynAcc", {10});
  card.Refuses(1, kPathState, "GT_BufIO", {1});
  card.Refuses(4, kPathState, "GT_MvXY", {0, 0, 0, 1});
  card.Refuses(4, kPathState, "GT_MvXY", {0, 0, 1, 0});
  card.Do("GT_MvXY", {0, 0, 10, 1});
  card.Refuses(1, kPathState, "GT_MvXY", {0, 0, 10, 1});
  card.Refuses(1, kPathState, "GT_LnXYZ", {1, 2, 3});
  card.Refuses(1, kPathState, "GT_ArcYZ", {1, 2, 3});
  card.Do("GT_LnXY", {1000, 0});
  card.Do("GT_StrtMtn");
  card.Refuses(1, kListState, "GT_StrtMtn");
  card.Refuses(1, kListState, "GT_RestoreMtn");
  card.Do("GT_EndList");
  card.Do("GT_EndList");
  card.Refuses(1, kListState, "GT_StrtList");
  card.Do("GT_AddList");
}

TEST(GeList, IsOpenedWhileAnImmediateLineMoves) {
  PathTestCard card;
  card.SetRates(10, 1);
  card.Do("GT_LnXYZ", {0, 0, 500});
  card.Run(5);
  card.BeginList(10, 1);
  card.Do("GT_LnXY", {100, 0});
  card.Do("GT_EndList");
  card.Refuses(1, kListState, "GT_StrtMtn");
  card.RunPath();
  card.Do("GT_StrtMtn");
  card.RunPath();
  // Z stays where the line has led it.
  EXPECT_THAT(card.Point(), ElementsAre(100, 0, 500));
}

TEST(GeList, PassesJointsWithTheLowerFeed) {
  PathTestCard card;
  card.BeginList(20, 0.5);
  card.Do("GT_LnXY", {4000, 0});
  card.Do("GT_SetSynVel", {40});
  card.Do("GT_LnXY", {4000, 6000});
  card.Do("GT_SetSynVel", {10});
  card.Do("GT_LnXY", {4500, 6000});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  // 0.5 to 20 in 39 ms, on at 20: 219.01 ms; 20 to 40 to 10: 182.5; 10 to 0.5: 59.03.
  card.Run(219.25);
  EXPECT_NEAR(card.Read("GT_GetPrfVel"), 20, 0.2);
  EXPECT_EQ(card.Read("GT_GetMtnNm"), 2);
  EXPECT_NEAR(219.25 + card.RunPath(), 460.54, 0.3);
  EXPECT_THAT(card.Point(), ElementsAre(4500, 6000, 0));
}

TEST(GeList, EndsOneSegmentWithTheVelocityOfSetDccVel) {
  PathTestCard card;
  card.Do("GT_SetMaxVel", {25});
  card.BeginList(20, 0.5);
  card.Do("GT_SetDccVel", {5});
  card.Do("GT_LnXY", {4000, 0});
  card.Do("GT_SetSynVel", {40});
  card.Do("GT_SetDccVel", {0});
  card.Do("GT_LnXY", {4000, 6000});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  // 39 ms up to 20, 30 ms down to 5: 230.26 ms; 5 to 25 to 0.5: 40 + 49 ms and 4675 + ... pulses.
  card.Run(230.25);
  EXPECT_NEAR(card.Read("GT_GetPrfVel"), 5, 0.2);
  // Segment 2: 600 pulses up, 624.75 down, 4775.25 at 25: 40 + 49 + 191.01 ms.
  EXPECT_NEAR(230.25 + card.RunPath(), 230.26 + 280.01, 0.5);
}

TEST(GeList, RestsBeforeAndAfterALineOfG0) {
  PathTestCard card;
  card.BeginList(10, 1);
  card.Do("GT_LnXY", {100, 0});
  card.Do("GT_LnXYG0", {200, 0});
  card.Do("GT_LnXY", {300, 0});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  // Each of the three from 0.5 to 10 to 0.5: 9.5 ms and 49.875 pulses twice, 0.025 ms at 10.
  EXPECT_NEAR(card.RunPath(), 3 * 19.025, 0.3);
}

TEST(GeList, WaitsForSegmentsWhileItIsOpen) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {0, 0, 10, 1});
  card.Do("GT_StrtMtn");
  card.Run(5);
  EXPECT_EQ(card.PathStatus(), 0x2010);
  card.Do("GT_LnXY", {100, 0});
  card.Run(30);
  EXPECT_EQ(card.PathStatus(), 0x2010);
  EXPECT_THAT(card.Point(), ElementsAre(100, 0, 0));
  card.Do("GT_EndList");
  EXPECT_EQ(card.PathStatus(), 0x2093);
}

TEST(GeList, GoesOnAfterItsEnd) {
  PathTestCard card;
  card.BeginList(10, 1);
  card.Do("GT_LnXY", {100, 0});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.RunPath();
  card.Do("GT_AddList");
  card.Do("GT_SetSynVel", {5});
  card.Do("GT_LnXY", {100, 100});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(100, 100, 0));
  EXPECT_EQ(card.Read("GT_GetMtnNm"), 2);
}

TEST(GeList, StopsAndGoesOnFromTheBreakPoint) {
  PathTestCard card;
  card.Do("GT_SetStpAcc", {5});
  card.BeginList(20, 0.1);
  card.Do("GT_LnXY", {40000, 0});
  card.Do("GT_LnXY", {40000, 30000});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.Run(1000);
  card.Do("GT_StpMtn");
  // From 20 to 0.5 with 0.1: 195 ms, 1998.75 pulses.
  const double before = card.Point()[0];
  EXPECT_NEAR(card.RunPath(), 195, 0.5);
  EXPECT_NEAR(card.Point()[0], before + 1998.75, 5);
  EXPECT_EQ(card.Point("GT_GetBrkPnt"), card.Point());
  EXPECT_EQ(card.PathStatus(), 0x0093);
  EXPECT_EQ(card.Read("GT_GetMtnNm"), 1);
  // From elsewhere the axes come back first.
  card.SetRates(50, 5);
  card.Do("GT_LnXY", {before, 700});
  card.RunPath();
  card.Do("GT_RestoreMtn");
  card.Run(600);
  card.Do("GT_EStpMtn");
  // With 5 instead of 0.1: 3.9 ms.
  EXPECT_NEAR(card.RunPath(), 3.9, 0.5);
  card.Do("GT_StrtMtn");
  EXPECT_NE(card.reason.en.find("GT_RestoreMtn"), std::string::npos);
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(40000, 30000, 0));
  EXPECT_EQ(card.Read("GT_GetMtnNm"), 2);
}

TEST(GeList, IsClosedByAStopAtRest) {
  PathTestCard card;
  card.BeginList(10, 1);
  card.Do("GT_LnXY", {100, 0});
  card.Do("GT_StpMtn");
  EXPECT_EQ(card.PathStatus(), 0x0093);
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_EQ(card.PathStatus(), 0x2093);
}

TEST(GeList, BeginsWhereTheAxesHaveBeenPlaced) {
  PathTestCard card;
  card.SetRates(100, 10);
  card.Do("GT_LnXY", {1000, 0});
  card.RunPath();
  card.Do("GT_StrtList");
  card.Do("GT_ZeroPos", {1});
  card.Do("GT_MvXY", {0, 50, 10, 1});
  card.Do("GT_EndList");
  EXPECT_THAT(card.Point(), ElementsAre(0, 0, 0));
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(0, 50, 0));
}

TEST(GeList, StopsDuringTheWayToItsStartAndRepeatsIt) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {1000, 0, 10, 1});
  card.Do("GT_LnXY", {1000, 100});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.Run(20);
  EXPECT_EQ(card.Read("GT_GetMtnNm"), 0);
  card.Do("GT_StpMtn");
  card.RunPath();
  card.Do("GT_RestoreMtn");
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(1000, 100, 0));
}

TEST(GeList, WritesOutputsBetweenSegments) {
  PathTestCard card;
  const auto outputs = [&] { return card.Read("GT_GetExOpt"); };
  card.BeginList(10, 1);
  card.Do("GT_BufIO", {1});
  card.Do("GT_BufIO", {3});
  card.Refuses(1, kPathState, "GT_BufIO", {7});
  card.Do("GT_LnXY", {1000, 0});
  card.Do("GT_BufIOBit", {4, 0});
  card.Do("GT_BufIOBit", {4, 1});
  card.Do("GT_Delay", {500});
  card.Refuses(1, kPathState, "GT_Delay", {500});
  card.Do("GT_LnXY", {2000, 0});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.Run(1);
  EXPECT_EQ(outputs(), 3);
  // A line of 1000 takes 109.025 ms.
  card.Run(300);
  EXPECT_EQ(outputs(), 3);
  EXPECT_EQ(card.PathStatus(), 0x0012);
  card.Run(310);
  EXPECT_EQ(outputs(), 19);
}

TEST(GeList, HoldsEightThousandWords) {
  PathTestCard card;
  card.BeginList(100, 10);  // 9 words
  // A line in two axes takes 5: 1636 fit.
  for (int i = 1; i <= 1636; ++i) card.Do("GT_LnXY", {10.0 * i, 0});
  card.Refuses(1, kBufferFull, "GT_LnXY", {20000, 0});
  card.Do("GT_SetSynVel", {50});
  card.Refuses(1, kBufferFull, "GT_SetDccVel", {50});
  card.Do("GT_StrtMtn");
  card.Run(20);
  card.Do("GT_LnXY", {20000, 0});
}

TEST(GeList, NumbersSegmentsUpTo32767) {
  PathTestCard card;
  card.BeginList(32000, 32000);
  card.Do("GT_StrtMtn");
  for (int i = 1; i <= 32768; ++i) {
    while (card.Call("GT_LnXY", {i % 2 == 0 ? 0.0 : 1.0, 0}) != 0) card.Run(50);
  }
  card.Do("GT_EndList");
  card.RunPath();
  EXPECT_EQ(card.Read("GT_GetMtnNm"), 1);
}

}  // namespace
}  // namespace oncard::gtcalls::ges
