// Electronic gear (motion/profiles/gear_mode.h): the clutch, ratio changes, directions, events, and
// the order of master and slave within a cycle.
#include "motion/profiles/gear_mode.h"

#include <gtest/gtest.h>

#include <limits>

#include "motion/common/state_hash.h"
#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/slave_axes.h"

namespace oncard::motion {
namespace {

class GearTest : public ::testing::Test {
 protected:
  explicit GearTest(int64_t cycle_us = 250, const CardDefaults& defaults = {})
      : core_({.axis_count = 8, .cycle_us = cycle_us, .defaults = defaults}) {}

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

// --- A ratio that is one number ----------------------------------------------------------------

/// Slaves come last, and stops take no time.
class DirectGearTest : public GearTest {
 protected:
  DirectGearTest()
      : GearTest(1000, {.abrupt_stop = std::numeric_limits<double>::infinity(),
                        .filter_ticks = 1,
                        .slaves_last = true}) {}

  void Engage(size_t slave, Master master, double ratio) {
    profile(slave).mode = ProfileMode::kGear;
    profile(slave).gear.master = master;
    profile(slave).gear.direct = {true, ratio};
    core_.ProfileAt(slave).Start();
  }
  void Engage(size_t slave, size_t master, double ratio) {
    Engage(slave, {true, MasterType::kProfile, static_cast<uint8_t>(master), false}, ratio);
  }
  void SetLimit(DiType type, bool active) {
    ChangeState(core_).io.SetPin(type, kSlave, active);
    core_.Tick();
  }
  bool Held() { return profile(kSlave).gear.direct.held; }
};

TEST_F(DirectGearTest, TheRatioHoldsFromThePresentPositionOn) {
  Jog(kMaster, 1, 10);
  RunTo(20);
  const double begin = profile(kMaster).now.position;
  Engage(kSlave, kMaster, -1.2345);
  RunTo(50);
  EXPECT_DOUBLE_EQ(Slave().position, (profile(kMaster).now.position - begin) * -1.2345);
  EXPECT_DOUBLE_EQ(Slave().velocity, -12.345);
  EXPECT_TRUE(Slave().moving);
}

TEST_F(DirectGearTest, AnotherRatioInMotionHoldsFromThereOn) {
  Jog(kMaster, 10, 10);
  Engage(kSlave, kMaster, 0.5);
  RunTo(11);  // the master is at 105
  Engage(kSlave, kMaster, 3);
  RunTo(21);
  EXPECT_DOUBLE_EQ(Slave().position, 52.5 + 300);
}

// Ticks of 1 ms at 10 pulse/ms: a slave that lags would be 10 pulses behind.
TEST_F(DirectGearTest, SlavesOfLaterAxesDoNotLag) {
  Jog(5, 10, 10);
  Engage(0, 5, 1);
  Engage(1, 0, 0.5);
  RunTo(10);
  EXPECT_DOUBLE_EQ(profile(5).now.position, 95);
  EXPECT_DOUBLE_EQ(profile(0).now.position, 95);
  EXPECT_DOUBLE_EQ(profile(1).now.position, 47.5);
}

TEST_F(DirectGearTest, ALaterSlaveOfASlaveIsFollowedACycleLater) {
  Jog(5, 10, 10);
  Engage(1, 5, 1);
  Engage(0, 1, 1);
  RunTo(10);
  EXPECT_DOUBLE_EQ(profile(1).now.position, 95);
  EXPECT_DOUBLE_EQ(profile(0).now.position, 85);
}

TEST_F(DirectGearTest, AnAuxiliaryEncoderLeadsAsOfTheCycleBefore) {
  Engage(kSlave, {true, MasterType::kEncoder, kAuxiliaryFirst + 1, false}, 0.25);
  ChangeState(core_).plants[kAuxiliaryFirst + 1].hand = 8;
  RunTo(10);
  EXPECT_DOUBLE_EQ(Slave().position, 18);
}

// The master goes on: what it does towards the limit does not move the slave, what it does away
// from it does, from the first cycle on.
TEST_F(DirectGearTest, ALimitHoldsTheSlaveUntilItsMasterTurns) {
  Jog(kMaster, 10, 10);
  Engage(kSlave, kMaster, 2);
  RunTo(10);
  SetLimit(DiType::kLimitPositive, true);
  const double held = Slave().position;
  EXPECT_EQ(held, 2 * profile(kMaster).now.position);
  EXPECT_TRUE(Held());
  EXPECT_EQ(Slave().velocity, 0);
  RunTo(20);
  EXPECT_EQ(Slave().position, held);
  EXPECT_TRUE(Held());
  Jog(kMaster, 20, -10);  // 10, 0, then -10 pulse/ms: forward by 5, then back by 5
  RunTo(21);
  const double turned = profile(kMaster).now.position;
  EXPECT_EQ(Slave().position, held);
  RunTo(25);
  EXPECT_FALSE(Held());
  EXPECT_DOUBLE_EQ(Slave().position, held + 2 * (profile(kMaster).now.position - turned));
}

TEST_F(DirectGearTest, AnActiveLimitHoldsTheSlaveBeforeItMoves) {
  SetLimit(DiType::kLimitNegative, true);
  Engage(kSlave, kMaster, -1);
  core_.Tick();
  EXPECT_FALSE(Held()) << "nothing leads it anywhere";
  Jog(kMaster, 10, 10);
  RunTo(20);
  EXPECT_EQ(Slave().position, 0);
  EXPECT_TRUE(Held());
}

TEST_F(DirectGearTest, AStopEndsTheGearOfAHeldSlave) {
  SetLimit(DiType::kLimitPositive, true);
  Engage(kSlave, kMaster, 1);
  Jog(kMaster, 10, 10);
  RunTo(5);
  core_.ProfileAt(kSlave).Stop(true);
  EXPECT_FALSE(Slave().moving);
  EXPECT_FALSE(Held());
  Jog(kMaster, 10, -10);
  RunTo(10);
  EXPECT_EQ(Slave().position, 0);
}

// A card that does not use it has the hash of one that does not know it.
TEST(DirectRatio, IsNoPartOfTheHashWithoutAValue) {
  GearMode gear;
  const uint64_t before = StateHash().Add(gear).value();
  gear.direct.value = 2;
  EXPECT_EQ(StateHash().Add(gear).value(), before);
  gear.direct.given = true;
  EXPECT_NE(StateHash().Add(gear).value(), before);
}

}  // namespace
}  // namespace oncard::motion
