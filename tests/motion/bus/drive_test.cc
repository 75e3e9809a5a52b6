// A drive on the bus in its modes of operation.
#include "motion/bus/drive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/motion/bus/bus_card.h"
#include "tests/motion/change_state.h"

namespace oncard::motion::bus {
namespace {

constexpr int kCyclesPerMs = 4;

class DriveInMode : public ::testing::Test {
 protected:
  DriveInMode() : card_({FullDrive(0)}) {
    card_.Power();
    card_.Enable();
  }
  void Mode(DriveMode mode) {
    card_.core.bus_axes().SetMode(0, mode);
    card_.Ticks(1);
  }
  void Set(ObjectId id, int64_t value) {
    if (!card_.bus().SetOutput(0, id, value)) card_.drive().values().Set(id, value);
  }
  /// The control word for one exchange, as a host writes it.
  void Control(uint16_t word) {
    const std::vector<uint8_t> data = {static_cast<uint8_t>(word), static_cast<uint8_t>(word >> 8)};
    card_.bus().image().WriteByHost(0, data);
    card_.Ticks(1);
  }
  uint16_t status() { return static_cast<uint16_t>(card_.object(ObjectId::kStatusWord)); }

  BusCard card_;
};

TEST_F(DriveInMode, ReachesOperationEnabledInOneTransitionPerCycle) {
  card_.core.AxisAt(0).ServoOff();
  card_.Ticks(8);
  EXPECT_EQ(card_.drive().state(), DriveState::kReadyToSwitchOn);
  card_.core.AxisAt(0).ServoOn();
  card_.Ticks(1);
  EXPECT_EQ(card_.drive().state(), DriveState::kSwitchedOn);
  EXPECT_FALSE(card_.axis().servo_on);
  card_.Ticks(1);
  EXPECT_EQ(card_.drive().state(), DriveState::kOperationEnabled);
  EXPECT_TRUE(card_.axis().servo_on);
}

TEST_F(DriveInMode, FollowsThePlannedPositionInMode8) {
  Profile& profile = ChangeState(card_.core).profiles[0];
  profile.mode = ProfileMode::kJog;
  profile.jog.velocity = 10;
  profile.jog.parameters = {.acc = 1, .dec = 1};
  profile.Start(card_.core.now());
  for (int i = 0; i < 400; ++i) {
    card_.Ticks(1);
    EXPECT_NEAR(card_.motor().position, profile.now.position, 0.5);
    EXPECT_EQ(card_.object(ObjectId::kPositionActual), card_.motor().position);
    EXPECT_EQ(card_.encoder(), card_.motor().position);
  }
  EXPECT_GT(card_.motor().position, 900);
  EXPECT_NE(status() & kStatusFollowsTarget, 0);
}

TEST_F(DriveInMode, TurnsAtTheCommandedVelocityInMode9) {
  Mode(DriveMode::kCyclicVelocity);
  Set(ObjectId::kTargetVelocity, 4000);
  card_.Ticks(1);
  EXPECT_EQ(card_.motor().velocity, 4);
  EXPECT_EQ(card_.object(ObjectId::kVelocityActual), 4000);
  const double begin = card_.motor().position;
  card_.Ticks(10 * kCyclesPerMs);
  EXPECT_NEAR(card_.motor().position - begin, 40, 1e-9);
}

TEST_F(DriveInMode, RampsToTheCommandedVelocityInMode3) {
  Mode(DriveMode::kProfileVelocity);
  Set(ObjectId::kProfileAcceleration, 1'000'000);  // 1 count/ms^2
  Set(ObjectId::kTargetVelocity, 4000);
  card_.Ticks(kCyclesPerMs);
  EXPECT_NEAR(card_.motor().velocity, 1, 1e-9);
  EXPECT_EQ(status() & kStatusTargetReached, 0);
  card_.Ticks(4 * kCyclesPerMs);
  EXPECT_NEAR(card_.motor().velocity, 4, 1e-9);
  EXPECT_NE(status() & kStatusTargetReached, 0);
}

TEST_F(DriveInMode, AcceleratesWithTheTorqueInMode10) {
  card_.core.ConnectDrive(0, VelocityDrive(50, 4, 0, card_.core.config().ServoMs()));
  Mode(DriveMode::kCyclicTorque);
  Set(ObjectId::kTargetTorque, 500);
  card_.Ticks(4 * kCyclesPerMs);
  // One time constant: 25 pulse/ms (1 - 1/e).
  EXPECT_NEAR(card_.motor().velocity, 25 * (1 - std::exp(-1.0)), 0.01);
  EXPECT_EQ(card_.object(ObjectId::kTorqueActual), 500);
  EXPECT_EQ(card_.object(ObjectId::kCurrentActual), 500);
}

TEST_F(DriveInMode, LimitsTheTorque) {
  Set(ObjectId::kMaxTorque, 200);
  Mode(DriveMode::kProfileTorque);
  Set(ObjectId::kTargetTorque, 1000);
  card_.Ticks(100 * kCyclesPerMs);
  EXPECT_NEAR(card_.motor().velocity, 20, 1e-3);
  EXPECT_EQ(card_.object(ObjectId::kTorqueActual), 200);
}

TEST_F(DriveInMode, MovesToASetPointInMode1) {
  Mode(DriveMode::kProfilePosition);
  Set(ObjectId::kTargetPosition, 1000);
  Set(ObjectId::kProfileVelocity, 10'000);
  Control(kControlEnable | kControlNewSetPoint);
  EXPECT_NE(status() & kStatusSetPointAcknowledged, 0);
  EXPECT_EQ(status() & kStatusTargetReached, 0);
  double fastest = 0;
  for (int i = 0; i < 1000; ++i) {
    card_.Ticks(1);
    fastest = std::max(fastest, card_.motor().velocity);
  }
  EXPECT_NEAR(fastest, 10, 1e-9);
  EXPECT_EQ(card_.motor().position, 1000);
  EXPECT_NE(status() & kStatusTargetReached, 0);
}

TEST_F(DriveInMode, KeepsInsideItsSoftwareLimits) {
  Set(ObjectId::kSoftLimitMin, -100);
  Set(ObjectId::kSoftLimitMax, 100);
  Mode(DriveMode::kProfilePosition);
  Set(ObjectId::kTargetPosition, 1000);
  Control(kControlEnable | kControlNewSetPoint);
  card_.Ticks(1000);
  EXPECT_EQ(card_.motor().position, 100);
}

TEST_F(DriveInMode, BrakesInAQuickStopAndIsThenDisabled) {
  Mode(DriveMode::kCyclicVelocity);
  Set(ObjectId::kTargetVelocity, 100'000);
  Set(ObjectId::kQuickStopDeceleration, 100'000'000);  // 100 counts/ms^2
  card_.Ticks(4);
  Control(0x02);
  EXPECT_EQ(card_.drive().state(), DriveState::kQuickStopActive);
  EXPECT_NEAR(card_.motor().velocity, 75, 1e-9);
  for (int i = 0; i < 2; ++i) Control(0x02);
  EXPECT_EQ(card_.drive().state(), DriveState::kQuickStopActive);
  Control(0x02);
  EXPECT_EQ(card_.motor().velocity, 0);
  EXPECT_EQ(card_.drive().state(), DriveState::kSwitchOnDisabled);
}

TEST_F(DriveInMode, HasAFaultWhenItsFollowingErrorIsTooLarge) {
  Set(ObjectId::kErrorWindow, 50);
  Mode(DriveMode::kCyclicVelocity);
  Set(ObjectId::kTargetVelocity, 10'000);
  card_.motor().stalled = true;
  card_.Ticks(21);
  EXPECT_EQ(card_.drive().state(), DriveState::kFaultReactionActive);
  EXPECT_NE(status() & kStatusFollowingError, 0);
  card_.Ticks(2);
  EXPECT_EQ(card_.drive().state(), DriveState::kFault);
  EXPECT_NE(card_.axis().latched & kAlarmBit, 0u);
  EXPECT_FALSE(card_.axis().servo_on);
}

TEST_F(DriveInMode, HoldsItsPositionWhenTheModeChanges) {
  Mode(DriveMode::kCyclicVelocity);
  Set(ObjectId::kTargetVelocity, 8000);
  card_.Ticks(100);
  Set(ObjectId::kTargetVelocity, 0);
  card_.Ticks(2);
  const double place = card_.motor().position;
  for (const DriveMode mode : {DriveMode::kCyclicPosition, DriveMode::kHoming, DriveMode::kNone,
                               DriveMode::kProfilePosition, DriveMode::kCyclicPosition}) {
    Mode(mode);
    card_.Ticks(4);
    EXPECT_EQ(card_.object(ObjectId::kModeDisplay), static_cast<int64_t>(mode));
    EXPECT_NEAR(card_.motor().position, place, 0.5);
  }
}

TEST_F(DriveInMode, ALaggingMotorFollowsWithAnErrorThatVanishesAtRest) {
  card_.core.ConnectDrive(0, VelocityDrive(200, 2, 0, card_.core.config().ServoMs()));
  Profile& profile = ChangeState(card_.core).profiles[0];
  profile.mode = ProfileMode::kJog;
  profile.jog.velocity = 10;
  profile.jog.parameters = {.acc = 1, .dec = 1};
  profile.Start(card_.core.now());
  card_.Ticks(400);
  EXPECT_NE(card_.object(ObjectId::kFollowingError), 0);
  profile.Stop(card_.core.now(), 1);
  card_.Ticks(400);
  EXPECT_NEAR(card_.motor().position, profile.now.position, 0.6);
}

TEST_F(DriveInMode, AMotorThatIsOffIsTurnedByHand) {
  card_.core.AxisAt(0).ServoOff();
  card_.Ticks(4);
  card_.motor().hand = 2;
  card_.Ticks(40);
  EXPECT_EQ(card_.encoder(), 20);
}

TEST(Ramp, ArrivesWithoutPassingTheTarget) {
  for (const double speed : {0.3, 5.0, 1000.0}) {
    for (const double acceleration : {0.01, 1.0, 500.0}) {
      for (const double target : {1.0, -17.5, 12'345.0}) {
        Ramp ramp;
        int cycles = 0;
        while (!ramp.TowardsPosition(target, speed, acceleration, 0.25) && ++cycles < 1'000'000) {
          EXPECT_LE(std::fabs(ramp.velocity), speed * (1 + 1e-12));
          EXPECT_LE(std::fabs(ramp.position), std::fabs(target) + speed * 0.25 + 1e-6);
        }
        EXPECT_EQ(ramp.position, target) << speed << " " << acceleration;
        EXPECT_EQ(ramp.velocity, 0);
      }
    }
  }
}

}  // namespace
}  // namespace oncard::motion::bus
