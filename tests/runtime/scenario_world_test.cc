// The effects of a scenario's world on a card.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "motion/common/state_hash.h"
#include "runtime/scenario/run/scenario_card.h"
#include "tests/motion/change_state.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

using motion::DiType;

Scenario ParsedWorld(std::string_view text) {
  auto scenario = ParseScenario(text, "world.toml");
  EXPECT_TRUE(scenario.ok()) << scenario.error().message.en;
  return std::move(scenario).value();
}

TEST(ScenarioWorld, InputsActInTheCycleThatBeginsAtTheirInstantOrNext) {
  const Scenario scenario = ParsedWorld(R"(program = "x.c"
[[world.input]]
type = "home"
index = 2
value = 1
at_ms = 0.6
[[world.input]]
value = 0x8001
at_ms = 0
[[world.input]]
index = 16
value = 0
at_ms = 0.5
)");
  Controller controller(CardOptions(scenario));
  ApplyWorld(scenario, &controller);
  const auto pins = [&](DiType type) { return controller.motion().state().io.Pins(type); };
  EXPECT_EQ(pins(DiType::kGpi), 0x8001u);
  controller.RunCycle();
  EXPECT_EQ(pins(DiType::kGpi), 0x8001u);
  controller.RunCycle();
  EXPECT_EQ(pins(DiType::kGpi), 0x8001u);
  controller.RunCycle();  // begins at 0.5 ms
  EXPECT_EQ(pins(DiType::kGpi), 1u);
  EXPECT_EQ(pins(DiType::kHome), 0u);
  controller.RunCycle();
  EXPECT_EQ(pins(DiType::kHome), 2u);
}

TEST(ScenarioWorld, GtResetLeavesTheWorldAlone) {
  const Scenario scenario = ParsedWorld(R"(program = "x.c"
[[world.input]]
index = 1
value = 1
at_ms = 1
)");
  Controller controller(CardOptions(scenario));
  ApplyWorld(scenario, &controller);
  controller.RunCycle();
  controller.Reset();
  for (int i = 0; i < 4; ++i) controller.RunCycle();
  EXPECT_EQ(controller.motion().state().io.Pins(DiType::kGpi), 1u);
}

/// A card in the world of a scenario, with functions for its first axis.
class WorldCard {
 public:
  explicit WorldCard(const std::string& world)
      : scenario_(ParsedWorld("program = \"x.c\"\n" + world)), controller_(CardOptions(scenario_)) {
    ApplyWorld(scenario_, &controller_);
  }
  motion::MotionState& state() { return ChangeState(controller_.motion()); }
  uint32_t conditions() { return controller_.motion().Conditions(0); }
  /// Enables axis 1 and starts a jog.
  void Jog(double velocity) {
    controller_.motion().AxisAt(0).ServoOn();
    motion::Profile& profile = state().profiles[0];
    profile.mode = motion::ProfileMode::kJog;
    profile.jog.parameters = {.acc = 1, .dec = 1};
    profile.jog.velocity = velocity;
    controller_.motion().ProfileAt(0).Start();
  }
  void RunUntil(double ms) {
    while (controller_.NowMs() < ms) controller_.RunCycle();
  }

 private:
  Scenario scenario_;
  Controller controller_;
};

TEST(ScenarioWorld, AnAxisRunsIntoItsLimitSwitch) {
  WorldCard card("[[world.switch]]\naxis = 1\ntype = \"limit_positive\"\nfrom = 20000\n");
  card.Jog(100);
  card.RunUntil(190);
  EXPECT_EQ(card.conditions() & motion::kPositiveLimitBit, 0u);
  card.RunUntil(1000);
  EXPECT_NE(card.conditions() & motion::kPositiveLimitBit, 0u);
  EXPECT_EQ(card.conditions() & motion::kMovingBit, 0u);
  // It stops after the switch, because of the filter's time and the abrupt stop.
  EXPECT_GT(card.state().plants[0].position, 20000);
  EXPECT_LT(card.state().plants[0].position, 20200);
}

