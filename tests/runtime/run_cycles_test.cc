// RunCycles() ends in the state in which as many RunCycle() end, whatever threads, paths and the
// family do meanwhile, with the same refused commands and events at the same times. The programs
// and worlds are those of the samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "runtime/sim/controller.h"
#include "runtime/sim/program.h"

namespace oncard::runtime {
namespace {

/// The scenarios of the samples that are single runs.
std::vector<std::string> Scenarios() {
  std::vector<std::string> paths;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(ONCARD_SOURCE_DIR "/samples")) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".toml") || path.ends_with(".host.toml")) continue;
    if (LoadScenario(path, ScenarioUse::kRun).ok()) paths.push_back(path);
  }
  std::ranges::sort(paths);
  return paths;
}

/// A card on which a scenario has been started, and what it reported since.
class StartedCard {
 public:
  StartedCard(const Scenario& scenario, const vm::Policy& policy) : card_(CardOptions(scenario)) {
    card_.ListenToEvents([this](int64_t time_us, const Message& what) {
      report_ += std::to_string(time_us) + " " + what.en + "\n";
    });
    card_.CollectRefusals(&refused_);
    ProgramLoad load = LoadProgram(ProgramPath(scenario), CompileOptions(scenario));
    EXPECT_TRUE(load.object.has_value());
    if (load.object.has_value()) {
      EXPECT_TRUE(StartScenario(scenario, std::move(*load.object), &card_).ok());
    }
    card_.machine().SetPolicy(policy);
  }

  Controller& card() { return card_; }
  std::string Report() const {
    std::string report = report_;
    for (const RefusedCommand& refused : refused_.list()) {
      report += DescribeRefusedCommand(refused, "program.c").en + "\n";
    }
    return report;
  }

 private:
  Controller card_;
  RefusedCommands refused_;
  std::string report_;
};

class RunCycles : public testing::TestWithParam<std::string> {};

TEST_P(RunCycles, EndsWhereSingleCyclesEnd) {
  const auto scenario = LoadScenario(GetParam(), ScenarioUse::kRun);
  ASSERT_TRUE(scenario.ok());
  for (const char* policy : {"rr", "rr:7", "random:3"}) {
    SCOPED_TRACE(policy);
    StartedCard one(scenario.value(), vm::ParsePolicy(policy).value());
    StartedCard many(scenario.value(), vm::ParsePolicy(policy).value());
    int64_t cycles = 0;
    for (const int64_t chunk : {1, 2, 13, 400, 3, 4000, 77}) {
      for (int64_t i = 0; i < chunk; ++i) one.card().RunCycle();
      many.card().RunCycles(chunk);
      cycles += chunk;
      ASSERT_EQ(many.card().cycle(), cycles);
      ASSERT_EQ(one.card().Hash(), many.card().Hash()) << "after " << cycles << " cycles";
    }
    EXPECT_EQ(one.Report(), many.Report());
  }
}

std::string NameOf(const testing::TestParamInfo<std::string>& scenario) {
  std::string name = std::filesystem::path(scenario.param).stem().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name + std::to_string(scenario.index);
}

/// A family that changes the velocity of the first axis at the end of each tenth cycle, and says
/// so.
const gtcalls::Family& PeriodicFamily() {
  static const gtcalls::Family kFamily = [] {
    gtcalls::Family family = gtcalls::GtsFamily();
    family.after_tick = [](gtcalls::Card& card) {
      const int64_t cycle = card.motion.cycle();
      if (cycle % 10 != 0) return;
      card.motion.ProfileAt(0).SetVelocity(static_cast<double>(cycle % 70));
      card.motion.ProfileAt(0).Start();
    };
    family.cycles_before_act = [](const gtcalls::CardView& card) {
      return 9 - card.motion.cycle() % 10;
    };
    return family;
  }();
  return kFamily;
}

TEST(RunCyclesOfAFamily, PassOnlyCyclesInWhichItDoesNotAct) {
  ControllerOptions options;
  options.family = &PeriodicFamily();
  Controller one(options);
  Controller many(options);
  for (Controller* card : {&one, &many}) {
    card->motion().AxisAt(0).ServoOn();
    const motion::ProfileHandle profile = card->motion().ProfileAt(0);
    profile.SelectMode(motion::ProfileMode::kJog);
    profile.SetParameters(motion::JogParameters{.acc = 1, .dec = 1});
  }
  for (const int64_t chunk : {1, 2, 13, 400, 3, 4000, 77}) {
    for (int64_t i = 0; i < chunk; ++i) one.RunCycle();
    many.RunCycles(chunk);
    EXPECT_EQ(one.Hash(), many.Hash()) << "after " << chunk << " cycles";
  }
  EXPECT_NE(many.motion().encoder(0).position, 0);
}

INSTANTIATE_TEST_SUITE_P(Samples, RunCycles, testing::ValuesIn(Scenarios()), NameOf);

}  // namespace
}  // namespace oncard::runtime
