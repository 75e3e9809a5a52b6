// Commands of axes with drives on the EtherCAT bus.
#include <gtest/gtest.h>

#include "tests/gtcalls/bus_command_support.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::WorldEventKind;
using motion::bus::DefaultSlave;
using motion::bus::ObjectId;
using motion::bus::Slave;
using motion::bus::SlaveKind;

constexpr uint32_t kEnabledBit = 1u << 9;
constexpr uint32_t kMovingBit = 1u << 10;
constexpr uint32_t kAlarmBit = 1u << 1;

Slave DefaultDrive() {
  Slave drive = DefaultSlave(SlaveKind::kDrive);
  drive.axis = 0;
  return drive;
}

void StartJog(CommandTestCard& card, int axis = 1) {
  std::vector<double> jog = {1, 1, 0};
  card.Expect(0, "GT_PrfJog", {axis});
  card.Expect(0, "GT_SetJogPrm", {axis, &jog});
  card.Expect(0, "GT_SetVel", {axis, 20});
  card.Expect(0, "GT_Update", {1 << (axis - 1)});
}

TEST(BusAxisCommands, Bit9FollowsOperationEnabled) {
  BusCommandCard card({CompleteDrive(0)});
  card.Up();
  card.Expect(0, "GT_AxisOn", {1});
  EXPECT_EQ(card.Status() & kEnabledBit, 0u);
  card.Cycles(2);
  EXPECT_EQ(card.Status() & kEnabledBit, 0u);
  card.Cycle();
  EXPECT_EQ(card.bus().slave(0).drive->state(), motion::bus::DriveState::kOperationEnabled);
  EXPECT_NE(card.Status() & kEnabledBit, 0u);
  card.Expect(0, "GT_AxisOff", {1});
  EXPECT_EQ(card.Status() & kEnabledBit, 0u);
}

TEST(BusAxisCommands, NothingMovesBeforeTheStart) {
  BusCommandCard card({CompleteDrive(0)});
  const auto refused = [&] {
    card.Expect(1, "GT_AxisOn", {1});
    card.Expect(0, "GT_PrfJog", {1});
    card.Expect(0, "GT_SetVel", {1, 20});
    card.Expect(1, "GT_Update", {1});
  };
  refused();
  card.Expect(0, "GT_InitEcatComm");
  card.Cycles(600);
  refused();
  card.Expect(0, "GT_StartEcatComm");
  card.Expect(0, "GT_AxisOn", {1});
}

TEST(BusAxisCommands, AxesAtTheTerminalsNeedNoBus) {
  BusCommandCard card({CompleteDrive(0)});
  card.Expect(0, "GT_AxisOn", {2});
  StartJog(card, 2);
  card.Cycles(100);
  EXPECT_GT(card.motor(1), 0);
}

