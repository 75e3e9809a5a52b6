// The EtherCAT bus of a scenario: its keys, and what they do to the card.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/observe/quantity.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/world/bus_setup.h"
#include "tests/motion/change_state.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using motion::bus::ObjectId;
using motion::bus::SlaveKind;

constexpr char kHeader[] = "program = \"x.c\"\n";

Scenario ParsedBus(const std::string& text) {
  auto scenario = ParseScenario(kHeader + text, "bus.toml");
  EXPECT_TRUE(scenario.ok()) << (scenario.ok() ? "" : scenario.error().message.en);
  return scenario.ok() ? std::move(scenario).value() : Scenario();
}

std::string BusError(const std::string& text) {
  const auto scenario = ParseScenario(kHeader + text, "bus.toml");
  EXPECT_FALSE(scenario.ok());
  return scenario.ok() ? "" : scenario.error().message.en;
}

/// A card whose bus is in operation.
class BusOfScenario {
 public:
  explicit BusOfScenario(const std::string& text)
      : scenario_(ParsedBus(text)), controller_(CardOptions(scenario_)) {
    ApplyWorld(scenario_, &controller_);
  }
  void Up() {
    EXPECT_EQ(bus().Init(0), motion::bus::InitOutcome::kDone);
    while (bus().phase() != motion::bus::BusPhase::kOp) controller_.RunCycle();
    bus().Start();
  }
  void RunUntilMs(double ms) {
    while (controller_.NowMs() < ms) controller_.RunCycle();
  }
  motion::MotionState& state() { return ChangeState(controller_.motion()); }
  motion::bus::Bus& bus() { return state().bus->line; }
  Controller& controller() { return controller_; }

 private:
  Scenario scenario_;
  Controller controller_;
};

TEST(ScenarioBus, DrivesGetTheNextAxisUnlessTheySayAnother) {
  const Scenario scenario = ParsedBus(R"([[ethercat.slave]]
[[ethercat.slave]]
kind = "io"
[[ethercat.slave]]
[[ethercat.slave]]
axis = 7
)");
  ASSERT_EQ(scenario.bus.slaves.size(), 4u);
  EXPECT_EQ(scenario.bus.slaves[0].axis, 1);
  EXPECT_EQ(scenario.bus.slaves[1].kind, SlaveKind::kIo);
  EXPECT_EQ(scenario.bus.slaves[2].axis, 2);
  EXPECT_EQ(scenario.bus.slaves[3].axis, 7);
}

TEST(ScenarioBus, ProcessDataNameObjects) {
  const Scenario scenario = ParsedBus(R"([[ethercat.slave]]
outputs = ["6040", "607A", "60FE"]
inputs = ["6041", "6064"]
[[ethercat.slave]]
kind = "io"
inputs = ["6000:1:1", "gap:7", "6000:2"]
)");
  EXPECT_THAT(
      SlaveOf(scenario.bus.slaves[0]).outputs,
      ElementsAre(motion::bus::PdoEntry{0x6040, 0, 16}, motion::bus::PdoEntry{0x607A, 0, 32},
                  motion::bus::PdoEntry{0x60FE, 1, 32}));
  EXPECT_THAT(SlaveOf(scenario.bus.slaves[1]).inputs,
              ElementsAre(motion::bus::PdoEntry{0x6000, 1, 1}, motion::bus::PdoEntry{0, 0, 7},
                          motion::bus::PdoEntry{0x6000, 2, 16}));
}

TEST(ScenarioBus, IsWrittenSoThatItIsReadBack) {
  const Scenario scenario = ParsedBus(R"([[ethercat.slave]]
outputs = ["6040", "607A"]
lost_at_ms = 12.5
[[ethercat.slave]]
kind = "coupler"
vendor = 7
product = 4294967295
absent = true
[[ethercat.configured]]
axis = 3
[[ethercat.input]]
slave = 1
object = "6020:2"
value = 1234
at_ms = 3
)");
  const auto again = ParseScenario(FormatScenario(scenario), "bus.toml");
  ASSERT_TRUE(again.ok()) << again.error().message.en;
  EXPECT_EQ(again.value().bus, scenario.bus);
  EXPECT_EQ(FormatScenario(again.value()), FormatScenario(scenario));
}

TEST(ScenarioBus, ASlaveCanHaveNoProcessData) {
  const Scenario scenario = ParsedBus("[[ethercat.slave]]\nkind = \"io\"\noutputs = [\"none\"]\n");
  const motion::bus::Slave slave = SlaveOf(scenario.bus.slaves[0]);
  EXPECT_TRUE(slave.outputs.empty());
  EXPECT_EQ(SlaveOf(SetupOf(slave)), slave);
}

TEST(ScenarioBus, ConditionsNameItsDrives) {
  BusOfScenario card("[[ethercat.slave]]\n[[ethercat.slave]]\naxis = 3\n");
  card.Up();
  card.controller().motion().AxisAt(2).ServoOn();
  card.RunUntilMs(155);
  const auto value = [&](const std::string& name) {
    const auto found = ResolveQuantity(name, card.controller());
    EXPECT_TRUE(found.ok()) << name;
    return found.ok() ? ReadQuantity(found.value().front(), card.controller()) : -1;
  };
  EXPECT_EQ(value("drive3.state"), 4);
  EXPECT_EQ(value("drive3.mode"), 8);
  EXPECT_EQ(value("drive3.control"), 0x0F);
  EXPECT_EQ(value("drive3.status"), 0x1237);
  EXPECT_EQ(value("drive1.state"), 2);
  EXPECT_FALSE(ResolveQuantity("drive2.state", card.controller()).ok());
}

