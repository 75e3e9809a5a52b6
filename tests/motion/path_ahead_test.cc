// Where the path of a coordinate system goes on.
#include "motion/paths/path_ahead.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/motion/change_state.h"
#include "tests/motion/crd_run.h"

namespace oncard::motion {
namespace {

using Points = std::vector<std::vector<double>>;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr size_t kMost = 100;

PathAhead Ahead(const CrdRunTest& test, size_t most = kMost) {
  return FindPathAhead(test.core.state().crds[0], test.core.CrdPosition(0), most);
}

TEST(PathAhead, HasTheEndsOfLinesThatWait) {
  CrdRunTest test;
  EXPECT_THAT(Ahead(test).profiles, ElementsAre(0, 1));
  EXPECT_THAT(Ahead(test).points, IsEmpty());
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  ASSERT_TRUE(test.Delay(5));
  ASSERT_TRUE(test.Line({100, 50}, 10, 1));
  EXPECT_EQ(Ahead(test).points, (Points{{0, 0}, {100, 0}, {100, 50}}));
  EXPECT_TRUE(Ahead(test).whole);
}

TEST(PathAhead, BeginsWhereThePathIs) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({200, 0}, 10, 1));
  ASSERT_TRUE(test.Line({200, 50}, 10, 1));
  test.Start();
  test.RunUntil(15);  // 50 in 10 ms, 50 in 5
  EXPECT_EQ(Ahead(test).points, (Points{{100, 0}, {200, 0}, {200, 50}}));
  test.TicksToEnd();
  EXPECT_THAT(Ahead(test).points, IsEmpty());
}

TEST(PathAhead, IsThatOfTheFifoInUse) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({200, 0}, 10, 1));
  ASSERT_TRUE(test.Line({0, 70}, 10, 1, 0, 1));
  EXPECT_EQ(Ahead(test).points, (Points{{0, 0}, {200, 0}}));
  test.Start(1);
  EXPECT_EQ(Ahead(test).points, (Points{{0, 0}, {0, 70}}));
}

TEST(PathAhead, HasChordsOfArcs) {
  CrdRunTest test;
  PathSlot slot;
  slot.is_segment = true;
  slot.segment = *MakeArcAroundCentre({}, {200, 0}, kXyPlane, 100, 0, false);
  slot.velocity = 10;
  slot.acceleration = 1;
  ASSERT_TRUE(test.core.CrdAt(0).Append(0, slot));
  const Points points = Ahead(test).points;
  ASSERT_EQ(points.size(), 17u);  // pi by chords of 0.2: 16
  for (size_t i = 0; i < points.size(); ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / 16;
    EXPECT_NEAR(points[i][0], 100 - 100 * std::cos(angle), 1e-9);
    EXPECT_NEAR(points[i][1], 100 * std::sin(angle), 1e-9);
  }
}

TEST(PathAhead, HasTheNextPointsOfALongPath) {
  CrdRunTest test;
  for (const double x : {10.0, 20.0, 30.0}) ASSERT_TRUE(test.Line({x, 0}, 10, 1));
  EXPECT_EQ(Ahead(test, 3).points, (Points{{0, 0}, {10, 0}, {20, 0}}));
  EXPECT_FALSE(Ahead(test, 3).whole);
  EXPECT_TRUE(Ahead(test, 4).whole);
}

TEST(PathAhead, LeavesOutWhatLookAheadHasNotPlanned) {
  CrdRunTest test;
  test.core.CrdAt(0).BeginLookAhead(0, 5, 1, 10);
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  EXPECT_THAT(Ahead(test).points, IsEmpty());
  ASSERT_TRUE(test.core.CrdAt(0).Flush(0));
  EXPECT_EQ(Ahead(test).points, (Points{{0, 0}, {100, 0}}));
}

TEST(PathAhead, LeadsBackToABreakpoint) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({400, 0}, 10, 1));
  test.Start();
  test.RunUntil(15);
  test.core.CrdAt(0).Halt();
  test.core.ProfileAt(1).SetPosition(30);
  PathSlot back;
  back.velocity = 10;
  back.acceleration = 1;
  test.core.CrdAt(0).Resume(0, back);
  EXPECT_EQ(Ahead(test).points, (Points{{100, 30}, {100, 0}, {400, 0}}));
}

TEST(PathAhead, GoesToApproachesFromWhereItIs) {
  CrdRunTest test;
  PathSlot slot;
  slot.is_segment = true;
  slot.segment.end = {300, 400};
  slot.ends_at_rest = true;
  slot.approach.axes = 1;
  ASSERT_TRUE(test.core.CrdAt(0).Append(0, slot));
  test.core.ProfileAt(1).SetPosition(80);
  EXPECT_EQ(Ahead(test).points, (Points{{0, 80}, {300, 80}}));
}

TEST(PathAhead, IsWhereTheProfilesWillBe) {
  CrdRunTest test;
  ChangeState(test.core).crds[0].origin = {1000, 2000};
  test.core.ProfileAt(0).SetPosition(1000);
  test.core.ProfileAt(1).SetPosition(2000);
  ASSERT_TRUE(test.Line({100, 50}, 10, 1));
  EXPECT_EQ(Ahead(test).points, (Points{{1000, 2000}, {1100, 2050}}));
}

TEST(PathAhead, OfAMapIsWhereItPutsTheAxes) {
  CrdRunTest test(1000, 4);
  test.core.CrdAt(0).BeginMap();
  MapRow row;
  row.coefficients = {2, 1, 0, 0};
  row.offset = 7;
  test.core.ProfileAt(2).SetPosition(7);
  test.core.CrdAt(0).MapAxis(2, row);
  ASSERT_TRUE(test.Line({100, 50}, 10, 1));
  EXPECT_THAT(Ahead(test).profiles, ElementsAre(2));
  EXPECT_EQ(Ahead(test).points, (Points{{7}, {257}}));
}

}  // namespace
}  // namespace oncard::motion
