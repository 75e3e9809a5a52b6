// Coordinate systems: plans along segments, runs, stops, overrides, buffered commands.
#include "motion/paths/crd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/motion/change_state.h"
#include "tests/motion/crd_run.h"

namespace oncard::motion {
namespace {

// --- Plans ---------------------------------------------------------------------------------------

TEST(PlanSpan, IsATrapezoidATriangleOrARamp) {
  struct {
    PathSpan span;
    double duration, end_velocity;
  } const cases[] = {
      // 100 at 0.1: 1000 ms and 50000 pulses each way.
      {{0, 200000, 0, 100, 0, 0.1}, 3000, 0},
      // A triangle with the peak sqrt(0.1 * 1000) = 10.
      {{0, 1000, 0, 100, 0, 0.1}, 200, 0},
      // The end velocity is 50: 1000 ms to 100 (50000), 500 ms to 50 (37500), 112500 at 100.
      {{0, 200000, 0, 100, 50, 0.1}, 2625, 50},
      // The end velocity cannot be reached: sqrt(2 * 0.1 * 500) = 10.
      {{0, 500, 0, 100, 50, 0.1}, 100, 10},
      // Too fast to stop: sqrt(100^2 - 2 * 0.1 * 18000) = 80, after 200 ms.
      {{0, 18000, 100, 100, 0, 0.1}, 200, 80},
      // Faster than the target: 200 ms to 80 (18000), 80 for 100 ms, 800 ms to rest (32000).
      {{0, 58000, 100, 80, 0, 0.1}, 1100, 0},
      // Constant velocity.
      {{0, 1000, 10, 10, 10, 0.1}, 100, 10}};
  for (const auto& c : cases) {
    const Plan plan = PlanSpan(c.span);
    EXPECT_NEAR(plan.duration, c.duration, 1e-9);
    EXPECT_NEAR(plan.end_velocity, c.end_velocity, 1e-9);
    EXPECT_EQ(plan.end_position, c.span.end);
  }
}

TEST(PlanSpan, EvenTimeLowersThePeakUntilItLastsSoLong) {
  // (a / 2) (-te + sqrt(te^2 + 4 L / a)) with a 0.1, te 100, L 1000: 6.1803 pulse/ms.
  const double peak = 0.05 * (-100 + std::sqrt(100.0 * 100 + 4 * 1000 / 0.1));
  const Plan plan = PlanSpan({0, 1000, 0, 100, 0, 0.1, 100});
  ASSERT_EQ(plan.count, 3u);
  EXPECT_NEAR(plan.pieces[1].velocity, peak, 1e-9);
  EXPECT_NEAR(plan.pieces[1].duration, 100, 1e-9);
  EXPECT_NEAR(plan.duration, 100 + 2 * peak / 0.1, 1e-9);
}

TEST(PlanSpanStop, RestsInTheSegmentOrGoesOnInTheNext) {
  const Plan inside = PlanSpanStop({0, 1000, 10, 10, 10, 0.1}, 1);
  EXPECT_DOUBLE_EQ(inside.end_position, 50);
  EXPECT_DOUBLE_EQ(inside.duration, 10);
  const Plan beyond = PlanSpanStop({0, 18, 10, 10, 10, 0.1}, 1);
  EXPECT_DOUBLE_EQ(beyond.end_position, 18);
  EXPECT_DOUBLE_EQ(beyond.end_velocity, 8);
  // A segment that ends at rest does so even if the stop has a lower deceleration.
  const Plan harder = PlanSpanStop({0, 18, 10, 10, 0, 10}, 1);
  EXPECT_DOUBLE_EQ(harder.end_position, 18);
  EXPECT_DOUBLE_EQ(harder.end_velocity, 0);
}

// --- Example 6-10: a hexagon, 7 lines with two delays --------------------------------------------

void AppendHexagon(CrdRunTest* test) {
  const Coordinates corners[] = {{200000, 0},  {100000, 173205},   {-100000, 173205},
                                 {-200000, 0}, {-100000, -173205}, {100000, -173205},
                                 {200000, 0}};
  for (int i = 0; i < 7; ++i) {
    ASSERT_TRUE(test->Line(corners[i], 100, 0.1));
    const double pause = i == 3 ? 400 : 100;
    ASSERT_TRUE((i != 3 && i != 4) || test->Delay(pause));
  }
}

TEST(CrdRun, FollowsTheHexagonOfExample610) {
  CrdRunTest test(250);
  AppendHexagon(&test);
  test.Start();
  // Diagonal sides are sqrt(1e10 + 173205^2) = 199999.9956 long and last 2999.999956 ms.
  struct {
    double t, x, y, v;
  } const instants[] = {{300, 4500, 0, 30},
                        {1500, 100000, 0, 100},
                        {3000, 200000, 0, 0},
                        {7500, -0.066, 173205, 100},
                        {12200, -200000, 0, 0}};
  for (const auto& at : instants) {
    test.RunUntil(at.t);
    EXPECT_NEAR(test.profile(0).position, at.x, 0.1) << at.t;
    EXPECT_NEAR(test.profile(1).position, at.y, 0.1) << at.t;
    EXPECT_NEAR(test.crd().run.velocity, at.v, 1e-3) << at.t;
  }
  test.RunUntil(21499.75);
  EXPECT_TRUE(test.running());
  test.core.Tick();
  EXPECT_FALSE(test.running());
  EXPECT_NEAR(test.crd().run.at, 21499.9972, 1e-4);
  EXPECT_EQ(test.profile(0).position, 200000);
  EXPECT_EQ(test.profile(1).position, 0);
  EXPECT_EQ(test.fifo().done, 7);
}

TEST(CrdRun, DoesNotDependOnTheCycle) {
  std::vector<double> values;
  for (const int64_t cycle_us : {125, 250, 1000, 4000}) {
    CrdRunTest test(cycle_us);
    ASSERT_TRUE(test.Line({1000, 500}, 20, 0.5, 10));
    ASSERT_TRUE(test.Line({1500, 1500}, 30, 0.5, 5));
    ASSERT_TRUE(test.Delay(13));
    ASSERT_TRUE(test.Line({0, 0}, 30, 0.5));
    test.Start();
    size_t i = 0;
    for (double t = 4; t < 320; t += 4) {
      test.RunUntil(t);
      for (const double value : {test.profile(0).position, test.profile(1).velocity}) {
        if (cycle_us == 125) values.push_back(value);
        EXPECT_EQ(value, values[i++]) << cycle_us << " us at " << t;
      }
    }
  }
}

TEST(CrdRun, SegmentsChainAtTheirEndVelocity) {
  CrdRunTest test;
  // 0 -> 10 in 100 ms over 500, then 500 at 10, then 100 ms to rest.
  ASSERT_TRUE(test.Line({500, 0}, 10, 0.1, 10));
  ASSERT_TRUE(test.Line({1000, 0}, 10, 0.1, 10));
  ASSERT_TRUE(test.Line({1500, 0}, 10, 0.1));
  test.Start();
  EXPECT_TRUE(test.profile(0).moving);
  EXPECT_EQ(test.TicksToEnd(), 250);
  EXPECT_EQ(test.profile(0).position, 1500);
  EXPECT_FALSE(test.profile(0).moving);
}

TEST(CrdRun, ADelayMakesTheSegmentBeforeItEndAtRest) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({1000, 0}, 10, 0.1, 10));
  test.Start();
  test.RunUntil(50);
  ASSERT_TRUE(test.Delay(100));
  // 100 ms up, 100 ms down, 100 ms of waiting.
  EXPECT_EQ(test.TicksToEnd() + 50, 300);
}

