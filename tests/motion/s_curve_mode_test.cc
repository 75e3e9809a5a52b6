// Mode S of a profile: starts, changes in motion and stops. The plans themselves are tested by
// jerk_plan_test.cc.
#include "motion/profiles/s_curve_mode.h"

#include <gtest/gtest.h>

#include <limits>

#include "motion/common/state_hash.h"
#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/profile_run.h"

namespace oncard::motion {
namespace {

constexpr double kAtOnce = std::numeric_limits<double>::infinity();

/// A profile in mode S whose ramps take 150 ms over 3750 pulses: 50 ms for each change of the
/// acceleration and 50 ms with the largest one.
class SCurve : public ::testing::Test {
 protected:
  SCurve() {
    run_.profile.mode = ProfileMode::kSCurve;
    registers().limits = {.velocity = 50, .acceleration = 0.5, .jerk = 0.01};
  }

  SCurveMode& registers() { return run_.profile.s_curve; }
  void MoveTo(int32_t target) {
    registers().target = target;
    run_.profile.Start(run_.now);
  }
  void StopSmoothly() { run_.profile.StopSmoothly(run_.now); }
  void ExpectAt(double ms, double position, double velocity, double acceleration) {
    const Sample& sample = run_.At(ms);
    EXPECT_NEAR(sample.position, position, 1e-9) << ms;
    EXPECT_NEAR(sample.velocity, velocity, 1e-9) << ms;
    EXPECT_NEAR(sample.acceleration, acceleration, 1e-9) << ms;
    EXPECT_TRUE(sample.moving) << ms;
  }

