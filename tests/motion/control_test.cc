// Servo controllers: the formula sample by sample, the closed loop with a velocity drive, the
// following error limit and the encoder check.
#include "motion/control.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/core_run.h"

namespace oncard::motion {
namespace {

TEST(Pid, FollowsTheFormulaSampleBySample) {
  Control control;
  control.sets[0] = {.kp = 2, .ki = 128, .kd = 10, .kvff = 3, .kaff = 100};
  struct {
    double error, velocity, acceleration, output;
  } const samples[] = {
      // 2 E + 128/256 sum + 10 dE + 3 v + 100 a
      {4, 0, 0, 8 + 2 + 40},
      {6, 1, 0, 12 + 5 + 20 + 3},
      {6, 1, 0.5, 12 + 8 + 0 + 3 + 50},
      {-10, 2, -0.5, -20 + 3 - 160 + 6 - 50},
  };
  for (const auto& s : samples) {
    EXPECT_DOUBLE_EQ(control.Advance(s.error, s.velocity, s.acceleration, 0.125), s.output);
  }
}

TEST(Pid, LimitsSumDifferenceAndOutput) {
  Control control;
  control.sets[0] = {.ki = 256, .integral_limit = 10};
  EXPECT_EQ(control.Advance(8, 0, 0, 0.125), 8);
  EXPECT_EQ(control.Advance(8, 0, 0, 0.125), 10);
  EXPECT_EQ(control.Advance(-3, 0, 0, 0.125), 7);
  EXPECT_EQ(control.Advance(-100, 0, 0, 0.125), -10);
  Control second;
  second.sets[0] = {.kd = 1, .derivative_limit = 5};
  EXPECT_EQ(second.Advance(3, 0, 0, 0.125), 3);
  EXPECT_EQ(second.Advance(30, 0, 0, 0.125), 5);
  EXPECT_EQ(second.Advance(-30, 0, 0, 0.125), -5);
  Control third;
  third.sets[0] = {.kp = 100, .limit = 500};
  EXPECT_EQ(third.Advance(4, 0, 0, 0.125), 400);
  EXPECT_EQ(third.Advance(6, 0, 0, 0.125), 500);
  EXPECT_EQ(third.Advance(-6, 0, 0, 0.125), -500);
}

TEST(Pid, TheSelectedSetActsAtOnceAndTheSumStays) {
  Control control;
  control.sets[0] = {.ki = 256};
  control.sets[2] = {.kp = 5, .ki = 256};
  EXPECT_EQ(control.Advance(1, 0, 0, 0.125), 1);
  control.selected = 2;
  EXPECT_EQ(control.Advance(1, 0, 0, 0.125), 7);
}

TEST(Pid, HasTheSubStepsOfTheConfiguration) {
  const struct {
    int64_t servo_us;
    double steps;
  } cases[] = {{125, 8}, {250, 4}, {1000, 1}};
  for (const auto& c : cases) {
    MotionCore core({.cycle_us = 1000, .servo_us = c.servo_us});
    core.AxisAt(0).SetClosedLoop(true);
    core.AxisAt(0).ServoOn();
    ChangeState(core).encoder_faults[0].slip = -1;  // an error of 1 in each sub-step
    core.Tick();
    EXPECT_EQ(core.state().controls[0].sum, c.steps) << c.servo_us;
  }
}

TEST(Pid, TheFedForwardVelocityIsFiltered) {
  Control control;
  control.sets[0] = {.kvff = 1, .kvff_filter = 1};
  EXPECT_EQ(control.Advance(0, 8, 0, 0.125), 4);
  EXPECT_EQ(control.Advance(0, 8, 0, 0.125), 6);
  Control limited;
  limited.sets[0] = {.kvff = 1, .kvff_acc_max = 16};  // 2 pulse/ms in each 0.125 ms
  EXPECT_EQ(limited.Advance(0, 8, 0, 0.125), 2);
  EXPECT_EQ(limited.Advance(0, 8, 0, 0.125), 4);
  EXPECT_EQ(limited.Advance(0, 1, 0, 0.125), 2);
}

/// Axis 1 in closed loop with a velocity drive.
MotionCore ServoCore(const PidSet& pid, double tau = 2) {
  MotionCore core({});
  core.ConnectDrive(0, VelocityDrive(100, tau, 0, 0.125));
  ChangeState(core).controls[0].sets[0] = pid;
  core.AxisAt(0).SetClosedLoop(true);
  core.AxisAt(0).ServoOn();
  return core;
}

double Error(const MotionCore& core) {
  return core.state().axes[0].profile.position - core.state().axes[0].encoder.position;
}

double MeanError(MotionCore& core, int ticks) {
  double sum = 0;
  for (int i = 0; i < ticks; ++i) {
    core.Tick();
    sum += Error(core);
  }
  return sum / ticks;
}

TEST(ClosedLoop, TheSteadyErrorIsWhatTheVelocityNeeds) {
  // v = Kdrive U / 32767 and U = kp E: E = 32767 v / (100 kp). Counting whole pulses adds noise of
  // less than a pulse with a mean close to 0.
  struct {
    double kp, velocity, error;
  } const cases[] = {{20, 10, 163.835}, {40, 10, 81.9175}, {20, -5, -81.9175}, {60, 50, 273.0583}};
  for (const auto& c : cases) {
    MotionCore core = ServoCore({.kp = c.kp});
    Jog(core, c.velocity);
    Ticks(core, 2000);
    EXPECT_NEAR(MeanError(core, 4000), c.error, 0.1) << c.kp << " " << c.velocity;
  }
}

TEST(ClosedLoop, FeedForwardTakesTheSteadyErrorAway) {
  MotionCore core = ServoCore({.kp = 20, .kvff = 327.67});
  Jog(core, 10);
  Ticks(core, 4000);
  EXPECT_NEAR(MeanError(core, 4000), 0, 0.1);
}

TEST(ClosedLoop, TheIntegralTakesTheSteadyErrorAway) {
  MotionCore core = ServoCore({.kp = 20, .ki = 40});
  Jog(core, 10);
  Ticks(core, 20'000);
  EXPECT_NEAR(MeanError(core, 4000), 0, 0.5);
}

TEST(ClosedLoop, AgreesWithAFineIntegrationOfTheSameLoop) {
  // The plant is integrated with 1000 steps per sub-step, directly from the equations.
  const PidSet pid{.kp = 20, .kd = 10};
  MotionCore core = ServoCore(pid);
  Jog(core, 20);
  double position = 0;
  double velocity = 0;
  double before = 0;
  double reference = 0;
  for (int tick = 0; tick < 800; ++tick) {
    core.Tick();
    const double next = core.state().axes[0].profile.position;
    for (int half = 0; half < 2; ++half) {
      const double error = reference + half * (next - reference) / 2 - std::round(position);
      const double output = std::round(pid.kp * error + pid.kd * (error - before));
      before = error;
      const double commanded = 100 * output / 32767;
      for (int i = 0; i < 1000; ++i) {
        const double middle = velocity + (commanded - velocity) / 2 * 0.000125 / 2;
        velocity += (commanded - middle) / 2 * 0.000125;
        position += middle * 0.000125;
      }
    }
    reference = next;
    ASSERT_NEAR(core.state().plants[0].position, position, 1e-3) << tick;
  }
}

TEST(ClosedLoop, EnablingTakesTheMeasuredPositionSoThatNothingJumps) {
  MotionCore core({});
  core.AxisAt(0).SetClosedLoop(true);
  core.ConnectDrive(0, VelocityDrive(100, 2, 0, 0.125));
  ChangeState(core).controls[0].sets[0] = {.kp = 20};
  core.ProfileAt(0).SetPosition(5000);
  core.AxisAt(0).SynchPosition();
  core.AxisAt(0).ServoOn();
  EXPECT_EQ(core.state().axes[0].profile.position, 0);
  EXPECT_EQ(core.state().profiles[0].now.position, 0);
  Ticks(core, 100);
  EXPECT_EQ(core.state().plants[0].position, 0);
}

TEST(ClosedLoop, EnablingUsesTheScaleOfTheProfile) {
  MotionCore core({});
  core.AxisAt(0).SetClosedLoop(true);
  core.AxisAt(0).SetProfileScale({4, 2});
  core.EncoderAt(0).SetPosition(300);
  core.AxisAt(0).SynchPosition();
  core.AxisAt(0).ServoOn();
  EXPECT_EQ(core.state().axes[0].profile.position, 300);
  EXPECT_EQ(core.state().profiles[0].now.position, 600);
}

TEST(OpenLoop, EnablingChangesNoPosition) {
  MotionCore core({});
  core.ProfileAt(0).SetPosition(5000);
  core.AxisAt(0).SynchPosition();
  core.AxisAt(0).ServoOn();
  Ticks(core, 3);
  EXPECT_EQ(core.state().axes[0].profile.position, 5000);
  EXPECT_EQ(core.state().axes[0].encoder.position, 0);
}

TEST(ClosedLoop, DisablingTakesTheVoltageAway) {
  MotionCore core = ServoCore({.kp = 20});
  Jog(core, 10);
  Ticks(core, 400);
  EXPECT_GT(core.state().dacs[0].Output(), 1000);
  core.AxisAt(0).ServoOff();
  EXPECT_EQ(core.state().dacs[0].Output(), 0);
}

TEST(ClosedLoop, ZeroingAndSynchronisingDoNotMoveTheMotor) {
  MotionCore core({});
  core.AxisAt(0).SetClosedLoop(true);
  core.AxisAt(0).ServoOn();
  Jog(core, 10);
  Ticks(core, 400);
  core.ProfileAt(0).Stop(true);
  Ticks(core, 40);
  const double place = core.state().plants[0].position;
  core.AxisAt(0).ZeroPosition();
  Ticks(core, 40);
  EXPECT_EQ(core.state().plants[0].position, place);
  EXPECT_EQ(core.state().axes[0].profile.position, 0);
}

TEST(FollowingError, IsStrictLatchedAndStopsTheAxis) {
  MotionCore core({});
  core.ControlAt(0).SetErrorLimit(100);
  core.AxisAt(0).ServoOn();
  ChangeState(core).encoder_faults[0].slip = 100;  // the measured position is 100 ahead
  core.Tick();
  EXPECT_EQ(core.Conditions(0), kServoOnBit);
  Jog(core, 10);
  ChangeState(core).encoder_faults[0].slip = 0;
  ChangeState(core).encoder_faults[0].held = true;
  Ticks(core, 120);
  const uint32_t status = core.Conditions(0);
  EXPECT_TRUE(status & kFollowingErrorBit);
  EXPECT_FALSE(status & kServoOnBit);
  EXPECT_FALSE(status & kMovingBit);
  // 100 pulses beyond the measured position of 100, at which the encoder has stopped.
  EXPECT_NEAR(core.state().axes[0].profile.position, 200, 5);
  EXPECT_EQ(core.state().io.Register(DoType::kEnable), 0u);
}

TEST(FollowingError, IsOnlyLatchedOnACardThatDoesNotStop) {
  MotionCore core({.defaults = {.following_error_stops = false}});
  core.AxisAt(0).ServoOn();
  ChangeState(core).encoder_faults[0].slip = 32768;
  core.Tick();
  EXPECT_EQ(core.Conditions(0), kFollowingErrorBit | kServoOnBit);
}

TEST(FollowingError, TheBitIsClearedWhenTheErrorHasGone) {
  MotionCore core({});
  core.AxisAt(0).ServoOn();
  ChangeState(core).encoder_faults[0].slip = 32768;
  core.Tick();
  EXPECT_TRUE(core.Conditions(0) & kFollowingErrorBit);
  core.AxisAt(0).ClearStatus();
  EXPECT_TRUE(core.Conditions(0) & kFollowingErrorBit);
  core.AxisAt(0).ZeroPosition();
  EXPECT_TRUE(core.Conditions(0) & kFollowingErrorBit);
  core.AxisAt(0).ClearStatus();
  EXPECT_FALSE(core.Conditions(0) & kFollowingErrorBit);
}

TEST(FollowingError, IsWatchedByActiveControllersOfEnabledAxesOnly) {
  for (const auto& [active, servo, bit] :
       {std::tuple{true, true, true}, {true, false, false}, {false, true, false}}) {
    MotionCore core({});
    if (servo) core.AxisAt(0).ServoOn();
    ChangeState(core).controls[0].active = active;
    ChangeState(core).encoder_faults[0].slip = 40'000;
    core.Tick();
    EXPECT_EQ((core.Conditions(0) & kFollowingErrorBit) != 0, bit) << active << servo;
  }
}

TEST(FollowingError, ARunawayWithAReversedEncoderIsStopped) {
  MotionCore core = ServoCore({.kp = 20});
  core.ControlAt(0).SetErrorLimit(1000);
  core.EncoderAt(0).SetSense(true);
  Jog(core, 1);
  Ticks(core, 4000);
  EXPECT_TRUE(core.Conditions(0) & kFollowingErrorBit);
  EXPECT_FALSE(core.Conditions(0) & kServoOnBit);
  EXPECT_NEAR(core.state().plants[0].velocity, 0, 1e-9);
}

TEST(ResponseCheck, AVoltageWithoutMotionSwitchesTheAxisOff) {
  MotionCore core = ServoCore({.kp = 20});
  ChangeState(core).controls[0].check = {
      .on = true, .threshold = 200, .min_velocity = 1, .time = 10'000};
  Jog(core, 10);
  Ticks(core, 400);
  EXPECT_TRUE(core.Conditions(0) & kServoOnBit);
  ChangeState(core).plants[0].stalled = true;
  ChangeState(core).plants[0].velocity = 0;
  Ticks(core, 39);
  EXPECT_TRUE(core.Conditions(0) & kServoOnBit);
  Ticks(core, 5);
  EXPECT_FALSE(core.Conditions(0) & kServoOnBit);
  EXPECT_TRUE(core.Conditions(0) & kFollowingErrorBit);
}

}  // namespace
}  // namespace oncard::motion
