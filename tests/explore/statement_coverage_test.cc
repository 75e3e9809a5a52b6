// The statements that searches have executed (explore/models/statement_coverage.h).
#include "explore/models/statement_coverage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// What is known of the lines of a program: those with no executed statement, and those with a
/// condition that has gone one way only.
struct Lines {
  std::set<int> executed;
  std::set<int> missed;
  std::set<int> one_way;
};

Lines LinesOf(const vm::Object& object, const StatementCoverage& coverage) {
  Lines lines;
  for (size_t f = 0; f < object.functions.size(); ++f) {
    const vm::Function& function = object.functions[f];
    for (size_t i = 0; i < function.instructions.size(); ++i) {
      const uint8_t bits = coverage.At(f, i);
      (bits != 0 ? lines.executed : lines.missed).insert(function.lines[i]);
      const bool both =
          (bits & StatementCoverage::kHeld) != 0 && (bits & StatementCoverage::kNotHeld) != 0;
      if (bits != 0 && HasTwoWays(function.instructions[i]) && !both) {
        lines.one_way.insert(function.lines[i]);
      }
    }
  }
  return lines;
}

Lines LinesOf(const Findings& findings) {
  return LinesOf(findings.subject.image->object, findings.exploration.coverage);
}

/// Line 8 needs the other thread's write between lines 4 and 5. Line 12 cannot be reached.
constexpr const char* kLateWrite =
    "int x;\n"
    "int t0() {\n"
    "  int a, b, c;\n"
    "  a = x;\n"
    "  b = x;\n"
    "  c = a == b;\n"
    "  if (c) goto E;\n"
    "  a = 5;\n"
    "E:\n"
    "  c = b != 2;\n"
    "  if (c) goto F;\n"
    "  a = 6;\n"
    "F:\n"
    "  return a;\n"
    "}\n"
    "int t1() {\n"
    "  x = 1;\n"
    "  return 0;\n"
    "}\n"
    "//@ final: x == 1\n";

class EngineCoverageTest : public testing::TestWithParam<EngineKind> {};

TEST_P(EngineCoverageTest, EveryEngineNotesWhatItExecutes) {
  const Lines lines = LinesOf(FindingsOf(kLateWrite, {.engine = GetParam()}));
  EXPECT_THAT(lines.missed, ElementsAre(12));
  EXPECT_THAT(lines.one_way, ElementsAre(11));
}

INSTANTIATE_TEST_SUITE_P(StatementCoverageTest, EngineCoverageTest,
                         testing::Values(EngineKind::kAuto, EngineKind::kDpor,
                                         EngineKind::kStateful, EngineKind::kBounded,
                                         EngineKind::kRandom, EngineKind::kPct, EngineKind::kPos),
                         [](const auto& engine) { return std::string(EngineName(engine.param)); });

TEST(StatementCoverageTest, ACompleteSearchExecutesWhatEveryOtherOneDoes) {
  for (uint64_t seed = 1; seed <= 500; ++seed) {
    const std::string source = RandomThreads(seed);
    const Findings single =
        FindingsOf(source, {.engine = EngineKind::kStateful, .merge_private = false, .all = true});
    for (const ExploreOptions& options :
         {ExploreOptions{.engine = EngineKind::kStateful, .merge_private = true, .all = true},
          ExploreOptions{.engine = EngineKind::kDpor, .all = true},
          ExploreOptions{.state_limit = 1, .all = true}}) {
      const Findings other = FindingsOf(source, options);
      // Beside a failure, what `auto` shows is that of the states, which are limited here.
      if (options.state_limit == 1 && other.exploration.failure) continue;
      ASSERT_EQ(other.exploration.coverage, single.exploration.coverage) << source;
    }
  }
}

// A thread that waits in a loop is not asked for passes that change nothing; it is known that it
// can go round, and that it can go on.
TEST(StatementCoverageTest, LoopsThatWaitGoBothWays) {
  const std::string source =
      "int x;\n"
      "int t0() {\n  int a;\nL:\n  a = x == 0;\n  if (a) goto L;\n  return 0;\n}\n"
      "int t1() {\n  int i;\n  i = 0;\n  i = i + 1;\n  x = i;\n  return 0;\n}\n"
      "//@ final: x == 1\n";
  const Findings states = FindingsOf(source, {.engine = EngineKind::kStateful});
  const Findings traces = FindingsOf(source, {.engine = EngineKind::kDpor});
  ASSERT_EQ(traces.exploration.verdict, Verdict::kProved);
  EXPECT_THAT(LinesOf(states).one_way, IsEmpty());
  EXPECT_EQ(traces.exploration.coverage, states.exploration.coverage);
}

TEST(StatementCoverageTest, CountedTracesAreNotedAsExecutedOnes) {
  std::string source = "int x;\nint y;\n";
  for (int i = 0; i < 6; ++i) {
    source += "int t" + std::to_string(i) + "() {\n  int c;\n  x = " + std::to_string(i) +
              ";\n  c = x != 9;\n  if (c) goto E;\n  y = 1;\nE:\n  return 0;\n}\n";
  }
  source += "//@ final: y == 0\n";
  const Findings counted = FindingsOf(source, {.state_limit = 10});
  ASSERT_TRUE(counted.exploration.traces->counted);
  const Findings states = FindingsOf(source, {.engine = EngineKind::kStateful});
  EXPECT_EQ(counted.exploration.coverage, states.exploration.coverage);
  EXPECT_EQ(LinesOf(counted).missed.size(), 6u);
}

TEST(StatementCoverageTest, WithACardEveryStatementIsNoted) {
  // Line 8 cannot be reached.
  const std::string source =
      "int x;\n"
      "int t0() {\n"
      "  int a, c;\n"
      "  GT_Delay(1);\n"
      "  a = x;\n"
      "  c = a != 3;\n"
      "  if (c) goto E;\n"
      "  x = 4;\n"
      "E:\n"
      "  return 0;\n"
      "}\n"
      "int t1() {\n"
      "  x = 1;\n"
      "  return 0;\n"
      "}\n";
  for (const EngineKind engine :
       {EngineKind::kStateful, EngineKind::kAuto, EngineKind::kBounded, EngineKind::kRandom}) {
    const Lines lines = LinesOf(FindingsOf(source, "rate = 10\n", {.engine = engine, .runs = 50}));
    EXPECT_THAT(lines.missed, ElementsAre(8)) << EngineName(engine);
    EXPECT_TRUE(lines.one_way.contains(7)) << EngineName(engine);
  }
}

// The failing run may have been found by another search than the one whose coverage is shown.
TEST(StatementCoverageTest, TheStatementsOfAFailureAreNoted) {
  const std::string source = Increments(3, 4);
  const Findings findings = FindingsOf(source, {.state_limit = 20});
  ASSERT_EQ(findings.exploration.verdict, Verdict::kFailed);
  ASSERT_FALSE(findings.exploration.coverage.empty());
  Problem problem = ProblemOf(source);
  StatementCoverage of_failure;
  problem.model.NoteIn(&of_failure);
  for (const uint8_t thread : findings.exploration.failure->steps) problem.model.Step(thread);
  StatementCoverage both = findings.exploration.coverage;
  both.Include(of_failure);
  EXPECT_EQ(both, findings.exploration.coverage);
}

TEST(StatementCoverageTest, WhatOneSearchDoesNotKnowIsNotKnown) {
  StatementCoverage known(ProblemOf(kLateWrite).model.image().object);
  ASSERT_FALSE(known.empty());
  known.Include(StatementCoverage());
  EXPECT_TRUE(known.empty());
}

}  // namespace
}  // namespace oncard::explore
