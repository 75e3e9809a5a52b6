// Paths whose axes follow a map: where the axes are, how they stop, and lists whose joints are
// limited by the jumps of the axes. Worked figures are those of the GT manual, chapter 5.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/common/state_hash.h"
#include "motion/motion_core.h"
#include "motion/paths/segment.h"
#include "tests/base/random_cases.h"
#include "tests/motion/change_state.h"
#include "tests/motion/planned_path.h"

namespace oncard::motion {
namespace {

constexpr size_t kList = 0;

/// A card of four axes and a path of four coordinates.
class MapRunTest {
 public:
  explicit MapRunTest(double scale = 1) : core({.axis_count = 4, .cycle_us = 1000}) {
    CrdParameters parameters;
    parameters.dimension = 4;
    parameters.velocity_max = kUnlimited;
    path().SetUp(parameters);
    path().BeginMap();
    path().SetJoints(kList, JointRule::kAxisJumps);
    for (size_t axis = 0; axis < 4; ++axis) {
      MapRow row;
      row.coefficients[axis] = scale;
      path().MapAxis(axis, row);
    }
  }

  CrdDriver path() { return core.CrdAt(0); }
  const Crd& crd() const { return core.state().crds[0]; }
  const CrdFifo& list() const { return crd().fifos[kList]; }
  const Sample& profile(size_t axis) const { return core.state().profiles[axis].now; }
  bool running() const { return crd().run.running; }

  void Add(const Segment& segment, double velocity, double acceleration) {
    PathSlot slot;
    slot.is_segment = true;
    slot.segment = segment;
    slot.velocity = velocity;
    slot.acceleration = acceleration;
    ASSERT_TRUE(path().Append(kList, slot));
  }
  void AddLine(const Coordinates& end, double velocity, double acceleration) {
    Add(*MakeLine(list().idle() ? core.CrdPosition(0) : list().tail, end), velocity, acceleration);
  }
  void Start() { path().Start(kList, false); }
  void RunFor(int ticks) {
    for (int i = 0; i < ticks; ++i) core.Tick();
  }
  /// The time until the path ends, with the part of the last cycle.
  double TimeToEnd() {
    for (int ticks = 0; running() && ticks < 1'000'000; ++ticks) core.Tick();
    return crd().run.at;
  }

