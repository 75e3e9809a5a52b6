// The list of segments: what it takes when, its numbers, runs, stops and break points. Figures are
// those of the GT manual, chapter 5.4.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/gtcalls/gt400/path_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

const std::vector<double> kOrigin = {0, 0, 0, 0};

// Example "1-21": a line, an arc of 123 degrees and a line in four coordinates without a stop.
TEST(GtList, PassesItsSegmentsWithoutAStop) {
  PathTestCard card(2000);
  card.Do("GT_StrtList");
  card.Do("GT_MvXYZA", {0, 0, 0, 0, 0.01, 1e-8});
  card.Do("GT_LnXY", {10, 10});
  card.Do("GT_ArcXY", {0, 0, 123});
  card.Do("GT_LnXYZA", {0, 0, 10, 12});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  std::vector<int> numbers;
  int cycles = 0;
  for (; !card.PathBit(0); ++cycles) {
    card.Cycle();
    if (numbers.empty() || numbers.back() != card.Number()) numbers.push_back(card.Number());
  }
  EXPECT_NEAR(cycles, 161954.5, 2);
  EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(card.Point(), (std::vector<double>{0, 0, 10, 12}));
  EXPECT_EQ(card.Planned(4), 24000);
  EXPECT_EQ(card.PathStatus() & 0x2013, 0x2013);
}

TEST(GtList, BeginsWithALineToItsStartPoint) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {200, 0, 2, 0.02});
  card.Do("GT_LnXY", {200, 200});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.Run(100);
  EXPECT_EQ(card.Number(), 0);
  EXPECT_EQ(card.Planned(1), 100);
  EXPECT_EQ(card.Velocity(), 2);
  // 200 pulses are 100 up to 2 and 100 down; the next line is as long.
  EXPECT_EQ(card.RunPath(), 300);
  EXPECT_EQ(card.Number(), 1);
}

// P: a move with the coordinates of a list.
TEST(GtList, MayBeAStartPointAlone) {
  PathTestCard card;
  card.MakeList({}, 2, 0.02);
  card.Do("GT_StrtMtn");
  // Nothing is to be done there.
  EXPECT_LE(card.RunPath(), 1);
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {200, 0, 2, 0.02});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  EXPECT_EQ(card.RunPath(), 200);
  EXPECT_EQ(card.Planned(1), 200);
}

TEST(GtList, LeavesCoordinatesThatItDoesNotNameWhereTheyAre) {
  PathTestCard card;
  card.MakeList({100}, 2, 0.02);
  card.SetRates(2, 0.02);
  card.Do("GT_LnXYZ", {0, 0, 30});
  card.RunPath();
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_EQ(card.Point(), (std::vector<double>{100, 0, 30, 0}));
}

// 5.4.3: a right angle at 2 pulse/ST, with the limit after a reset and with 0.5.
TEST(GtList, PassesCornersAsFastAsItsAxesBear) {
  for (const double limit : {16384.0, 0.5}) {
    PathTestCard card;
    card.Do("GT_SetAccLmt", {limit});
    card.Do("GT_StrtList");
    card.Do("GT_MvXY", {0, 0, 2, 0.01});
    card.Do("GT_LnXY", {3000, 0});
    card.Do("GT_LnXY", {3000, 3000});
    card.Do("GT_EndList");
    card.Do("GT_StrtMtn");
    EXPECT_EQ(card.RunPath(), limit > 1 ? 3200 : 3313) << limit;
    EXPECT_EQ(card.PathBit(5), false) << limit;
  }
}

TEST(GtList, TakesNewVelocitiesForSegmentsThatFollow) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {0, 0, 2, 0.02});
  card.Do("GT_LnXY", {1000, 0});
  card.Do("GT_SetSynVel", {1});
  card.Do("GT_LnXY", {2000, 0});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.Run(400);
  EXPECT_EQ(card.Velocity(), 2);
  card.Run(400);
  EXPECT_EQ(card.Number(), 2);
  EXPECT_EQ(card.Velocity(), 1);
}

// --- What it takes when --------------------------------------------------------------------------

TEST(GtList, ShowsThatItIsOpenAndEmpty) {
  PathTestCard card;
  card.Do("GT_StrtList");
  EXPECT_EQ(card.PathStatus() & 0x2083, 0x2001);
  card.Do("GT_MvXY", {0, 0, 1, 1});
  EXPECT_FALSE(card.PathBit(13));
  card.Do("GT_EndList");
  EXPECT_TRUE(card.PathBit(1));
  card.Do("GT_EndList");
  card.Do("GT_AddList");
  EXPECT_FALSE(card.PathBit(1));
}