TEST(BusAxisCommands, TheProfileIsTheTargetOfTheDrive) {
  BusCommandCard card({CompleteDrive(0)});
  card.Enable();
  StartJog(card);
  card.Cycles(400);
  EXPECT_NEAR(card.Read("GT_GetEcatEncPos", {1}), card.motion.state().profiles[0].now.position, 1);
  EXPECT_NEAR(card.Read("GT_GetEcatEncVel", {1}), 20'000, 4000);
  EXPECT_EQ(card.Read("GT_GetEcatAxisPE", {1}), 0);
  EXPECT_EQ(card.Read("GT_GetEcatAxisMode", {1}), 8);
  EXPECT_NE(card.Status() & kMovingBit, 0u);
}

/// Objects that are not in the process data, one row for each command.
TEST(BusAxisCommands, ReturnOneWithoutTheirObjectInTheProcessData) {
  BusCommandCard card({DefaultDrive()});
  card.Enable();
  std::vector<double> cell(1);
  std::vector<double> a(1), b(1), c(1), d(1);
  card.Expect(1, "GT_GetEcatAxisAI", {1, 1, &cell});
  card.Expect(1, "GT_GetEcatAxisAtlCurrent", {1, &cell});
  card.Expect(1, "GT_GetEcatAxisAtlTorque", {1, &cell});
  card.Expect(0, "GT_GetEcatAxisDI", {1, &cell});
  card.Expect(1, "GT_GetEcatAxisDO", {1, &cell});
  card.Expect(1, "GT_GetEcatAxisMode", {1, &cell});
  card.Expect(1, "GT_GetEcatAxisPE", {1, &cell});
  card.Expect(0, "GT_GetEcatEncPos", {1, &cell});
  card.Expect(1, "GT_GetEcatEncVel", {1, &cell});
  card.Expect(0, "GT_GetEcatHomingStatus", {1, &cell});
  card.Expect(1, "GT_GetTouchProbeStatus", {1, &cell, &a, &b, &c, &d});
  card.Expect(1, "GT_SetEcatAxisDO", {1, 1});
  card.Expect(1, "GT_SetEcatAxisMode", {1, 6});
  card.Expect(1, "GT_SetEcatAxisPT", {1, 10});
  card.Expect(1, "GT_SetEcatAxisPV", {1, 10});
  card.Expect(1, "GT_SetTouchProbeFunction", {1, 0x13});
  card.Expect(1, "GT_SetTouchProbeFunctionEx", {1, 1, 0, 1, 0, 0, 0});
  EXPECT_EQ(card.reason.en,
            "object 60B8h is not in the process data of axis 1: add it to its PDO in the ENI file "
            "or in [[ethercat.slave]]");
}

TEST(BusAxisCommands, OfAnAxisWithoutADriveReturnOne) {
  BusCommandCard card({CompleteDrive(0)});
  card.Up();
  std::vector<double> cell(1);
  card.Expect(1, "GT_GetEcatEncPos", {2, &cell});
  card.Expect(1, "GT_SetHomingMode", {2, 6});
  card.Expect(7, "GT_GetEcatEncPos", {9, &cell});
}

TEST(BusAxisCommands, AModeIsNotChangedWhileTheProfileMoves) {
  BusCommandCard card({CompleteDrive(0)});
  card.Enable();
  StartJog(card);
  card.Cycles(10);
  card.Expect(1, "GT_SetHomingMode", {1, 6});
  card.Expect(1, "GT_SetEcatAxisMode", {1, 9});
  card.Expect(1, "GT_SetPosScale", {1, 3});
  card.Expect(7, "GT_SetEcatAxisMode", {1, 7});
}

TEST(BusAxisCommands, PlannedMotionNeedsMode8) {
  BusCommandCard card({CompleteDrive(0)});
  card.Enable();
  card.Expect(0, "GT_SetEcatAxisMode", {1, 9});
  card.Cycle();
  card.Expect(0, "GT_PrfJog", {1});
  card.Expect(0, "GT_SetVel", {1, 20});
  card.Expect(1, "GT_Update", {1});
  card.Expect(0, "GT_SetEcatAxisPV", {1, 8000});
  card.Cycles(40);
  EXPECT_NEAR(card.motor(), 80, 1e-9);
  card.Expect(0, "GT_SetEcatAxisPV", {1, 0});
  card.Expect(0, "GT_SetEcatAxisMode", {1, 8});
  card.Cycles(4);
  EXPECT_NEAR(card.motor(), 80, 1e-9);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 80);
  card.Expect(0, "GT_Update", {1});
}

TEST(BusAxisCommands, ATorqueTurnsTheMotor) {
  BusCommandCard card({CompleteDrive(0)});
  card.Enable();
  card.Expect(0, "GT_SetEcatAxisMode", {1, 10});
  card.Expect(0, "GT_SetEcatAxisPT", {1, -300});
  card.Cycles(400);
  EXPECT_LT(card.motor(), 0);
  EXPECT_EQ(card.Read("GT_GetEcatAxisAtlTorque", {1}), -300);
  EXPECT_EQ(card.Read("GT_GetEcatAxisAtlCurrent", {1}), -300);
}