TEST(CrdRun, CoordinatesAreRelativeToTheOrigin) {
  CrdRunTest test;
  test.core.ProfileAt(0).SetPosition(100);
  test.core.CrdAt(0).SetUp(test.crd().parameters);
  ASSERT_TRUE(test.Line({50, 0}, 10, 1));
  test.Start();
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 150);
  EXPECT_EQ(test.core.CrdPosition(0)[0], 50);
}

// --- Stops and resumption ------------------------------------------------------------------------

TEST(CrdStop, KeepsToThePathAndResumesAtTheBreakpoint) {
  for (const bool abrupt : {false, true}) {
    CrdRunTest test;
    test.crd().smooth_stop = 0.5;
    ASSERT_TRUE(test.Line({3000, 4000}, 20, 1));
    test.Start();
    test.RunUntil(100);
    // 20 ms and 200 pulses to 20 pulse/ms, then 80 ms at it.
    EXPECT_NEAR(test.profile(0).position, 0.6 * 1800, 1e-9);
    test.core.CrdAt(0).Stop(abrupt);
    test.TicksToEnd();
    const double rest = 1800 + (abrupt ? 20.0 * 20 / 2 / 1000 : 400);
    EXPECT_NEAR(test.profile(0).position, 0.6 * rest, 1e-9);
    EXPECT_NEAR(test.profile(1).position, 0.8 * rest, 1e-9);
    EXPECT_TRUE(test.fifo().executing);
    test.Start();
    test.TicksToEnd();
    EXPECT_EQ(test.profile(0).position, 3000);
    EXPECT_EQ(test.fifo().done, 1);
  }
}

