// Axes of a card with drives on a bus, and the bus itself.
#include "motion/bus_axes.h"

#include <gtest/gtest.h>

#include "tests/motion/bus/bus_card.h"

namespace oncard::motion::bus {
namespace {

constexpr size_t kX = 0;

void Jog(BusCard& card, double velocity, size_t axis = kX) {
  Profile& profile = card.core.state().profiles[axis];
  profile.mode = ProfileMode::kJog;
  profile.jog.velocity = velocity;
  profile.jog.parameters = {.acc = 1, .dec = 1};
  profile.Start(card.core.now());
}

TEST(Bus, ReachesOpInFourStepsOf50Ms) {
  BusCard card({FullDrive(0)});
  card.Power();
  EXPECT_EQ(card.bus().phase(), BusPhase::kDown);
  EXPECT_EQ(card.bus().Init(card.core.now()), InitOutcome::kDone);
  for (const BusPhase phase :
       {BusPhase::kInit, BusPhase::kPreOp, BusPhase::kSafeOp, BusPhase::kOp}) {
    EXPECT_EQ(card.bus().phase(), phase);
    card.Ticks(199);
    EXPECT_EQ(card.bus().phase(), phase);
    EXPECT_EQ(card.bus().ready(), phase == BusPhase::kOp);
    card.Ticks(1);
  }
}

TEST(Bus, InitSaysWhyItDoesNotBegin) {
  const auto drive = std::make_shared<const Slaves>(Slaves{FullDrive(0)});
  const auto none = std::make_shared<const Slaves>();
  EXPECT_EQ(Bus(nullptr, drive).Init(0), InitOutcome::kNoConfiguration);
  EXPECT_EQ(Bus(drive, none).Init(0), InitOutcome::kNoSlaves);
  const auto two = std::make_shared<const Slaves>(Slaves{FullDrive(0), FullDrive(1)});
  EXPECT_EQ(Bus(two, drive).Init(0), InitOutcome::kDifferent);
}

TEST(Bus, ALostSlaveTakesThoseBehindItWithIt) {
  BusCard card({FullDrive(0), FullDrive(1), DefaultSlave(SlaveKind::kIo)});
  card.Power({{100'000, WorldEventKind::kBusLost, 1, 0, 1}});
  card.Ticks(401);
  EXPECT_TRUE(card.bus().Online(0));
  EXPECT_FALSE(card.bus().Online(1));
  EXPECT_FALSE(card.bus().Online(2));
}

TEST(BusAxes, ALostSlaveRaisesTheAlarmAndStopsItsAxis) {
  BusCard card({FullDrive(0), FullDrive(1)});
  card.Power({{300'000, WorldEventKind::kBusLost, 1, 0, 1}});
  card.Enable(2);
  Jog(card, 10, 0);
  Jog(card, 10, 1);
  while (card.core.now() <= 300'000) card.Ticks(1);
  card.Ticks(2);
  EXPECT_FALSE(card.bus().ready());
  EXPECT_NE(card.axis(1).latched & kAlarmBit, 0u);
  EXPECT_FALSE(card.axis(1).servo_on);
  EXPECT_FALSE(card.core.state().profiles[1].now.moving);
  EXPECT_EQ(card.motor(1).velocity, 0);
  EXPECT_TRUE(card.axis(0).servo_on);
  EXPECT_NEAR(card.motor(0).velocity, 10, 2);
}

TEST(BusAxes, ASlaveWithAWrongWorkingCounterIsOnlineButRaisesTheAlarm) {
  BusCard card({FullDrive(0)});
  card.Power({{300'000, WorldEventKind::kBusSilent, 0, 0, 1}});
  card.Enable();
  while (card.core.now() <= 300'000) card.Ticks(1);
  card.Ticks(2);
  EXPECT_TRUE(card.bus().Online(0));
  EXPECT_FALSE(card.bus().ready());
  EXPECT_NE(card.axis().latched & kAlarmBit, 0u);
}

TEST(BusAxes, AFaultIsResetByClearingTheStatus) {
  BusCard card({FullDrive(0)});
  card.Power();
  card.Enable();
  card.drive().LoseBus();
  card.Ticks(2);
  EXPECT_NE(card.axis().latched & kAlarmBit, 0u);
  EXPECT_FALSE(card.axis().servo_on);
  card.core.ClearStatus(0);
  card.Ticks(3);
  EXPECT_EQ(card.axis().latched & kAlarmBit, 0u);
  card.core.ServoOn(0);
  card.Ticks(4);
  EXPECT_TRUE(card.axis().servo_on);
}

TEST(BusAxes, NothingMovesBeforeTheStart) {
  BusCard card({FullDrive(0)});
  card.Power();
  card.bus().Init(card.core.now());
  card.Ticks(900);
  card.core.ServoOn(0);
  card.Ticks(20);
  EXPECT_FALSE(card.axis().servo_on);
  EXPECT_EQ(card.drive().state(), DriveState::kSwitchOnDisabled);
  card.bus().Start();
  card.Ticks(4);
  EXPECT_TRUE(card.axis().servo_on);
}

TEST(BusAxes, TheEndOfCommunicationStopsAndDisables) {
  BusCard card({FullDrive(0)});
  card.Power();
  card.Enable();
  Jog(card, 10);
  card.Ticks(100);
  card.core.TerminateBus();
  card.Ticks(1);
  EXPECT_FALSE(card.core.state().profiles[0].now.moving);
  EXPECT_FALSE(card.axis().servo_on);
  EXPECT_EQ(card.motor().velocity, 0);
  EXPECT_EQ(card.axis().latched & kAlarmBit, 0u);
  const double place = card.motor().position;
  card.Enable();
  EXPECT_TRUE(card.axis().servo_on);
  EXPECT_EQ(card.motor().position, place);
}

TEST(BusAxes, AScaleDividesTheCountsOfTheDrive) {
  BusCard card({FullDrive(0)});
  card.Power();
  card.Enable();
  card.core.bus_axes().SetScale(0, 6);
  Jog(card, 10);
  card.Ticks(400);
  const Profile& profile = card.core.state().profiles[0];
  EXPECT_NEAR(card.motor().position, 64 * profile.now.position, 0.5);
  EXPECT_NEAR(card.encoder(), profile.now.position, 0.6);
}

TEST(BusAxes, ADefaultDriveWithoutItsModeInTheProcessDataMovesToo) {
  Slave drive = DefaultSlave(SlaveKind::kDrive);
  drive.axis = 0;
  BusCard card({drive});
  card.Power();
  card.Enable();
  EXPECT_TRUE(card.axis().servo_on);
  Jog(card, 10);
  card.Ticks(400);
  EXPECT_GT(card.encoder(), 900);
}

TEST(BusAxes, ZeroingThePositionMovesNothing) {
  BusCard card({FullDrive(0)});
  card.Power();
  card.Enable();
  Jog(card, 10);
  card.Ticks(400);
  card.core.StopProfile(0, true);
  card.Ticks(8);
  const double place = card.motor().position;
  card.core.ZeroAxis(0);
  card.Ticks(8);
  EXPECT_EQ(card.motor().position, place);
  EXPECT_EQ(card.encoder(), 0);
}

TEST(BusAxes, TheCommunicationOutlivesAReset) {
  BusCard card({FullDrive(0)});
  card.Power();
  card.Enable();
  Jog(card, 10);
  card.Ticks(400);
  card.core.Reset();
  card.Ticks(4);
  EXPECT_TRUE(card.bus().started());
  EXPECT_FALSE(card.axis().servo_on);
  EXPECT_EQ(card.encoder(), 0);
  card.core.ServoOn(0);
  card.Ticks(8);
  EXPECT_TRUE(card.axis().servo_on);
  EXPECT_EQ(card.core.state().profiles[0].now.position, 0);
}

TEST(BusAxes, ACardWithoutABusHasTheHashThatItHadBefore) {
  MotionCore plain({});
  MotionCore with({});
  const auto slaves = std::make_shared<const Slaves>(Slaves{FullDrive(0)});
  with.ConnectBus(slaves, slaves);
  EXPECT_NE(plain.Hash(), with.Hash());
  with.state().bus = {};
  EXPECT_EQ(plain.Hash(), with.Hash());
}

TEST(BusAxes, ACopyOfTheStateContinuesInTheSameWay) {
  BusCard card({FullDrive(0)});
  card.Power();
  card.Enable();
  Jog(card, 10);
  card.Ticks(50);
  const MotionState copy = card.core.state();
  card.Ticks(50);
  const uint64_t end = card.core.Hash();
  card.core.state() = copy;
  card.Ticks(50);
  EXPECT_EQ(card.core.Hash(), end);
  card.core.state() = copy;
  card.core.Advance(50);
  EXPECT_EQ(card.core.Hash(), end);
}

}  // namespace
}  // namespace oncard::motion::bus
