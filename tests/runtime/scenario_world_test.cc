// The world of a scenario as a card sees it.
#include <gtest/gtest.h>

#include "runtime/scenario_world.h"

namespace oncard::runtime {
namespace {

using motion::DiType;

Scenario Parsed(std::string_view text) {
  auto scenario = ParseScenario(text, "world.toml");
  EXPECT_TRUE(scenario.ok()) << scenario.error().message.en;
  return std::move(scenario).value();
}

TEST(ScenarioWorld, InputsActInTheCycleThatBeginsAtTheirInstantOrNext) {
  const Scenario scenario = Parsed(R"(program = "x.c"
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
  EXPECT_EQ(pins(DiType::kGpi), 0u);
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
  const Scenario scenario = Parsed(R"(program = "x.c"
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

TEST(ScenarioWorld, TheCardHasTheScenariosCycleAndRate) {
  const ControllerOptions options =
      CardOptions(Parsed("program = \"x.c\"\ncycle_us = 1000\nrate = 40"));
  EXPECT_EQ(options.motion.cycle_us, 1000);
  EXPECT_EQ(options.rate, 40);
}

}  // namespace
}  // namespace oncard::runtime