TEST(CrdStop, GoesOnInTheNextSegment) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({1000, 0}, 20, 1, 20));
  ASSERT_TRUE(test.Line({1000, 1000}, 20, 1));
  test.Start();
  test.RunUntil(55);  // 200 + 35 * 20 = 900
  test.core.CrdAt(0).Stop(false);
  test.TicksToEnd();
  // 200 pulses to rest: 100 on each line.
  EXPECT_EQ(test.profile(0).position, 1000);
  EXPECT_NEAR(test.profile(1).position, 100, 1e-9);
}

TEST(CrdStop, AtRestLeavesProfilesWhereTheyHaveBeenPlaced) {
  CrdRunTest test;
  test.core.ProfileAt(0).SetPosition(5);
  test.core.CrdAt(0).Stop(false);
  test.core.CrdAt(0).Halt();
  test.core.CrdAt(0).CloseList(0);
  EXPECT_EQ(test.profile(0).position, 5);
}

TEST(CrdStop, AStopOfOneMemberStopsAll) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({3000, 4000}, 20, 1));
  test.Start();
  test.RunUntil(100);
  test.core.ProfileAt(1).Stop(true);
  test.TicksToEnd();
  EXPECT_NEAR(test.profile(0).position / test.profile(1).position, 0.75, 1e-12);
  EXPECT_LT(test.profile(1).position, 1500);
}

TEST(CrdStop, ASoftLimitOfOneAxisStopsAll) {
  CrdRunTest test;
  ChangeState(test.core).axes[0].soft_positive = 500;
  ASSERT_TRUE(test.Line({3000, 4000}, 20, 1));
  test.Start();
  test.TicksToEnd();
  EXPECT_NEAR(test.profile(0).position, 510, 10);
  EXPECT_NEAR(test.profile(0).position / test.profile(1).position, 0.75, 1e-12);
}

TEST(CrdStop, ALimitStopsSmoothlyWhereTheSystemIsSetSo) {
  CrdRunTest test;
  test.crd().limit_stop.smooth = true;
  test.crd().smooth_stop = 2;
  ChangeState(test.core).axes[0].soft_positive = 145;
  ASSERT_TRUE(test.Line({1000, 0}, 10, 1));
  test.Start();
  // The first tick beyond 145 is that at 20 ms, where the path has reached 150; 25 pulses stop it.
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 175);
}

TEST(CrdStop, AnAlarmStopsAbruptlyAlsoWhereLimitsStopSmoothly) {
  CrdRunTest test;
  test.crd().limit_stop.smooth = true;
  ChangeState(test.core).axes[0].soft_positive = 145;
  ASSERT_TRUE(test.Line({1000, 0}, 10, 1));
  test.Start();
  test.RunUntil(19);
  ChangeState(test.core).axes[0].latched = kAlarmBit;
  // Both stop the path in the tick at 20 ms, where it has reached 150; smoothly it would go to 200.
  test.TicksToEnd();
  EXPECT_NEAR(test.profile(0).position, 150, 0.1);
}

TEST(CrdStop, DropsADelayUnderWay) {
  CrdRunTest test;
  ASSERT_TRUE(test.Delay(1000));
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  test.Start();
  test.RunUntil(10);
  test.core.CrdAt(0).Stop(false);
  EXPECT_FALSE(test.running());
  test.Start();
  EXPECT_EQ(test.TicksToEnd(), 20);
}

TEST(CrdRun, StepModeRestsBehindEverySegment) {
  CrdRunTest test;
  test.crd().step_mode = true;
  ASSERT_TRUE(test.Line({500, 0}, 10, 0.1, 10));
  ASSERT_TRUE(test.Line({1000, 0}, 10, 0.1));
  for (const double end : {500.0, 1000.0}) {
    test.Start();
    test.TicksToEnd();
    EXPECT_EQ(test.profile(0).position, end);
  }
}

TEST(CrdRun, TheSecondFifoServesAPauseOfTheFirst) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({1000, 0}, 10, 1));
  test.Start();
  test.RunUntil(50);
  test.core.CrdAt(0).Stop(false);
  test.TicksToEnd();
  const double stopped = test.profile(0).position;
  ASSERT_TRUE(test.Line({stopped, 500}, 10, 1, 0, 1));
  ASSERT_TRUE(test.Line({stopped, 0}, 10, 1, 0, 1));
  test.Start(1);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, stopped);
  test.Start(0);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 1000);
}

