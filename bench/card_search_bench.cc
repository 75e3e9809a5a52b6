// A part of `oncard_bench explore`: searches of whole machines, programs with their card and its
// world. The programs and their scenarios are in searches/. Each search is a run of the command, so
// that its peak of memory is known; it ends by itself, proved or at a limit.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files.h"
#include "bench/measure.h"
#include "bench/tool.h"
#include "runtime/scenario/file/scenario.h"

namespace oncard::bench {
namespace {

/// The limits of a search.
constexpr int kSeconds = 60;
constexpr int kMemoryMib = 2048;
/// The most axes that a card has.
constexpr size_t kAxesMax = 12;

struct CardSearch {
  std::string verdict;
  double states = 0;      ///< 0 if the report names none
  double seconds = 0;     ///< wall-clock time of the whole command
  double peak_bytes = 0;  ///< the most memory that the command occupied
};

/// What stands behind a key in a report, up to the end of its line; empty if the key is missing.
std::string_view ValueOf(std::string_view key, std::string_view report) {
  const size_t at = report.find(fmt::format("\n  \"{}\": ", key));
  if (at == std::string_view::npos) return {};
  const size_t begin = report.find(": ", at) + 2;
  return report.substr(begin, report.find_first_of(",\n", begin) - begin);
}

runtime::Scenario LoadSearch(const std::string& name) {
  auto scenario = runtime::LoadScenario(fmt::format("{}/{}.toml", ONCARD_SEARCHES, name),
                                        runtime::ScenarioUse::kExplore);
  if (!scenario.ok()) Fail(scenario.error().message.en);
  return std::move(scenario).value();
}

/// The independent axes of searches/axes.toml, the first `count` of them.
runtime::Scenario Axes(size_t count) {
  runtime::Scenario scenario = LoadSearch("axes");
  scenario.threads.resize(count);
  scenario.final.resize(count);
  scenario.axis_count = count <= 8 ? 8 : 12;
  return scenario;
}

/// The states of the proof: those that were left over, or of islands, or all.
double StatesOf(std::string_view report) {
  for (const std::string_view key : {"reduced_states", "island_states"}) {
    const std::string states(ValueOf(key, report));
    if (!states.empty()) return std::strtod(states.c_str(), nullptr);
  }
  return std::strtod(std::string(ValueOf("states", report)).c_str(), nullptr);
}

CardSearch SearchOf(const runtime::Scenario& scenario, const std::vector<std::string>& options) {
  const std::string folder = NewFolder();
  const std::string file = folder + "/search.toml";
  if (!WriteFileAtomically(file, runtime::FormatScenario(runtime::MoveScenario(scenario, file)))
           .ok()) {
    Fail("cannot write a scenario");
  }
  std::vector<std::string> arguments = {"explore", file, fmt::format("--time={}", kSeconds),
                                        fmt::format("--memory={}", kMemoryMib), "--format=json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ToolRun run = MeasureTool(arguments);
  std::filesystem::remove_all(folder);
  const std::string_view verdict = ValueOf("verdict", run.out);
  if (verdict.size() < 2) Fail("a search gave no verdict");
  return {std::string(verdict.substr(1, verdict.size() - 2)), StatesOf(run.out), run.seconds,
          run.peak_bytes};
}

/// What was found, behind the figures of a line.
void PrintFound(const CardSearch& search) {
  std::printf(" (%s, %.0f states, %.0f MB)\n", search.verdict.c_str(), search.states,
              search.peak_bytes * 1e-6);
  std::fflush(stdout);
}

void MeasureSearch(const char* name, const runtime::Scenario& scenario) {
  const CardSearch search = SearchOf(scenario, {});
  std::printf("%s: %.2f s", name, search.seconds);
  PrintFound(search);
}

/// The memory of a state is what the command occupies beyond its need for a search of few states.
void MeasureBytes() {
  const CardSearch few = SearchOf(Axes(1), {"--engine=stateful"});
  const CardSearch many = SearchOf(Axes(4), {"--engine=stateful"});
  std::printf("card 4 axes: %.2f s, %.0f bytes/state of the peak of memory", many.seconds,
              std::max(0.0, many.peak_bytes - few.peak_bytes) / std::max(1.0, many.states));
  PrintFound(many);
}

/// How many independent axes can be proved within the limits.
void MeasureAxes(const char* how, const std::vector<std::string>& options) {
  size_t proved = 0;
  CardSearch last;
  CardSearch next;
  while (proved < kAxesMax) {
    next = SearchOf(Axes(proved + 1), options);
    if (next.verdict != "PROVED") break;
    last = next;
    ++proved;
  }
  std::printf("axes proved in %d s, %s: %zu, the last in %.2f s", kSeconds, how, proved,
              last.seconds);
  PrintFound(last);
}

}  // namespace

void BenchCardSearches() {
  MeasureBytes();
  MeasureAxes("all states", {"--engine=stateful"});
  MeasureAxes("with reductions", {"--no-islands"});
  MeasureAxes("by islands", {});
  runtime::Scenario stop = LoadSearch("estop");
  MeasureSearch("e-stop any instant 10..40 ms, 4 threads, 2 axes", stop);
  stop.rate = 400;
  MeasureSearch("the same at rate 400", stop);
  MeasureSearch("polling pick-and-place 290 ms", LoadSearch("pick"));
}

}  // namespace oncard::bench
