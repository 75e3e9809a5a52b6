// Backlash and pitch error of an axis.
#include "motion/compensation.h"

#include <gtest/gtest.h>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

namespace oncard::motion {
namespace {

// Points at 1000, 2000 and 3000.
const PitchTable kTable{1000, 2000, {4, 10, -2}, {-8, 0, 6}};

TEST(PitchTable, IsLinearBetweenThePointsAndNothingOutside) {
  struct Case {
    double position, positive, negative;
  };
  for (const Case& c : {Case{999.5, 0, 0},
                        {1000, 4, -8},
                        {1250, 5.5, -6},
                        {1500, 7, -4},
                        {2000, 10, 0},
                        {2500, 4, 3},
                        {3000, -2, 6},
                        {3000.5, 0, 0},
                        {-1500, 0, 0}}) {
    EXPECT_EQ(kTable.At(c.position, true), c.positive) << c.position;
    EXPECT_EQ(kTable.At(c.position, false), c.negative) << c.position;
  }
}

TEST(Backlash, IsTakenUpInItsDirectionOnly) {
  struct Case {
    bool positive;
    double velocity, error;
  };
  for (const Case& c :
       {Case{true, 1, 20}, {true, -1, 0}, {false, -1, -20}, {false, 1, 0}, {true, 0, 0}}) {
    Compensation compensation;
    compensation.SetBacklash({20, 0, c.positive});
    compensation.Advance(0, 1000, 0, c.velocity);
    EXPECT_EQ(compensation.backlash_error, c.error) << c.positive << c.velocity;
  }
}

TEST(Backlash, StaysWhileTheAxisRests) {
  Compensation compensation;
  compensation.SetBacklash({20, 0, true});
  compensation.Advance(0, 1000, 0, 5);
  compensation.Advance(1000, 2000, 5, 0);
  EXPECT_EQ(compensation.backlash_error, 20);
  compensation.Advance(2000, 3000, 4, -1);
  EXPECT_EQ(compensation.backlash_error, 0);
}

TEST(Backlash, ChangesByTheGivenPulsesPerMillisecond) {
  for (const Micros cycle : {125, 250, 500, 1000, 4000}) {
    Compensation compensation;
    compensation.SetBacklash({20, 0.5, false});
    auto error_at = [&, now = Micros{0}](Micros instant) mutable {
      for (; now < instant; now += cycle) compensation.Advance(now, now + cycle, 0, -1);
      return compensation.backlash_error;
    };
    // 0.5 pulse/ms until 20 pulses are reached after 40 ms.
    EXPECT_EQ(error_at(4000), -2) << cycle;
    EXPECT_EQ(error_at(36000), -18) << cycle;
    EXPECT_EQ(error_at(40000), -20) << cycle;
    EXPECT_EQ(error_at(48000), -20) << cycle;
  }
}

TEST(Backlash, TurnsRoundInTheMiddleOfAChange) {
  Compensation compensation;
  compensation.SetBacklash({20, 2, true});
  compensation.Advance(0, 4000, 0, 1);
  EXPECT_EQ(compensation.backlash_error, 8);
  compensation.Advance(4000, 5000, 0, -1);
  EXPECT_EQ(compensation.backlash_error, 6);
  compensation.Advance(5000, 8000, 0, -1);
  EXPECT_EQ(compensation.backlash_error, 0);
}

TEST(Backlash, ComesAtOnceWhenTheChangeReachesTheValue) {
  for (const auto& [change, error] : {std::pair{19.0, 19.0}, {20.0, 20.0}, {21.0, 20.0}}) {
    Compensation compensation;
    compensation.SetBacklash({20, change, true});
    compensation.Advance(0, 1000, 0, 1);
    EXPECT_EQ(compensation.backlash_error, error) << change;
  }
  Compensation half;
  half.SetBacklash({20, 20, true});
  half.Advance(0, 500, 0, 1);
  EXPECT_EQ(half.backlash_error, 20);
}

TEST(Backlash, IsGoneAtOnceWhenItIsSwitchedOff) {
  Compensation compensation;
  compensation.SetBacklash({20, 0, true});
  compensation.Advance(0, 1000, 0, 1);
  compensation.SetBacklash({0, 1, true});
  EXPECT_TRUE(compensation.InUse());
  compensation.Advance(1000, 2000, 0, 1);
  EXPECT_EQ(compensation.backlash_error, 0);
  EXPECT_FALSE(compensation.InUse());
}

/// A core whose first axis jogs at 10 pulse/ms from the first tick on.
struct JoggingCore {
  JoggingCore() {
    core.AxisAt(0).ServoOn();
    Profile& profile = ChangeState(core).profiles[0];
    profile.mode = ProfileMode::kJog;
    profile.jog.parameters = {1000000, 1000000, 0};
    profile.jog.velocity = 10;
    core.ProfileAt(0).Start();
  }
  void Reverse() {
    ChangeState(core).profiles[0].jog.velocity = -10;
    core.ProfileAt(0).Start();
  }
  void Ticks(int count) {
    for (int i = 0; i < count; ++i) core.Tick();
  }
  /// The distance from the planned position to the motor.
  double Lead() const {
    return core.state().plants[0].position - core.state().axes[0].profile.position;
  }

