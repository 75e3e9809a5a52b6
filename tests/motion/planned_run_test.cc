// Runs of a coordinate system with the path planner, checked in every cycle against the limits.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/base/random_cases.h"
#include "tests/motion/change_state.h"
#include "tests/motion/crd_run.h"
#include "tests/motion/planned_path.h"

namespace oncard::motion {
namespace {

constexpr int64_t kCycleUs = 250;
constexpr double kCycle = 0.25;
/// 1e-6 mm at 1000 pulses per mm.
constexpr double kOnPath = 1e-3;

/// A path in pulses and ms on a card, with a planner of `capacity` segments.
class PlannedRun {
 public:
  PlannedRun(const PlannedPath& path, size_t capacity, bool virtual_run = false)
      : path_(path), card(kCycleUs, 4, 50) {
    card.fifo().planner.Emplace({.limits = path.limits, .capacity = capacity});
    card.fifo().planner->virtual_run.on = virtual_run;
    card.fifo().planner->virtual_run.cycle = kCycle;
    for (const PathSlot& slot : path.slots) {
      EXPECT_TRUE(card.core.CrdAt(0).Append(0, slot));
      if (slot.is_segment) {
        segments_.slots.push_back(slot);
      } else if (slot.command.kind == BufferedKind::kGear) {
        displacement_[static_cast<size_t>(slot.command.item)] += slot.command.values[0];
      } else if (slot.command.NeedsRest()) {
        segments_.slots.back().ends_at_rest = true;
      }
    }
    segments_.limits = path.limits;
    EXPECT_TRUE(card.fifo().Flush());
  }

  /// Runs to the end and checks every cycle; the time in ms.
  double Run() {
    card.Start();
    override_ = card.crd().override_ratio;
    double time = 0;
    for (; card.running() && time < 1e6; time += kCycle) {
      if (each_cycle) each_cycle(time);
      card.core.Tick();
      if (!card.running()) continue;
      CheckAlong();
      CheckAxes();
      CheckFollowers();
      CheckCorner();
      CheckOnPath();
    }
    for (size_t i = 0; i < 4; ++i) EXPECT_EQ(card.profile(i).position, path_.end()[i]) << i;
    for (size_t i = 4; i < kFollowerMax; ++i) {
      EXPECT_NEAR(card.profile(i).position, displacement_[i], 1e-6) << i;
    }
    return time;
  }

  std::function<void(double time)> each_cycle;

 private:
  const PathSlot& current() { return card.fifo().current; }