TEST(ScenarioWorld, ACutLimitSwitchStopsNothing) {
  WorldCard card(
      "[[world.switch]]\naxis = 1\ntype = \"limit_positive\"\nfrom = 20000\n"
      "[[world.fault]]\nkind = \"cut_switch\"\nswitch = 1\n");
  card.Jog(100);
  card.RunUntil(1000);
  EXPECT_EQ(card.conditions() & motion::kPositiveLimitBit, 0u);
  EXPECT_GT(card.state().plants[0].position, 90000);
}

TEST(ScenarioWorld, ALimitSwitchIsMoved) {
  WorldCard card(
      "[[world.switch]]\naxis = 1\ntype = \"limit_positive\"\nfrom = 20000\n"
      "[[world.move]]\nswitch = 1\nfrom = 40000\nat_ms = 100\n"
      "[[world.move]]\nswitch = 1\nto = 0\nat_ms = 1500\n");
  card.Jog(100);
  card.RunUntil(390);
  EXPECT_EQ(card.conditions() & motion::kPositiveLimitBit, 0u);
  card.RunUntil(1000);
  EXPECT_NE(card.conditions() & motion::kPositiveLimitBit, 0u);
  EXPECT_GT(card.state().plants[0].position, 40000);
  EXPECT_LT(card.state().plants[0].position, 40200);
  const auto level = [&] { return card.state().io.Read(DiType::kLimitPositive) & 1; };
  card.RunUntil(1500);
  EXPECT_EQ(level(), 1u);
  card.RunUntil(1502);
  EXPECT_EQ(level(), 0u);
}

TEST(ScenarioWorld, ASwitchIsMovedUnderAnAxisThatStands) {
  WorldCard card(
      "[[world.switch]]\naxis = 1\nfrom = 500\nto = 600\n"
      "[[world.move]]\nswitch = 1\nfrom = -10\nto = 10\nat_ms = 20\n");
  card.RunUntil(20);
  EXPECT_EQ(card.state().io.Pins(DiType::kHome), 0u);
  card.RunUntil(20.25);
  EXPECT_EQ(card.state().io.Pins(DiType::kHome), 1u);
}

TEST(ScenarioWorld, AStalledMachineExceedsTheFollowingError) {
  WorldCard card("[[world.fault]]\nkind = \"stall\"\naxis = 1\nat_ms = 500\n");
  card.Jog(100);
  card.RunUntil(500);
  EXPECT_EQ(card.conditions() & motion::kFollowingErrorBit, 0u);
  const double held = card.state().plants[0].position;
  // 32767 pulses at 100 pulse/ms.
  card.RunUntil(820);
  EXPECT_EQ(card.conditions() & motion::kFollowingErrorBit, 0u);
  card.RunUntil(830);
  EXPECT_NE(card.conditions() & motion::kFollowingErrorBit, 0u);
  EXPECT_EQ(card.state().plants[0].position, held);
}

TEST(ScenarioWorld, AnAlarmLastsAsLongAsTheFileSays) {
  WorldCard card("[[world.fault]]\nkind = \"alarm\"\naxis = 1\nat_ms = 10\nuntil_ms = 20\n");
  const auto alarm = [&] { return card.state().io.Read(DiType::kAlarm) & 1; };
  card.RunUntil(9);
  EXPECT_EQ(alarm(), 0u);
  card.RunUntil(12);
  EXPECT_EQ(alarm(), 1u);
  EXPECT_NE(card.conditions() & motion::kAlarmBit, 0u);
  card.RunUntil(22);
  EXPECT_EQ(alarm(), 0u);
}

TEST(ScenarioWorld, OneFaultCanFollowAnotherAtOnceInAnyOrder) {
  WorldCard card(
      "[[world.fault]]\nkind = \"alarm\"\naxis = 1\nat_ms = 20\nuntil_ms = 30\n"
      "[[world.fault]]\nkind = \"alarm\"\naxis = 1\nat_ms = 10\nuntil_ms = 20\n");
  const auto alarm = [&] { return card.state().io.Read(DiType::kAlarm) & 1; };
  card.RunUntil(15);
  EXPECT_EQ(alarm(), 1u);
  card.RunUntil(25);
  EXPECT_EQ(alarm(), 1u);
  card.RunUntil(35);
  EXPECT_EQ(alarm(), 0u);
}