TEST(CrdOverride, TakesEffectAtOnceWithTheSegmentsAcceleration) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({10000, 0}, 20, 1));
  test.Start();
  test.RunUntil(100);
  test.crd().override_ratio = 0.5;
  test.crd().Replan(test.core.now());
  test.RunUntil(105);
  EXPECT_NEAR(test.crd().run.velocity, 15, 1e-9);
  test.RunUntil(120);
  EXPECT_NEAR(test.crd().run.velocity, 10, 1e-9);
  // 1800 + 150 + 10 per ms, and 50 for the stop: 8050 / 10 - ... = 800 ms at 10, 10 ms to rest.
  EXPECT_EQ(test.TicksToEnd() + 120, 100 + 10 + 800 + 10);
  EXPECT_EQ(test.profile(0).position, 10000);
}

// --- Buffered commands ---------------------------------------------------------------------------

TEST(CrdBuffer, OutputsChangeAtTheTickInWhichTheSegmentEnds) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({1000, 0}, 10, 0.1, 10));
  ASSERT_TRUE(
      test.Command({BufferedKind::kOutputs, static_cast<int>(DoType::kGpo), 0, {0x5, 0x4}}));
  ASSERT_TRUE(test.Line({2000, 0}, 10, 0.1));
  test.Start();
  test.core.digital_io().Write(DoType::kGpo, 0xffff, 0x3);
  test.RunUntil(149);  // 100 ms and 500, 50 ms and 500
  EXPECT_EQ(test.core.state().io.Register(DoType::kGpo), 0x3u);
  test.RunUntil(150);
  EXPECT_EQ(test.core.state().io.Register(DoType::kGpo), 0x6u);
}

TEST(CrdBuffer, AGearedAxisEndsExactlyWithTheSegment) {
  for (const double ramp : {0.0, 0.25}) {
    CrdRunTest test;
    test.core.ProfileAt(4).SetPosition(1000);
    ASSERT_TRUE(test.Command({BufferedKind::kGear, 4, 0, {-300, ramp, ramp}}));
    ASSERT_TRUE(test.Line({3000, 4000}, 20, 1));
    ASSERT_TRUE(test.Line({0, 0}, 20, 1));
    test.Start();
    double last = 1000;
    while (test.fifo().done == 0) {
      test.core.Tick();
      const double position = test.profile(4).position;
      const double part = test.profile(0).position / 3000;
      if (ramp == 0 && test.fifo().done == 0) {
        EXPECT_NEAR(position, 1000 - 300 * part, 1e-9);
      }
      EXPECT_LE(position, last);
      last = position;
    }
    EXPECT_EQ(test.profile(4).position, 700);
    EXPECT_FALSE(test.profile(4).moving);
    test.TicksToEnd();
    EXPECT_EQ(test.profile(4).position, 700);
  }
}

TEST(CrdBuffer, AMoveWaitsOnlyWhenModal) {
  for (const int modal : {0, 1}) {
    CrdRunTest test;
    ASSERT_TRUE(test.Command({BufferedKind::kMove, 4, modal, {1000, 10, 1}}));
    ASSERT_TRUE(test.Line({100, 0}, 10, 1));
    test.Start();
    const int ticks = test.TicksToEnd();
    // The line lasts 20 ms, the move 110 ms.
    EXPECT_NEAR(ticks, modal == 1 ? 131 : 20, 1);
    EXPECT_EQ(test.profile(4).moving, modal == 0);
  }
}

TEST(CrdBuffer, AModalMoveIsWaitedForAcrossAPause) {
  CrdRunTest test;
  ASSERT_TRUE(test.Command({BufferedKind::kMove, 4, 1, {1000, 10, 1}}));
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  test.Start();
  test.RunUntil(20);
  test.core.CrdAt(0).Stop(false);
  EXPECT_FALSE(test.running());
  test.RunUntil(30);
  EXPECT_TRUE(test.profile(4).moving);
  test.Start();
  while (test.profile(4).moving) {
    ASSERT_EQ(test.profile(0).position, 0) << "at " << test.core.now() << " us";
    test.core.Tick();
  }
  EXPECT_EQ(test.profile(4).position, 1000);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 100);
}

TEST(CrdBuffer, AModalMoveThatEndedDuringAPauseIsNotMadeAgain) {
  CrdRunTest test;
  ASSERT_TRUE(test.Command({BufferedKind::kMove, 4, 1, {1000, 10, 1}}));
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  test.Start();
  test.RunUntil(20);
  test.core.CrdAt(0).Stop(false);
  test.RunUntil(200);
  ASSERT_EQ(test.profile(4).position, 1000);
  test.Start();
  EXPECT_NEAR(test.TicksToEnd(), 20, 1);
}

