// Drives: the lag's exact solution, friction, and how the motor follows pulses and voltages.
#include "motion/mechanics/plant.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/core_run.h"

namespace oncard::motion {
namespace {

TEST(ExpMinus, AgreesWithTheLibrary) {
  for (const double x : {0.0, 1e-9, 0.01, 1.0 / 64, 0.0625, 0.5, 1.0, 3.7, 20.0, 99.0}) {
    EXPECT_NEAR(ExpMinus(x) / std::exp(-x), 1, 1e-12) << x;
  }
}

TEST(VelocityDrive, FollowsAStepWithItsTimeConstant) {
  // v(t) = 100 (1 - e^(-t/2)), p(t) = 100 (t - 2 (1 - e^(-t/2))) at full output.
  const Drive drive = VelocityDrive(100, 2, 0, 0.125);
  Plant plant;
  for (int i = 1; i <= 160; ++i) {
    plant.Advance(drive, 32767, 0.125);
    const double t = i * 0.125;
    EXPECT_NEAR(plant.velocity, 100 * (1 - std::exp(-t / 2)), 1e-9) << t;
    EXPECT_NEAR(plant.position, 100 * (t - 2 * (1 - std::exp(-t / 2))), 1e-8) << t;
  }
}

TEST(VelocityDrive, WithoutALagObeysAtOnce) {
  const Drive drive = VelocityDrive(80, 0, 0, 0.125);
  Plant plant;
  plant.Advance(drive, -32767, 0.125);
  EXPECT_EQ(plant.velocity, -80);
  EXPECT_EQ(plant.position, -10);
}

TEST(VelocityDrive, FrictionMissesTheCommandedSpeed) {
  const Drive drive = VelocityDrive(32.767, 2, 1, 0.125);  // 1 pulse/ms for an output of 1000
  struct {
    double output, speed;
  } const cases[] = {{0, 0}, {999, 0}, {-999, 0}, {1000, 0}, {3000, 2}, {-3000, -2}};
  for (const auto& c : cases) EXPECT_NEAR(drive.Commanded(c.output), c.speed, 1e-12) << c.output;
}

TEST(IdealDrive, FollowsExactlyByPulsesAndInClosedLoop) {
  for (const bool closed : {false, true}) {
    for (const int64_t cycle_us : {125, 250, 1000}) {
      MotionCore core({.cycle_us = cycle_us});
      core.PlaceMotor(0, 777);
      core.AxisAt(0).SetClosedLoop(closed);
      core.AxisAt(0).ServoOn();
      Jog(core, 33.3);
      for (int i = 0; i < 500; ++i) {
        core.Tick();
        const double planned = core.state().axes[0].profile.position;
        ASSERT_NEAR(core.state().plants[0].position, 777 + planned, 1e-9) << closed << " " << i;
        ASSERT_NEAR(core.state().axes[0].encoder.position, planned, 0.51) << closed << " " << i;
        ASSERT_EQ(core.state().plants[0].velocity, core.state().axes[0].profile.velocity);
      }
    }
  }
}

TEST(IdealDrive, LosesThePulsesOfAStall) {
  MotionCore core({});
  core.AxisAt(0).ServoOn();
  Jog(core, 10);
  Ticks(core, 400);
  const double before = core.state().plants[0].position;
  const double planned = core.state().axes[0].profile.position;
  ChangeState(core).plants[0].stalled = true;
  Ticks(core, 40);
  EXPECT_EQ(core.state().plants[0].position, before);
  EXPECT_EQ(core.state().plants[0].velocity, 0);
  ChangeState(core).plants[0].stalled = false;
  Ticks(core, 40);
  EXPECT_NEAR(core.state().plants[0].position, before + 100, 1e-9);
  EXPECT_NEAR(core.state().axes[0].profile.position, planned + 200, 1e-9);
}

TEST(VelocityDriveMotor, ObeysTheVoltageOfItsOutputWhileEnabled) {
  MotionCore core({});
  core.ConnectDrive(0, VelocityDrive(100, 2, 0, 0.125));
  ChangeState(core).dacs[0].value = 32767;
  Ticks(core, 40);
  EXPECT_EQ(core.state().plants[0].position, 0);
  core.AxisAt(0).ServoOn();
  Ticks(core, 40);  // 10 ms
  EXPECT_NEAR(core.state().plants[0].position, 100 * (10 - 2 * (1 - std::exp(-5.0))), 1e-8);
  core.AxisAt(0).ServoOff();
  Ticks(core, 400);
  EXPECT_NEAR(core.state().plants[0].velocity, 0, 1e-9);
}

TEST(VelocityDriveMotor, DoesNotDependOnTheCycle) {
  const auto run = [](int64_t cycle_us) {
    MotionCore core({.cycle_us = cycle_us});
    core.ConnectDrive(0, VelocityDrive(100, 2, 0.5, 0.125));
    core.AxisAt(0).ServoOn();
    ChangeState(core).dacs[0].value = 12345;
    while (core.now() < 100'000) core.Tick();
    return core.state().plants[0].position;
  };
  EXPECT_EQ(run(125), run(250));
  EXPECT_EQ(run(125), run(4000));
}

}  // namespace
}  // namespace oncard::motion
