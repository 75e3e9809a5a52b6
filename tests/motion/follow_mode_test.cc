// Follow (motion/profiles/follow_mode.h): segment types, passes, events, switching of FIFOs.
#include "motion/profiles/follow_mode.h"

#include <gtest/gtest.h>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/slave_axes.h"

namespace oncard::motion {
namespace {

using enum FollowSegmentType;

class FollowTest : public ::testing::Test {
 protected:
  explicit FollowTest(int64_t cycle_us = 250) : core_({.axis_count = 8, .cycle_us = cycle_us}) {
    profile(kSlave).mode = ProfileMode::kFollow;
    follow().master = {true, MasterType::kProfile, kMaster, false};
  }

  Profile& profile(size_t index) { return ChangeState(core_).profiles[index]; }
  FollowMode& follow() { return profile(kSlave).follow; }
  const Sample& Slave() { return profile(kSlave).now; }
  double Ratio() { return Slave().velocity / profile(kMaster).now.velocity; }

  void Jog(double acc, double velocity) {
    profile(kMaster).mode = ProfileMode::kJog;
    profile(kMaster).jog.parameters = {acc, acc, 0};
    profile(kMaster).jog.velocity = velocity;
    core_.ProfileAt(kMaster).Start();
  }
  void Start(uint8_t fifo = 0) {
    follow().fifo = fifo;
    core_.ProfileAt(kSlave).Start();
  }
  void RunTo(double ms) {
    while (core_.now() < static_cast<Micros>(ms * 1000)) core_.Tick();
  }
  /// Runs until the master reaches a position.
  void RunMasterTo(double position) {
    while (profile(kMaster).now.position < position) core_.Tick();
  }