TEST(BusAxisCommands, TheScaleDividesCounts) {
  BusCommandCard card({CompleteDrive(0)});
  card.Enable();
  card.Expect(0, "GT_SetPosScale", {1, 6});
  EXPECT_EQ(card.Read("GT_GetPosScale", {1}), 6);
  StartJog(card);
  card.Cycles(400);
  const double planned = card.motion.state().profiles[0].now.position;
  EXPECT_NEAR(card.Read("GT_GetEcatEncPos", {1}), 64 * planned, 1);
  EXPECT_NEAR(card.motion.state().encoders[0].position, planned, 1);
  card.Expect(7, "GT_SetPosScale", {1, 31});
}

/// The manual's example 5-2.
TEST(BusAxisCommands, HomeWithMethod3AsInTheManual) {
  BusCommandCard card({CompleteDrive(0)});
  motion::PositionSwitch home;
  home.first = 20'000;
  home.last = 1e9;
  card.motion.AddSwitch(home);
  card.motion.SetIndexMarks(0, {500, 1000});
  card.Enable();
  card.Expect(0, "GT_SetHomingMode", {1, 6});
  card.Expect(0, "GT_SetEcatHomingPrm", {1, 3, 50, 3, 100'000, 0, 0});
  card.Expect(0, "GT_StartEcatHoming", {1});
  EXPECT_EQ(card.Read("GT_GetEcatHomingStatus", {1}), 0);
  for (int i = 0; i < 100'000 && card.Read("GT_GetEcatHomingStatus", {1}) == 0; ++i) card.Cycle();
  EXPECT_EQ(card.Read("GT_GetEcatHomingStatus", {1}), 3);
  EXPECT_EQ(card.motor(), 19'500);
  EXPECT_EQ(card.Read("GT_GetEcatEncPos", {1}), 0);
  card.Expect(0, "GT_SetHomingMode", {1, 8});
  card.Cycles(4);
  EXPECT_EQ(card.motor(), 19'500);
  EXPECT_EQ(card.Read("GT_GetEcatHomingStatus", {1}), 3);
  card.Expect(0, "GT_ClrSts", {1, 1});
  StartJog(card);
  card.Cycles(40);
  EXPECT_GT(card.motor(), 19'500);
}

/// The same with the numbers of the manual, and as there the status is asked for in every cycle;
/// then homing that is stopped. On cards with any profile cycle, which is that of the bus.
TEST(BusAxisCommands, TheManualsCycleHomesAndStops) {
  for (const int64_t cycle_us : {125, 250, 1000, 4000}) {
    motion::MotionConfig config;
    config.cycle_us = cycle_us;
    BusCommandCard card({CompleteDrive(0)}, {}, config);
    motion::PositionSwitch home;
    home.first = 20'000;
    home.last = 1e9;
    card.motion.AddSwitch(home);
    card.motion.SetIndexMarks(0, {500, 1000});
    card.Enable();
    const int64_t step = (motion::bus::kBusStepUs + cycle_us - 1) / cycle_us;
    EXPECT_EQ(card.motion.now(), (3 * step + 8) * cycle_us);
    card.Expect(0, "GT_SetHomingMode", {1, 6});
    card.Expect(0, "GT_SetEcatHomingPrm", {1, 3, 5000, 3000, 100'000, 0, 0});
    card.Expect(0, "GT_StartEcatHoming", {1});
    for (int i = 0, homed = 0; i < 4000 && homed < 10; ++i) {
      card.Cycle();
      if (card.Read("GT_GetEcatHomingStatus", {1}) != 3) continue;
      ++homed;
      card.Expect(0, "GT_SetHomingMode", {1, 8});
    }
    EXPECT_EQ(card.Read("GT_GetEcatHomingStatus", {1}), 3) << cycle_us;
    EXPECT_EQ(card.motor(), 19'500) << cycle_us;
    EXPECT_EQ(card.motion.state().profiles[0].now.position, 0) << cycle_us;

    card.Expect(0, "GT_SetHomingMode", {1, 6});
    card.Expect(0, "GT_SetEcatHomingPrm", {1, 27, 50, 3, 1, 0, 0});
    card.Expect(0, "GT_StartEcatHoming", {1});
    card.Cycles(static_cast<int>(100'000 / cycle_us));
    EXPECT_NE(card.motion.state().plants[0].velocity, 0) << cycle_us;
    card.Expect(0, "GT_StopEcatHoming", {1});
    card.Expect(0, "GT_SetHomingMode", {1, 8});
    card.Cycles(4);
    EXPECT_EQ(card.motion.state().plants[0].velocity, 0) << cycle_us;
    EXPECT_EQ(card.Read("GT_GetEcatHomingStatus", {1}), 0) << cycle_us;
    EXPECT_EQ(card.motion.state().profiles[0].now.position, card.Read("GT_GetEcatEncPos", {1}))
        << cycle_us;
    EXPECT_EQ(card.Status() & (kEnabledBit | kAlarmBit), kEnabledBit) << cycle_us;
  }
}

TEST(BusAxisCommands, HomingHasThreeConditions) {
  BusCommandCard card({CompleteDrive(0)});
  card.Up();
  card.Expect(1, "GT_StartEcatHoming", {1});
  EXPECT_NE(card.reason.en.find("not enabled"), std::string::npos);
  card.Expect(0, "GT_AxisOn", {1});
  card.Cycles(8);
  card.Expect(1, "GT_StartEcatHoming", {1});
  EXPECT_NE(card.reason.en.find("mode 6"), std::string::npos);
  card.Expect(0, "GT_SetHomingMode", {1, 6});
  card.Expect(1, "GT_StartEcatHoming", {1});
  EXPECT_NE(card.reason.en.find("parameters"), std::string::npos);
  card.Expect(7, "GT_SetEcatHomingPrm", {1, 15, 50, 3, 1, 0, 0});
  card.Expect(0, "GT_SetEcatHomingPrm", {1, 35, 50, 3, 1, 0, 0});
  card.Expect(0, "GT_StartEcatHoming", {1});
}

TEST(BusAxisCommands, HomingWorksThroughTheMailboxToo) {
  BusCommandCard card({DefaultDrive()});
  card.Enable();
  card.Expect(0, "GT_SetHomingMode", {1, 6});
  card.Expect(0, "GT_SetEcatHomingPrm", {1, 34, 50, 3, 1, 25, 0});
  card.Expect(0, "GT_StartEcatHoming", {1});
  card.Cycles(30'000);
  EXPECT_EQ(card.Read("GT_GetEcatHomingStatus", {1}), 3);
  EXPECT_EQ(card.Read("GT_GetEcatEncPos", {1}), 25);
}

TEST(BusAxisCommands, AStopOfHomingClearsItsState) {
  BusCommandCard card({CompleteDrive(0)});
  card.Enable();
  card.Expect(0, "GT_SetHomingMode", {1, 6});
  card.Expect(0, "GT_SetEcatHomingPrm", {1, 23, 50, 3, 1, 0, 0});
  card.Expect(0, "GT_StartEcatHoming", {1});
  card.Cycles(100);
  EXPECT_NE(card.motion.state().plants[0].velocity, 0);
  card.Expect(0, "GT_StopEcatHoming", {1});
  card.Cycles(400);
  EXPECT_EQ(card.motion.state().plants[0].velocity, 0);
  EXPECT_EQ(card.Read("GT_GetEcatHomingStatus", {1}), 0);
}

/// The manual's example 5-3.
TEST(BusAxisCommands, AProbeCapturesAgainAndAgain) {
  motion::WorldEvents events;
  for (int i = 0; i < 6; ++i) {
    events.push_back({400'000 + 10'000 * i, WorldEventKind::kBusProbe, 0, 0, i % 2 == 0 ? 1. : 0.});
  }
  BusCommandCard card({CompleteDrive(0)}, events);
  card.Enable();
  StartJog(card);
  card.Expect(0, "GT_SetTouchProbeFunction", {1, 0x13});
  std::vector<double> status(1), rise1(1), fall1(1), rise2(1), fall2(1);
  std::vector<double> captured;
  bool before = false;
  while (card.motion.now() < 500'000) {
    card.Cycle();
    card.Expect(0, "GT_GetTouchProbeStatus", {1, &status, &rise1, &fall1, &rise2, &fall2});
    const auto word = static_cast<unsigned>(status[0]);
    const bool again = (word & 1u << 6) != 0;
    if ((word & 3) == 3 && again != before) captured.push_back(rise1[0]);
    before = again;
  }
  ASSERT_EQ(captured.size(), 3u);
  EXPECT_NEAR(captured[1] - captured[0], 400, 1);
  EXPECT_NEAR(captured[2] - captured[1], 400, 1);
  EXPECT_EQ(fall1[0], 0);
  card.Expect(0, "GT_SetTouchProbeFunction", {1, 0});
  card.Cycle();
  card.Expect(0, "GT_GetTouchProbeStatus", {1, &status, &rise1, &fall1, &rise2, &fall2});
  EXPECT_EQ(status[0], 0);
}

TEST(BusAxisCommands, TheDescriptiveFormOfProbesSetsTheSameBits) {
  BusCommandCard card({CompleteDrive(0)});
  card.Up();
  card.Expect(0, "GT_SetTouchProbeFunctionEx", {1, 1, 1, 1, 1, 0, 3});
  card.Cycle();
  EXPECT_EQ(card.bus().slave(0).drive->values()[ObjectId::kProbeFunction], 0x3113);
}

TEST(BusAxisCommands, ReadAndWriteTheTerminalsOfADrive) {
  BusCommandCard card({CompleteDrive(0)});
  card.Up();
  card.bus().SetTerminal(0, static_cast<size_t>(ObjectId::kAnalogInput1), -123);
  card.bus().SetTerminal(0, static_cast<size_t>(ObjectId::kAnalogInput2), 456);
  card.bus().SetTerminal(0, static_cast<size_t>(ObjectId::kDigitalInputs), 0x50000);
  card.Expect(0, "GT_SetEcatAxisDO", {1, 4294967295.0});
  card.Cycle();
  EXPECT_EQ(card.Read("GT_GetEcatAxisAI", {1, 1}), -123);
  EXPECT_EQ(card.Read("GT_GetEcatAxisAI", {1, 2}), 456);
  EXPECT_EQ(card.Read("GT_GetEcatAxisDI", {1}), 0x50000);
  EXPECT_EQ(card.Read("GT_GetEcatAxisDO", {1}), 4294967295.0);
  EXPECT_EQ(card.bus().slave(0).drive->values()[ObjectId::kDigitalOutputs], 0xFFFFFFFF);
}

TEST(BusAxisCommands, ASlaveThatIsLostInAMoveStopsItsAxis) {
  BusCommandCard card({CompleteDrive(0)}, {{300'000, WorldEventKind::kBusLost, 0, 0, 1}});
  card.Enable();
  StartJog(card);
  while (card.motion.now() <= 300'000) card.Cycle();
  card.Cycles(2);
  EXPECT_EQ(card.Status() & (kAlarmBit | kEnabledBit | kMovingBit), kAlarmBit);
  std::vector<double> cell(1);
  card.Expect(1, "GT_GetEcatEncPos", {1, &cell});
  card.Expect(0, "GT_ClrSts", {1, 1});
  EXPECT_NE(card.Status() & kAlarmBit, 0u);
}

TEST(BusAxisCommands, AFollowingErrorStopsTheAxis) {
  BusCommandCard card({CompleteDrive(0)});
  card.Enable();
  card.Expect(0, "GT_SetPosErr", {1, 100});
  StartJog(card);
  card.Cycles(100);
  ChangeState(card.motion).plants[0].stalled = true;
  card.Cycles(100);
  EXPECT_NE(card.Status() & 1u << 4, 0u);
  EXPECT_EQ(card.Status() & (kEnabledBit | kMovingBit), 0u);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
