// Events of the world: when they take effect, on what, and what GT_Reset keeps.
#include "motion/mechanics/world_events.h"

#include <gtest/gtest.h>

#include <memory>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/core_run.h"

namespace oncard::motion {
namespace {

TEST(WorldEvent, ActsInTheCycleThatBeginsAtItsInstantOrNext) {
  struct {
    int64_t at_us;
    int cycle;  // the first cycle with the effect; 0: before the first
  } const cases[] = {{0, 0}, {1, 2}, {249, 2}, {250, 2}, {251, 3}, {1000, 5}};
  for (const auto& c : cases) {
    MotionCore core({});
    Happen(core, {{.at = c.at_us, .kind = WorldEventKind::kAdc, .item = 2, .value = 5}});
    int cycle = 0;
    while (core.state().adcs[2].volts == 0 && cycle < 10) {
      core.Tick();
      ++cycle;
    }
    EXPECT_EQ(cycle, c.cycle) << c.at_us;
  }
}

TEST(PowerOn, TheFirstCallSeesTheWorldOfInstantZero) {
  MotionCore core({});
  core.AddSwitch({.type = DiType::kHome, .bit = 4, .first = 0, .last = 10});
  core.AddSwitch({.type = DiType::kHome, .bit = 5, .first = 5, .last = 10, .active_low = true});
  const auto pin = [](DiType type, uint16_t bit) {
    return WorldEvent{.item = static_cast<uint8_t>(type), .index = bit, .value = 1};
  };
  Happen(core, {pin(DiType::kAlarm, 1),
                pin(DiType::kLimitPositive, 2),
                pin(DiType::kGpi, 3),
                {.kind = WorldEventKind::kAdc, .item = 2, .value = 5}});
  const DigitalIo& io = core.state().io;
  EXPECT_EQ(io.Read(DiType::kAlarm), 0b10u);
  EXPECT_EQ(io.Read(DiType::kGpi), 0b1000u);
  EXPECT_EQ(io.Read(DiType::kHome), 0b110000u);
  EXPECT_EQ(io.Edges(DiType::kGpi, 3), 0u);
  EXPECT_EQ(core.Conditions(0), 0u);
  EXPECT_EQ(core.Conditions(1), kAlarmBit);
  EXPECT_EQ(core.Conditions(2), kPositiveLimitBit);
  // 5 V of 12.5 V.
  EXPECT_EQ(core.state().adcs[2].Value(), 13107);
}

TEST(PowerOn, ResetFindsTheAlarmThatIsOn) {
  MotionCore core({});
  Happen(core, {{.item = static_cast<uint8_t>(DiType::kAlarm), .value = 1}});
  core.Reset();
  EXPECT_EQ(core.Conditions(0), kAlarmBit);
}

TEST(WorldEvent, EventsOfOneInstantActInTheirOrder) {
  MotionCore core({});
  Happen(core,
         {{.kind = WorldEventKind::kAdc, .value = 1}, {.kind = WorldEventKind::kAdc, .value = 2}});
  core.Tick();
  EXPECT_EQ(core.state().adcs[0].volts, 2);
}

TEST(WorldEvent, OneThatNobodyPlannedComesBeforeThoseOfItsInstant) {
  MotionCore core({});
  Happen(core, {{.at = 250, .kind = WorldEventKind::kAdc, .item = 2, .value = 5}});
  core.Tick();
  core.Happen({.at = 9000, .kind = WorldEventKind::kAdc, .item = 2, .value = 3});
  core.Happen({.kind = WorldEventKind::kAdc, .item = 1, .value = 4});
  EXPECT_EQ(core.state().adcs[2].volts, 3);
  core.Tick();
  EXPECT_EQ(core.state().adcs[2].volts, 5);
  EXPECT_EQ(core.state().adcs[1].volts, 4);
}

TEST(WorldEvent, EachKindActsOnItsPart) {
  MotionCore core({});
  core.AddSwitch({});
  Happen(core, {{.kind = WorldEventKind::kPin, .item = 3, .index = 1, .value = 1},
                {.kind = WorldEventKind::kModuleInputs, .item = 4, .value = 65535},
                {.kind = WorldEventKind::kModuleVoltage, .item = 5, .index = 6, .value = -2.5},
                {.kind = WorldEventKind::kStall, .item = 1, .value = 1},
                {.kind = WorldEventKind::kSwitchConnected, .index = 0, .value = 0}});
  core.Tick();
  EXPECT_EQ(core.state().io.Pins(DiType::kHome), 2u);
  EXPECT_EQ(core.state().modules[4].inputs, 65535);
  EXPECT_EQ(core.state().modules[5].input_volts[6], -2.5);
  EXPECT_TRUE(core.state().plants[1].stalled);
  EXPECT_FALSE(core.state().switches[0].connected);
}

TEST(WorldState, ResetClearsTheCardAndLeavesTheWorldAlone) {
  MotionCore core({});
  Happen(core, {{.kind = WorldEventKind::kAdc, .value = 3},
                {.kind = WorldEventKind::kModuleVoltage, .value = 4},
                {.kind = WorldEventKind::kStall, .item = 1, .value = 1}});
  ChangeState(core).adcs[0].filter = 100;
  core.Tick();
  ChangeState(core).modules[0].outputs = 7;
  ChangeState(core).modules[0].output_volts[1] = 1;
  ChangeState(core).modules[9].present = false;
  ChangeState(core).dacs[0].value = 5;
  core.Reset();
  EXPECT_EQ(core.state().adcs[0].Volts(), Adc({.volts = 3, .filtered = 3}).Volts());
  EXPECT_EQ(core.state().adcs[0].filter, 0);
  EXPECT_EQ(core.state().modules[0].input_volts[0], 4);
  EXPECT_EQ(core.state().modules[0].outputs, 0);
  EXPECT_EQ(core.state().modules[0].output_volts[1], 0);
  EXPECT_FALSE(core.state().modules[9].present);
  EXPECT_TRUE(core.state().plants[1].stalled);
  EXPECT_EQ(core.state().dacs[0].value, 0);
}

TEST(WorldState, AMotorMovedByHandStaysWhereItIsPut) {
  MotionCore core({});
  core.PlaceMotor(0, -500);
  core.AxisAt(0).ServoOn();
  core.Tick();
  EXPECT_EQ(core.state().plants[0].position, -500);
  EXPECT_EQ(core.state().encoders[0].position, 0);
}

}  // namespace
}  // namespace oncard::motion
