// The map of the axes, lines and arcs that are executed at once, registers and status of paths.
// Figures are those of the GT manual, chapter 5.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/gtcalls/gt400/path_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

constexpr double kNotFinite[] = {std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()};
constexpr int kCoordinatedMode = 0x2800;

// --- The map -------------------------------------------------------------------------------------

TEST(GtMap, PutsAnAxisIntoCoordinatedModeAndKeepsTheCurrentAxis) {
  Gt400TestCard card;
  card.Do("GT_Axis", {1});
  std::vector<double> row = {0, 2000, 0, 0, 5};
  EXPECT_EQ(card.Call("GT_MapAxis", {2}, &row), 0);
  EXPECT_EQ(card.Read("GT_GetMode"), 0);
  card.Do("GT_Axis", {2});
  EXPECT_EQ(card.Read("GT_GetMode"), kCoordinatedMode);
}

TEST(GtMap, MovesAxesByTheirRows) {
  PathTestCard card;
  ASSERT_EQ(card.Map(2, {-2, 3, 0, 0, 0}), 0);
  card.SetRates(1, 0.01);
  card.Do("GT_LnXYZA", {100, -200, 300, 50});
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 100);
  EXPECT_EQ(card.Planned(2), -800);
  EXPECT_EQ(card.Point(), (std::vector<double>{100, -200, 300, 50}));
}

TEST(GtMap, FindsTheCoordinatesWhereTheAxesAre) {
  PathTestCard card(2000);
  card.Do("GT_SetAtlPos", {5000});
  EXPECT_EQ(card.Point(), (std::vector<double>{2.5, 0, 0, 0}));
}

// Of rows that depend on each other those of lower axes count.
TEST(GtMap, LetsAnAxisThatContradictsAnotherJumpAtTheNextMotion) {
  PathTestCard card;
  ASSERT_EQ(card.Map(3, {1, 0, 0, 0, 1000}), 0);
  card.SetRates(1, 0.01);
  EXPECT_EQ(card.Planned(3), 0);
  card.Do("GT_LnXY", {100, 0});
  EXPECT_EQ(card.Planned(3), 1000);
  card.RunPath();
  EXPECT_EQ(card.Planned(3), 1100);
}

TEST(GtMap, EndsWithAnotherMode) {
  PathTestCard card;
  card.Do("GT_Axis", {2});
  card.Do("GT_PrflT");
  card.SetRates(1, 0.01);
  card.Do("GT_LnXY", {100, 100});
  EXPECT_FALSE(card.StatusBit(10));
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 100);
  EXPECT_EQ(card.Planned(2), 0);
  EXPECT_EQ(card.Point(), (std::vector<double>{100, 100, 0, 0}));
}

TEST(GtMap, IsNotNeededForAPath) {
  Gt400TestCard card;
  card.Do("GT_SetSynVel", {1});
  card.Do("GT_SetSynAcc", {0.01});
  card.Do("GT_LnXY", {50, 20});
  card.Run(200);
  std::vector<double> point(4);
  EXPECT_EQ(card.Call("GT_GetPrfPnt", {}, &point), 0);
  EXPECT_EQ(point, (std::vector<double>{50, 20, 0, 0}));
  EXPECT_EQ(card.motion.profile(0).now.position, 0);
}

TEST(GtMap, RefusesNumbersAndFiguresThatAreNone) {
  PathTestCard card;
  for (const double axis : {0.0, 5.0}) {
    std::vector<double> row = {1, 0, 0, 0, 0};
    EXPECT_EQ(card.Call("GT_MapAxis", {axis}, &row), 7);
  }
  for (const double figure : kNotFinite) {
    for (size_t i = 0; i < 5; ++i) {
      std::vector<double> row = {1, 0, 0, 0, 0};
      row[i] = figure;
      EXPECT_EQ(card.Call("GT_MapAxis", {1}, &row), 7);
    }
  }
  std::vector<double> huge = {1, 0, 0, 0, -1.1e9};
  EXPECT_EQ(card.Call("GT_MapAxis", {1}, &huge), 7);
  EXPECT_EQ(card.Call("GT_MapAxis", {1}), 7);
  EXPECT_FALSE(card.PathBit(3));
  std::vector<double> zero = {0, 0, 0, 0, 7};
  card.RefusesFigure(6, "GT_MapAxis", {1}, &zero);
}