TEST(GtList, NeedsItsStartPointFirst) {
  PathTestCard card;
  card.Refuses(kListOrder, "GT_MvXY", {0, 0, 1, 1});
  card.Do("GT_StrtList");
  card.Refuses(kListOrder, "GT_LnXY", {1, 1});
  card.Refuses(kListOrder, "GT_ArcXY", {1, 1, 90});
  card.Refuses(kListOrder, "GT_SetSynVel", {1});
  card.Refuses(kListOrder, "GT_SetSynAcc", {1});
  card.Do("GT_MvXYZ", {0, 0, 0, 1, 1});
  card.Refuses(kListOrder, "GT_MvXY", {0, 0, 1, 1});
  card.Refuses(kListOrder, "GT_MvXYZA", {0, 0, 0, 0, 1, 1});
  card.Do("GT_LnXY", {1, 1});
}

TEST(GtList, TakesItsStartPointAlsoWhenItIsOpenedAgain) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_EndList");
  card.Refuses(kListOrder, "GT_MvXY", {0, 0, 1, 1});
  card.Do("GT_AddList");
  card.Do("GT_MvXY", {0, 0, 1, 1});
  card.Do("GT_LnXY", {1, 1});
}

TEST(GtList, RefusesFiguresOfItsStartPoint) {
  PathTestCard card;
  card.Do("GT_StrtList");
  for (const double rate : {0.0, -1.0, 16385.0}) {
    card.RefusesFigure(4, "GT_MvXY", {0, 0, rate, 1});
    card.RefusesFigure(4, "GT_MvXYZ", {0, 0, 0, 1, rate});
    card.RefusesFigure(4, "GT_MvXYZA", {0, 0, 0, 0, rate, 1});
  }
  card.RefusesFigure(5, "GT_MvXY", {1.1e9, 0, 1, 1});
  card.RefusesParameter("GT_MvXY", {0, INFINITY, 1, 1});
  card.RefusesParameter("GT_MvXY", {0, 0, NAN, 1});
}

TEST(GtList, OpensAgainOnlyWhenItIsClosed) {
  PathTestCard card;
  card.Refuses(kPathState, "GT_AddList");
  card.Do("GT_StrtList");
  card.Refuses(kPathState, "GT_AddList");
  card.Do("GT_StrtList");
  card.Do("GT_EndList");
  card.Do("GT_AddList");
}

TEST(GtList, StartsOnlyAtRestAndWithSomethingToDo) {
  PathTestCard card;
  card.Refuses(kPathState, "GT_StrtMtn");
  card.Do("GT_StrtList");
  card.Refuses(kPathState, "GT_StrtMtn");
  card.Do("GT_MvXY", {0, 0, 1, 0.01});
  card.Do("GT_LnXY", {100, 0});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.Cycle();
  card.Refuses(kPathState, "GT_StrtMtn");
  card.Refuses(kPathState, "GT_StrtList");
  card.Refuses(kPathState, "GT_LnXY", {1, 1});
  card.RunPath();
  card.Refuses(kPathState, "GT_StrtMtn");
}

TEST(GtList, MayBeOpenedWhileASingleSegmentRuns) {
  PathTestCard card;
  card.SetRates(1, 0.01);
  card.Do("GT_LnXY", {200, 0});
  card.Cycle();
  card.Do("GT_StrtList");
  EXPECT_FALSE(card.PathBit(7));
  card.Do("GT_MvXY", {0, 0, 1, 0.01});
  card.Refuses(kPathState, "GT_StrtMtn");
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 200);
  EXPECT_FALSE(card.PathBit(1));
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 0);
}

// A run that has executed all of an open list rests until there is more.
TEST(GtList, WaitsForMoreWhileItIsOpen) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {0, 0, 2, 0.02});
  card.Do("GT_LnXY", {200, 0});
  card.Do("GT_StrtMtn");
  card.Run(300);
  EXPECT_EQ(card.Planned(1), 200);
  // It moves, the list is open and empty; no segment runs.
  EXPECT_EQ(card.PathStatus() & 0x2013, 0x2010);
  EXPECT_EQ(card.Number(), 1);
  EXPECT_EQ(card.Velocity(), 0);
  card.Do("GT_LnXY", {400, 0});
  card.Cycle();
  EXPECT_EQ(card.Number(), 2);
  card.Do("GT_EndList");
  EXPECT_EQ(card.RunPath(), 199);
  EXPECT_EQ(card.Planned(1), 400);
}

TEST(GtList, EndsAWaitingRunWhenItIsClosed) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {0, 0, 2, 0.02});
  card.Do("GT_StrtMtn");
  card.Run(10);
  EXPECT_FALSE(card.PathBit(0));
  card.Do("GT_EndList");
  EXPECT_TRUE(card.PathBit(0));
  EXPECT_FALSE(card.PathBit(9));
}

// --- Room ----------------------------------------------------------------------------------------