  void CheckAlong() {
    // As commanded, not as planned.
    const auto index = static_cast<size_t>(card.fifo().done);
    const PathSlot& slot = segments_.slots[index];
    const double ratio = slot.second_override ? card.crd().second_override : override_;
    const double velocity = card.crd().run.velocity;
    EXPECT_LE(velocity, slot.velocity * ratio * (1 + 1e-9));
    EXPECT_LE(std::fabs(card.crd().run.acceleration), slot.acceleration * (1 + 1e-9));
    // The curvature of an arc, or of the lines before and after.
    EXPECT_LE(velocity, std::sqrt(segments_.TopOf(index)) * (1 + 1e-6));
    // From and to rest within a cycle's acceleration.
    if (card.fifo().done == segment_ + 1 && segments_.slots[index - 1].ends_at_rest) {
      EXPECT_LE(velocity, slot.acceleration * kCycle * (1 + 1e-9));
      EXPECT_LE(speed_, segments_.slots[index - 1].acceleration * kCycle * (1 + 1e-9));
    }
    speed_ = velocity;
  }
  void CheckAxes() {
    for (size_t i = 0; i < 4; ++i) {
      const AxisLimits& axis = path_.limits.axes[i];
      EXPECT_LE(std::fabs(card.profile(i).velocity), axis.velocity * (1 + 1e-6)) << i;
      EXPECT_LE(std::fabs(card.profile(i).acceleration), axis.acceleration * (1 + 1e-6)) << i;
    }
  }
  /// Profiles 5 to 8. With ramps their velocities tell the acceleration, from cycle to cycle.
  void CheckFollowers() {
    for (size_t i = 4; i < kFollowerMax; ++i) {
      const AxisLimits& limit = path_.limits.followers[i];
      const double velocity = card.profile(i).velocity;
      if (limit.velocity < kUnlimited) {
        EXPECT_LE(std::fabs(velocity), limit.velocity * (1 + 1e-9)) << i;
        const double jump = card.fifo().done != segment_ ? limit.jump : 0;
        EXPECT_LE(std::fabs(velocity - follower_[i]),
                  jump + limit.acceleration * kCycle * (1 + 1e-6))
            << i;
      }
      follower_[i] = velocity;
    }
  }
  /// From one cycle to the next the velocities change by the corner's jump and the accelerations.
  void CheckCorner() {
    double square = 0;
    for (size_t i = 0; i < 4; ++i) {
      const AxisLimits& axis = path_.limits.axes[i];
      const double change = card.profile(i).velocity - velocity_[i];
      square += change * change;
      if (card.fifo().done != segment_ && axis.jump < kUnlimited) {
        EXPECT_LE(std::fabs(change), axis.jump + axis.acceleration * kCycle * (1 + 1e-6)) << i;
      }
      velocity_[i] = card.profile(i).velocity;
    }
    if (card.fifo().done == segment_ + 1 && path_.limits.geometric) {
      const PathSlot& before = segments_.slots[static_cast<size_t>(segment_)];
      const PathSlot& after = segments_.slots[static_cast<size_t>(segment_) + 1];
      // Along the path, and on arcs towards the centre.
      const double acceleration = std::max(before.acceleration, after.acceleration) *
                                  (1 + std::max(path_.limits.radius_ratio, 1.0));
      EXPECT_LE(std::sqrt(square),
                path_.limits.corner_time * std::min(before.acceleration, after.acceleration) +
                    acceleration * kCycle);
    }
    segment_ = card.fifo().done;
  }
  /// In the plane of the arc the distance from the centre, across it the share of the angle.
  void CheckOnArc(const Segment& arc) {
    double forward = 0;
    double aside = 0;
    for (size_t i = 0; i < 4; ++i) {
      const double off = card.profile(i).position - arc.centre[i];
      forward += off * arc.toward_start[i];
      aside += off * arc.sideways[i];
    }
    EXPECT_NEAR(std::sqrt(forward * forward + aside * aside), arc.radius, kOnPath);
    double angle = std::atan2(aside, forward);
    if (angle < -1e-9) angle += 2 * M_PI;
    for (size_t i = 0; i < 4; ++i) {
      const double along = card.profile(i).position - arc.centre[i] -
                           forward * arc.toward_start[i] - aside * arc.sideways[i];
      EXPECT_NEAR(along, arc.travel[i] * angle / arc.sweep, kOnPath) << i;
    }
  }
  void CheckOnPath() {
    const Segment& segment = current().segment;
    Coordinates off{};
    for (size_t i = 0; i < 4; ++i) off[i] = card.profile(i).position - segment.start[i];
    if (segment.shape == SegmentShape::kArc) {
      CheckOnArc(segment);
      return;
    }
    double along = 0;
    double length = 0;
    for (size_t i = 0; i < 4; ++i) {
      along += off[i] * segment.travel[i];
      length += segment.travel[i] * segment.travel[i];
    }
    for (size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(off[i], along / length * segment.travel[i], kOnPath) << i;
    }
  }

  PlannedPath path_;
  ReferencePath segments_;  ///< without commands between them
  std::array<double, kFollowerMax> displacement_{};
  Coordinates velocity_{};  ///< of the axes, a cycle before
  std::array<double, kFollowerMax> follower_{};
  double speed_ = 0;
  double override_ = 1;  ///< the first one, at the start
  int32_t segment_ = 0;  ///< number of the segment a cycle before