  MotionCore core_;
};

const std::vector<FollowSegment> kExample77 = {
    {20000, 10000, kNormal}, {40000, 30000, kNormal}, {60000, 40000, kNormal}};

// Manual example 7-7: the master passes 50000 at 1025 ms; 400 ms each of acceleration, constant
// velocity, deceleration; 40000 pulses and 1200 ms per pass.
TEST_F(FollowTest, PassEventAndThreeSegmentsForEver) {
  follow().fifos[0] = kExample77;
  follow().event = FollowEvent::kPass;
  follow().event_position = 50000;
  Jog(1, 50);
  Start();
  RunTo(1025);
  EXPECT_NEAR(Slave().position, 0, 1e-9);
  EXPECT_TRUE(Slave().moving);
  RunTo(1225);  // half of the first segment: ratio 0.5
  EXPECT_NEAR(Slave().velocity, 25, 1e-9);
  EXPECT_NEAR(Slave().position, 2500, 1e-6);
  RunTo(1425);
  EXPECT_NEAR(Slave().velocity, 50, 1e-9);
  EXPECT_NEAR(Slave().position, 10000, 1e-6);
  RunTo(1825);
  EXPECT_NEAR(Slave().position, 30000, 1e-6);
  RunTo(2225);
  EXPECT_NEAR(Slave().position, 40000, 1e-6);
  EXPECT_NEAR(Slave().velocity, 0, 1e-9);
  RunTo(1025 + 10 * 1200 + 200);
  EXPECT_NEAR(Slave().position, 10 * 40000 + 2500, 1e-5);
}

// Manual example 7-6: the table of a flying shear; end ratios 1, then 1, 0.6, 0.6, 1, 1.
TEST_F(FollowTest, ContinueTakesTheRatioOfThePassBefore) {
  follow().fifos[0] = {{5000, 2500, kNormal}};
  follow().fifos[1] = {{1000, 1000, kContinue},
                       {4000, 3400, kNormal},
                       {6000, 4600, kNormal},
                       {9000, 7000, kNormal},
                       {10000, 8000, kNormal}};
  Jog(1000, 10);
  Start();
  follow().switching = true;
  const double begin = profile(kMaster).now.position;
  const auto ratio_at = [&](double master) {
    RunMasterTo(begin + master - 1e-9);
    return Ratio();
  };
  EXPECT_NEAR(ratio_at(5000), 1, 1e-3);
  EXPECT_NEAR(ratio_at(5500), 1, 1e-3);
  EXPECT_NEAR(ratio_at(9000), 0.6, 1e-3);
  EXPECT_NEAR(ratio_at(10500), 0.6, 1e-3);
  EXPECT_NEAR(ratio_at(14000), 1, 1e-3);
  EXPECT_NEAR(ratio_at(14900), 1, 1e-3);
  EXPECT_NEAR(ratio_at(15500), 1, 1e-3);  // the next pass continues at 1
  RunMasterTo(begin + 25000);
  EXPECT_NEAR(Slave().position, 2500 + 16000, 3);
}

// Manual example 7-8 with a START event: the switch is made at the end of the pass and clears the
// previous FIFO.
TEST_F(FollowTest, SwitchHappensAtTheEndOfAPassAndClearsTheFifo) {
  follow().fifos[0] = {{20000, 10000, kNormal}, {40000, 30000, kNormal}, {60000, 40000, kNormal}};
  follow().fifos[1] = {{20000, 10000, kContinue}, {40000, 30000, kNormal}, {60000, 46000, kNormal}};
  Jog(1000, 50);
  Start();
  RunMasterTo(30000);
  follow().switching = true;
  EXPECT_EQ(follow().fifo, 0);
  RunMasterTo(60100);
  EXPECT_EQ(follow().fifo, 1);
  EXPECT_EQ(follow().Space(0), 16u);
  EXPECT_NEAR(Slave().position, 40000, 5);  // CONTINUE begins at the ratio 0 of the first table
  follow().fifos[0] = {{20000, 16000, kContinue}, {40000, 36000, kNormal}, {60000, 52000, kNormal}};
  follow().switching = true;
  RunMasterTo(119900);
  EXPECT_NEAR(Ratio(), 0.6, 1e-2);
  RunMasterTo(120100);
  EXPECT_EQ(follow().fifo, 0);
  EXPECT_NEAR(Ratio(), 0.6, 1e-2);  // 0.6 at the end of the second table
  RunMasterTo(150000);
  EXPECT_NEAR(Ratio(), 1, 1e-2);
  RunMasterTo(179900);
  EXPECT_NEAR(Ratio(), 0.6, 1e-2);
}

TEST_F(FollowTest, EvenAndStopSegments) {
  follow().fifos[0] = {{1000, 500, kEven}, {2000, 1500, kStop}};
  follow().loop = 1;
  Jog(1000, 10);
  Start();
  const double begin = profile(kMaster).now.position;
  RunMasterTo(begin + 600);
  EXPECT_NEAR(Ratio(), 0.5, 1e-9);
  const double x = profile(kMaster).now.position - begin;
  EXPECT_NEAR(Slave().position, x / 2, 1e-9);
  RunMasterTo(begin + 1500);
  EXPECT_NEAR(Ratio(), 2 * (1 - (profile(kMaster).now.position - begin - 1000) / 1000), 1e-9);
}

TEST_F(FollowTest, TheLastPassEndsTheRunAtTheTablesEnd) {
  follow().fifos[0] = {{1000, 500, kEven}};
  follow().loop = 2;
  Jog(1000, 10);
  Start();
  RunMasterTo(2500);
  EXPECT_FALSE(Slave().moving);
  EXPECT_EQ(Slave().position, 1000);
  EXPECT_EQ(Slave().velocity, 0);
}

TEST_F(FollowTest, AMasterThatTurnsBackTakesTheSlaveBack) {
  follow().fifos[0] = kExample77;
  Jog(1000, 50);
  Start();
  RunMasterTo(45000);
  Jog(1000, -50);
  while (profile(kMaster).now.position > 30000) core_.Tick();
  EXPECT_NEAR(Slave().position, 10000 + profile(kMaster).now.position - 20000, 1e-6);
  while (profile(kMaster).now.position > -1000) core_.Tick();
  EXPECT_EQ(Slave().position, 0);
  EXPECT_EQ(Slave().velocity, 0);
}

TEST_F(FollowTest, AFarMasterGoesOverManyPassesAtOnce) {
  follow().fifos[0] = {{1, 2, kNormal}};
  Start();
  const Sample slave = Slave();
  EXPECT_NEAR(follow().At(slave, {1e9 + 0.5, 0, 0}).position, 2e9 + 0.5, 1e-3);
  EXPECT_EQ(follow().passes, 1000000000);
}

TEST_F(FollowTest, AMasterMayGoTheNegativeWay) {
  follow().fifos[0] = {{-1000, 500, kEven}};
  Jog(1000, -10);
  Start();
  RunTo(51);
  EXPECT_NEAR(Slave().position, -profile(kMaster).now.position / 2, 1e-9);
}

class FollowCycleTest : public FollowTest, public ::testing::WithParamInterface<int64_t> {
 protected:
  FollowCycleTest() : FollowTest(GetParam()) {}
};

TEST_P(FollowCycleTest, ValuesDoNotDependOnTheCycle) {
  follow().fifos[0] = kExample77;
  follow().event = FollowEvent::kPass;
  follow().event_position = 50001;
  Jog(1, 50);
  Start();
  RunTo(8000);
  // The master has reached 1250 + 50 * 7950: five passes and 48749 pulses.
  EXPECT_NEAR(Slave().position, 5 * 40000 + 40000 - 11251.0 * 11251.0 / 40000.0, 1e-5);
}
INSTANTIATE_TEST_SUITE_P(Cycles, FollowCycleTest,
                         ::testing::Values(125, 250, 500, 1000, 2000, 4000));

}  // namespace
}  // namespace oncard::motion
