// What the handles of a core keep true of the registers that they write.
#include <gtest/gtest.h>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

namespace oncard::motion {
namespace {

// --- Axes --------------------------------------------------------------------------------------

TEST(AxisHandle, ClearsOnlyTheConditionsItIsGiven) {
  MotionCore core({});
  ChangeState(core).axes[0].latched = kPositiveLimitBit | kNegativeLimitBit;
  core.AxisAt(0).ClearConditions(kPositiveLimitBit);
  EXPECT_EQ(core.axis(0).latched, kNegativeLimitBit);
}

TEST(AxisHandle, KeepsAConditionWhoseCauseExists) {
  MotionCore core({});
  core.ProfileAt(0).SetPosition(150);
  core.AxisAt(0).SynchPosition();
  core.AxisAt(0).SetSoftLimits(100, -100);
  core.Tick();
  core.AxisAt(0).ClearConditions(kPositiveLimitBit);
  EXPECT_EQ(core.axis(0).latched, kPositiveLimitBit);
  core.AxisAt(0).SetSoftLimits(200, -100);
  core.AxisAt(0).ClearConditions(kPositiveLimitBit);
  EXPECT_EQ(core.axis(0).latched, 0u);
}

TEST(AxisHandle, LatchesWhatItsOwnerKeepsAndWhatHasACause) {
  MotionCore core({});
  core.ProfileAt(0).SetPosition(150);
  core.AxisAt(0).SynchPosition();
  core.AxisAt(0).SetSoftLimits(100, -100);
  ChangeState(core).axes[0].latched = kAlarmBit;
  core.AxisAt(0).LatchConditions(kNegativeLimitBit);
  EXPECT_EQ(core.axis(0).latched, kPositiveLimitBit | kNegativeLimitBit);
}

TEST(AxisHandle, NewMapsSetThePositionsToTheMappedSums) {
  MotionCore core({});
  core.ProfileAt(0).SetPosition(100);  // the axis keeps its position, 0
  core.ProfileAt(1).SetPosition(40);
  const AxisMaps old = {.profiles = 0b01, .encoders = 0b01};
  core.AxisAt(0).SetMaps(old);
  EXPECT_EQ(core.axis(0).profile.position, 0) << "nothing is new";
  core.AxisAt(0).SetMaps({.profiles = 0b11, .encoders = 0b01, .profile_scale = {2, 1}});
  EXPECT_EQ(core.axis(0).profile.position, 70);
  core.AxisAt(0).SetMaps(old);
  EXPECT_EQ(core.axis(0).profile.position, 100);
}

TEST(AxisHandle, ABandIsJudgedOnceItHasBeenSet) {
  MotionCore core({});
  core.Tick();
  EXPECT_EQ(core.Conditions(0) & kInPositionBit, 0u);
  core.AxisAt(0).SetBand(5, 500);
  for (int i = 0; i < 2; ++i) core.Tick();
  EXPECT_EQ(core.Conditions(0) & kInPositionBit, 0u) << "not for 500 us yet";
  core.Tick();
  EXPECT_EQ(core.Conditions(0) & kInPositionBit, kInPositionBit);
}

TEST(AxisHandle, AFilterBeginsWithTheCurrentVelocity) {
  MotionCore core({});
  core.ProfileAt(0).SelectMode(ProfileMode::kJog);
  core.ProfileAt(0).SetParameters(JogParameters{.acc = 1000});
  core.ProfileAt(0).SetVelocity(8);
  core.ProfileAt(0).Start();
  for (int i = 0; i < 4; ++i) core.Tick();
  core.AxisAt(0).SetProfileVelocityFilter(2);
  EXPECT_EQ(core.axis(0).profile.FilteredVelocity(), 8);
  core.ProfileAt(0).StopWith(1e9);
  core.Tick();
  // One of the four velocities is 0.
  EXPECT_EQ(core.axis(0).profile.FilteredVelocity(), 6);
}

// --- Profiles ----------------------------------------------------------------------------------

TEST(ProfileHandle, TheVelocityIsThatOfTheSelectedMode) {
  MotionCore core({});
  core.ProfileAt(0).SetVelocity(3);
  core.ProfileAt(0).SelectMode(ProfileMode::kJog);
  core.ProfileAt(0).SetVelocity(-4);
  EXPECT_EQ(core.profile(0).trap.velocity, 3);
  EXPECT_EQ(core.profile(0).jog.velocity, -4);
}

TEST(ProfileHandle, StopsWithTheDecelerationsOfItsRegisters) {
  for (const bool abrupt : {false, true}) {
    MotionCore core({});
    const ProfileHandle profile = core.ProfileAt(0);
    profile.SelectMode(ProfileMode::kJog);
    profile.SetParameters(JogParameters{.acc = 1000});
    profile.SetVelocity(10);
    profile.Start();
    core.Tick();
    profile.SetStopDecelerations(2, 8);
    profile.Stop(abrupt);
    // 10 pulse/ms at 2 or 8 pulse/ms^2: 5 or 1.25 ms of four cycles each.
    int cycles = 0;
    for (; core.profile(0).now.moving; ++cycles) core.Tick();
    EXPECT_EQ(cycles, abrupt ? 5 : 20);
  }
}

// --- Drives ------------------------------------------------------------------------------------

TEST(DacHandle, TheLoopOfItsControllerIsClosedAsLongAsItBelongsToIt) {
  MotionCore core({});
  core.DacAt(2).GiveTo(1);
  EXPECT_TRUE(core.state().controls[1].closed);
  EXPECT_EQ(core.state().dacs[2].control, 1);
  core.ControlAt(1).Configure(true, 1, 1);
  core.DacAt(2).Configure(true, false, 0, 32767);
  EXPECT_FALSE(core.state().controls[1].closed);
  EXPECT_EQ(core.state().dacs[2].control, -1);
}

TEST(DacHandle, AConfiguredOutputBeginsAtZero) {
  MotionCore core({});
  core.DacAt(0).SetValue(500);
  core.DacAt(0).Configure(true, true, 20, 300);
  EXPECT_EQ(core.state().dacs[0].Output(), 20);
  core.DacAt(0).SetValue(500);
  EXPECT_EQ(core.state().dacs[0].Output(), 300);
}

TEST(ControlHandle, ASwitchedCheckBeginsAnew) {
  MotionCore core({});
  core.ControlAt(0).SetResponseCheck(100, 2, 750);
  ChangeState(core).controls[0].check.silent = true;
  core.ControlAt(0).SwitchResponseCheck(true);
  const ResponseCheck& check = core.state().controls[0].check;
  EXPECT_TRUE(check.on);
  EXPECT_FALSE(check.silent);
  EXPECT_EQ(check.time, 750);
}

TEST(EncoderHandle, AConfiguredEncoderIsWiredForItsSense) {
  for (const bool reversed : {false, true}) {
    MotionCore core({});
    core.EncoderAt(0).Configure(true, reversed, true);
    core.PlaceMotor(0, 50);
    ChangeState(core).plants[0].hand = 4;
    core.Tick();
    EXPECT_EQ(core.encoder(0).position, 1) << "in the direction of motion";
    core.EncoderAt(0).SetSense(!reversed);
    core.Tick();
    EXPECT_EQ(core.encoder(0).position, 0) << "against it, from the same position";
  }
}

// --- Coordinate systems ------------------------------------------------------------------------

TEST(CrdDriver, APlannerBeginsWhereTheFifoEnds) {
  MotionCore core({});
  core.ProfileAt(0).SetPosition(30);
  core.CrdAt(0).SetUp(
      {.dimension = 1, .coordinates = {1}, .velocity_max = 10, .acceleration_max = 1});
  core.CrdAt(0).BeginLookAhead(0, 1, 1, 10);
  core.CrdAt(0).BeginPlanner(0, PathLimits{}, 20);
  const CrdFifo& fifo = core.state().crds[0].fifos[0];
  EXPECT_EQ(fifo.tail[0], 0) << "the origin is where the profile was";
  EXPECT_TRUE(fifo.plans_axes());
  EXPECT_EQ(fifo.planner->capacity, 20u);
  core.CrdAt(0).SetTail(0, {7});
  core.CrdAt(0).BeginVirtualRun(0, {5});
  EXPECT_EQ(fifo.Tail()[0], 5);
  EXPECT_EQ(fifo.tail[0], 7);
  core.CrdAt(0).DropPlanners();
  EXPECT_EQ(fifo.Tail()[0], 7);
}

// --- The whole ---------------------------------------------------------------------------------

TEST(MotionCore, ContinuesFromACopyOfItsState) {
  MotionCore core({});
  core.ProfileAt(0).SelectMode(ProfileMode::kJog);
  core.ProfileAt(0).SetVelocity(5);
  core.ProfileAt(0).Start();
  core.Advance(100);
  const MotionState copy = core.state();
  core.Advance(100);
  const uint64_t later = core.Hash();
  core.Restore(copy);
  EXPECT_EQ(core.cycle(), 100);
  EXPECT_NE(core.Hash(), later);
  core.Advance(100);
  EXPECT_EQ(core.Hash(), later);
}

}  // namespace
}  // namespace oncard::motion