  MotionCore core;
};

TEST(MappedPath, MovesEachAxisByItsRow) {
  MapRunTest test;
  test.path().MapAxis(1, {{-2, 3}, 10});
  test.AddLine({100, 50}, 1, 0.1);
  test.Start();
  // At once the axis goes where its row puts it.
  EXPECT_EQ(test.profile(1).position, 0);
  EXPECT_TRUE(test.profile(1).moving);
  test.RunFor(30);
  const double speed = test.crd().run.velocity;
  EXPECT_EQ(speed, 1);
  EXPECT_NEAR(test.profile(0).velocity, 100 / std::hypot(100, 50 + 10.0 / 3), 1e-12);
  test.TimeToEnd();
  EXPECT_EQ(test.profile(0).position, 100);
  EXPECT_EQ(test.profile(1).position, -200 + 150 + 10);
  EXPECT_FALSE(test.profile(1).moving);
  EXPECT_EQ(test.core.CrdPosition(0), (Coordinates{100, 50}));
}

// Example 5-5: 10 * sqrt(2) mm with 1e-7 mm/ST^2, 2000 pulses/mm.
TEST(MappedPath, RunsInUnitsOfItsOwn) {
  MapRunTest test(2000);
  test.AddLine({10, 10}, 0.01, 1e-7);
  test.Start();
  EXPECT_NEAR(test.TimeToEnd(), 23784.1423, 1e-4);
  EXPECT_EQ(test.profile(0).position, 20000);
  EXPECT_EQ(test.profile(1).position, 20000);
  EXPECT_EQ(test.profile(2).position, 0);
}

TEST(MappedPath, IsAtZeroUntilAnAxisIsMapped) {
  MotionCore core({.axis_count = 4, .cycle_us = 1000});
  core.ProfileAt(0).SetPosition(500);
  CrdParameters parameters;
  parameters.dimension = 4;
  core.CrdAt(0).SetUp(parameters);
  core.CrdAt(0).BeginMap();
  EXPECT_EQ(core.CrdPosition(0), Coordinates{});
  core.CrdAt(0).MapAxis(0, {{0, 100}});
  EXPECT_EQ(core.CrdPosition(0), (Coordinates{0, 5}));
}

TEST(MappedPath, BeginsWhereTheAxesAreNow) {
  MapRunTest test(10);
  test.core.ProfileAt(0).SetPosition(500);
  EXPECT_EQ(test.core.CrdPosition(0), (Coordinates{50}));
}

TEST(MappedPath, AnAxisThatContradictsOthersJumpsAtTheStart) {
  MapRunTest test;
  test.path().MapAxis(3, {{1}, 1000});
  EXPECT_EQ(test.profile(3).position, 0);
  test.AddLine({100}, 1, 0.1);
  test.Start();
  EXPECT_EQ(test.profile(3).position, 1000);
  test.TimeToEnd();
  EXPECT_EQ(test.profile(3).position, 1100);
}

TEST(MappedPath, CoordinatesWithoutAnAxisStayUntilTheNextMap) {
  MapRunTest test;
  for (size_t axis = 1; axis < 4; ++axis) {
    test.core.ProfileAt(axis).SelectMode(ProfileMode::kTrap);
  }
  test.AddLine({30, 40}, 1, 0.1);
  test.Start();
  test.TimeToEnd();
  EXPECT_EQ(test.profile(1).position, 0);
  EXPECT_EQ(test.core.CrdPosition(0), (Coordinates{30, 40}));
  test.path().MapAxis(2, {{0, 0, 1}});
  EXPECT_EQ(test.core.CrdPosition(0), (Coordinates{30, 0}));
}

TEST(MappedPath, AnAxisInAnotherModeIsNotMapped) {
  MapRunTest test;
  test.core.ProfileAt(1).SelectMode(ProfileMode::kTrap);
  EXPECT_FALSE(test.crd().HasMember(1));
  test.AddLine({100, 100}, 1, 0.1);
  test.Start();
  test.TimeToEnd();
  EXPECT_EQ(test.profile(0).position, 100);
  EXPECT_EQ(test.profile(1).position, 0);
}

TEST(MappedPath, JoinsTheHashOnlyWithAMap) {
  Crd without;
  Crd with;
  with.map.Emplace();
  EXPECT_NE(StateHash().Add(with).value(), StateHash().Add(without).value());
}

// --- Stops ---------------------------------------------------------------------------------------

TEST(MappedPath, HaltsAtOnceWhereItIs) {
  MapRunTest test;
  test.AddLine({1000, 0}, 2, 0.1);
  test.Start();
  test.RunFor(100);
  const double at = test.profile(0).position;
  test.path().Halt();
  EXPECT_FALSE(test.running());
  EXPECT_EQ(test.profile(0).velocity, 0);
  EXPECT_FALSE(test.profile(0).moving);
  test.RunFor(10);
  EXPECT_EQ(test.profile(0).position, at);
  EXPECT_TRUE(test.list().executing);
  test.Start();
  test.TimeToEnd();
  EXPECT_EQ(test.profile(0).position, 1000);
}

TEST(MappedPath, AStopOfAnAxisStopsAll) {
  MapRunTest test;
  test.AddLine({1000, 500}, 2, 0.1);
  test.Start();
  test.RunFor(100);
  EXPECT_FALSE(test.crd().map->held);
  test.core.AxisAt(1).Stop(false);
  EXPECT_FALSE(test.running());
  EXPECT_FALSE(test.profile(0).moving);
  EXPECT_EQ(test.profile(0).velocity, 0);
  EXPECT_TRUE(test.crd().map->held);
  test.path().ForgetHold();
  EXPECT_FALSE(test.crd().map->held);
}

TEST(MappedPath, IsHeldOnlyByAxes) {
  for (const bool at_once : {false, true}) {
    MapRunTest test;
    test.path().SetStopDecelerations(0.1, 0.1);
    test.AddLine({1000, 500}, 2, 0.1);
    test.Start();
    test.RunFor(100);
    at_once ? test.path().Halt() : test.path().Stop(false);
    test.RunFor(19);
    EXPECT_NE(test.running(), at_once);
    test.RunFor(1);
    EXPECT_FALSE(test.running());
    EXPECT_FALSE(test.crd().map->held) << at_once;
  }
}

TEST(MappedPath, AnAxisThatIsStoppedAloneLeavesTheMap) {
  MapRunTest test;
  test.path().SetStopsTogether(false);
  test.AddLine({1000, 500}, 2, 0.1);
  test.Start();
  test.RunFor(100);
  const double at = test.profile(1).position;
  test.core.AxisAt(1).Stop(false);
  EXPECT_TRUE(test.running());
  EXPECT_FALSE(test.crd().map->held);
  EXPECT_FALSE(test.profile(1).moving);
  EXPECT_EQ(test.profile(1).velocity, 0);
  test.TimeToEnd();
  EXPECT_EQ(test.profile(0).position, 1000);
  EXPECT_EQ(test.profile(1).position, at);
  EXPECT_FALSE(test.crd().HasMember(1));
}

// --- Joints limited by jumps ---------------------------------------------------------------------

// A right angle at 2 pulse/ST: with no limit it is passed at full speed, otherwise at 0.5.
TEST(AxisJumps, LimitTheJointOfTwoSegments) {
  for (const double jump : {16384.0, 0.5}) {
    MapRunTest test;
    test.path().SetJump(0, jump);
    test.path().SetJump(1, jump);
    test.AddLine({3000, 0}, 2, 0.01);
    test.AddLine({3000, 3000}, 2, 0.01);
    test.Start();
    EXPECT_NEAR(test.TimeToEnd(), jump > 1 ? 3200 : 3312.5, 1e-6) << jump;
    EXPECT_EQ(test.profile(1).position, 3000);
  }
}

// Example "1-21": a line, an arc of 123 degrees and a line in four dimensions are one triangle.
TEST(AxisJumps, PassThreeSegmentsAsOne) {
  MapRunTest test(2000);
  test.path().SetJump(0, 16384);
  test.AddLine({10, 10}, 0.01, 1e-8);
  test.Add(
      *MakeArcWithSweep({10, 10}, kXyPlane, -10, -10, 123 * 3.14159265358979323846 / 180, true),
      0.01, 1e-8);
  test.AddLine({0, 0, 10, 12}, 0.01, 1e-8);
  test.Start();
  EXPECT_NEAR(test.TimeToEnd(), 161954.4914, 1e-3);
  EXPECT_EQ(test.profile(3).position, 24000);
}

TEST(AxisJumps, AreThoseOfTheAxesThatMoveThere) {
  MapRunTest test(100);
  // The second axis turns by 100 * 1 per unit of speed.
  test.path().SetJump(1, 20);
  test.path().SetJump(2, 1e-3);
  test.AddLine({30, 0}, 2, 0.01);
  test.AddLine({30, 30}, 2, 0.01);
  EXPECT_EQ(test.list().slots.At(0).end_velocity, 0.2);
}

TEST(AxisJumps, ActOnJointsThatWaitAlready) {
  MapRunTest test;
  test.AddLine({3000, 0}, 2, 0.01);
  test.AddLine({3000, 3000}, 2, 0.01);
  test.Start();
  test.RunFor(500);
  test.path().SetJump(0, 0.5);
  EXPECT_NEAR(test.TimeToEnd(), 3312.5, 1e-6);
}

TEST(AxisJumps, ActOnSegmentsThatAreAppendedToAMovingPath) {
  MapRunTest test;
  test.path().SetJump(1, 0.5);
  test.AddLine({3000, 0}, 2, 0.01);
  test.Start();
  test.RunFor(500);
  test.AddLine({3000, 3000}, 2, 0.01);
  EXPECT_NEAR(test.TimeToEnd(), 3312.5, 1e-6);
}

TEST(AxisJumps, OfAMapThatChangesLimitTheJointsThatWait) {
  MapRunTest test;
  test.path().SetJump(0, 0.5);
  test.AddLine({3000, 0}, 2, 0.01);
  test.AddLine({3000, 3000}, 2, 0.01);
  test.path().MapAxis(0, {{0.5}});
  EXPECT_EQ(test.list().slots.At(0).end_velocity, 1);
}

// A stop keeps them, too: behind the first joint it brakes harder than it was told to.
TEST(AxisJumps, HoldForAPathThatStops) {
  MapRunTest test;
  test.path().SetJump(1, 0.5);
  test.path().SetStopDecelerations(0.001, 0.001);
  test.AddLine({3000, 0}, 2, 0.01);
  test.AddLine({3000, 3000}, 2, 0.01);
  test.Start();
  test.RunFor(1500);
  test.path().Stop(false);
  double before = 0;
  double most = 0;
  while (test.running()) {
    test.core.Tick();
    most = std::max(most, test.profile(1).velocity - before);
    before = test.profile(1).velocity;
  }
  EXPECT_LE(most, 0.5 + 1e-9);
  EXPECT_GT(test.profile(1).position, 0);
}

// --- Random lists --------------------------------------------------------------------------------

/// A list of lines and arcs with an axis for each coordinate, to which segments are appended while
/// it runs and stops.
class RandomMappedList {
 public:
  explicit RandomMappedList(uint32_t seed) : random_(seed) {
    crd_.parameters.dimension = 4;
    crd_.parameters.velocity_max = kUnlimited;
    CoordinateMap& map = crd_.map.Emplace();
    for (size_t axis = 0; axis < map.rows.size(); ++axis) {
      for (double& value : map.rows[axis].coefficients) {
        value = random_.Between(0, 1) < 0.4 ? random_.Between(-5, 5) : 0;
      }
      map.jumps[axis] = random_.Between(0.5, 20);
    }
    list().list = {JointRule::kAxisJumps, true};
    for (double chance = 1; random_.Between(0, 1) < chance; chance = 0.8) AppendSegment();
  }