TEST(ScenarioWorld, EncodersLoseTheirSignalSlipAndReadNoise) {
  WorldCard lost("[[world.fault]]\nkind = \"lost_encoder\"\naxis = 1\nat_ms = 100\n");
  lost.Jog(10);
  lost.RunUntil(100);
  const double last = lost.state().encoders[0].position;
  lost.RunUntil(300);
  EXPECT_EQ(lost.state().encoders[0].position, last);
  EXPECT_GT(lost.state().plants[0].position, last + 1900);

  WorldCard slip("[[world.fault]]\nkind = \"slip\"\naxis = 1\nvelocity = 0.5\n");
  slip.RunUntil(1000);
  EXPECT_NEAR(slip.state().encoders[0].position, 500, 1);

  WorldCard noise("[[world.fault]]\nkind = \"noise\"\naxis = 1\npulses = 3\n");
  double smallest = 0;
  double largest = 0;
  for (int ms = 1; ms <= 200; ++ms) {
    noise.RunUntil(ms);
    smallest = std::min(smallest, noise.state().encoders[0].position);
    largest = std::max(largest, noise.state().encoders[0].position);
  }
  EXPECT_EQ(smallest, -3);
  EXPECT_EQ(largest, 3);
}

TEST(ScenarioWorld, MachinesStandAndTurnAsDescribed) {
  WorldCard card(
      "axes = 4\n[[world.axis]]\naxis = 1\ndrive = \"velocity\"\ngain = 50\ntau_ms = 5\n"
      "friction = 0.5\nposition = -300\nindex_offset = 20\nindex_period = 4000\n");
  const motion::Drive& drive = card.state().drives[0];
  EXPECT_EQ(drive.kind, motion::DriveKind::kVelocity);
  const auto hash = [](const motion::Drive& of) { return motion::StateHash().Add(of).value(); };
  EXPECT_EQ(hash(drive), hash(motion::VelocityDrive(50, 5, 0.5, 0.125)));
  EXPECT_EQ(card.state().plants[0].position, -300);
  EXPECT_EQ(card.state().index_marks[0], (motion::IndexMarks{20, 4000}));
  card.RunUntil(1);
  EXPECT_EQ(card.state().encoders[0].position, 0);
}

TEST(ScenarioWorld, AHandTurnsWhatNoDriveHolds) {
  const char* turns =
      "[[world.hand]]\naxis = 1\npulses = 4321\nat_ms = 10\nuntil_ms = 33.3\n"
      "[[world.hand]]\naxis = 1\npulses = -321\nat_ms = 40\nuntil_ms = 50\n"
      "[[world.hand]]\nencoder = 9\npulses = 77\nuntil_ms = 100\n";
  WorldCard card(turns);
  const auto encoder = [&](size_t i) { return card.state().encoders[i].position; };
  card.RunUntil(10);
  EXPECT_EQ(encoder(0), 0);
  card.RunUntil(21.75);  // half of 23.5 ms, rounded to whole cycles
  EXPECT_NEAR(encoder(0), 4321.0 / 2, 1);
  card.RunUntil(40);
  EXPECT_EQ(encoder(0), 4321);
  card.RunUntil(200);
  EXPECT_EQ(encoder(0), 4000);
  EXPECT_EQ(card.state().plants[0].velocity, 0);
  EXPECT_EQ(encoder(8), 77);

  WorldCard enabled(turns);
  enabled.Jog(1);
  enabled.RunUntil(200);
  EXPECT_NEAR(enabled.state().plants[0].position, 199.5, 1e-6);
}

TEST(ScenarioWorld, AMachineTurnedByHandStaysWhenItsDriveComesOn) {
  WorldCard card(
      "[[world.axis]]\naxis = 1\ndrive = \"velocity\"\n"
      "[[world.hand]]\naxis = 1\npulses = 500\nuntil_ms = 10\n");
  card.RunUntil(12);
  EXPECT_NEAR(card.state().plants[0].position, 500, 1e-6);
  card.Jog(0);
  card.RunUntil(20);
  EXPECT_NEAR(card.state().plants[0].position, 500, 1e-6);
}

