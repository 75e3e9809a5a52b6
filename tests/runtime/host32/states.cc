// Runs scenarios under several policies and prints the result of each run in the format that
// states.sh uses: FILE POLICY PROGRAM_HASH STATE_HASH, or `refused` for a scenario that is not a
// single run.
#include <fmt/core.h>

#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/scenario_run.h"
#include "runtime/sim/program.h"

namespace oncard::runtime {
namespace {

std::string HashesOf(const std::string& path, const std::string& policy) {
  auto scenario = LoadScenario(path, ScenarioUse::kRun);
  if (!scenario.ok()) return "refused";
  scenario.value().schedule = policy;
  ProgramLoad load = LoadProgram(ProgramPath(scenario.value()), CompileOptions(scenario.value()));
  if (!load.object.has_value()) return "refused";
  const auto run = RunScenario(scenario.value(), std::move(*load.object));
  if (!run.ok()) return "refused";
  return fmt::format("{:016x} {:016x}", run.value().program_hash, run.value().hash);
}

}  // namespace
}  // namespace oncard::runtime

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    for (const char* policy : {"rr", "random:7", "pct:7:3"}) {
      fmt::print("{} {} {}\n", argv[i], policy, oncard::runtime::HashesOf(argv[i], policy));
    }
  }
  return 0;
}