  void Run() {
    crd_.Start(kList, false, 0);
    for (int cycle = 1; crd_.run.running; ++cycle) {
      ASSERT_LT(cycle, 20000);
      now_ = cycle * Micros{1000};
      Advance();
      if (testing::Test::HasFatalFailure()) return;
      Disturb(cycle);
    }
    EXPECT_EQ(crd_.position, end_);
    EXPECT_EQ(list().done, appended_);
    EXPECT_EQ(crd_.run.velocity, 0);
  }

 private:
  CrdFifo& list() { return crd_.fifos[kList]; }

  void AppendSegment() {
    PathSlot slot;
    slot.is_segment = true;
    if (random_.Between(0, 1) < 0.3) {
      constexpr ArcPlane kPlanes[] = {kXyPlane, kYzPlane, kZxPlane};
      slot.segment = *MakeArcWithSweep(end_, kPlanes[static_cast<size_t>(random_.Between(0, 3))],
                                       random_.Between(1, 30), random_.Between(-30, 30),
                                       random_.Between(0.1, 6), random_.Between(0, 1) < 0.5);
    } else {
      Coordinates next = end_;
      for (double& value : next) value += random_.Between(-60, 60);
      slot.segment = *MakeLine(end_, next);
    }
    slot.velocity = random_.Between(0.5, 30);
    slot.acceleration = kAcceleration;
    ASSERT_TRUE(crd_.Append(kList, slot, now_));
    end_ = slot.segment.end;
    joints_.push_back(slot.segment);
    ++appended_;
  }