 public:
  CrdRunTest card;
};

/// Random lines and arcs in pulses (1000 per mm) and ms.
PlannedPath RandomPath(uint32_t seed, bool geometric, bool axes) {
  RandomNumbers random(seed);
  PlannedPath path;
  path.limits.geometric = geometric;
  path.limits.corner_time = 20;
  path.limits.radius_ratio = 0.8;
  if (axes) {
    for (AxisLimits& axis : path.limits.axes) axis = {80, 0.35, 8};
    path.limits.axes[3] = {30, 0.2, 2};
  }
  for (int i = 0; i < 6; ++i) {
    path.velocity = random.Between(40, 150);
    path.acceleration = random.Between(0.3, 1.5);
    Coordinates end = path.end();
    for (double& value : end) value += std::round(random.Between(-10000, 10000));
    path.Line(end);
    const double first = random.Between(-6000, 6000);
    const double second = random.Between(-6000, 6000);
    const double radius = std::sqrt(first * first + second * second);
    const double direction = random.Between(0, 6.28);
    end[0] += first + radius * std::cos(direction);
    end[1] += second + radius * std::sin(direction);
    path.Arc(end, first, second, random.Between(0, 1) < 0.5);
  }
  return path;
}

TEST(PlannedRun, KeepsTheLimitsInEveryCycle) {
  for (uint32_t seed = 1; seed <= RandomCases(12u); ++seed) {
    SCOPED_TRACE(seed);
    PlannedRun run(RandomPath(seed, seed % 2 == 0, seed % 3 != 0), seed % 4 == 0 ? 3 : 12);
    run.Run();
  }
}

/// Many short lines with small turns and some corners and stops; some have the second override.
PlannedPath RandomCarving(uint32_t seed) {
  RandomNumbers random(seed);
  PlannedPath path;
  path.limits.corner_time = 10;
  path.limits.radius_ratio = 0.3;
  if (seed % 2 == 0) path.limits.axes = {{{80, 0.5, 10}, {60, 0.4, 8}, {30, 0.3, 4}, {30, 0.2, 2}}};
  double angle = 0;
  for (int i = 0; i < 120; ++i) {
    path.velocity = random.Between(60, 120);
    path.acceleration = random.Between(0.4, 1.2);
    angle += random.Between(0, 1) < 0.1 ? random.Between(-3, 3) : random.Between(-0.3, 0.3);
    const double length = random.Between(20, 1500);
    Coordinates end = path.end();
    end[0] += length * std::cos(angle);
    end[1] += length * std::sin(angle);
    end[2] += random.Between(-0.1, 0.1) * length;
    if (seed % 3 == 0) end[3] += random.Between(-0.3, 0.3) * length;
    path.Line(end);
    path.slots.back().second_override = i % 3 == 0;
    if (random.Between(0, 1) < 0.04) path.Rest();
  }
  return path;
}

TEST(PlannedRun, KeepsTheLimitsOfCurvesMadeOfLines) {
  for (uint32_t seed = 1; seed <= RandomCases(6u); ++seed) {
    SCOPED_TRACE(seed);
    PlannedRun run(RandomCarving(seed), seed % 2 == 0 ? 5 : 200);
    run.card.crd().second_override = 0.4;
    run.Run();
  }
}

// A slow segment is not entered faster than its override allows, also after several short ones.
TEST(PlannedRun, SlowsDownBeforeSegmentsWithALowerOverride) {
  for (const double ratio : {0.05, 0.4, 0.9}) {
    PlannedPath path;
    path.limits.geometric = false;
    path.limits.axes[0] = {100, 0.5, kUnlimited};
    path.acceleration = 1;
    path.Line({10000, 0}).Line({10100, 0}).Arc({10100, 2000}, 0, 1000, true).Line({10000, 2000});
    path.Line({5000, 2000});
    path.slots.back().second_override = true;
    path.Line({0, 2000});
    PlannedRun run(path, 20);
    run.card.crd().second_override = ratio;
    run.Run();
    PlannedRun all(path, 20);
    all.card.crd().second_override = all.card.crd().override_ratio = ratio;
    all.Run();
  }
}

TEST(PlannedRun, KeepsTheLimitsOfFollowers) {
  for (uint32_t seed = 1; seed <= RandomCases(8u); ++seed) {
    SCOPED_TRACE(seed);
    RandomNumbers random(seed + 100);
    PlannedPath path = RandomPath(seed, seed % 2 == 0, seed % 3 == 0);
    path.limits.followers[4] = {20, 0.2, 3};
    path.limits.followers[5] = {50, 0.1, 1};
    for (size_t at = path.slots.size(); at-- > 0;) {
      for (int profile = 4; profile < 6; ++profile) {
        if (random.Between(0, 1) < 0.4) continue;
        PathSlot gear;
        gear.command = {BufferedKind::kGear, profile, 0, {random.Between(-9000, 9000)}};
        if (seed > 4) {
          gear.command.values[1] = random.Between(0, 1) < 0.3 ? 0 : random.Between(0.05, 0.5);
          gear.command.values[2] = random.Between(0, 1) < 0.3 ? 0 : random.Between(0.05, 0.5);
        }
        path.slots.insert(path.slots.begin() + static_cast<std::ptrdiff_t>(at), gear);
      }
    }
    const double estimate = PlannedRun(path, 6, true).card.fifo().planner->virtual_run.time;
    EXPECT_NEAR(PlannedRun(path, 6).Run(), estimate, kCycle);
  }
}

TEST(PlannedRun, StaysOnHelicesAndInEveryPlane) {
  for (const ArcPlane plane : {kXyPlane, kYzPlane, kZxPlane}) {
    PlannedPath path;
    path.limits.radius_ratio = 0.5;
    path.limits.axes[plane.second] = {60, 0.3, kUnlimited};
    path.acceleration = 1;
    Coordinates end{};
    end[plane.first] = 10000;
    end[plane.second] = 10000;
    end[plane.normal] = 7000;
    path.Arc(end, 0, 10000, true, plane);
    end[plane.normal] = -3000;
    path.Arc(end, -3000, 0, false, plane);
    PlannedRun(path, 5).Run();
  }
}

TEST(PlannedRun, TakesTheTimeOfTheVirtualRunWithinACycle) {
  for (uint32_t seed = 20; seed < 20 + RandomCases(11u); ++seed) {
    SCOPED_TRACE(seed);
    const PlannedPath path = RandomPath(seed, seed % 2 == 0, seed % 3 != 0);
    PlannedRun estimate(path, 5, true);
    EXPECT_TRUE(estimate.card.fifo().slots.empty());
    EXPECT_NEAR(PlannedRun(path, 5).Run(), estimate.card.fifo().planner->virtual_run.time, kCycle);
  }
}

TEST(PlannedRun, IgnoresTheTimeOfConstantVelocity) {
  // evenTime is 50 ms for other paths.
  PlannedPath path;
  path.limits.geometric = false;
  path.velocity = 100;
  path.acceleration = 1;
  for (int i = 1; i <= 10; ++i) path.Line({i * 1000.0, 0});
  EXPECT_NEAR(PlannedRun(path, 20).Run(), 2 * std::sqrt(10000.0), kCycle);
}

TEST(PlannedRun, DelaysAndMovesCountInTheTime) {
  PlannedPath path = RandomPath(40, true, true);
  const auto insert = [&](size_t at, const BufferedCommand& command) {
    PathSlot slot;
    slot.command = command;
    path.slots.insert(path.slots.begin() + static_cast<std::ptrdiff_t>(at), slot);
  };
  insert(8, {BufferedKind::kMove, 6, 1, {-3000, 20, 0.5}});
  insert(5, {BufferedKind::kDelay, 0, 0, {37}});
  insert(2, {BufferedKind::kMove, 6, 1, {5000, 20, 0.5}});
  const double estimate = PlannedRun(path, 20, true).card.fifo().planner->virtual_run.time;
  PlannedRun run(path, 20);
  run.card.Start();
  EXPECT_NEAR(run.card.TicksToEnd() * kCycle, estimate, kCycle);
}

TEST(PlannedRun, ALowerOverrideIsKeptOnArcsToo) {
  PlannedPath path = RandomPath(50, false, true);
  PlannedRun run(path, 20);
  double slowest = 1e9;
  run.each_cycle = [&](double time) {
    if (time == 200) {
      run.card.crd().override_ratio = 0.1;
      run.card.crd().Replan(run.card.core.now());
    }
    if (time > 1000) slowest = std::min(slowest, 16 - run.card.crd().run.velocity);
  };
  run.Run();
  EXPECT_GE(slowest, 0);
}

// Where it stops does not change the path, and the rest is planned from there.
TEST(PlannedRun, StopsAndGoesOnInAnArc) {
  PlannedPath path;
  path.limits.geometric = false;
  path.limits.axes[0] = {60, 0.3, kUnlimited};
  path.Arc({0, 0}, 20000, 0, false);
  path.slots[0].velocity = 100;
  path.slots[0].acceleration = 1;
  PlannedRun run(path, 5);
  bool stopped = false;
  run.each_cycle = [&](double time) {
    if (!stopped && time == 500) {
      run.card.crd().smooth_stop = 0.2;
      run.card.core.CrdAt(0).Stop(false);
      EXPECT_LT(run.card.TicksToEnd(), 4000);
      EXPECT_TRUE(run.card.fifo().executing);
      run.card.Start();
      stopped = true;
    }
  };
  run.Run();
  EXPECT_TRUE(stopped);
}

// A snapshot in the middle of an arc goes on like the card it was taken of.
TEST(PlannedRun, GoesOnFromACopyOfItsState) {
  PlannedRun run(RandomPath(60, true, true), 4);
  run.card.Start();
  for (int i = 0; i < 3000; ++i) run.card.core.Tick();
  const MotionState copy = run.card.core.state();
  for (int i = 0; i < 3000; ++i) run.card.core.Tick();
  const uint64_t hash = run.card.core.Hash();
  ChangeState(run.card.core) = copy;
  EXPECT_NE(run.card.core.Hash(), hash);
  for (int i = 0; i < 3000; ++i) run.card.core.Tick();
  EXPECT_EQ(run.card.core.Hash(), hash);
}

}  // namespace
}  // namespace oncard::motion