TEST(CrdBuffer, AModalMoveStoppedShortPausesThePathAndGoesOnWithIt) {
  CrdRunTest test;
  ASSERT_TRUE(test.Command({BufferedKind::kMove, 4, 1, {1000, 10, 1}}));
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  test.Start();
  test.RunUntil(20);
  test.core.ProfileAt(4).Stop(false);
  EXPECT_TRUE(test.running());
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 0);
  EXPECT_LT(test.profile(4).position, 1000);
  test.Start();
  test.TicksToEnd();
  EXPECT_EQ(test.profile(4).position, 1000);
  EXPECT_EQ(test.profile(0).position, 100);
}

TEST(CrdBuffer, AWaitBelongsToItsFifo) {
  CrdRunTest test;
  ASSERT_TRUE(test.Command({BufferedKind::kMove, 4, 1, {1000, 10, 1}}));
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  ASSERT_TRUE(test.Line({0, 50}, 10, 1, 0, 1));
  test.Start();
  test.RunUntil(20);
  test.core.CrdAt(0).Stop(false);
  test.Start(1);
  EXPECT_NEAR(test.TicksToEnd(), 15, 1);
  EXPECT_TRUE(test.profile(4).moving);
  test.crd().Clear(0);
  EXPECT_TRUE(test.fifo().idle());
}

TEST(CrdBuffer, AHoldWaitsForAnotherStart) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({100, 0}, 10, 1, 10));
  ASSERT_TRUE(test.Command({BufferedKind::kHold}));
  ASSERT_TRUE(test.Line({200, 0}, 10, 1));
  test.Start();
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 100);
  test.Start();
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 200);
}

TEST(CrdBuffer, RegistersAreWritten) {
  CrdRunTest test;
  ASSERT_TRUE(test.Command({BufferedKind::kAnalogOutput, 2, 0, {1234}}));
  ASSERT_TRUE(test.Command({BufferedKind::kLimits, 1, 0, {0}}));
  ASSERT_TRUE(test.Command({BufferedKind::kStopInput, 0, 1, {4, 3}}));
  test.Start();
  test.core.Tick();
  const MotionState& state = test.core.state();
  EXPECT_EQ(state.dacs[2].value, 1234);
  EXPECT_FALSE(state.axes[1].positive_limit_on);
  EXPECT_TRUE(state.axes[1].negative_limit_on);
  EXPECT_EQ(state.axes[0].abrupt_stop, (InputChoice{DiType::kGpi, 3}));
  EXPECT_FALSE(test.running());
}

TEST(CrdBuffer, WhatIsOutsideTheCoreIsHandedOverInTheOrderOfThePath) {
  CrdRunTest test;
  ASSERT_TRUE(test.Command({BufferedKind::kOutside, 7, 0, {-5}}));
  ASSERT_TRUE(test.Command({BufferedKind::kOutside, 8, 1, {2.5}}));
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  ASSERT_TRUE(test.Command({BufferedKind::kOutside, 9, 0, {1}}));
  const auto is_nine = [](const BufferedCommand& command) { return command.item == 9; };
  EXPECT_FALSE(test.core.state().crds[0].WillReach(is_nine)) << "it does not run";
  test.Start();
  test.core.Tick();
  std::vector<BufferedCommand>& reached = ChangeState(test.core).reached;
  ASSERT_EQ(reached.size(), 2u);
  EXPECT_EQ(reached[0].item, 7);
  EXPECT_EQ(reached[0].values[0], -5);
  EXPECT_EQ(reached[1].detail, 1);
  EXPECT_TRUE(test.core.state().crds[0].WillReach(is_nine));
  reached.clear();
  test.TicksToEnd();
  ASSERT_EQ(reached.size(), 1u);
  EXPECT_EQ(reached[0].item, 9);
  EXPECT_FALSE(test.core.state().crds[0].WillReach(is_nine));
}

TEST(CrdFifo, Holds4096) {
  CrdRunTest test;
  for (int i = 1; i <= 4096; ++i) ASSERT_TRUE(test.Line({1.0 * i, 0}, 10, 1));
  EXPECT_FALSE(test.Line({5000, 0}, 10, 1));
  EXPECT_EQ(test.fifo().space(), 0u);
  EXPECT_EQ(test.fifo().tail[0], 4096);
}

}  // namespace
}  // namespace oncard::motion
