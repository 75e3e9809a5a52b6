// The planner against the fastest motion on a fine grid (path_reference.h).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/base/random_cases.h"
#include "tests/motion/planned_path.h"

namespace oncard::motion {
namespace {

/// Plans may not be slower than the optimum by more than this.
constexpr double kRatioMax = 1.01;
/// The grid's own error.
constexpr double kGridError = 0.003;

void ExpectOptimal(const PlannedPath& path, double grid) {
  const double shortest = path.ShortestTime(grid);
  const double time = path.Time(path.slots.size());
  testing::Test::RecordProperty("ratio", std::to_string(time / shortest));
  EXPECT_LE(time, kRatioMax * shortest);
  EXPECT_GE(time, (1 - kGridError) * shortest);
}

void SetAxes(PathLimits* limits, double velocity, double acceleration, double jump) {
  for (AxisLimits& axis : limits->axes) axis = {velocity, acceleration, jump};
}

PlannedPath RandomPolyline(uint32_t seed, int count, double turn_max) {
  RandomNumbers random(seed);
  PlannedPath path;
  path.limits.corner_time = 0.02;
  path.limits.radius_ratio = 0.5;
  double angle = 0;
  for (int i = 0; i < count; ++i) {
    path.velocity = random.Between(20, 120);
    path.acceleration = random.Between(200, 1500);
    angle += random.Between(-turn_max, turn_max);
    const double length = random.Between(0.05, 4);
    Coordinates end = path.end();
    end[0] += length * std::cos(angle);
    end[1] += length * std::sin(angle);
    end[2] += random.Between(-0.2, 0.2) * length;
    path.Line(end);
    if (random.Between(0, 1) < 0.03) path.Rest();
  }
  return path;
}

TEST(PathOptimum, RandomPolylinesWithCornersAndCurves) {
  for (uint32_t seed = 1; seed <= RandomCases(12u); ++seed) {
    SCOPED_TRACE(seed);
    ExpectOptimal(RandomPolyline(seed, 40, seed % 2 == 0 ? 0.4 : 2.5), 0.001);
  }
}

TEST(PathOptimum, RandomPolylinesWithLimitsOfTheAxes) {
  for (uint32_t seed = 20; seed < 20 + RandomCases(6u); ++seed) {
    SCOPED_TRACE(seed);
    PlannedPath path = RandomPolyline(seed, 40, 1.2);
    path.limits.geometric = seed % 2 == 0;
    SetAxes(&path.limits, 70, 400, 6);
    ExpectOptimal(path, 0.004);
  }
}

TEST(PathOptimum, ArcsWhoseAxesHoldThemBack) {
  // Full circles: the velocities of the axes, their accelerations, and both.
  for (const double velocity : {60.0, 1000.0}) {
    for (const double acceleration : {300.0, 1e6}) {
      for (const double radius : {2.0, 20.0}) {
        SCOPED_TRACE(testing::Message() << velocity << " " << acceleration << " " << radius);
        PlannedPath path;
        path.limits.geometric = false;
        SetAxes(&path.limits, velocity, acceleration, kUnlimited);
        path.Arc({0, 0}, radius, 0, false);
        ExpectOptimal(path, radius * 2e-4);
      }
    }
  }
}

TEST(PathOptimum, RandomPathsOfLinesAndArcs) {
  for (uint32_t seed = 40; seed < 40 + RandomCases(8u); ++seed) {
    SCOPED_TRACE(seed);
    RandomNumbers random(seed);
    PlannedPath path;
    path.limits.corner_time = 0.02;
    path.limits.radius_ratio = 0.8;
    path.limits.geometric = seed % 2 == 0;
    SetAxes(&path.limits, 80, 350, 8);
    for (int i = 0; i < 8; ++i) {
      path.velocity = random.Between(40, 150);
      path.acceleration = random.Between(300, 1500);
      Coordinates end = path.end();
      end[0] += random.Between(-10, 10);
      end[1] += random.Between(-10, 10);
      path.Line(end);
      // An arc that continues from there: its centre is anywhere.
      const double first = random.Between(-6, 6);
      const double second = random.Between(-6, 6);
      const double radius = std::sqrt(first * first + second * second);
      const double direction = random.Between(0, 6.28);
      Coordinates arc_end = end;
      arc_end[0] += first + radius * std::cos(direction);
      arc_end[1] += second + radius * std::sin(direction);
      path.Arc(arc_end, first, second, random.Between(0, 1) < 0.5);
    }
    ExpectOptimal(path, 0.004);
  }
}

// A rotary axis turns while the others move: it counts in the length, or it does not.
TEST(PathOptimum, MixedRotaryMoves) {
  for (uint32_t seed = 60; seed < 60 + RandomCases(5u); ++seed) {
    SCOPED_TRACE(seed);
    RandomNumbers random(seed);
    PlannedPath path;
    path.limits.geometric = false;
    path.limits.length_axes = seed % 2 == 0 ? 0xF : 0x7;
    SetAxes(&path.limits, 100, 800, 10);
    path.limits.axes[3] = {30, 200, 2};
    for (int i = 0; i < 30; ++i) {
      Coordinates end = path.end();
      for (size_t k = 0; k < 3; ++k) end[k] += random.Between(-5, 5);
      end[3] += random.Between(-9, 9);
      path.Line(end);
    }
    ExpectOptimal(path, 0.004);
  }
}

TEST(PathOptimum, LargerWindowsAreNeverSlower) {
  for (uint32_t seed = 80; seed <= 90; ++seed) {
    SCOPED_TRACE(seed);
    PlannedPath path = RandomPolyline(seed, 60, 0.4);
    path.Arc(path.end(), 3, 0, true);
    path.limits.axes[0] = {60, 300, kUnlimited};
    double before = path.Time(1);
    for (const size_t capacity : {2u, 3u, 4u, 6u, 8u, 12u, 20u, 30u, 61u}) {
      const double time = path.Time(capacity);
      EXPECT_LE(time, before * (1 + 1e-12)) << capacity;
      before = time;
    }
  }
}

}  // namespace
}  // namespace oncard::motion