// Example 5-1.
TEST(GtMap, RefusesAnAxisThatMoves) {
  Gt400TestCard card;
  card.Enable(1);
  card.Do("GT_PrflV");
  card.Do("GT_SetVel", {1});
  card.Do("GT_SetAcc", {0.1});
  card.Do("GT_Update");
  std::vector<double> row = {1, 0, 0, 0, 0};
  EXPECT_EQ(card.Call("GT_MapAxis", {1}, &row), 1);
  EXPECT_EQ(card.Cause(), kPathState);
  EXPECT_EQ(static_cast<int>(card.Read("GT_GetCrdSts")) >> 3 & 1, 1);
  // Axis commands have a bit of their own.
  EXPECT_FALSE(card.StatusBit(7));
  EXPECT_EQ(card.Call("GT_MapAxis", {2}, &row), 0);
}

TEST(GtMap, RefusesAllAxesWhileAPathRuns) {
  PathTestCard card;
  card.Do("GT_Axis", {4});
  card.Do("GT_PrflT");
  card.SetRates(1, 0.01);
  card.Do("GT_LnXY", {100, 0});
  EXPECT_EQ(card.Map(4, {1, 0, 0, 0, 0}), 1);
  EXPECT_EQ(card.Cause(), kPathState);
}

// --- Status --------------------------------------------------------------------------------------

TEST(GtPathStatus, IsThatOfTheManualAfterAReset) {
  Gt400TestCard card;
  EXPECT_EQ(card.Read("GT_GetCrdSts"), 0x20D3);
}

TEST(GtPathStatus, ShowsASingleSegment) {
  PathTestCard card;
  card.Do("GT_StrtList");
  EXPECT_FALSE(card.PathBit(7));
  card.Do("GT_EndList");
  card.SetRates(1, 0.01);
  card.Do("GT_LnXY", {200, 0});
  // Moving, closed, a segment runs, immediate, the list is empty.
  EXPECT_EQ(card.PathStatus(), 0x20C2);
  card.Cycle();
  EXPECT_EQ(card.PathStatus(), 0x20C2);
  EXPECT_TRUE(card.StatusBit(10));
  card.RunPath();
  EXPECT_EQ(card.PathStatus(), 0x20D3);
  EXPECT_FALSE(card.StatusBit(10));
  EXPECT_TRUE(card.StatusBit(0));
}

TEST(GtPathStatus, KeepsARefusalUntilAGoodPathCommand) {
  PathTestCard card;
  EXPECT_EQ(card.Call("GT_SetSynVel", {-1}), 4);
  EXPECT_TRUE(card.PathBit(3));
  card.Do("GT_SetPos", {7});
  EXPECT_TRUE(card.PathBit(3));
  card.Do("GT_SetSynVel", {1});
  EXPECT_FALSE(card.PathBit(3));
  EXPECT_FALSE(card.StatusBit(7));
}

// On a circle of 100 at 2 per ST each axis changes its velocity by up to 0.04 in an ST.
TEST(GtPathStatus, NotesAnAxisThatJumpsByMoreThanItsLimit) {
  for (const double limit : {0.045, 0.01}) {
    PathTestCard card;
    card.SetRates(2, 0.005);
    card.Do("GT_SetAccLmt", {limit});
    card.Do("GT_ArcXY", {100, 0, 360});
    card.RunPath();
    EXPECT_EQ(card.PathBit(5), limit < 0.02) << limit;
    card.Do("GT_LnXY", {10, 0});
    EXPECT_FALSE(card.PathBit(5));
  }
}

// On a line along x axis 1 accelerates as the path does.
TEST(GtPathStatus, NotesAnAccelerationAboveTheLimitAlsoWithinASegment) {
  for (const double limit : {0.0101, 0.009, 0.001}) {
    PathTestCard card;
    card.SetRates(2, 0.01);
    card.Do("GT_SetAccLmt", {limit});
    card.Do("GT_LnXY", {1000, 0});
    card.RunPath();
    EXPECT_EQ(card.PathBit(5), limit < 0.01) << limit;
    card.Do("GT_LnXYZ", {1000, 0, 500});
    card.RunPath();
    EXPECT_FALSE(card.PathBit(5)) << "axis 1 rests";
  }
}

// --- Limits of jumps -----------------------------------------------------------------------------

TEST(GtAccLmt, IsOneOfTheCurrentAxis) {
  Gt400TestCard card;
  EXPECT_EQ(card.Read("GT_GetAccLmt"), 16384);
  card.Do("GT_Axis", {2});
  card.Do("GT_SetAccLmt", {7.9});
  EXPECT_EQ(card.Read("GT_GetAccLmt"), 7);
  card.Do("GT_Axis", {1});
  EXPECT_EQ(card.Read("GT_GetAccLmt"), 16384);
}

