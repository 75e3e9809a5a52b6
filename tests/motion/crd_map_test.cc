// Paths whose axes follow a map: where the axes are, and how they stop. Worked figures are those of
// the GT manual, chapter 5.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/common/state_hash.h"
#include "motion/motion_core.h"
#include "motion/paths/segment.h"
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
  test.core.AxisAt(1).Stop(false);
  EXPECT_FALSE(test.running());
  EXPECT_FALSE(test.profile(0).moving);
  EXPECT_EQ(test.profile(0).velocity, 0);
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
  EXPECT_FALSE(test.profile(1).moving);
  EXPECT_EQ(test.profile(1).velocity, 0);
  test.TimeToEnd();
  EXPECT_EQ(test.profile(0).position, 1000);
  EXPECT_EQ(test.profile(1).position, at);
  EXPECT_FALSE(test.crd().HasMember(1));
}

}  // namespace
}  // namespace oncard::motion