TEST(ScenarioWorld, AnalogueInputsAndModulesChangeOverTime) {
  WorldCard card(
      "[[world.analog]]\nchannel = 3\nvolts = -2.5\nat_ms = 5\n"
      "[[world.module]]\nmodule = 2\ninputs = 0x11\nvolts = [0, 5]\nat_ms = 3\n");
  EXPECT_FALSE(card.state().modules[0].present);
  EXPECT_TRUE(card.state().modules[2].present);
  card.RunUntil(2);
  EXPECT_EQ(card.state().modules[2].inputs, 0);
  card.RunUntil(6);
  EXPECT_EQ(card.state().modules[2].inputs, 0x11);
  EXPECT_EQ(card.state().modules[2].input_volts[1], 5);
  EXPECT_EQ(card.state().adcs[2].volts, -2.5);
}

constexpr const char* kWholeWorld = R"(program = "x.c"
axes = 12
[[world.input]]
type = "home"
index = 1
value = 1
at_ms = 0.5
[[world.axis]]
axis = 12
drive = "velocity"
gain = 80.5
tau_ms = 0
friction = 1.5
position = -20
index_offset = 3
index_period = 0
[[world.switch]]
axis = 2
type = "limit_negative"
to = -1000.5
active_low = true
[[world.switch]]
axis = 2
index = 4
from = 10
to = 20
[[world.move]]
switch = 2
to = 25.5
at_ms = 9
[[world.move]]
switch = 1
from = -2000
to = -1000
at_ms = 3
[[world.fault]]
kind = "cut_switch"
switch = 2
at_ms = 7
until_ms = 8.25
[[world.fault]]
kind = "noise"
axis = 3
pulses = 4
[[world.fault]]
kind = "stall"
axis = 4
[[world.fault]]
kind = "lost_encoder"
axis = 4
[[world.fault]]
kind = "alarm"
axis = 4
[[world.fault]]
kind = "slip"
axis = 3
velocity = -0.25
[[world.hand]]
axis = 11
pulses = -20.5
at_ms = 1.5
until_ms = 8
[[world.analog]]
channel = 8
volts = 12.5
at_ms = 40
[[world.module]]
module = 15
inputs = 0x8001
volts = [1, -2.5]
at_ms = 2
)";

TEST(ScenarioWorld, IsWrittenAsItIsRead) {
  const Scenario first = ParsedWorld(kWholeWorld);
  EXPECT_EQ(first.axis_count, 12);
  EXPECT_EQ(first.world.switches[0].index, 2);
  EXPECT_EQ(first.world.switches[1].type, DiType::kHome);
  EXPECT_EQ(first.world.moves[0].number, 1);
  EXPECT_EQ(first.world.moves[1].to, 25.5);
  EXPECT_EQ(first.world.faults[0].until_us, 8250);
  const Scenario second = ParsedWorld(FormatScenario(first));
  EXPECT_EQ(second.world, first.world);
  EXPECT_EQ(second.axis_count, 12);
  const Scenario wheel =
      ParsedWorld("program = \"x.c\"\n[[world.hand]]\nencoder = 11\npulses = 5\nuntil_ms = 4\n");
  EXPECT_EQ(wheel.world.hands[0].number, 11);
  EXPECT_EQ(ParsedWorld(FormatScenario(wheel)).world, wheel.world);
}

TEST(ScenarioWorld, TheLimitsOfAnAxisAreWrittenAsTheyAreRead) {
  const Scenario scenario =
      ParsedWorld("program = \"x.c\"\n[[world.axis]]\naxis = 3\nmax_vel = 20\nmax_acc = 0.5\n");
  ASSERT_EQ(scenario.world.motors.size(), 1u);
  EXPECT_EQ(scenario.world.motors[0].max_vel, 20);
  EXPECT_EQ(scenario.world.motors[0].max_acc, 0.5);
  const std::string written = "program = \"x.c\"\n" + FormatWorld(scenario.world, 8);
  EXPECT_EQ(ParsedWorld(written).world, scenario.world);
  Controller controller(CardOptions(scenario));
  ApplyWorld(scenario, &controller);
  EXPECT_EQ(controller.motion().config().drive_limits[2].velocity, 20);
}