TEST(GtAccLmt, MustBeAboveZero) {
  Gt400TestCard card;
  for (const double limit : {0.0, -1.0, 16384.5, kNotFinite[0]}) {
    EXPECT_EQ(card.Call("GT_SetAccLmt", {limit}), 1) << limit;
    EXPECT_EQ(card.Cause(), kIllegal);
  }
  card.Do("GT_SetAccLmt", {16384});
}

TEST(GtAccLmt, IsRefusedAsAPathCommand) {
  PathTestCard card;
  card.Refuses(kIllegal, "GT_SetAccLmt", {0});
  EXPECT_TRUE(card.PathBit(3));
  EXPECT_FALSE(card.StatusBit(kBitRefused));
}

// --- Velocity and acceleration -------------------------------------------------------------------

TEST(GtSynRates, AreAboveZeroAndAtMost16384) {
  PathTestCard card;
  for (const char* name : {"GT_SetSynVel", "GT_SetSynAcc"}) {
    for (const double rate : {0.0, -1.0, 16384.5, kNotFinite[0]}) {
      card.RefusesFigure(4, name, {rate});
    }
    card.Do(name, {1e-8});
    card.Do(name, {16384});
  }
}

TEST(GtSynRates, MustBeSetBeforeASegment) {
  for (const char* missing : {"GT_SetSynVel", "GT_SetSynAcc"}) {
    PathTestCard card;
    if (missing != std::string_view("GT_SetSynVel")) card.Do("GT_SetSynVel", {1});
    if (missing != std::string_view("GT_SetSynAcc")) card.Do("GT_SetSynAcc", {1});
    card.RefusesFigure(4, "GT_LnXY", {10, 10});
    // The geometry is judged first.
    card.RefusesFigure(3, "GT_LnXY", {0, 0});
  }
}

// --- Segments ------------------------------------------------------------------------------------

// Example 5-5.
TEST(GtSegment, IsExecutedAtOnce) {
  PathTestCard card(2000);
  card.SetRates(0.01, 1e-7);
  card.Do("GT_LnXY", {10, 10});
  card.Run(11892);
  // sqrt(1e-7 * 10 * sqrt(2)).
  EXPECT_NEAR(card.Velocity(), 0.001189207115, 1e-7);
  EXPECT_EQ(11892 + card.RunPath(), 23785);
  EXPECT_EQ(card.Planned(1), 20000);
  EXPECT_EQ(card.Planned(2), 20000);
  EXPECT_EQ(card.Planned(3), 0);
  EXPECT_EQ(card.Velocity(), 0);
}

TEST(GtSegment, LeavesCoordinatesThatItDoesNotName) {
  PathTestCard card;
  card.SetRates(10, 1);
  card.Do("GT_LnXYZA", {1, 2, 3, 4});
  card.RunPath();
  card.Do("GT_LnXY", {10, 20});
  card.RunPath();
  EXPECT_EQ(card.Point(), (std::vector<double>{10, 20, 3, 4}));
  card.Do("GT_LnXYZ", {0, 0, 0});
  card.RunPath();
  EXPECT_EQ(card.Point(), (std::vector<double>{0, 0, 0, 4}));
}

struct ArcCase {
  const char* name;
  std::vector<double> arguments;
  std::vector<double> end;
  /// A point on the way: after half of the arc.
  std::vector<double> middle;
};

// From (10, 20, 30).
const ArcCase kArcCases[] = {
    {"GT_ArcXY", {10, 10, 90}, {0, 10, 30}, {10 - 10 * M_SQRT1_2, 10 + 10 * M_SQRT1_2, 30}},
    {"GT_ArcXY", {10, 10, -90}, {20, 10, 30}, {10 + 10 * M_SQRT1_2, 10 + 10 * M_SQRT1_2, 30}},
    {"GT_ArcXY", {0, 20, 360}, {10, 20, 30}, {-10, 20, 30}},
    {"GT_ArcYZ", {20, 20, 180}, {10, 20, 10}, {10, 10, 20}},
    {"GT_ArcZX", {30, 0, -180}, {-10, 20, 30}, {0, 20, 40}},
    {"GT_ArcXYP", {20, 30, 10, 1}, {20, 30, 30}, {10 + 10 * M_SQRT1_2, 30 - 10 * M_SQRT1_2, 30}},
    {"GT_ArcXYP", {20, 30, 10, -1}, {20, 30, 30}, {20 - 10 * M_SQRT1_2, 20 + 10 * M_SQRT1_2, 30}},
    {"GT_ArcXYP", {20, 30, -10, 1}, {20, 30, 30}, {20 + 10 * M_SQRT1_2, 20 - 10 * M_SQRT1_2, 30}},
    {"GT_ArcYZP", {20, 50, 10, 1}, {10, 20, 50}, {10, 30, 40}},
    {"GT_ArcZXP", {30, -10, 10, -1}, {-10, 20, 30}, {0, 20, 40}}};

