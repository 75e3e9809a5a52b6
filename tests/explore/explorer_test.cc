// Verdicts of both engines (explore/search/explorer.h).
#include "explore/search/explorer.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

Exploration RunOn(const std::string& source, const ExploreOptions& options) {
  auto result = Explore(ProblemOf(source), options);
  EXPECT_TRUE(result.ok());
  return std::move(result).value();
}

TEST(ExplorerTest, BothEnginesProveAndRefuteAlike) {
  struct Case {
    std::string source;
    Verdict verdict;
  };
  const std::string good =
      "int x, y;\n//@ final: x == 1 && y == 1\nint t0() {\n x = 1;\n}\n"
      "int t1() {\n y = 1;\n}\n";
  for (const Case& c : {Case{good, Verdict::kProved}, Case{Increments(2, 2), Verdict::kFailed}}) {
    for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kDpor, EngineKind::kStateful}) {
      EXPECT_EQ(RunOn(c.source, {.engine = engine}).verdict, c.verdict) << EngineName(engine);
    }
  }
}

TEST(ExplorerTest, WaitingLoopsAreDecidedByStates) {
  EXPECT_EQ(RunOn(Peterson(false), {}).verdict, Verdict::kProved);
  EXPECT_EQ(RunOn(Peterson(true), {}).verdict, Verdict::kFailed);
  const Exploration livelock = RunOn(MutualWait(), {});
  EXPECT_EQ(livelock.verdict, Verdict::kFailed);
  EXPECT_TRUE(livelock.failure->livelock);
}

TEST(ExplorerTest, MergedStatementsDecideTheSame) {
  const ExploreOptions merged = {.engine = EngineKind::kStateful,
                                 .merge_private = true,
                                 .dead_locals = false,
                                 .symmetry = false};
  for (const std::string& source :
       {Peterson(false), Peterson(true), MutualWait(), Increments(3, 2)}) {
    const Exploration whole =
        RunOn(source, {.engine = EngineKind::kStateful, .merge_private = false});
    const Exploration less = RunOn(source, merged);
    EXPECT_EQ(less.verdict, whole.verdict);
    EXPECT_LT(less.states->states, whole.states->states);
    EXPECT_EQ(less.states->final_full, whole.states->final_full);
    if (!whole.failure) continue;
    EXPECT_EQ(less.failure->livelock, whole.failure->livelock);
    EXPECT_EQ(less.failure->preemptions, whole.failure->preemptions);
    // The failure's steps are a run of the program, statement by statement.
    Model model = ProblemOf(source).model;
    for (const uint8_t thread : less.failure->steps) {
      ASSERT_TRUE(model.Running(thread));
      model.Step(thread);
    }
  }
}

// Between `x = 1` and the end of thread 0 there is a state that merging skips.
TEST(ExplorerTest, StatementsAreNotMergedWhereARequirementSeesWhatIsBetween) {
  const std::string threads =
      "int x;\nint t0() {\n  int t;\n  x = 1;\n  t = 1;\n  t = 2;\n  return 5;\n}\n"
      "int t1() {\n  x = 1;\n  return 0;\n}\n";
  struct Case {
    std::string requirement;
    Verdict verdict;
    bool mergeable;
  };
  for (const Case& c : {Case{"never: x == 1 && page0.t == 1", Verdict::kFailed, false},
                        Case{"always: x == 0 || ret0 == 5", Verdict::kFailed, false},
                        Case{"eventually: page0.t == 1", Verdict::kProved, false},
                        Case{"leads: ret0 == 5 -> x == 1", Verdict::kProved, false},
                        Case{"leads: x == 1 -> page0.t == 1", Verdict::kFailed, false},
                        Case{"never: x == 2", Verdict::kProved, true},
                        Case{"final: page0.t == 2 && ret0 == 5", Verdict::kProved, true}}) {
    SCOPED_TRACE(c.requirement);
    const Problem problem = ProblemOf("//@ " + c.requirement + "\n" + threads);
    const Exploration found = Explore(problem, {.engine = EngineKind::kStateful}).value();
    EXPECT_EQ(found.verdict, c.verdict);
    EXPECT_EQ(found.states->merged, c.mergeable);
    const ExploreOptions merged = {.engine = EngineKind::kStateful, .merge_private = true};
    EXPECT_EQ(Explore(problem, merged).ok(), c.mergeable);
  }
}

// What is shown of a failure does not depend on whether its search has merged statements.
TEST(ExplorerTest, AFailureIsShownAsInSingleStatements) {
  for (const std::string& source : {Peterson(true), MutualWait(), Increments(2, 2)}) {
    const Exploration whole =
        RunOn(source, {.engine = EngineKind::kStateful, .merge_private = false});
    const Exploration found = RunOn(source, {.engine = EngineKind::kStateful});
    ASSERT_TRUE(found.failure && whole.failure);
    EXPECT_EQ(found.failure->steps, whole.failure->steps);
    EXPECT_EQ(found.failure->cycle, whole.failure->cycle);
    EXPECT_EQ(found.failure->fewest_steps, whole.failure->fewest_steps);
    EXPECT_EQ(found.states->states, whole.states->states);
    EXPECT_FALSE(found.states->merged);
  }
}