struct WordsCase {
  std::string name;
  std::vector<double> arguments;
  int words;
};

const WordsCase kWordsCases[] = {{"GT_LnXY", {1, 1}, 5},         {"GT_LnXYZ", {1, 1, 1}, 7},
                                 {"GT_LnXYZA", {1, 1, 1, 1}, 9}, {"GT_ArcXY", {5, 5, 360}, 7},
                                 {"GT_ArcYZ", {5, 5, 360}, 7},   {"GT_ArcZX", {5, 5, 360}, 7},
                                 {"GT_SetSynVel", {1}, 3},       {"GT_SetSynAcc", {1}, 3}};

// Until 4096 words are used; GT_MvXY takes 9.
TEST(GtList, HasRoomFor4096Words) {
  for (const WordsCase& c : kWordsCases) {
    SCOPED_TRACE(c.name);
    PathTestCard card;
    card.Do("GT_StrtList");
    card.Do("GT_MvXY", {0, 0, 1, 1});
    const int most = (4096 - 9) / c.words;
    for (int i = 0; i < most; ++i) {
      std::vector<double> arguments = c.arguments;
      // Lines need a length.
      if (c.name.starts_with("GT_Ln")) arguments[0] = i + 1;
      ASSERT_EQ(card.Call(c.name, arguments), 0) << i;
    }
    std::vector<double> more = c.arguments;
    more[0] += 5000;
    if (c.name.starts_with("GT_Set")) more = c.arguments;
    card.Refuses(kListFull, c.name, more);
  }
}

TEST(GtList, HasRoomAgainWhenASegmentHasEnded) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {0, 0, 10, 10});
  int sent = 0;
  while (card.Call("GT_LnXY", {sent + 1.0, 0}) == 0) ++sent;
  EXPECT_EQ(sent, 817);
  card.Do("GT_StrtMtn");
  // Hosts repeat what was refused: far more than the buffer holds.
  for (int cycles = 0; sent < 3000 && cycles < 100'000; ++cycles) {
    card.Cycle();
    while (sent < 3000 && card.Call("GT_LnXY", {sent + 1.0, 0}) == 0) ++sent;
  }
  card.Do("GT_EndList");
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 3000);
  EXPECT_EQ(card.Number(), 3000);
}

TEST(GtList, NumbersWrapAt65536) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {0, 0, 1000, 1000});
  card.Do("GT_StrtMtn");
  card.state().path.list.last_number = 65534;
  for (int i = 0; i < 3; ++i) card.Do("GT_LnXY", {i + 1.0, 0});
  card.Do("GT_EndList");
  card.RunPath();
  EXPECT_EQ(card.Number(), 1);
}

// --- Stops and break points ----------------------------------------------------------------------

// 5.4.2.3, 5.4.4: a stop in the second of three lines, and the rest of the list.
TEST(GtStopMotion, KeepsTheBreakPointFromWhichItGoesOn) {
  PathTestCard card;
  card.MakeList({4000, 8000, 12000}, 2, 0.01);
  card.Do("GT_StrtMtn");
  card.Run(3100);
  EXPECT_EQ(card.Planned(1), 6000);
  card.Do("GT_StpMtn");
  EXPECT_EQ(card.RunPath(), 200);
  EXPECT_EQ(card.PathStatus() & 3, 3);
  EXPECT_FALSE(card.PathBit(9));
  EXPECT_EQ(card.Number(), 2);
  EXPECT_NEAR(card.Planned(1), 6200, 1e-9);
  EXPECT_EQ(card.Point("GT_GetBrkPnt"), card.Point());
  card.Do("GT_StrtMtn");
  EXPECT_EQ(card.RunPath(), 3100);
  EXPECT_EQ(card.Planned(1), 12000);
  EXPECT_EQ(card.Number(), 3);
  // What a new list drops.
  EXPECT_NEAR(card.Point("GT_GetBrkPnt")[0], 6200, 1e-9);
  card.Do("GT_StrtList");
  EXPECT_EQ(card.Point("GT_GetBrkPnt"), kOrigin);
  EXPECT_EQ(card.Number(), 0);
}

TEST(GtStopMotion, KeepsWhereAListWaitedForMore) {
  for (const char* stop : {"GT_StpMtn", "GT_EStpMtn"}) {
    SCOPED_TRACE(stop);
    PathTestCard card;
    card.MakeList({200}, 2, 0.01);
    card.Do("GT_AddList");
    card.Do("GT_StrtMtn");
    card.Run(600);
    EXPECT_FALSE(card.PathBit(0));
    card.Do(stop);
    EXPECT_TRUE(card.PathBit(0));
    EXPECT_EQ(card.Point("GT_GetBrkPnt"), (std::vector<double>{200, 0, 0, 0}));
    EXPECT_EQ(card.Number(), 1);
  }
}

