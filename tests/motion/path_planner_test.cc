// The multi-axis look-ahead, rule by rule. Units of these tests: mm and s.
#include "motion/paths/path_planner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/common/state_hash.h"
#include "tests/motion/planned_path.h"

namespace oncard::motion {
namespace {

constexpr size_t kWindow = 200;

/// Two lines of 50 mm that turn by `degrees`.
PlannedPath Corner(double degrees) {
  PlannedPath path;
  path.limits.corner_time = 0.01;
  const double angle = degrees * M_PI / 180;
  path.Line({50, 0}).Line({50 + 50 * std::cos(angle), 50 * std::sin(angle)});
  return path;
}

double CornerVelocityOf(const PlannedPath& path) { return path.Planned(kWindow)[0].end_velocity; }

TEST(PathPlanner, OneLineIsATrapezoid) {
  PlannedPath path;
  path.Line({30, 40});
  // 100 mm/s after 10 mm and 0.2 s, 30 mm at that velocity.
  EXPECT_NEAR(path.Time(kWindow), 0.2 + 30 / 100.0 + 0.2, 1e-12);
}

TEST(PathPlanner, ACornerLimitsTheChangeOfVelocity) {
  // v |u - t| <= 500 mm/s^2 * 0.01 s; |u - t| = 2 sin(angle / 2).
  EXPECT_NEAR(CornerVelocityOf(Corner(90)), 5 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(CornerVelocityOf(Corner(60)), 5, 1e-9);
  EXPECT_NEAR(CornerVelocityOf(Corner(180)), 2.5, 1e-9);
}

TEST(PathPlanner, ALongerTimeConstantMakesCornersFaster) {
  PlannedPath path = Corner(90);
  path.limits.corner_time = 0.05;
  EXPECT_NEAR(CornerVelocityOf(path), 25 / std::sqrt(2.0), 1e-9);
}

TEST(PathPlanner, CornersAndCurvesCanBeIgnored) {
  PlannedPath path = Corner(90);
  path.limits.geometric = false;
  EXPECT_NEAR(CornerVelocityOf(path), 100, 1e-9);
}

TEST(PathPlanner, TheSlowerOfTwoLinesDeterminesTheVelocityBetweenThem) {
  PlannedPath path;
  path.Line({50, 0});
  path.velocity = 20;
  path.Line({100, 0});
  EXPECT_NEAR(CornerVelocityOf(path), 20, 1e-9);
}

TEST(PathPlanner, AnArcIsLimitedByItsRadius) {
  PlannedPath path;
  path.limits.radius_ratio = 0.02;
  path.Arc({10, 10}, 0, 10, true);
  EXPECT_NEAR(path.Planned(kWindow)[0].velocity_limit, std::sqrt(0.02 * 500 * 10), 1e-9);
}

TEST(PathPlanner, AHelixIsLimitedByTheCurvatureOfItsPath) {
  PlannedPath path;
  path.limits.radius_ratio = 0.02;
  path.Arc({0, 0, 30}, 0, 10, true);
  const double radius =
      path.slots[0].segment.length * path.slots[0].segment.length / (4 * M_PI * M_PI * 10);
  EXPECT_GT(radius, 10);
  EXPECT_NEAR(path.Planned(kWindow)[0].velocity_limit, std::sqrt(0.02 * 500 * radius), 1e-6);
}

TEST(PathPlanner, ChordsOfACircleAreLimitedByItsRadius) {
  PlannedPath path;
  path.limits.corner_time = 1;
  path.limits.radius_ratio = 0.02;
  for (int i = 1; i <= 72; ++i) {
    const double angle = i * M_PI / 36;
    path.Line({10 * std::sin(angle), 10 - 10 * std::cos(angle)});
  }
  for (const PathSlot& slot : path.Planned(kWindow)) {
    EXPECT_NEAR(slot.velocity_limit, std::sqrt(0.02 * 500 * 10), 1e-9);
  }
}

TEST(PathPlanner, ACornerIsNoCurve) {
  for (const PathSlot& slot : Corner(31).Planned(kWindow)) EXPECT_EQ(slot.velocity_limit, 100);
  EXPECT_LT(Corner(29).Planned(kWindow)[0].velocity_limit, 1000);
}

TEST(PathPlanner, AnAxisLimitsItsVelocityOnALine) {
  PlannedPath path;
  path.limits.axes[1].velocity = 40;
  path.Line({30, 40}).Line({60, 40});
  EXPECT_NEAR(path.Planned(kWindow)[0].velocity_limit, 50, 1e-9);
  EXPECT_NEAR(path.Planned(kWindow)[1].velocity_limit, 100, 1e-9);
}

TEST(PathPlanner, AnAxisLimitsItsAccelerationOnALine) {
  PlannedPath path;
  path.limits.axes[0].acceleration = 60;
  path.Line({30, 40});
  EXPECT_NEAR(path.Planned(kWindow)[0].acceleration, 100, 1e-9);
}

TEST(PathPlanner, AnAxisLimitsItsJumpAtACorner) {
  PlannedPath path = Corner(90);
  path.limits.geometric = false;
  path.limits.axes[1].jump = 3;
  EXPECT_NEAR(CornerVelocityOf(path), 3, 1e-9);
}

TEST(PathPlanner, AnAxisThatDoesNotCountIsLimitedAllTheSame) {
  PlannedPath path;
  path.limits.length_axes = 0x7;
  path.limits.axes[3].velocity = 40;
  path.Line({30, 40, 0, 100});
  EXPECT_EQ(path.slots[0].segment.length, 50);
  EXPECT_NEAR(path.Planned(kWindow)[0].velocity_limit, 20, 1e-9);
}

TEST(PathPlanner, ALineThatMovesNoneOfTheAxesThatCountIsMeasuredWithAll) {
  PlannedPath path;
  path.limits.length_axes = 0x7;
  path.Line({0, 0, 0, 100});
  EXPECT_EQ(path.slots[0].segment.length, 100);
}

/// A line with a profile that follows it by `displacement`, between two without.
std::vector<PathSlot> Followed(const AxisLimits& limits, double displacement, double up = 0,
                               double down = 0) {
  PlannedPath path;
  path.limits.followers[4] = limits;
  path.Line({50, 0});
  PathSlot gear;
  gear.command = {BufferedKind::kGear, 4, 0, {displacement, up, down}};
  path.slots.push_back(gear);
  path.Line({100, 0}).Line({150, 0});
  std::vector<PathSlot> planned = path.Planned(kWindow);
  planned.erase(planned.begin() + 1);
  return planned;
}

TEST(PathPlanner, AFollowerLimitsTheVelocityOfItsSegment) {
  const auto planned = Followed({10, kUnlimited, kUnlimited}, 25);
  EXPECT_NEAR(planned[1].velocity_limit, 20, 1e-9);
  EXPECT_EQ(planned[2].velocity_limit, 100);
}

TEST(PathPlanner, AFollowerLimitsTheAccelerationOfItsSegment) {
  EXPECT_NEAR(Followed({kUnlimited, 100, kUnlimited}, -25)[1].acceleration, 200, 1e-9);
}

TEST(PathPlanner, AFollowerLimitsItsJumpAtBothEnds) {
  const auto planned = Followed({kUnlimited, kUnlimited, 4}, 25);
  EXPECT_NEAR(planned[0].end_velocity, 8, 1e-9);
  EXPECT_NEAR(planned[1].end_velocity, 8, 1e-9);
}

// The slope is displacement / (50 mm * (1 - (up + down) / 2)) between the ramps.
TEST(PathPlanner, AFollowerWithRampsIsLimitedByItsLargestSlope) {
  EXPECT_NEAR(Followed({10, kUnlimited, kUnlimited}, 25, 0.5, 0.5)[1].velocity_limit, 10, 1e-9);
}

TEST(PathPlanner, TheRampsOfAFollowerTakeHalfOfItsAcceleration) {
  const auto planned = Followed({kUnlimited, 100, kUnlimited}, 25, 0.4, 0.2);
  const double slope = 0.5 / 0.7;
  EXPECT_NEAR(planned[1].acceleration, 50 / slope, 1e-9);
  // The shorter ramp is 10 mm: v^2 slope / 10 mm is the other half.
  EXPECT_NEAR(planned[1].velocity_limit, std::sqrt(50 * 10 / slope), 1e-9);
}

TEST(PathPlanner, AFollowerDoesNotJumpAtARamp) {
  const auto planned = Followed({kUnlimited, kUnlimited, 4}, 25, 0.5, 0);
  EXPECT_NEAR(planned[0].end_velocity, 100, 1e-9);
  EXPECT_NEAR(planned[1].end_velocity, 4 / (0.5 / 0.75), 1e-9);
}

TEST(PathPlanner, ASegmentCanEndAtRest) {
  PlannedPath path;
  path.Line({50, 0}).Rest().Line({100, 0});
  EXPECT_EQ(CornerVelocityOf(path), 0);
}

TEST(PathPlanner, CommandsThatNeedRestStopThePath) {
  for (const bool waits : {false, true}) {
    PlannedPath path;
    path.Line({50, 0});
    PathSlot move;
    move.command = {BufferedKind::kMove, 5, waits ? 1 : 0, {1000, 10, 10}};
    path.slots.push_back(move);
    path.Line({100, 0});
    EXPECT_NEAR(CornerVelocityOf(path), waits ? 0 : 100, 1e-9);
  }
}

TEST(PathPlanner, StopsInsideTheWindow) {
  // Lines of 1 mm: with a window of n, a segment may leave with v^2 = 2 * 500 * n.
  for (const size_t window : {1u, 2u, 4u, 8u}) {
    PlannedPath path;
    path.limits.geometric = false;
    for (int i = 1; i <= 40; ++i) path.Line({static_cast<double>(i), 0});
    const std::vector<PathSlot> planned = path.Planned(window);
    double fastest = 0;
    for (size_t i = 0; i < planned.size(); ++i) {
      const double after = static_cast<double>(std::min(window, planned.size() - 1 - i));
      EXPECT_LE(planned[i].end_velocity * planned[i].end_velocity, 1000 * after + 1e-9) << i;
      fastest = std::max(fastest, planned[i].end_velocity);
    }
    EXPECT_NEAR(fastest, std::min(100.0, std::sqrt(1000.0 * static_cast<double>(window))), 1e-9);
  }
}

// What can be kept at a segment's end depends on the window alone.
TEST(PathPlanner, StopsInsideTheWindowOnAnyPath) {
  RandomNumbers random(7);
  for (const size_t window : {1u, 3u, 7u}) {
    PlannedPath path;
    path.limits.corner_time = 0.1;
    for (int i = 0; i < 200; ++i) {
      path.acceleration = random.Between(100, 1000);
      Coordinates end = path.end();
      end[0] += random.Between(0.1, 3);
      end[1] += random.Between(-0.5, 0.5);
      path.Line(end);
    }
    const std::vector<PathSlot> planned = path.Planned(window);
    for (size_t i = 0; i < planned.size(); ++i) {
      double square = 0;
      for (size_t k = i + 1; k < std::min(i + 1 + window, planned.size()); ++k) {
        square += 2 * planned[k].acceleration * planned[k].segment.length;
      }
      EXPECT_LE(planned[i].end_velocity * planned[i].end_velocity, square * (1 + 1e-9)) << i;
    }
  }
}

// The newest line can still become a chord of a curve with a radius of its length.
TEST(PathPlanner, LeavesRoomForACurveThatIsNotYetKnown) {
  PlannedPath path;
  path.limits.radius_ratio = 0.1;
  for (int i = 1; i <= 40; ++i) path.Line({static_cast<double>(i), 0});
  EXPECT_NEAR(path.Planned(1)[10].end_velocity, std::sqrt(0.1 * 500 * 1), 1e-9);
  EXPECT_NEAR(path.Planned(2)[10].end_velocity, std::sqrt(0.1 * 500 * 1 + 1000), 1e-9);
}

TEST(PathPlanner, HoldsNoMoreSegmentsThanItsWindow) {
  PlannedPath path;
  for (int i = 1; i <= 50; ++i) path.Line({static_cast<double>(i), 0});
  CrdFifo fifo;
  fifo.planner.Emplace({.limits = path.limits, .capacity = 20});
  for (const PathSlot& slot : path.slots) ASSERT_TRUE(fifo.Append(slot));
  EXPECT_EQ(fifo.planner->spans.size(), 20u);
  EXPECT_EQ(fifo.slots.size(), 30u);
  EXPECT_TRUE(fifo.Flush());
  EXPECT_EQ(fifo.slots.size(), 50u);
}

TEST(PathPlanner, AFullFifoRefusesASegmentAndKeepsWhatItHas) {
  PlannedPath path;
  for (int i = 1; i <= 4096 + 20 + 1; ++i) path.Line({static_cast<double>(i), 0});
  CrdFifo fifo;
  fifo.planner.Emplace({.limits = path.limits, .capacity = 20});
  for (size_t i = 0; i + 1 < path.slots.size(); ++i) ASSERT_TRUE(fifo.Append(path.slots[i])) << i;
  const uint64_t before = StateHash().Add(fifo).value();
  EXPECT_FALSE(fifo.Append(path.slots.back()));
  EXPECT_EQ(StateHash().Add(fifo).value(), before);
  fifo.slots.Pop();
  EXPECT_TRUE(fifo.Append(path.slots.back()));
  EXPECT_FALSE(fifo.Flush());
  while (!fifo.slots.empty()) fifo.slots.Pop();
  EXPECT_TRUE(fifo.Flush());
}

TEST(PathPlanner, GoesOnFromRestAfterAFlush) {
  PlannedPath path;
  path.Line({50, 0}).Line({100, 0});
  CrdFifo fifo;
  fifo.planner.Emplace({.limits = path.limits, .capacity = 10});
  for (int round = 0; round < 2; ++round) {
    for (const PathSlot& slot : path.slots) ASSERT_TRUE(fifo.Append(slot));
    ASSERT_TRUE(fifo.Flush());
    EXPECT_NEAR(fifo.slots.front().end_velocity, 100, 1e-9);
    EXPECT_EQ(fifo.slots.back().end_velocity, 0);
    fifo.slots.Clear();
  }
}

// What cards without a planner are named by does not change (state_hash.h).
TEST(PathPlanner, JoinsTheHashOnlyInUse) {
  CrdFifo without;
  CrdFifo with;
  with.planner.Emplace({});
  EXPECT_NE(StateHash().Add(with).value(), StateHash().Add(without).value());
  with.planner.Reset();
  EXPECT_EQ(StateHash().Add(with).value(), StateHash().Add(without).value());
  EXPECT_EQ(StateHash().Add(without.planner).value(), StateHash().value());
  EXPECT_EQ(StateHash().Add(PlannedMotion{}).Add(CurveRun{}).value(), StateHash().value());
}

TEST(PathPlanner, IsCopiedWithTheStateThatHoldsIt) {
  CrdFifo fifo;
  fifo.planner.Emplace({.capacity = 7});
  CrdFifo copy = fifo;
  copy.planner->capacity = 8;
  EXPECT_EQ(fifo.planner->capacity, 7u);
  fifo = copy;
  EXPECT_EQ(fifo.planner->capacity, 8u);
  EXPECT_NE(&*fifo.planner, &*copy.planner);
}

}  // namespace
}  // namespace oncard::motion