TEST(ScenarioWorld, TheCardSaysHowManyAxesThereAre) {
  const Scenario scenario = ParsedWorld("program = \"x.c\"\ncard = \"GTS-1200\"\n");
  EXPECT_EQ(scenario.axis_count, 12);
  EXPECT_EQ(CardOptions(scenario).motion.axis_count, 12);
  EXPECT_EQ(CardOptions(scenario).family->name, "gts");
  const std::string text = FormatScenario(scenario);
  EXPECT_THAT(text, HasSubstr("card = \"GTS-1200\"\naxes = 12\n"));
  EXPECT_EQ(ParsedWorld(text).card, "GTS-1200");
}

TEST(ScenarioWorld, ACardWithoutANameHasEightAxes) {
  const Scenario scenario = ParsedWorld("program = \"x.c\"\n");
  EXPECT_EQ(scenario.axis_count, 8);
  EXPECT_THAT(FormatScenario(scenario), Not(HasSubstr("card")));
}

TEST(ScenarioWorld, MistakesSayWhatToDo) {
  const struct {
    const char* text;
    const char* message;
  } cases[] = {
      {"axes = 5\n", "w.toml:2:8: 'axes' must be one of 4, 8, 12"},
      {"card = \"GTS-500\"\n", "w.toml:2:8: 'card' must be one of GTS-400, GTS-800, GTS-1200"},
      {"card = \"GTS-400\"\naxes = 8\n",
       "w.toml:3:8: 'axes' is 8, but the card GTS-400 has 4 axes: remove 'axes'"},
      {"card = \"GTS-400\"\n[[world.axis]]\naxis = 5\n",
       "'axis' must be a whole number from 1 to 4"},
      {"card = \"GE-800-PG\"\n",
       "w.toml:1:11: 'program' is for motion programs, and the card GE-800-PG has none: remove it"},
      {"card = \"GE-800-PG\"\n[[thread]]\nfunction = \"f\"\n",
       "w.toml:3:1: 'thread' is for motion programs, and the card GE-800-PG has none: remove it"},
      {"[[world.axes]]\n", "unknown key 'axes'; did you mean 'axis'?"},
      {"[[world.axis]]\ndrive = \"ideal\"\n", "'axis' is missing: the number of the axis, from 1"},
      {"[[world.axis]]\naxis = 9\n", "'axis' must be a whole number from 1 to 8"},
      {"[[world.axis]]\naxis = 1\ndrive = \"stepper\"\n", "'drive' must be one of ideal, velocity"},
      {"[[world.axis]]\naxis = 1\ndrive = \"velocity\"\ngain = -1\n",
       "'gain' must be a number from 0 to 32767"},
      {"[[world.axis]]\naxis = 1\n[[world.axis]]\naxis = 1\n", "axis 1 is described twice"},
      {"[[world.switch]]\naxis = 1\n", "'from' or 'to' is missing"},
      {"[[world.switch]]\naxis = 1\nfrom = 2\nto = 1\n", "'from' is greater than 'to'"},
      {"[[world.switch]]\naxis = 1\nfrom = 1\nactive_low = 1\n",
       "'active_low' must be true or false"},
      {"[[world.move]]\nswitch = 1\nfrom = 2\n", "there is no switch to move"},
      {"[[world.switch]]\naxis = 1\nto = 0\n[[world.move]]\nfrom = 1\n",
       "'switch' is missing: the number of the [[world.switch]]"},
      {"[[world.switch]]\naxis = 1\nto = 0\n[[world.move]]\nswitch = 2\nfrom = 1\n",
       "'switch' must be a whole number from 1 to 1"},
      {"[[world.switch]]\naxis = 1\nto = 0\n[[world.move]]\nswitch = 1\n",
       "w.toml:5:1: 'from' or 'to' is missing"},
      {"[[world.switch]]\naxis = 1\nto = 0\n[[world.move]]\nswitch = 1\nfrom = 2\nto = 1\n",
       "'from' is greater than 'to'"},
      {"[[world.fault]]\naxis = 1\n", "'kind' is missing: one of stall, lost_encoder"},
      {"[[world.fault]]\nkind = \"stal\"\naxis = 1\n", "'kind' must be one of stall"},
      {"[[world.fault]]\nkind = \"noise\"\naxis = 1\n", "'pulses' is missing"},
      {"[[world.fault]]\nkind = \"cut_switch\"\nswitch = 1\n", "there is no switch to cut"},
      {"[[world.switch]]\naxis = 1\nto = 0\n[[world.fault]]\nkind = \"cut_switch\"\nswitch = 2\n",
       "'switch' must be a whole number from 1 to 1"},
      {"[[world.fault]]\nkind = \"stall\"\naxis = 1\nat_ms = 5\nuntil_ms = 5\n",
       "'until_ms' must be later than 'at_ms'"},
      {"[[world.fault]]\nkind = \"alarm\"\naxis = 1\nat_ms = 10\nuntil_ms = 40\n"
       "[[world.fault]]\nkind = \"alarm\"\naxis = 1\nat_ms = 12\nuntil_ms = 20\n",
       "w.toml:7:1: this fault overlaps another one of its kind"},
      {"[[world.fault]]\nkind = \"stall\"\naxis = 1\npulses = 3\n",
       "w.toml:5:10: 'pulses' has no effect here"},
      {"[[world.axis]]\naxis = 1\ntau_ms = 3\n", "'tau_ms' has no effect here"},
      {"[[world.switch]]\naxis = 1\nfrom = 1\n[[world.switch]]\naxis = 2\nindex = 1\nto = 1\n",
       "two switches are wired to this input"},
      {"[[world.switch]]\naxis = 1\nfrom = 1\n[[world.input]]\ntype = \"home\"\nvalue = 0\n",
       "drives an input that a [[world.switch]] is wired to"},
      {"[[world.hand]]\npulses = 3\nuntil_ms = 9\n", "'axis' is missing"},
      {"[[world.hand]]\naxis = 1\nuntil_ms = 9\n", "'pulses' is missing: the distance"},
      {"[[world.hand]]\naxis = 1\npulses = 3\n", "'until_ms' is missing"},
      {"[[world.hand]]\naxis = 1\npulses = 3\nat_ms = 5\nuntil_ms = 8\n",
       "'until_ms' must be at least 4 ms after 'at_ms'"},
      {"[[world.hand]]\naxis = 1\npulses = 1e6\nuntil_ms = 5\n", "faster than 32767 pulse/ms"},
      {"[[world.hand]]\naxis = 1\npulses = 3\nuntil_ms = 9\n"
       "[[world.hand]]\naxis = 1\npulses = 3\nat_ms = 8\nuntil_ms = 19\n",
       "w.toml:6:1: this turn overlaps another one"},
      {"[[world.hand]]\nencoder = 8\npulses = 3\nuntil_ms = 9\n",
       "'encoder' must be a whole number from 9 to 11"},
      {"[[world.hand]]\naxis = 1\nencoder = 9\npulses = 3\nuntil_ms = 9\n",
       "'axis' has no effect here"},
      {"axes = 12\n[[world.hand]]\nencoder = 9\npulses = 3\nuntil_ms = 9\n",
       "a card of 12 axes has no auxiliary encoders"},
      {"[[world.analog]]\nvolts = 13\n", "'volts' must be a number from -12.5 to 12.5"},
      {"[[world.module]]\nvolts = [11]\n", "at most 8 voltages from -10 to 10"},
  };
  for (const auto& c : cases) {
    const auto scenario = ParseScenario(std::string("program = \"x.c\"\n") + c.text, "w.toml");
    ASSERT_FALSE(scenario.ok()) << c.text;
    EXPECT_THAT(scenario.error().message.en, HasSubstr(c.message));
    EXPECT_NE(scenario.error().message.zh, scenario.error().message.en);
  }
  const auto nine = ParseScenario(
      "program = \"x.c\"\naxes = 12\n[[world.switch]]\naxis = 9\nfrom = 1\n", "w.toml");
  ASSERT_FALSE(nine.ok());
  EXPECT_THAT(nine.error().message.en, HasSubstr("'index' is missing"));
}

TEST(ScenarioWorld, TheCardHasTheScenariosCycleAndRate) {
  const ControllerOptions options =
      CardOptions(ParsedWorld("program = \"x.c\"\ncycle_us = 1000\nrate = 40"));
  EXPECT_EQ(options.motion.cycle_us, 1000);
  EXPECT_EQ(options.rate, 40);
}

}  // namespace
}  // namespace oncard::runtime
