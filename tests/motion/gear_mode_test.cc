// Electronic gear (motion/profiles/gear_mode.h): the clutch, ratio changes, directions, events, and
// the order of master and slave within a cycle.
#include "motion/profiles/gear_mode.h"

#include <gtest/gtest.h>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/slave_axes.h"

namespace oncard::motion {
namespace {

class GearTest : public ::testing::Test {
 protected:
  explicit GearTest(int64_t cycle_us = 250) : core_({.axis_count = 8, .cycle_us = cycle_us}) {}

  Profile& profile(size_t index) { return ChangeState(core_).profiles[index]; }

  void Jog(size_t index, double acc, double velocity) {
    profile(index).mode = ProfileMode::kJog;
    profile(index).jog.parameters = {acc, acc, 0};
    profile(index).jog.velocity = velocity;
    core_.ProfileAt(index).Start();
  }
  void Gear(size_t slave, size_t master, int32_t master_even, int32_t slave_even, int32_t slope,
            int8_t direction = 0) {
    GearMode& gear = profile(slave).gear;
    profile(slave).mode = ProfileMode::kGear;
    gear.direction = direction;
    gear.master = {true, MasterType::kProfile, static_cast<uint8_t>(master), false};
    gear.master_even = master_even;
    gear.slave_even = slave_even;
    gear.slope = slope;
    core_.ProfileAt(slave).Start();
  }
  void RunTo(double ms) {
    while (core_.now() < static_cast<Micros>(ms * 1000)) core_.Tick();
  }
  const Sample& Slave() { return profile(kSlave).now; }