  ProfileRun run_;
};

TEST_F(SCurve, MovesToItsTarget) {
  MoveTo(20000);
  EXPECT_TRUE(run_.profile.now.moving);
  ExpectAt(75, 677 + 1.0 / 12, 25, 0.5);
  ExpectAt(275, 10000, 50, 0);
  EXPECT_TRUE(run_.At(549.75).moving);
  EXPECT_EQ(run_.At(550), AtRest(20000));
  EXPECT_FALSE(registers().running);
}

TEST_F(SCurve, WithoutDistanceVelocityAccelerationOrJerkNothingMoves) {
  constexpr JerkLimits kNothing[] = {{0, 0.5, 0.01}, {50, 0, 0.01}, {50, 0.5, 0}, {1e-10, 1, 1}};
  MoveTo(0);
  EXPECT_FALSE(run_.profile.now.moving);
  for (const JerkLimits& limits : kNothing) {
    registers().limits = limits;
    MoveTo(100);
    EXPECT_FALSE(run_.profile.now.moving);
    EXPECT_EQ(run_.Tick(), AtRest(0));
  }
}

TEST_F(SCurve, RegistersWaitForTheNextStart) {
  MoveTo(20000);
  run_.At(200);
  registers().limits.velocity = 25;
  registers().target = 30000;
  ExpectAt(250, 8750, 50, 0);
  // 100 ms over 3750 to 25; 100 ms over 1250 to rest: 16250 remain for the cruise.
  run_.profile.Start(run_.now);
  ExpectAt(350, 12500, 25, 0);
  ExpectAt(999.75, 28743.75, 25, 0);
  EXPECT_EQ(run_.At(1100), AtRest(30000));
}

TEST_F(SCurve, ATargetBehindIsReachedAfterAStop) {
  MoveTo(20000);
  run_.At(210);
  MoveTo(8000);
  // 150 ms to 10500, and 200 ms back.
  ExpectAt(260, 6750 + 2291 + 2.0 / 3, 37.5, -0.5);
  ExpectAt(460, 9250, -25, 0);
  EXPECT_EQ(run_.At(560), AtRest(8000));
}

TEST_F(SCurve, AStartBeforeTheFirstCycleReplacesTheOneBefore) {
  MoveTo(-20000);
  MoveTo(20000);
  EXPECT_EQ(run_.At(550), AtRest(20000));
}

TEST_F(SCurve, StopsSmoothly) {
  // In the ramp at 70 ms, at 22.5 pulse/ms: 50 ms to 35, then 120 ms to rest.
  MoveTo(20000);
  run_.At(70);
  StopSmoothly();
  ExpectAt(120, 2100, 35, 0);
  ExpectAt(190, 3991 + 2.0 / 3, 12.5, -0.5);
  StopSmoothly();
  EXPECT_TRUE(run_.At(239.75).moving);
  EXPECT_EQ(run_.At(240).velocity, 0);
  EXPECT_NEAR(run_.profile.now.position, 4200, 1e-9);
  EXPECT_FALSE(run_.profile.now.moving);
}

TEST_F(SCurve, StopsWithTheLimitsOfItsRun) {
  MoveTo(20000);
  run_.At(200);
  registers().limits = {.velocity = 1, .acceleration = 2, .jerk = 1};
  StopSmoothly();
  EXPECT_TRUE(run_.At(349.75).moving);
  EXPECT_NEAR(run_.At(350).position, 10000, 1e-9);
}

TEST_F(SCurve, ASmoothStopBeforeTheFirstCycleOrAtRestIsNothing) {
  MoveTo(20000);
  StopSmoothly();
  EXPECT_EQ(run_.profile.now, AtRest(0));
  StopSmoothly();
  EXPECT_EQ(run_.Tick(), AtRest(0));
}

TEST_F(SCurve, StopsAtOnceAndGoesOnToItsTarget) {
  MoveTo(20000);
  run_.At(275);
  run_.Stop(kAtOnce);
  EXPECT_EQ(run_.profile.now, AtRest(10000));
  EXPECT_FALSE(registers().running);
  run_.At(300);
  run_.profile.Start(run_.now);
  // 150 ms and 3750 pulses for each ramp.
  EXPECT_EQ(run_.At(300 + 350), AtRest(20000));
}

TEST_F(SCurve, AStopWithADecelerationIsNotReplacedByASmoothOne) {
  MoveTo(20000);
  run_.At(275);
  run_.Stop(5);
  StopSmoothly();
  EXPECT_EQ(run_.At(280).velocity, 25);
  EXPECT_EQ(run_.At(285), AtRest(10250));
}

TEST_F(SCurve, GoesOnDuringAStopWithoutItsDeceleration) {
  MoveTo(20000);
  run_.At(275);
  run_.Stop(5);
  run_.At(280);
  run_.profile.Start(run_.now);
  EXPECT_NEAR(run_.Tick().velocity, 25 + 0.01 * 0.25 * 0.25 / 2, 1e-12);
  while (run_.Tick().moving) {
  }
  EXPECT_EQ(run_.profile.now, AtRest(20000));
}

TEST(SCurveOnACard, StopsSmoothlyAsItPlansIt) {
  MotionCore core({});
  Profile& profile = ChangeState(core).profiles[0];
  profile.mode = ProfileMode::kSCurve;
  profile.s_curve.limits = {.velocity = 50, .acceleration = 0.5, .jerk = 0.01};
  profile.s_curve.target = 20000;
  core.ProfileAt(0).Start();
  core.Advance(275 * 4);
  core.ProfileAt(0).Stop(false);
  core.Advance(149 * 4);
  EXPECT_TRUE(core.profile(0).now.moving);
  core.Advance(4);
  EXPECT_FALSE(core.profile(0).now.moving);
  EXPECT_NEAR(core.profile(0).now.position, 13750, 1e-9);
}

TEST_F(SCurve, IsNotInTheHashOfACardThatDoesNotUseIt) {
  const uint64_t without = StateHash().value();
  SCurveMode other;
  EXPECT_EQ(StateHash().Add(other).value(), without);
  other.target = 1;
  EXPECT_NE(StateHash().Add(other).value(), without);
  EXPECT_NE(StateHash().Add(registers()).value(), without);
  MoveTo(20000);
  const uint64_t begun = StateHash().Add(registers()).value();
  StopSmoothly();
  EXPECT_NE(StateHash().Add(registers()).value(), begun);
}

}  // namespace
}  // namespace oncard::motion
