// Axes of a card with drives on a bus, and the bus itself.
#include "motion/bus_axes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "tests/motion/bus/bus_card.h"
#include "tests/motion/change_state.h"

namespace oncard::motion::bus {
namespace {

constexpr size_t kX = 0;

void Jog(BusCard& card, double velocity, size_t axis = kX) {
  Profile& profile = ChangeState(card.core).profiles[axis];
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
  card.core.AxisAt(0).ClearStatus();
  card.Ticks(3);
  EXPECT_EQ(card.axis().latched & kAlarmBit, 0u);
  card.core.AxisAt(0).ServoOn();
  card.Ticks(4);
  EXPECT_TRUE(card.axis().servo_on);
}

TEST(BusAxes, NothingMovesBeforeTheStart) {
  BusCard card({FullDrive(0)});
  card.Power();
  card.bus().Init(card.core.now());
  card.Ticks(900);
  card.core.AxisAt(0).ServoOn();
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
  card.core.ProfileAt(0).Stop(true);
  card.Ticks(8);
  const double place = card.motor().position;
  card.core.AxisAt(0).ZeroPosition();
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
  card.core.AxisAt(0).ServoOn();
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
  ChangeState(with).bus = {};
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
  ChangeState(card.core) = copy;
  card.Ticks(50);
  EXPECT_EQ(card.core.Hash(), end);
  ChangeState(card.core) = copy;
  card.core.Advance(50);
  EXPECT_EQ(card.core.Hash(), end);
}

// --- Cycles that only move drives
// ------------------------------------------------------------------

/// What makes the next cycle do something else than move drives.
struct Disturbance {
  const char* name;
  void (*cause)(BusCard& card);
};

constexpr Disturbance kDisturbances[] = {
    {"the bus ends", [](BusCard& card) { card.bus().Terminate(); }},
    {"the bus begins again", [](BusCard& card) { card.bus().Init(card.core.now()); }},
    {"a slave is lost", [](BusCard& card) { card.bus().slave(0).lost = true; }},
    {"a drive is silent", [](BusCard& card) { card.bus().slave(1).silent = true; }},
    {"a drive has a fault", [](BusCard& card) { card.drive(1).LoseBus(); }},
    {"a fault is reset", [](BusCard& card) { card.link(1).resets_fault = true; }},
    {"an axis is switched off", [](BusCard& card) { card.link().enable = false; }},
    {"another mode",
     [](BusCard& card) { card.core.bus_axes().SetMode(kX, DriveMode::kCyclicVelocity); }},
    {"another mode, by the mailbox",
     [](BusCard& card) { card.drive().values().Set(ObjectId::kMode, 9); }},
    {"homing begins", [](BusCard& card) { card.core.bus_axes().StartHoming(kX); }},
    {"another output",
     [](BusCard& card) { card.bus().SetOutput(kX, ObjectId::kTargetVelocity, 7); }},
    {"a probe is enabled",
     [](BusCard& card) {
       card.bus().SetOutput(kX, ObjectId::kProbeFunction, kProbeEnable);
       card.drive().values().Set(ObjectId::kProbeFunction, kProbeEnable);
     }},
    {"a host writes the image",
     [](BusCard& card) {
       const std::array<uint8_t, 1> control = {kControlEnable};
       card.bus().image().WriteByHost(card.bus().place(kX).outputs, control);
     }},
    {"another control word",
     [](BusCard& card) { card.bus().SetOutput(kX, ObjectId::kControlWord, kControlShutdown); }},
    {"another control word, by the mailbox",
     [](BusCard& card) { card.drive().values().Set(ObjectId::kControlWord, kControlShutdown); }},
    {"a motor is blocked", [](BusCard& card) { card.motor().stalled = true; }},
    {"a motor is moved", [](BusCard& card) { card.motor().position += 7; }},
    {"a motor that is off is turned by hand", [](BusCard& card) { card.motor(2).hand = 1; }},
    {"a motor that is off is moved", [](BusCard& card) { card.motor(2).position += 0.25; }},
    {"a pin changes",
     [](BusCard& card) { card.core.digital_io().SetPin(DiType::kHome, kX, true); }},
    {"a switch operates",
     [](BusCard& card) {
       card.core.AddSwitch({.axis = kX, .type = DiType::kHome, .first = -1e6, .last = 1e6});
     }},
    {"the axis has not yet followed", [](BusCard& card) { card.link().follows = false; }},
    {"the axis is not yet enabled", [](BusCard& card) { card.axis(1).servo_on = false; }},
    {"an alarm ends", [](BusCard& card) { card.link(1).alarm = true; }},
};

TEST(BusAxes, OnlyMoveUnlessSomethingElseHappens) {
  for (const Disturbance& disturbance : kDisturbances) {
    SCOPED_TRACE(disturbance.name);
    BusCard card({FullDrive(0), FullDrive(1), FullDrive(2)});
    card.Power();
    card.Enable(2);
    Jog(card, 10);
    card.Ticks(20);
    EXPECT_TRUE(card.core.bus_axes().OnlyMove());
    disturbance.cause(card);
    EXPECT_FALSE(card.core.bus_axes().OnlyMove());
  }
}

/// Process data with which a cycle does something else than lanes can do.
struct OddData {
  const char* name;
  void (*change)(Slave& drive);
};

constexpr OddData kOddData[] = {
    {"no control word",
     [](Slave& drive) {
       drive.outputs[0] = {0, 0, 16};
     }},
    {"no target position",
     [](Slave& drive) {
       drive.outputs[1] = {0, 0, 32};
     }},
    {"a short target position", [](Slave& drive) { drive.outputs[1].bits = 24; }},
    {"two target positions", [](Slave& drive) { drive.outputs.push_back(drive.outputs[1]); }},
    {"no status word",
     [](Slave& drive) {
       drive.inputs[0] = {0, 0, 16};
     }},
    {"no measured position",
     [](Slave& drive) {
       drive.inputs[1] = {0, 0, 32};
     }},
    {"a short measured position", [](Slave& drive) { drive.inputs[1].bits = 24; }},
};

TEST(BusAxes, OnlyMoveWithWholePositionsAndBothWordsInTheProcessData) {
  for (const OddData& data : kOddData) {
    SCOPED_TRACE(data.name);
    Slave odd = FullDrive(0);
    data.change(odd);
    BusCard card({odd});
    card.Power();
    card.Enable();
    EXPECT_FALSE(card.core.bus_axes().OnlyMove());
  }
}

TEST(BusAxes, OnlyMoveIfNoOtherDriveMovesTheMotorOfAnAxis) {
  BusCard card({FullDrive(0), FullDrive(0)});
  card.Power();
  card.Enable();
  EXPECT_FALSE(card.core.bus_axes().OnlyMove());
}

}  // namespace
}  // namespace oncard::motion::bus
