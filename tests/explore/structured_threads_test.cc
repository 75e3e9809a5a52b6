// Random threads in structured C: the explorer decides about such a program what it decides about
// the text to which it is lowered, by the same search. ONCARD_STRUCTURED_PROGRAMS=1000 tests more
// than the default number.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

#include "compiler/lowering/lowering.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "tests/compiler/memory_files.h"
#include "tests/differential/random_choices.h"

namespace oncard::explore {
namespace {

constexpr int kUsualPrograms = 60;

// Every loop ends after a few rounds, whatever the other threads do.
class Generator : differential::RandomChoices {
 public:
  using RandomChoices::RandomChoices;

  std::string Make() {
    std::string text =
        "int g0, g1, a[2];\n"
        "int clamp(int x) { if (x > 3) return 3; return x < 0 ? 0 : x; }\n"
        "void add(int x) { g0 += x; a[x & 1]++; }\n";
    const int threads = Between(2, 3);
    for (int thread = 0; thread < threads; ++thread) {
      text += fmt::format("void t{}() {{\n  int l = {}, n = 2;\n", thread, Between(0, 2));
      for (int i = Between(1, threads == 2 ? 3 : 1); i > 0; --i) text += Statement(1);
      text += "  g1 += l;\n}\n";
    }
    return text;
  }

  std::string Requirement() {
    return fmt::format("//@ final: {} {} {}\n", Pick({"g0", "g1", "a[0]", "a[1]"}),
                       Pick({"!=", "!=", "<=", "=="}), Between(0, 4));
  }

 private:
  std::string Target() { return Pick({"g0", "g0", "g1", "a[0]", "a[l & 1]", "l"}); }

  std::string Value() {
    switch (Between(0, 5)) {
      case 0:
        return std::to_string(Between(1, 3));
      case 1:
        return fmt::format("{} + {}", Pick({"g0", "g1", "l"}), Between(1, 2));
      case 2:
        return fmt::format("clamp({} * 2 - l)", Pick({"g0", "g1"}));
      case 3:
        return fmt::format("{} > 0 && {} < 2", Pick({"g0", "g1"}), Pick({"g1", "a[0]", "l"}));
      default:
        return Pick({"g0", "g1", "a[1]", "l", "n"});
    }
  }

  std::string Statement(int depth) {
    switch (depth > 0 ? Between(0, 7) : Between(0, 4)) {
      case 0:
        return fmt::format("  {} = {};\n", Target(), Value());
      case 1:
        return fmt::format("  {} {} {};\n", Target(), Pick({"+=", "-=", "|=", "*="}), Value());
      case 2:
        return fmt::format("  {}{};\n", Target(), Pick({"++", "--"}));
      case 3:
        return fmt::format("  add({});\n", Value());
      case 4:
        return fmt::format("  l = {};\n", Value());
      case 5:
        return fmt::format("  for (int i = 0; i < 2; i++) {{\n  {}  }}\n", Statement(depth - 1));
      case 6:
        return fmt::format("  while (n-- > 0 && {}) {{\n  {}  }}\n", Value(), Statement(depth - 1));
      default:
        return fmt::format("  if ({}) {{\n  {}  }} else {{\n  {}  }}\n", Value(),
                           Statement(depth - 1), Statement(depth - 1));
    }
  }
};

int ProgramCount() {
  const char* wanted = std::getenv("ONCARD_STRUCTURED_PROGRAMS");
  return wanted != nullptr ? std::atoi(wanted) : kUsualPrograms;
}

std::string Lowered(const std::string& program, bool optimize) {
  const compiler::Lowering lowering =
      compiler::LowerText("program.c", program, {}, {optimize, false}, compiler::NoFiles());
  EXPECT_TRUE(lowering.text.has_value()) << program;
  return lowering.text.value_or("");
}

Exploration ExplorationOf(const std::string& source, EngineKind engine) {
  constexpr int64_t kExecutions = 2000;
  return Explore(ProblemOf(source), {.engine = engine, .execution_limit = kExecutions}).value();
}

// What an engine finds out, and how much it had to search for that.
std::string Summary(const Exploration& found) {
  std::string text = fmt::format("{} by {}", VerdictName(found.verdict), EngineName(found.engine));
  if (found.traces) {
    text +=
        fmt::format(", {} executions, {} bad", found.traces->executions, found.traces->bad_traces);
  }
  if (found.states) {
    text += fmt::format(", {} states, {} transitions, {} bad", found.states->states,
                        found.states->transitions, found.states->bad_states);
  }
  if (!found.failure) return text;
  text += fmt::format(", {} preemptions:", found.failure->preemptions);
  for (const uint8_t thread : found.failure->steps) text += fmt::format(" {}", thread);
  return text;
}

TEST(StructuredThreadsTest, HaveTheVerdictOfTheirLoweredText) {
  std::map<Verdict, int> verdicts;
  for (int seed = 0; seed < ProgramCount(); ++seed) {
    Generator generator(static_cast<uint64_t>(seed));
    const std::string program = generator.Make();
    const std::string requirement = generator.Requirement();
    SCOPED_TRACE(fmt::format("seed {}\n{}{}", seed, requirement, program));
    const std::string structured = "//@ structured\n" + requirement + program;
    const std::string lowered = requirement + Lowered(program, true);
    for (const EngineKind engine : {EngineKind::kStateful, EngineKind::kDpor}) {
      ASSERT_EQ(Summary(ExplorationOf(structured, engine)),
                Summary(ExplorationOf(lowered, engine)));
    }
    const Verdict verdict = ExplorationOf(structured, EngineKind::kStateful).verdict;
    ++verdicts[verdict];
    // The passes add no way for other threads to come between.
    const std::string plain = requirement + Lowered(program, false);
    if (ExplorationOf(plain, EngineKind::kStateful).verdict == Verdict::kProved) {
      ASSERT_EQ(verdict, Verdict::kProved);
    }
  }
  EXPECT_EQ(verdicts[Verdict::kProved] + verdicts[Verdict::kFailed], ProgramCount());
  EXPECT_GE(verdicts[Verdict::kProved], ProgramCount() / 5);
  EXPECT_GE(verdicts[Verdict::kFailed], ProgramCount() / 5);
}

}  // namespace
}  // namespace oncard::explore
