// What is reported of an axis that is planned beyond what its drive can follow.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/core_run.h"
#include "tests/motion/crd_run.h"

namespace oncard::motion {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Kinds = std::vector<CardEventKind>;

/// Axis 1 accelerates by 0.5 pulse/ms^2 to 10 pulse/ms, in 20 ms, and slows down as fast.
struct LimitedRun {
  explicit LimitedRun(const DriveLimits& limits) {
    core.WatchLimits(0, limits);
    core.Observe([this](const CardEvent& event) { events.push_back(event); });
    core.AxisAt(0).ServoOn();
    ChangeState(core).profiles[0].jog.parameters = {.acc = 0.5, .dec = 0.5};
    Jog(core, 10);
  }
  Kinds kinds() const {
    Kinds kinds;
    for (const CardEvent& event : events) kinds.push_back(event.kind);
    return kinds;
  }

  MotionCore core{{.cycle_us = 1000}};
  std::vector<CardEvent> events;
};

TEST(DriveLimits, TheVelocityIsReportedOnceWhenItBecomesTooHigh) {
  LimitedRun run({.velocity = 4});
  Ticks(run.core, 8);
  EXPECT_THAT(run.kinds(), IsEmpty());
  Ticks(run.core, 100);
  ASSERT_THAT(run.kinds(), ElementsAre(CardEventKind::kTooFast));
  EXPECT_EQ(run.events[0].item, 0u);
  EXPECT_NEAR(run.events[0].value, 4.5, 1e-9);
  EXPECT_EQ(run.events[0].bound, 4);
}

TEST(DriveLimits, TheChangeOfVelocityIsReportedWhenItBegins) {
  LimitedRun run({.acceleration = 0.25});
  Ticks(run.core, 100);
  ASSERT_THAT(run.kinds(), ElementsAre(CardEventKind::kTooSteep));
  EXPECT_NEAR(run.events[0].value, 0.5, 1e-9);
  Jog(run.core, -10);
  Ticks(run.core, 100);
  EXPECT_THAT(run.kinds(), ElementsAre(CardEventKind::kTooSteep, CardEventKind::kTooSteep));
  EXPECT_NEAR(run.events[1].value, -0.5, 1e-9);
}

TEST(DriveLimits, AVelocityThatDropsAtOnceIsTooSteep) {
  LimitedRun run({.acceleration = 1});
  Ticks(run.core, 50);
  EXPECT_THAT(run.kinds(), IsEmpty());
  // 10 pulse/ms to 0 within a cycle.
  ChangeState(run.core).profiles[0].Stop(run.core.now(), 1000);
  Ticks(run.core, 1);
  ASSERT_THAT(run.kinds(), ElementsAre(CardEventKind::kTooSteep));
  EXPECT_NEAR(run.events[0].value, -10, 1e-9);
}

TEST(DriveLimits, ARampThatBeginsWithinACycleIsTooSteep) {
  CrdRunTest test;
  test.core.AxisAt(0).ServoOn();
  test.core.WatchLimits(0, {.acceleration = 5});
  std::vector<CardEvent> events;
  test.core.Observe([&](const CardEvent& event) { events.push_back(event); });
  // 10 pulse/ms is reached at 100, after 20 ms, and the first line ends at 20.5 ms. The second one
  // gains 4 pulse/ms up to the end of that cycle, and slows down from 20 pulse/ms to rest.
  ASSERT_TRUE(test.Line({105}, 10, 0.5, 10));
  ASSERT_TRUE(test.Line({500}, 20, 8));
  test.Start();
  test.RunUntil(20);
  EXPECT_THAT(events, IsEmpty());
  test.RunUntil(21);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, CardEventKind::kTooSteep);
  EXPECT_NEAR(events[0].value, 8, 1e-9);
  test.TicksToEnd();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_NEAR(events[1].value, -8, 1e-9);
}

TEST(DriveLimits, ACornerIsTooSteepForTheAxisThatTurnsAwayAndTheOneThatBegins) {
  CrdRunTest test;
  for (size_t axis = 0; axis < 2; ++axis) {
    test.core.AxisAt(axis).ServoOn();
    test.core.WatchLimits(axis, {.acceleration = 1});
  }
  std::vector<CardEvent> events;
  test.core.Observe([&](const CardEvent& event) { events.push_back(event); });
  // 10 pulse/ms is reached at 100, after 20 ms, and the corner after 21 ms.
  ASSERT_TRUE(test.Line({110}, 10, 0.5, 10));
  ASSERT_TRUE(test.Line({110, 200}, 10, 0.5));
  test.Start();
  test.TicksToEnd();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].item, 0u);
  EXPECT_NEAR(events[0].value, -10, 1e-9);
  EXPECT_EQ(events[1].item, 1u);
  EXPECT_NEAR(events[1].value, 10, 1e-9);
}

TEST(DriveLimits, AreNotExceededByAMotionAtThem) {
  LimitedRun run({.velocity = 10, .acceleration = 0.5});
  Ticks(run.core, 100);
  Jog(run.core, -10);
  Ticks(run.core, 100);
  EXPECT_THAT(run.kinds(), IsEmpty());
}

TEST(DriveLimits, AreReportedAlikeOfManyCyclesAtOnce) {
  LimitedRun each({.velocity = 4, .acceleration = 0.25});
  Ticks(each.core, 300);
  LimitedRun block({.velocity = 4, .acceleration = 0.25});
  block.core.Advance(300);
  EXPECT_EQ(block.kinds(), each.kinds());
  EXPECT_EQ(block.core.Hash(), each.core.Hash());
}

}  // namespace
}  // namespace oncard::motion
