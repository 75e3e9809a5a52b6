// Gantries: the slave moves like its master, the controllers share the skew, the limit of the skew.
#include "motion/gantry.h"

#include <gtest/gtest.h>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/core_run.h"

namespace oncard::motion {
namespace {

/// Axes 1 and 2 in closed loop; at the same voltage the second drive is a tenth slower.
MotionCore UnevenCore(double coupling) {
  MotionCore core({});
  for (const size_t axis : {size_t{0}, size_t{1}}) {
    core.ConnectDrive(axis, VelocityDrive(axis == 0 ? 100 : 90, 2, 0, 0.125));
    ChangeState(core).controls[axis].sets[0] = {.kp = 20};
    core.AxisAt(axis).SetClosedLoop(true);
    core.AxisAt(axis).ServoOn();
  }
  core.EnableGantry(0, 1, coupling, coupling);
  return core;
}

TEST(Gantry, TheSlaveMovesAsItsMasterFromWhereItIs) {
  MotionCore core({.cycle_us = 1000});
  core.AxisAt(0).ServoOn();
  core.AxisAt(1).ServoOn();
  ChangeState(core).axes[1].profile_map = 0b10;
  core.ProfileAt(1).SetPosition(700);
  core.AxisAt(1).SynchPosition();
  core.EnableGantry(0, 1, 0, 0);
  Jog(core, 10);
  Ticks(core, 100);
  const double moved = core.state().axes[0].profile.position;
  EXPECT_GT(moved, 500);
  EXPECT_EQ(core.state().axes[1].profile.position, 700 + moved);
  EXPECT_EQ(core.GantrySkew(), 0);
  // Afterwards the axes are independent again and keep their positions.
  core.ProfileAt(0).Stop(true);
  while (core.AxisMoving(core.state().axes[0])) core.Tick();
  const double end = core.state().axes[0].profile.position;
  core.DisableGantry();
  Ticks(core, 1);
  EXPECT_EQ(core.state().axes[1].profile.position, 700 + end);
  EXPECT_EQ(core.state().axes[1].profile_map, 0b10u);
}

TEST(Gantry, ASwitchOfTheSlaveStopsBoth) {
  MotionCore core({.cycle_us = 1000});
  core.AxisAt(0).ServoOn();
  core.AxisAt(1).ServoOn();
  core.EnableGantry(0, 1, 0, 0);
  ChangeState(core).axes[1].soft_positive = 300;
  Jog(core, 10);
  Ticks(core, 200);
  EXPECT_NE(core.Conditions(1) & kPositiveLimitBit, 0u);
  EXPECT_EQ(core.Conditions(0) & kMovingBit, 0u);
  EXPECT_EQ(core.state().axes[0].profile.position, core.state().axes[1].profile.position);
}

TEST(Gantry, TheCouplingSharesTheSkew) {
  // At velocity v the drives need U1 = 32767 v / 100 and U2 = 32767 v / 90. Without coupling E = U
  // / kp, so that the skew is (U1 - U2) / kp; with coupling kp E1 + k s = U1 and kp E2 - k s = U2,
  // s = E1 - E2, so that s = (U1 - U2) / (kp + 2 k).
  const double difference = 32767 * 10 / 100.0 - 32767 * 10 / 90.0;
  for (const double coupling : {0.0, 10.0, 40.0}) {
    MotionCore core = UnevenCore(coupling);
    Jog(core, 10);
    Ticks(core, 4000);
    double sum = 0;
    constexpr int kTicks = 4000;
    for (int i = 0; i < kTicks; ++i) {
      core.Tick();
      sum += core.GantrySkew();
    }
    EXPECT_NEAR(sum / kTicks, difference / (20 + 2 * coupling), 0.6) << coupling;
  }
}

TEST(Gantry, RenamingPositionsMovesNothingAndIsNoSkew) {
  for (const size_t axis : {size_t{0}, size_t{1}}) {
    for (const bool zero : {true, false}) {
      MotionCore core = UnevenCore(10);
      core.SetGantryErrorLimit(20);
      Jog(core, 10);
      Ticks(core, 2000);
      core.ProfileAt(0).Stop(true);
      Ticks(core, 2000);
      const double skew = core.GantrySkew();
      const double beam[] = {core.state().plants[0].position, core.state().plants[1].position};
      ASSERT_GT(beam[0], 4000);
      if (zero) {
        core.AxisAt(axis).ZeroPosition();
        EXPECT_EQ(core.state().axes[axis].profile.position, 0);
        EXPECT_EQ(core.state().axes[axis].encoder.position, 0);
      } else {
        core.AxisAt(axis).SynchPosition();
      }
      EXPECT_EQ(core.GantrySkew(), skew);
      Ticks(core, 2000);
      for (const size_t side : {size_t{0}, size_t{1}}) {
        EXPECT_NEAR(core.state().plants[side].position, beam[side], 2) << "axis " << axis;
        EXPECT_NE(core.Conditions(side) & kServoOnBit, 0u) << "axis " << axis;
      }
    }
  }
}

TEST(Gantry, AScaleOfTheMasterIsTheSlavesToo) {
  MotionCore core({.cycle_us = 1000});
  core.AxisAt(0).ServoOn();
  core.AxisAt(1).ServoOn();
  core.EnableGantry(0, 1, 0, 0);
  core.AxisAt(0).SetProfileScale({2, 1});
  Jog(core, 10);
  Ticks(core, 100);
  EXPECT_GT(core.state().plants[0].position, 200);
  EXPECT_EQ(core.state().plants[0].position, core.state().plants[1].position);
}

TEST(Gantry, TooMuchSkewSwitchesBothOff) {
  MotionCore core({.cycle_us = 1000});
  core.AxisAt(0).ServoOn();
  core.AxisAt(1).ServoOn();
  core.EnableGantry(0, 1, 0, 0);
  core.SetGantryErrorLimit(50);
  ChangeState(core).plants[1].stalled = true;
  Jog(core, 1);
  while (core.state().axes[0].encoder.position < 50) core.Tick();
  EXPECT_NE(core.Conditions(0) & kServoOnBit, 0u);
  Ticks(core, 2);
  for (const size_t axis : {size_t{0}, size_t{1}}) {
    EXPECT_NE(core.Conditions(axis) & kFollowingErrorBit, 0u) << axis;
    EXPECT_EQ(core.Conditions(axis) & (kServoOnBit | kMovingBit), 0u) << axis;
  }
}

}  // namespace
}  // namespace oncard::motion
