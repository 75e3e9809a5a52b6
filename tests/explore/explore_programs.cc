#include "explore_programs.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <random>

#include "compiler/compiler.h"
#include "explore/scenario_exploration.h"
#include "tests/compiler/memory_files.h"

namespace oncard::explore {
namespace {

template <typename T>
T Need(Result<T> result) {
  if (!result.ok()) {
    std::fprintf(stderr, "%s\n", result.error().message.en.c_str());
    std::abort();
  }
  return std::move(result).value();
}

vm::Object Compiled(const std::string& source) {
  auto compilation = compiler::CompileText("program.c", source, {}, compiler::NoFiles());
  if (!compilation.ok()) std::abort();
  return *compilation.object;
}

runtime::Scenario ScenarioOf(const std::string& source, const std::string& keys,
                             const vm::Object& object) {
  runtime::Scenario scenario =
      Need(runtime::ParseScenario("program = \"program.c\"\n" + keys, "test.toml"));
  scenario.threads = Need(ReadComments("program.c", source, object)).scenario.threads;
  return scenario;
}

}  // namespace

Problem ProblemOf(const std::string& source) {
  const vm::Object object = Compiled(source);
  const CommentProblem read = Need(ReadComments("program.c", source, object));
  return Need(ProblemOfScenario(read.scenario, read.requirements, object));
}

CardModel CardOf(const std::string& source, const std::string& keys) {
  const vm::Object object = Compiled(source);
  const runtime::Scenario scenario = ScenarioOf(source, keys, object);
  return Need(CardModel::Create(scenario, RequirementsOf(scenario), object));
}

LoadedScenario LoadedOf(const std::string& source, const std::string& keys) {
  LoadedScenario loaded{Compiled(source), {}, {}};
  loaded.scenario = ScenarioOf(source, keys, loaded.object);
  loaded.requirements = RequirementsOf(loaded.scenario);
  return loaded;
}

Findings FindingsOf(const std::string& source, const ExploreOptions& options) {
  const vm::Object object = Compiled(source);
  const CommentProblem read = Need(ReadComments("program.c", source, object));
  return Need(ExploreScenario(read.scenario, read.requirements, object, options));
}

Findings FindingsOf(const std::string& source, const std::string& keys,
                    const ExploreOptions& options) {
  return Need(TryFindingsOf(source, keys, options));
}

Result<Findings> TryFindingsOf(const std::string& source, const std::string& keys,
                               const ExploreOptions& options) {
  const vm::Object object = Compiled(source);
  const runtime::Scenario scenario = ScenarioOf(source, keys, object);
  return ExploreScenario(scenario, RequirementsOf(scenario), object, options);
}

std::string Increments(int threads, int times) {
  std::string source = fmt::format("int x;\n//@ final: x == {}\n", threads * times);
  for (int thread = 0; thread < threads; ++thread) {
    source += fmt::format("int t{}() {{\n  int t;\n", thread);
    for (int i = 0; i < times; ++i) source += "  t = x;\n  t = t + 1;\n  x = t;\n";
    source += "  return 0;\n}\n";
  }
  return source;
}

std::string NeverFive() {
  return "int x;\n"
         "int t0() {\n"
         "  int c;\n"
         "  c = x != 5;\n"
         "  if (c) goto E;\n"
         "  x = 7;\n"
         "E:\n"
         "  return 0;\n"
         "}\n";
}

std::string Peterson(bool broken) {
  std::string source = "int f0, f1, turn, c;\n//@ final: c == 2\n";
  for (int own = 0; own < 2; ++own) {
    const int other = 1 - own;
    source += fmt::format(
        "int t{0}() {{\n  int a, cc;\n  f{0} = 1;\n  turn = {2};\nW:\n  a = f{1};\n  cc = a == 0;\n"
        "  if (cc) goto C;\n  a = turn;\n  cc = a == {1};\n  if (cc) goto W;\nC:\n  a = c;\n"
        "  a = a + 1;\n  c = a;\n  f{0} = 0;\n  return 0;\n}}\n",
        own, other, broken ? own : other);
  }
  return source;
}

std::string RandomThreads(uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](uint64_t n) { return static_cast<int>(random() % n); };
  std::string source = "int g[3];\n//@ final: g[0] != 2\n";
  const int threads = 2 + below(2);
  for (int thread = 0; thread < threads; ++thread) {
    source += fmt::format("int t{}() {{\n  int r, k, c;\n", thread);
    const int statements = 1 + below(threads == 2 ? 4 : 2);
    bool skips = false;
    for (int i = 0; i < statements; ++i) {
      switch (below(6)) {
        case 0:
          source += fmt::format("  r = g[{}];\n", below(3));
          break;
        case 1:
          source += fmt::format("  g[{}] = r + {};\n", below(3), 1 + below(2));
          break;
        case 2:
          source += fmt::format("  g[{0}] = g[{0}] + 1;\n", below(3));
          break;
        case 3:
          source += fmt::format("  g[{}] = g[{}];\n", below(3), below(3));
          break;
        case 4:
          source += "  k = r & 1;\n  g[k] = 2;\n";
          break;
        default:
          source += fmt::format("  c = g[{}] > 0;\n  if (c) goto E;\n", below(3));
          skips = true;
          break;
      }
    }
    source += skips ? "E:\n  return r;\n}\n" : "  return r;\n}\n";
  }
  return source;
}

std::string MutualWait() {
  std::string source = "int f0, f1;\n";
  for (int own = 0; own < 2; ++own) {
    source += fmt::format(
        "int t{0}() {{\n  int a, cc;\nW:\n  a = f{1};\n  cc = a == 0;\n  if (cc) goto W;\n"
        "  f{0} = 1;\n  return 0;\n}}\n",
        own, 1 - own);
  }
  return source;
}

}  // namespace oncard::explore