// A graph that is too large in single statements.
TEST(ExplorerTest, AFailureInManyStatesIsShownInMergedStatements) {
  const ExploreOptions few = {.engine = EngineKind::kStateful, .state_limit = 5000};
  const Exploration found = RunOn(Increments(3, 2), few);
  ASSERT_TRUE(found.failure);
  EXPECT_TRUE(found.states->merged);
  EXPECT_TRUE(found.states->complete);
  EXPECT_EQ(found.failure->preemptions, 1);
}

// As single statements they are 8 242 408 states.
TEST(ExplorerTest, ThreeThreadsOfFiftyIncrementsAreProved) {
  std::string source = "int x;\n//@ final: x == 150\n";
  for (int thread = 0; thread < 3; ++thread) {
    source += fmt::format(
        "int t{}() {{\n  int i, c;\nL:\n  x = x + 1;\n  i = i + 1;\n  c = i < 50;\n"
        "  if (c) goto L;\n  return 0;\n}}\n",
        thread);
  }
  const Exploration found = RunOn(source, {.engine = EngineKind::kStateful, .symmetry = false});
  EXPECT_EQ(found.verdict, Verdict::kProved);
  // Each thread is before one of its increments, or has ended.
  EXPECT_EQ(found.states->states, 51 * 51 * 51);
  // Multisets of three of these places.
  const Exploration exchanged = RunOn(source, {.engine = EngineKind::kStateful});
  EXPECT_EQ(exchanged.verdict, Verdict::kProved);
  EXPECT_EQ(exchanged.states->states, 53 * 52 * 51 / 6);
}

TEST(ExplorerTest, TheFailureIsTheSimplestWhereStatesAreKnown) {
  const Exploration exploration = RunOn(Increments(2, 1), {.engine = EngineKind::kStateful});
  ASSERT_TRUE(exploration.failure);
  EXPECT_TRUE(exploration.failure->fewest_preemptions);
  EXPECT_EQ(exploration.failure->preemptions, 1);
  EXPECT_EQ(exploration.failure->fewest_steps, 8);
  EXPECT_EQ(exploration.failure->last_escape, 1);
  EXPECT_EQ(exploration.states->finals_within, (std::vector<int64_t>{1, 2, 2, 2}));
}

TEST(ExplorerTest, DporCountsTracesAndEnds) {
  const Exploration exploration = RunOn(Increments(3, 2), {.engine = EngineKind::kDpor});
  EXPECT_EQ(exploration.traces->executions, 7134);
  EXPECT_EQ(exploration.traces->bad_traces, 7044);
  EXPECT_EQ(exploration.traces->final_globals, 5);
  EXPECT_EQ(exploration.failure->preemptions, 1);
}

TEST(ExplorerTest, ALimitIsNotAProof) {
  const Exploration exploration =
      RunOn(Increments(3, 2) + "\n", {.engine = EngineKind::kStateful, .state_limit = 10});
  EXPECT_EQ(exploration.verdict, Verdict::kIncomplete);
  EXPECT_FALSE(exploration.why.en.empty());
}

TEST(ExplorerTest, WhatMustHoldInSomeStateNeedsStates) {
  const std::string source =
      "int x;\n//@ eventually: x == 2\nint t0() {\n  x = 1;\n  x = 0;\n}\nint t1() {\n  int r;\n  "
      "r = "
      "x;\n}\n";
  EXPECT_FALSE(Explore(ProblemOf(source), {.engine = EngineKind::kDpor}).ok());
  const Exploration exploration = RunOn(source, {});
  EXPECT_EQ(exploration.verdict, Verdict::kFailed);
}

// So the counts are those of the graph.
TEST(ExplorerTest, WhatMustHoldInEveryStateIsSoughtInASmallGraphAlone) {
  const std::string source =
      "int x;\n//@ never: x == 1\nint t0() {\n  x = 1;\n  x = 0;\n}\nint t1() {\n  int r;\n  r = "
      "x;\n}\n";
  const Exploration exploration = RunOn(source, {});
  EXPECT_EQ(exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(exploration.failure->steps.size(), 1u);
  EXPECT_FALSE(exploration.traces);
  EXPECT_FALSE(exploration.paired);
}

TEST(ExplorerTest, EnginesHaveNames) {
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kDpor, EngineKind::kStateful}) {
    EXPECT_EQ(EngineNamed(EngineName(engine)), engine);
  }
  EXPECT_FALSE(EngineNamed("spin"));
}

}  // namespace
}  // namespace oncard::explore