  MotionCore core_;
};

// Manual example 7-5: the master accelerates at 1 to 100; ratio 2:1 over 100000 pulses of the
// master.
TEST_F(GearTest, ClutchIsLinearInTheMastersDisplacement) {
  Jog(kMaster, 1, 100);
  Gear(kSlave, kMaster, 2, 1, 100000);
  RunTo(100);
  // x = 5000: s = 0.5 / 100000 * x^2 / 2.
  EXPECT_DOUBLE_EQ(Slave().position, 0.25e-5 * 5000 * 5000);
  RunTo(1050);
  EXPECT_NEAR(Slave().position, 25000, 1e-6);
  EXPECT_NEAR(Slave().velocity, 50, 1e-9);
  RunTo(1060);
  EXPECT_NEAR(Slave().position, 25500, 1e-6);
  EXPECT_DOUBLE_EQ(Slave().velocity, 50);
}

TEST_F(GearTest, WithoutAClutchTheRatioHoldsAtOnce) {
  Jog(kMaster, 1, 10);
  RunTo(20);
  Gear(kSlave, kMaster, 4, 3, 0);
  const double begin = profile(kMaster).now.position;
  RunTo(50);
  EXPECT_DOUBLE_EQ(Slave().position, (profile(kMaster).now.position - begin) * 0.75);
  EXPECT_DOUBLE_EQ(Slave().velocity, 7.5);
}

TEST_F(GearTest, ARatioChangedInMotionStartsANewClutch) {
  Jog(kMaster, 10, 10);
  Gear(kSlave, kMaster, 4, 3, 0);
  RunTo(100);
  const double before = Slave().position;
  GearMode& gear = profile(kSlave).gear;
  gear.master_even = 2;
  gear.slave_even = 1;
  gear.slope = 100;
  gear.ChangeRatio(Slave());
  RunTo(110);  // 100 pulses of the master: the whole clutch, with the mean ratio
  EXPECT_NEAR(Slave().position, before + 62.5, 1e-9);
  EXPECT_DOUBLE_EQ(Slave().velocity, 5);
}

TEST_F(GearTest, AMasterThatTurnsBackInTheClutchTakesTheRatioBack) {
  Jog(kMaster, 10, 10);
  Gear(kSlave, kMaster, 1, 1, 1000);
  RunTo(51);
  Jog(kMaster, 10, -10);
  RunTo(52);
  while (profile(kMaster).now.position > 0) core_.Tick();
  EXPECT_NEAR(Slave().position, 0, 1e-2);
}

TEST_F(GearTest, AStepBackBeforeTheMoveDoesNotHoldTheClutch) {
  Gear(kSlave, kMaster, 1, 1, 1000);
  Jog(kMaster, 10, -1);
  RunTo(1);
  Jog(kMaster, 10, 100);
  RunTo(100);
  EXPECT_DOUBLE_EQ(Slave().velocity, 100);
}

TEST_F(GearTest, ANewPositionOfTheMasterDoesNotMoveTheSlave) {
  Gear(kSlave, kMaster, 1, 1, 0);
  core_.Tick();
  core_.ProfileAt(kMaster).SetPosition(100000);
  core_.Tick();
  EXPECT_EQ(Slave().position, 0);
}

TEST_F(GearTest, ARatioChangedWhileWaitingBeginsAtZero) {
  GearMode& gear = profile(kSlave).gear;
  gear.event = GearEvent::kPass;
  gear.event_first = 100;
  Jog(kMaster, 10, 10);
  Gear(kSlave, kMaster, 1, 5, 0);
  gear.master_even = 1;
  gear.slave_even = 1;
  gear.slope = 1000;
  gear.ChangeRatio(Slave());
  while (profile(kMaster).now.position < 110) core_.Tick();
  EXPECT_LT(Slave().velocity, 0.2);
}

TEST_F(GearTest, ADirectionFollowsOnlyOneWay) {
  Jog(kMaster, 10, 10);
  Gear(kSlave, kMaster, 1, 1, 0, -1);
  RunTo(50);
  EXPECT_EQ(Slave().position, 0);
  EXPECT_EQ(Slave().velocity, 0);
  Jog(kMaster, 10, -10);
  RunTo(100);
  EXPECT_LT(Slave().position, -450);
  EXPECT_DOUBLE_EQ(Slave().velocity, -10);
}

TEST_F(GearTest, TheSlaveMovesWhileTheMasterRests) {
  Gear(kSlave, kMaster, 1, 1, 0);
  core_.Tick();
  EXPECT_TRUE(Slave().moving);
}

TEST_F(GearTest, AStopLeavesTheGear) {
  Jog(kMaster, 10, 10);
  Gear(kSlave, kMaster, 1, 1, 0);
  RunTo(50);
  core_.ProfileAt(kSlave).Stop(true);
  RunTo(60);
  EXPECT_FALSE(Slave().moving);
  const double stopped = Slave().position;
  RunTo(70);
  EXPECT_EQ(Slave().position, stopped);
}

TEST_F(GearTest, HigherSlavesHaveNoLagLowerOnesOneCycle) {
  Jog(3, 10, 10);
  RunTo(10);
  const double begin = profile(3).now.position;
  Gear(5, 3, 1, 1, 0);
  Gear(0, 3, 1, 1, 0);
  RunTo(20);
  EXPECT_DOUBLE_EQ(profile(5).now.position, profile(3).now.position - begin);
  EXPECT_DOUBLE_EQ(profile(0).now.position, profile(3).now.position - begin - 2.5);
}

TEST_F(GearTest, PassEventStartsExactlyAtThePosition) {
  GearMode& gear = profile(kSlave).gear;
  gear.event = GearEvent::kPass;
  gear.event_first = 101;
  Jog(kMaster, 10, 10);
  Gear(kSlave, kMaster, 1, 1, 0);
  RunTo(5);
  EXPECT_EQ(Slave().position, 0);
  RunTo(50);
  EXPECT_NEAR(Slave().position, profile(kMaster).now.position - 101, 1e-9);
}

TEST_F(GearTest, AreaEventStartsAtTheAreasEdge) {
  GearMode& gear = profile(kSlave).gear;
  gear.event = GearEvent::kArea;
  gear.event_first = 300;
  gear.event_last = 200;
  Jog(kMaster, 10, 10);
  Gear(kSlave, kMaster, 1, 1, 0);
  RunTo(50);
  EXPECT_NEAR(Slave().position, profile(kMaster).now.position - 200, 1e-9);
}

TEST_F(GearTest, AnEncoderIsReadAsOfTheCycleBefore) {
  core_.AxisAt(kMaster).ServoOn();
  Jog(kMaster, 10, 10);
  GearMode& gear = profile(kSlave).gear;
  profile(kSlave).mode = ProfileMode::kGear;
  gear.master = {true, MasterType::kEncoder, kMaster, false};
  core_.ProfileAt(kSlave).Start();
  RunTo(100);
  const double before = core_.state().encoders[kMaster].position;
  core_.Tick();
  EXPECT_EQ(Slave().position, before);
}

class GearCycleTest : public GearTest, public ::testing::WithParamInterface<int64_t> {
 protected:
  GearCycleTest() : GearTest(GetParam()) {}
};

TEST_P(GearCycleTest, ValuesDoNotDependOnTheCycle) {
  Jog(kMaster, 1, 100);
  Gear(kSlave, kMaster, 2, 1, 100000);
  RunTo(600);
  // x = 5000 + 500 * 100.
  EXPECT_NEAR(Slave().position, 0.25e-5 * 55000.0 * 55000.0, 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Cycles, GearCycleTest, ::testing::Values(125, 250, 500, 1000, 2000, 4000));

}  // namespace
}  // namespace oncard::motion
