// Text files written by users: scenarios, schedules, requirements, configurations.
#include <string>

#include "explore/models/model.h"
#include "explore/scenario_exploration.h"
#include "gtcalls/gts/card_config.h"
#include "runtime/conditions/condition.h"
#include "runtime/host/eni_file.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/record/call_replay.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_run.h"
#include "runtime/sim/controller.h"
#include "tests/fuzz/fuzz.h"
#include "vm/schedule.h"

namespace oncard::fuzz {
namespace {

/// Two threads of the seeds' program, as in seeds/race.toml.
runtime::Scenario SeedScenario() {
  runtime::Scenario scenario;
  scenario.path = "race.toml";
  scenario.program = "race.c";
  scenario.limit_ms = 20;
  for (const char* thread : {"0=t0", "1=t1"}) {
    scenario.threads.push_back(runtime::ParseThreadStart(thread).value());
  }
  return scenario;
}

}  // namespace

void FuzzScenario(std::string_view bytes) {
  auto scenario = runtime::ParseScenario(bytes, "p.toml");
  if (!scenario.ok()) return;
  const auto again = runtime::ParseScenario(runtime::FormatScenario(scenario.value()), "p.toml");
  FUZZ_CHECK(again.ok());
  scenario.value().limit_ms = std::min<int64_t>(scenario.value().limit_ms, 20);
  // A thousand statements per cycle find as much as a million.
  scenario.value().rate = std::min(scenario.value().rate, 1000);
  runtime::RunOptions options;
  options.trace = true;
  static_cast<void>(runtime::RunScenario(scenario.value(), SeedProgram(), options));
}

void FuzzEni(std::string_view bytes) {
  const auto slaves = runtime::ParseEni(bytes, "Gecat.eni");
  if (!slaves.ok()) return;
  const auto again = runtime::ParseEni(runtime::FormatEni(slaves.value()), "Gecat.eni");
  FUZZ_CHECK(again.ok());
  runtime::Scenario scenario;
  for (const auto& slave : slaves.value()) {
    scenario.bus.slaves.push_back(runtime::SetupOf(slave));
    FUZZ_CHECK(runtime::SlaveOf(scenario.bus.slaves.back()) == slave);
  }
  runtime::Controller controller(runtime::CardOptions(scenario));
  runtime::ApplyWorld(scenario, &controller);
  if (!scenario.bus.slaves.empty()) controller.motion().bus_line()->Init(0);
  controller.RunCycles(700);
}

void FuzzSchedule(std::string_view bytes) {
  const auto schedule = vm::ParseSchedule(bytes);
  if (!schedule.ok()) return;
  const auto again = vm::ParseSchedule(vm::FormatSchedule(schedule.value()));
  FUZZ_CHECK(again.ok());
  static_cast<void>(runtime::ParseScenario(schedule.value().scenario, "p.schedule"));
  runtime::RunOptions options;
  options.replay = std::make_shared<const vm::Schedule>(schedule.value());
  static_cast<void>(runtime::RunScenario(SeedScenario(), SeedProgram(), options));
}

void FuzzRequirement(std::string_view bytes) {
  explore::Requirement requirement;
  requirement.scope = explore::Scope::kFinal;
  requirement.text = bytes;
  if (const auto timed = runtime::ParseTimedCondition(bytes); timed.ok()) {
    const runtime::Condition& condition = timed.value().condition;
    static_cast<void>(condition.Holds([&](size_t name) {
      FUZZ_CHECK(name < condition.names().size());
      return static_cast<double>(name);
    }));
  }
  const auto problem = explore::ProblemOfScenario(SeedScenario(), {requirement}, SeedProgram());
  if (!problem.ok()) return;
  explore::ExploreOptions options;
  options.engine = explore::EngineKind::kRandom;
  options.runs = 4;
  static_cast<void>(explore::Explore(problem.value(), options));
}

void FuzzConfig(std::string_view bytes) {
  const gtcalls::gts::CardConfig config = gtcalls::gts::ParseCardConfig(bytes);
  motion::MotionConfig motion_config;
  motion::MotionCore core(motion_config);
  gtcalls::gts::ApplyCardConfig(config, &core);
  constexpr int kCycles = 20;
  for (int i = 0; i < kCycles; ++i) core.Tick();
}

void FuzzCalls(std::string_view bytes) {
  auto opened = runtime::OpenCallRecord(std::string(bytes), "p.calls", std::nullopt, 1);
  if (!opened.ok()) return;
  const runtime::HostCalls& calls = *opened.value().calls;
  runtime::Controller controller(runtime::CardOptions(opened.value().scenario));
  constexpr int64_t kLastUs = 20'000;
  for (size_t i = 0; i < calls.size(); ++i) {
    const int64_t time = calls.TimeUs(i);
    FUZZ_CHECK(time >= controller.NowUs());
    if (time > kLastUs) return;
    controller.AdvanceUs(time - controller.NowUs());
    static_cast<void>(calls.Describe(i));
    static_cast<void>(calls.Execute(i, &controller));
  }
}

}  // namespace oncard::fuzz