TEST(GtStopMotion, AtOnceNeedsNoWay) {
  PathTestCard card;
  card.MakeList({4000}, 2, 0.01);
  card.Do("GT_StrtMtn");
  card.Run(1000);
  const double at = card.Planned(1);
  card.Do("GT_EStpMtn");
  EXPECT_TRUE(card.PathBit(0));
  EXPECT_TRUE(card.StatusBit(0));
  EXPECT_EQ(card.Velocity(), 0);
  card.Run(10);
  EXPECT_EQ(card.Planned(1), at);
  EXPECT_EQ(card.Point("GT_GetBrkPnt")[0], at);
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 4000);
}

TEST(GtStopMotion, GoesBackToTheBreakPointFirst) {
  PathTestCard card;
  card.MakeList({4000}, 2, 0.01);
  card.Do("GT_StrtMtn");
  card.Run(1100);
  card.Do("GT_EStpMtn");
  EXPECT_EQ(card.Point("GT_GetBrkPnt")[0], 2000);
  card.SetRates(10, 0.1);
  card.Do("GT_LnXY", {2000, 400});
  card.RunPath();
  card.Do("GT_StrtMtn");
  // 400 pulses with GT_MvXY's 2 and 0.01, rest, 2000 pulses.
  card.Run(200);
  EXPECT_EQ(card.Velocity(), 2);
  EXPECT_EQ(card.Number(), 1);
  card.Run(200);
  EXPECT_EQ(card.Planned(2), 0);
  EXPECT_EQ(card.RunPath(), 1200);
  EXPECT_EQ(card.Planned(1), 4000);
}

TEST(GtStopMotion, OnTheWayToTheStartPointOrBackLeavesTheBreakPoint) {
  PathTestCard card;
  card.Do("GT_StrtList");
  card.Do("GT_MvXY", {400, 0, 2, 0.01});
  card.Do("GT_LnXY", {4400, 0});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.Run(100);
  card.Do("GT_EStpMtn");
  EXPECT_EQ(card.Point("GT_GetBrkPnt"), kOrigin);
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 4400);

  card.MakeList({4000}, 2, 0.01);
  card.Do("GT_StrtMtn");
  card.Run(4000);
  card.Do("GT_EStpMtn");
  const std::vector<double> stopped = card.Point("GT_GetBrkPnt");
  EXPECT_GT(stopped[0], 0);
  card.SetRates(10, 0.1);
  card.Do("GT_LnXY", {stopped[0], 400});
  card.RunPath();
  card.Do("GT_StrtMtn");
  card.Run(100);
  card.Do("GT_StpMtn");
  card.RunPath();
  EXPECT_LT(card.Planned(2), 400);
  EXPECT_EQ(card.Point("GT_GetBrkPnt"), stopped);
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 4000);
  EXPECT_EQ(card.Planned(2), 0);
}

TEST(GtStopMotion, DropsASingleSegment) {
  for (const char* stop : {"GT_StpMtn", "GT_EStpMtn"}) {
    PathTestCard card;
    card.SetRates(2, 0.01);
    card.Do("GT_LnXY", {4000, 0});
    card.Run(1100);
    card.Do(stop);
    EXPECT_EQ(card.RunPath(), stop == std::string_view("GT_StpMtn") ? 200 : 0);
    EXPECT_LT(card.Planned(1), 4000);
    EXPECT_EQ(card.Point("GT_GetBrkPnt"), kOrigin);
    card.Refuses(kPathState, "GT_StrtMtn");
    card.Do("GT_LnXY", {0, 0});
    card.RunPath();
    EXPECT_EQ(card.Planned(1), 0);
  }
}

TEST(GtStopMotion, ClosesTheListAlsoAtRest) {
  for (const char* stop : {"GT_StpMtn", "GT_EStpMtn"}) {
    PathTestCard card;
    card.Do("GT_StrtList");
    card.Do(stop);
    EXPECT_TRUE(card.PathBit(1));
    card.Do("GT_AddList");
    card.Do("GT_MvXY", {0, 0, 1, 0.01});
    card.Do("GT_LnXY", {1000, 0});
    card.Do("GT_StrtMtn");
    card.Run(100);
    card.Do(stop);
    EXPECT_TRUE(card.PathBit(1));
  }
}

TEST(GtStopMotion, GoesOnWithSegmentsThatAreAddedLater) {
  PathTestCard card;
  card.MakeList({4000}, 2, 0.01);
  card.Do("GT_StrtMtn");
  card.Run(1100);
  card.Do("GT_EStpMtn");
  card.Do("GT_AddList");
  card.Do("GT_LnXY", {8000, 0});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  // 6000 pulses without a stop between them.
  EXPECT_EQ(card.RunPath(), 3200);
  EXPECT_EQ(card.Planned(1), 8000);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