  /// One cycle. Between two segments the velocity of the path is the one at the joint.
  void Advance() {
    const double before = crd_.run.velocity;
    const int done = list().done;
    EXPECT_EQ(crd_.Advance(now_), nullptr);
    // Even from one cycle to the next across several joints.
    ASSERT_LE(std::fabs(crd_.run.velocity - before), kAcceleration + 1e-9);
    if (list().executing) {
      ASSERT_LE(crd_.run.velocity, list().current.velocity + 1e-9);
    }
    // A joint is passed at most as fast as the path can have been in this cycle.
    for (int joint = done + 1; joint <= list().done && joint < appended_; ++joint) {
      const auto i = static_cast<size_t>(joint);
      const Coordinates turn =
          Between(joints_[i - 1].TangentAt(joints_[i - 1].length), joints_[i].TangentAt(0));
      const double least = std::max({before, crd_.run.velocity}) - kAcceleration;
      for (size_t axis = 0; axis < kMappedAxisMax; ++axis) {
        ASSERT_LE(std::fabs(crd_.map->Along(axis, turn)) * least, crd_.map->jumps[axis] + 1e-9);
      }
    }
  }

  void Disturb(int cycle) {
    const double event = random_.Between(0, 1);
    if (cycle > 300) {
      crd_.CloseList(kList);
    } else if (event < 0.05) {
      AppendSegment();
    } else if (event < 0.06) {
      crd_.smooth_stop = kAcceleration;
      crd_.Stop(false, now_);
      stopped_ = true;
    }
    if (!crd_.run.running && stopped_ && !list().idle()) {
      stopped_ = false;
      crd_.Start(kList, false, now_);
    }
  }

  static constexpr double kAcceleration = 1;

  RandomNumbers random_;
  Crd crd_;
  Micros now_ = 0;
  Coordinates end_{};
  std::vector<Segment> joints_;
  int appended_ = 0;
  bool stopped_ = false;
};

TEST(AxisJumps, KeepAllLimitsInAnyRun) {
  const uint32_t lists = RandomCases(10'000u);
  for (uint32_t seed = 0; seed < lists; ++seed) {
    SCOPED_TRACE(seed);
    RandomMappedList(seed).Run();
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace oncard::motion