TEST(ScenarioBus, AScenarioWithoutOneIsWrittenWithoutOne) {
  EXPECT_EQ(FormatScenario(ParsedBus("")).find("ethercat"), std::string::npos);
}

TEST(ScenarioBus, EveryMistakeHasItsMessage) {
  const std::pair<std::string, std::string> kCases[] = {
      {"[[ethercat.slave]]\nkind = \"valve\"", "kind"},
      {"[[ethercat.slave]]\nkind = \"io\"\naxis = 1", "only a drive has an 'axis'"},
      {"[[ethercat.slave]]\naxis = 9", "axis"},
      {"[[ethercat.slave]]\n[[ethercat.slave]]\naxis = 1", "axis 1 is not free"},
      {"[[ethercat.slave]]\noutputs = [\"6040\", \"xyz\"]", "'xyz' is not an entry"},
      {"[[ethercat.slave]]\noutputs = [\"6041\"]", "belongs to 'inputs'"},
      {"[[ethercat.slave]]\ninputs = [\"5000\"]", "a drive has no object '5000'"},
      {"[[ethercat.slave]]\ninputs = [\"6041:0:8\"]", "has 16 bits"},
      {"[[ethercat.slave]]\nkind = \"io\"\ninputs = [\"6000:1:33\"]", "is not an entry"},
      {"[[ethercat.configured]]\nabsent = true", "absent"},
      {"[[ethercat.input]]\nslave = 0\nobject = \"6000\"\nvalue = 1", "there are 0 slaves"},
      {"[[ethercat.slave]]\n[[ethercat.input]]\nslave = 0\nobject = \"6064\"\nvalue = 1",
       "slave 0 has no input '6064'"},
      {"[[ethercat.slave]]\n[[ethercat.input]]\nslave = 0\nobject = \"probe1\"\nvalue = 2",
       "0 or 1 for a probe"},
      {"[[ethercat.slave]]\n[[ethercat.input]]\nslave = 0\nvalue = 2", "'object' is missing"},
  };
  for (const auto& [text, expected] : kCases)
    EXPECT_THAT(BusError(text), HasSubstr(expected)) << text;
}

TEST(ScenarioBus, TheImageOfAllSlavesIsLimited) {
  std::string text;
  for (int i = 0; i < 63; ++i) text += "[[ethercat.slave]]\nkind = \"coupler\"\n";
  EXPECT_THAT(BusError(text), HasSubstr("more than 1486 bytes"));
}

TEST(ScenarioBus, TerminalsShowWhatTheScenarioSays) {
  BusOfScenario card(R"([[ethercat.slave]]
[[ethercat.slave]]
kind = "io"
[[ethercat.input]]
slave = 1
object = "6000:1"
value = 0x1234
at_ms = 200
[[ethercat.input]]
slave = 0
object = "60FD"
value = 0x10000
at_ms = 200
)");
  card.Up();
  EXPECT_EQ(card.bus().image().bytes()[18], 0);
  card.RunUntilMs(200.5);
  EXPECT_EQ(card.bus().image().bytes()[18], 0x34);
  EXPECT_EQ(card.bus().image().bytes()[19], 0x12);
  EXPECT_EQ(card.bus().Input(0, ObjectId::kDigitalInputs), 0x10000);
}

TEST(ScenarioBus, AnAbsentSlaveIsAMismatch) {
  BusOfScenario card("[[ethercat.slave]]\n[[ethercat.slave]]\nabsent = true\n");
  EXPECT_EQ(card.bus().Init(0), motion::bus::InitOutcome::kDifferent);
  BusOfScenario none("[[ethercat.slave]]\nabsent = true\n");
  EXPECT_EQ(none.bus().Init(0), motion::bus::InitOutcome::kNoSlaves);
}

TEST(ScenarioBus, SlavesBehindAnAbsentOneKeepTheirInputs) {
  BusOfScenario card(R"([[ethercat.slave]]
absent = true
[[ethercat.slave]]
kind = "io"
[[ethercat.configured]]
kind = "io"
[[ethercat.input]]
slave = 1
object = "6000"
value = 5
)");
  card.Up();
  EXPECT_EQ(card.bus().image().bytes()[2], 5);
}

TEST(ScenarioBus, AConfigurationOfItsOwnIsCompared) {
  BusOfScenario card("[[ethercat.slave]]\n[[ethercat.configured]]\nproduct = 1\n");
  EXPECT_EQ(card.bus().Init(0), motion::bus::InitOutcome::kDifferent);
}

TEST(ScenarioBus, SlavesFailWhenTheScenarioSaysSo) {
  BusOfScenario card(R"([[ethercat.slave]]
working_counter_at_ms = 300
[[ethercat.slave]]
lost_at_ms = 400
)");
  card.Up();
  EXPECT_TRUE(card.bus().ready());
  card.RunUntilMs(301);
  EXPECT_TRUE(card.bus().Online(0));
  EXPECT_FALSE(card.bus().Answers(0));
  EXPECT_TRUE(card.bus().Online(1));
  card.RunUntilMs(401);
  EXPECT_FALSE(card.bus().Online(1));
}

TEST(ScenarioBus, SnapshotsHoldTheBus) {
  BusOfScenario card("[[ethercat.slave]]\n");
  card.Up();
  card.controller().motion().AxisAt(0).ServoOn();
  card.RunUntilMs(200);
  const ControllerSnapshot snapshot = card.controller().Snapshot();
  card.controller().RunCycles(100);
  const uint64_t end = card.controller().Hash();
  card.controller().Restore(snapshot);
  card.controller().RunCycles(100);
  EXPECT_EQ(card.controller().Hash(), end);
}

}  // namespace
}  // namespace oncard::runtime