TEST(GtSegment, MayBeAnArcInAPlane) {
  for (const ArcCase& c : kArcCases) {
    SCOPED_TRACE(testing::Message() << c.name << testing::PrintToString(c.arguments));
    PathTestCard card;
    card.SetRates(100, 100);
    card.Do("GT_LnXYZ", {10, 20, 30});
    card.RunPath();
    // The velocity is never reached: the path is half way where it is fastest.
    card.SetRates(1000, 1e-6);
    card.Do(c.name, c.arguments);
    double peak = 0;
    std::vector<double> middle;
    for (int i = 0; i < 100'000 && !card.PathBit(0); ++i) {
      card.Cycle();
      if (card.Velocity() <= peak) continue;
      peak = card.Velocity();
      middle = card.Point();
    }
    const std::vector<double> end = card.Point();
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(end[i], c.end[i], 1e-9) << i;
      EXPECT_NEAR(middle[i], c.middle[i], 0.02) << i;
    }
  }
}

TEST(GtSegment, RefusesFiguresThatMakeNone) {
  PathTestCard card;
  card.SetRates(1, 0.01);
  card.RefusesFigure(3, "GT_LnXY", {0, 0});
  card.RefusesFigure(3, "GT_LnXYZ", {0, 0, 0});
  card.RefusesFigure(3, "GT_LnXYZA", {0, 0, 0, 0});
  card.RefusesFigure(2, "GT_ArcXY", {0, 0, 90});
  card.RefusesFigure(2, "GT_ArcXY", {1.1e9, 0, 1});
  card.RefusesFigure(2, "GT_ArcYZ", {0, 0, 90});
  card.RefusesFigure(2, "GT_ArcZX", {0, 0, 90});
  for (const char* name : {"GT_ArcXYP", "GT_ArcYZP", "GT_ArcZXP"}) {
    card.RefusesFigure(5, name, {0, 0, 10, 1});
    card.RefusesFigure(5, name, {10, 0, 0, 1});
    card.RefusesFigure(5, name, {20.01, 0, 10, 1});
    card.RefusesFigure(5, name, {20.01, 0, -10, -1});
  }
  // Beyond the positions of axes.
  card.RefusesFigure(5, "GT_LnXY", {1.1e9, 0});
  ASSERT_EQ(card.Map(1, {2000, 0, 0, 0, 0}), 0);
  card.RefusesFigure(5, "GT_LnXY", {600'000, 0});
  card.RefusesFigure(2, "GT_ArcXY", {600'000, 0, 1});
}

TEST(GtSegment, RefusesParametersThatAreNone) {
  PathTestCard card;
  card.SetRates(1, 0.01);
  for (const char* name : {"GT_ArcXY", "GT_ArcYZ", "GT_ArcZX"}) {
    for (const double angle : {0.0, 360.5, -361.0}) card.RefusesParameter(name, {10, 10, angle});
  }
  for (const char* name : {"GT_ArcXYP", "GT_ArcYZP", "GT_ArcZXP"}) {
    for (const double direction : {0.0, 2.0}) card.RefusesParameter(name, {10, 0, 10, direction});
  }
  for (const double figure : kNotFinite) {
    card.RefusesParameter("GT_LnXY", {figure, 0});
    card.RefusesParameter("GT_LnXYZA", {1, 1, 1, figure});
    card.RefusesParameter("GT_ArcXY", {figure, 1, 90});
    card.RefusesParameter("GT_ArcXYP", {1, 1, figure, 1});
  }
}

TEST(GtSegment, IsRefusedWhileAnotherOneRuns) {
  PathTestCard card;
  card.SetRates(1, 0.01);
  card.Do("GT_LnXY", {100, 0});
  card.Cycle();
  card.Refuses(kPathState, "GT_LnXYZ", {20, 20, 20});
  EXPECT_TRUE(card.PathBit(3));
  // What is set is for the next one.
  card.Do("GT_SetSynVel", {5});
  card.RunPath();
  EXPECT_EQ(card.Planned(1), 100);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
