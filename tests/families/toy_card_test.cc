// A card whose cycle a command can change, without a host: its time, its copies, its surroundings.
#include <gtest/gtest.h>

#include <array>

#include "runtime/scenario/run/scenario_card.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {
namespace {

/// 1601 steps of 30 ns.
constexpr double kOddUs = 48.03;

Scenario ToyScenario(std::string_view world = {}) {
  auto scenario =
      ParseScenario("card = \"TOY-3\"\n" + std::string(world), "toy.toml", ScenarioUse::kHost);
  EXPECT_TRUE(scenario.ok()) << scenario.error().message.en;
  return std::move(scenario).value();
}

/// Between two calls that take no time.
void SetCycle(double us, Controller* card) {
  std::array<vm::CommandArgument, 1> arguments;
  arguments[0].value = us;
  const gtcalls::Command& command = *card->family().catalogue.Find("TOY_SetCycle");
  EXPECT_EQ(card->Execute(command, arguments), vm::kOk);
}

TEST(ToyCard, EndsTheCycleThatHasBegunAndTakesTheNewLength) {
  Controller card(CardOptions(ToyScenario()));
  card.AdvanceUs(50);
  SetCycle(kOddUs, &card);
  EXPECT_EQ(card.UsToNextTick(), 950);
  // One of 1 ms and 20 of 48.03 us: 1.9606 ms.
  card.AdvanceUs(1950);
  EXPECT_EQ(card.cycle(), 21);
  EXPECT_EQ(card.NowUs(), 2000);
  EXPECT_DOUBLE_EQ(card.NowMs(), 1.960);
  EXPECT_EQ(card.UsToNextTick(), 9);  // 8.63 us
  // Not a nanosecond is lost on the way to the thousandth.
  for (int i = 0; i < 46'030; ++i) card.AdvanceUs(1);
  EXPECT_EQ(card.cycle(), 980);  // 1 + 47'030'000 / 48'030
}

TEST(ToyCard, BetweenTwoCyclesTakesTheNewLengthAtOnce) {
  Controller card(CardOptions(ToyScenario()));
  card.AdvanceUs(2000);
  SetCycle(kOddUs, &card);
  card.AdvanceUs(49);
  EXPECT_EQ(card.cycle(), 3);
}

TEST(ToyCard, CopiesKeepItsClock) {
  Controller card(CardOptions(ToyScenario()));
  card.AdvanceUs(50);
  const ControllerSnapshot before = card.Snapshot();
  EXPECT_FALSE(before.body.clock);
  SetCycle(kOddUs, &card);
  const ControllerSnapshot after = card.Snapshot();
  EXPECT_TRUE(after.body.clock);
  const uint64_t hash = card.Hash();
  card.AdvanceUs(5000);
  const uint64_t end = card.Hash();
  card.Restore(before);
  EXPECT_NE(card.Hash(), hash);
  card.AdvanceUs(3000);
  EXPECT_EQ(card.cycle(), 3);
  card.Restore(after);
  EXPECT_EQ(card.Hash(), hash);
  card.AdvanceUs(5000);
  EXPECT_EQ(card.Hash(), end);
}

TEST(ToyCard, AResetPutsTheCycleBack) {
  Controller card(CardOptions(ToyScenario()));
  SetCycle(kOddUs, &card);
  card.Reset();
  card.AdvanceUs(999);
  EXPECT_EQ(card.cycle(), 0);
}

// The pin changes at 3.3 ms: the first cycle that begins then or later is that from 3.33621 ms on.
TEST(ToyCard, EventsOutsideKeepTheirInstants) {
  const Scenario scenario =
      ToyScenario("[[world.input]]\nat_ms = 3.3\ntype = \"gpi\"\nindex = 1\nvalue = 1\n");
  Controller card(CardOptions(scenario));
  ApplyWorld(scenario, &card);
  const auto pin = [&] { return card.motion().state().io.Pins(motion::DiType::kGpi) & 1; };
  card.AdvanceUs(3000);
  SetCycle(kOddUs, &card);
  card.AdvanceUs(336);
  EXPECT_EQ(pin(), 0u);
  card.AdvanceUs(49);  // 3.38424 ms
  EXPECT_EQ(pin(), 1u);
}

// The condition holds from power-on, and the reaction is 3.3 ms later.
TEST(ToyCard, ReactionsKeepTheirDelays) {
  const Scenario scenario = ToyScenario(
      "[[world.react]]\nwhen = \"axis1.prfPos == 0\"\nafter_ms = 3.3\ntype = \"gpi\"\nindex = 1\n"
      "value = 1\n");
  Controller card(CardOptions(scenario));
  ApplyWorld(scenario, &card);
  const auto pin = [&] { return card.motion().state().io.Pins(motion::DiType::kGpi) & 1; };
  card.AdvanceUs(3000);
  SetCycle(kOddUs, &card);
  card.AdvanceUs(336);
  EXPECT_EQ(pin(), 0u);
  card.AdvanceUs(49);  // 3.38424 ms
  EXPECT_EQ(pin(), 1u);
}

TEST(ToyCard, VelocitiesOutsideKeepTheirMilliseconds) {
  const Scenario scenario = ToyScenario(
      "[[world.fault]]\nkind = \"slip\"\naxis = 1\nat_ms = 2\nuntil_ms = 12\nvelocity = 3\n");
  Controller card(CardOptions(scenario));
  ApplyWorld(scenario, &card);
  card.AdvanceUs(4000);
  SetCycle(500, &card);
  card.AdvanceUs(16'000);
  EXPECT_DOUBLE_EQ(card.motion().state().encoder_faults[0].slip, 30);
}

TEST(ToyCard, ItsScenarioDoesNotSetItsCycle) {
  const auto scenario =
      ParseScenario("card = \"TOY-3\"\ncycle_us = 500\n", "toy.toml", ScenarioUse::kHost);
  ASSERT_FALSE(scenario.ok());
  EXPECT_EQ(
      scenario.error().message.en.substr(0, 84),
      "toy.toml:2:12: the card TOY-3 itself says how long a cycle takes: remove 'cycle_us'\n");
}

}  // namespace
}  // namespace oncard::runtime