  MotionCore core{{.axis_count = 4, .cycle_us = 1000}};
};

TEST(CompensatedAxis, GivesTheDriveMoreThanIsPlanned) {
  JoggingCore jog;
  jog.core.AxisAt(0).SetBacklash({7, 0, true});
  jog.Ticks(10);
  EXPECT_NEAR(jog.Lead(), 7, 1e-9);
  EXPECT_NEAR(jog.core.state().profiles[0].now.position, 100, 0.01);
  jog.Reverse();
  jog.Ticks(10);
  EXPECT_NEAR(jog.Lead(), 0, 1e-9);
}

TEST(CompensatedAxis, FollowsThePitchTable) {
  JoggingCore jog;
  jog.core.AxisAt(0).SetPitchTable(
      std::make_shared<const PitchTable>(PitchTable{50, 100, {0, 40}, {9, 9}}));
  jog.core.AxisAt(0).EnablePitchCompensation(true);
  jog.Ticks(5);
  jog.Ticks(5);
  // At 100 the correction is half of 40.
  EXPECT_NEAR(jog.Lead(), 20, 0.01);
  jog.Reverse();
  jog.Ticks(2);
  EXPECT_NEAR(jog.Lead(), 9, 1e-9);
  jog.core.AxisAt(0).EnablePitchCompensation(false);
  jog.Ticks(1);
  EXPECT_NEAR(jog.Lead(), 0, 1e-9);
  EXPECT_FALSE(jog.core.state().compensates);
}

TEST(CompensatedAxis, HasNoFollowingErrorFromIt) {
  JoggingCore jog;
  jog.core.ControlAt(0).SetErrorLimit(5);
  jog.core.AxisAt(0).SetBacklash({1000, 0, true});
  jog.Ticks(10);
  EXPECT_FALSE(jog.core.FollowingErrorExceeded(0));
  EXPECT_EQ(jog.core.Conditions(0) & kFollowingErrorBit, 0u);
}

TEST(CompensatedAxis, DoesNotJumpWhenItIsEnabledAgain) {
  JoggingCore jog;
  jog.core.AxisAt(0).SetBacklash({1000, 0, true});
  jog.Ticks(10);
  jog.core.AxisAt(0).ServoOff();
  jog.Ticks(10);
  const double motor = jog.core.state().plants[0].position;
  jog.core.AxisAt(0).ServoOn();
  jog.Ticks(1);
  EXPECT_EQ(jog.core.state().plants[0].position, motor);
}

TEST(CompensatedAxis, DoesNotJumpWhenAClosedLoopIsEnabled) {
  JoggingCore jog;
  jog.core.AxisAt(0).SetBacklash({1000, 0, true});
  jog.Ticks(10);
  jog.core.AxisAt(0).ServoOff();
  jog.Ticks(10);
  jog.core.AxisAt(0).SetClosedLoop(true);
  const double motor = jog.core.state().plants[0].position;
  jog.core.AxisAt(0).ServoOn();
  jog.Ticks(1);
  EXPECT_NEAR(jog.core.state().plants[0].position, motor, 1);
}

TEST(CompensatedAxis, RenamingItsPositionsMovesNothing) {
  for (const bool closed : {false, true}) {
    for (const bool zero : {false, true}) {
      JoggingCore jog;
      MotionCore& core = jog.core;
      if (closed) {
        core.AxisAt(0).ServoOff();
        core.ConnectDrive(0, VelocityDrive(100, 2, 0, 0.125));
        ChangeState(core).controls[0].sets[0] = {.kp = 20};
        core.AxisAt(0).SetClosedLoop(true);
        core.AxisAt(0).ServoOn();
        core.ProfileAt(0).Start();
      }
      core.AxisAt(0).SetBacklash({300, 0, true});
      // Another error at every position: 500 at 0, 0 at 1000.
      core.AxisAt(0).SetPitchTable(
          std::make_shared<const PitchTable>(PitchTable{0, 1000, {500, 0}, {500, 0}}));
      core.AxisAt(0).EnablePitchCompensation(true);
      jog.Ticks(40);
      core.ProfileAt(0).Stop(true);
      jog.Ticks(400);
      const double motor = core.state().plants[0].position;
      ASSERT_NEAR(motor, 400 + 300 + 300, 5);
      if (zero) {
        core.AxisAt(0).ZeroPosition();
        EXPECT_EQ(core.state().axes[0].profile.position, 0);
        EXPECT_EQ(core.state().axes[0].encoder.position, 0);
      } else {
        core.AxisAt(0).SynchPosition();
      }
      EXPECT_EQ(core.state().plants[0].position, motor);
      jog.Ticks(400);
      EXPECT_NEAR(core.state().plants[0].position, motor, 2) << closed << zero;
      EXPECT_NEAR(core.state().axes[0].encoder.position, zero ? 0 : motor, 2) << closed << zero;
      // Afterwards the backlash is output as before.
      jog.Reverse();
      jog.Ticks(2);
      core.ProfileAt(0).Stop(true);
      jog.Ticks(400);
      EXPECT_NEAR(core.state().compensations[0].backlash_error, 0, 1e-9);
      EXPECT_LT(core.state().plants[0].position, motor - 290) << closed << zero;
    }
  }
}

TEST(CompensatedAxis, ForgetsEverythingAtReset) {
  JoggingCore jog;
  jog.core.AxisAt(0).SetBacklash({1000, 0, true});
  jog.Ticks(10);
  jog.core.Reset();
  EXPECT_EQ(jog.core.state().compensations[0].Amount(), 0);
  EXPECT_FALSE(jog.core.state().compensates);
}

}  // namespace
}  // namespace oncard::motion
