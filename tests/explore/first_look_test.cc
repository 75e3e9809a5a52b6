// What is found before everything is searched (explore/engines/first_look.h), and how far searches
// continue after a failure.
#include "explore/engines/first_look.h"

#include <gtest/gtest.h>

#include <random>

#include "explore/engines/card_graph.h"
#include "explore/engines/shrink.h"
#include "explore/engines/state_search.h"
#include "explore/engines/trace_search.h"
#include "explore/engines/walk.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

/// Threads that count to `times` in loops of three statements; far too many interleavings to
/// search.
std::string Counters(int threads, int times, const std::string& requirement) {
  std::string source = "int x;\n//@ final: " + requirement + "\n";
  for (int thread = 0; thread < threads; ++thread) {
    source +=
        "int t" + std::to_string(thread) +
        "() {\n  int i, t, cc;\n  i = 0;\nL:\n  cc = i >= " + std::to_string(times) +
        ";\n  if (cc) goto E;\n  t = x;\n  t = t + 1;\n  x = t;\n  i = i + 1;\n  goto L;\nE:\n"
        "  return i;\n}\n";
  }
  return source;
}

/// An endless loop that reads the inputs, as in many programs of machines.
std::string Scan(int threads) {
  std::string source = "int n;\n";
  for (int thread = 0; thread < threads; ++thread) {
    source += "int t" + std::to_string(thread) +
              "() {\n  int di;\nL:\n  GT_GetDi(4, &di);\n  n = n + di;\n  goto L;\n}\n";
  }
  return source;
}

TEST(FirstLookTest, FindsWhatNeedsNoPreemption) {
  // One after the other, the threads lose no addition.
  const Problem problem = ProblemOf(Counters(4, 100, "x != 400"));
  const FirstLook look = LookFirst(problem, nullptr);
  ASSERT_TRUE(look.found());
  EXPECT_TRUE(look.fewest_preemptions);
  ProgramWalk walk(problem);
  for (const uint8_t thread : look.failing) walk.Step(thread);
  EXPECT_EQ(walk.fault().kind, Fault::Kind::kRequirement);
  Model model = problem.model;
  EXPECT_EQ(CountPreemptions(&model, look.failing), 0);
}

TEST(FirstLookTest, RandomSchedulesFindWhatNeedsMany) {
  // More than a tenth of the additions is lost.
  const FirstLook look = LookFirst(ProblemOf(Counters(2, 100, "x > 180")), nullptr);
  EXPECT_TRUE(look.found());
}

TEST(FirstLookTest, FindsNothingInWhatIsRight) {
  EXPECT_FALSE(LookFirst(ProblemOf(Counters(2, 3, "x >= 1 && x <= 6")), nullptr).found());
  EXPECT_FALSE(LookFirst(ProblemOf(Peterson(false)), nullptr).found());
  CardModel card = CardOf(Increments(2, 1), "never = [\"x > 2\"]\n");
  EXPECT_FALSE(LookFirstAtCard(&card, nullptr).found());
}

TEST(FirstLookTest, AutoShowsWhatWasFoundWhereStatesAreTooMany) {
  const auto explore = [] { return Explore(ProblemOf(Counters(4, 100, "x != 400")), {}).value(); };
  const Exploration exploration = explore();
  EXPECT_EQ(exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(exploration.failure->preemptions, 0);
  EXPECT_TRUE(exploration.failure->fewest_preemptions);
  EXPECT_EQ(exploration.failure->steps, explore().failure->steps);
}

TEST(FirstLookTest, AnEndlessScanReachesTheLimitAtOnce) {
  for (const int threads : {1, 3}) {
    const Findings findings = FindingsOf(Scan(threads), "limit_ms = 2000\n", {});
    ASSERT_TRUE(findings.exploration.failure);
    EXPECT_EQ(findings.exploration.failure->fault.kind, Fault::Kind::kTimeLimit);
    // 100 statements per millisecond; only the last few are shown.
    EXPECT_EQ(findings.exploration.failure->steps.size(), 200'000u);
    EXPECT_EQ(findings.trail.steps.size() + static_cast<size_t>(findings.trail.skipped), 200'000u);
    EXPECT_LT(findings.trail.steps.size(), 100u);
  }
}

TEST(FirstLookTest, ALongScanIsFollowedFromShortlyBeforeItsEnd) {
  const std::string limit = "limit_ms = 9000\n";
  CardModel card = CardOf(Scan(1), limit);
  const FirstLook look = LookFirstAtCard(&card, nullptr);
  ASSERT_TRUE(look.failure);
  const Failure& failure = *look.failure;
  EXPECT_EQ(failure.fault.kind, Fault::Kind::kTimeLimit);
  ASSERT_EQ(failure.steps.size(), 900'000u);
  ASSERT_NE(failure.late, nullptr);
  EXPECT_EQ(failure.late_steps, 700'000);
  // The part that is shown equals the end of the whole run.
  Failure from_the_start = failure;
  from_the_start.late = nullptr;
  from_the_start.late_steps = 0;
  const Trail late = Follow(&card, failure);
  const Trail whole = Follow(&card, from_the_start);
  ASSERT_EQ(late.steps.size(), whole.steps.size());
  EXPECT_EQ(late.skipped, whole.skipped);
  for (size_t i = 0; i < late.steps.size(); ++i) {
    EXPECT_EQ(late.steps[i].log.at_ms, whole.steps[i].log.at_ms);
    EXPECT_EQ(late.steps[i].log.line, whole.steps[i].log.line);
  }
}

// --- After a failure -----------------------------------------------------------------------------

TEST(AftermathTest, TracesEndSoonAfterTheFirstThatGoesWrong) {
  const Problem problem = ProblemOf(Increments(2, 2));
  TraceSearch at_once;
  SearchTraces(problem, {.statements_after_bad = 0}, &at_once);
  EXPECT_EQ(at_once.bad, 1);
  EXPECT_FALSE(at_once.complete());
  // 14 statements each.
  TraceSearch later;
  SearchTraces(problem, {.statements_after_bad = 10 * 14}, &later);
  EXPECT_EQ(later.executions, at_once.executions + 10);
  TraceSearch whole;
  SearchTraces(problem, {}, &whole);
  EXPECT_EQ(whole.executions, 34);
  EXPECT_EQ(whole.bad, 28);
}

TEST(AftermathTest, StatesEndSoonAfterTheFirstBadOne) {
  const Problem problem = ProblemOf(Increments(2, 2));
  const StateSearch at_once = SearchStates(problem, {.states_after_bad = 1});
  EXPECT_EQ(at_once.counts.bad_states, 1);
  EXPECT_FALSE(at_once.counts.complete);
  const StateSearch later = SearchStates(problem, {.states_after_bad = 21});
  EXPECT_EQ(later.counts.states, at_once.counts.states + 20);
  CardModel card = CardOf(Increments(2, 2), "expect = [\"x == 4\"]\n");
  const CardGraph some = BuildCardGraph(&card, {.states_after_bad = 1});
  const CardGraph all = BuildCardGraph(&card, {});
  EXPECT_FALSE(some.graph.complete);
  EXPECT_GE(some.bad_states, 1);
  EXPECT_LT(some.graph.size(), all.graph.size());
}

TEST(AftermathTest, ASmallProgramIsCountedWholeAllTheSame) {
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful}) {
    const Exploration exploration =
        Explore(ProblemOf(Increments(2, 2)), {.engine = engine}).value();
    EXPECT_TRUE(exploration.states->complete);
    EXPECT_EQ(exploration.states->bad_states, 6);
  }
}

// --- Runs in place -------------------------------------------------------------------------------

TEST(CardWalkTest, InPlaceItDoesWhatItDoesWithStates) {
  CardModel kept_model = CardOf(Increments(3, 2), "rate = 16\nalways = [\"x < 6\"]\n");
  CardModel live_model = CardOf(Increments(3, 2), "rate = 16\nalways = [\"x < 6\"]\n");
  CardWalk kept(&kept_model, true);
  CardWalk live(&live_model, false);
  std::mt19937_64 random(3);
  for (int run = 0; run < 50; ++run) {
    kept.Restart();
    live.Restart();
    while (!kept.ended()) {
      ASSERT_EQ(live.choices(), kept.choices());
      EXPECT_EQ(live.DependOnEachOther(0, 1), kept.DependOnEachOther(0, 1));
      int thread = static_cast<int>(random() % 3);
      while ((kept.choices() >> thread & 1) == 0) thread = (thread + 1) % 3;
      kept.Step(thread);
      live.Step(thread);
    }
    EXPECT_TRUE(live.ended());
    EXPECT_EQ(live.finished(), kept.finished());
    EXPECT_EQ(live.fault().kind, kept.fault().kind);
    EXPECT_EQ(live.EndKey(), kept.EndKey());
    EXPECT_EQ(live.EndNow(), kept.EndNow());
  }
}

TEST(CardWalkTest, SeveralStatementsAtOnceAreTheSameAsOneByOne) {
  // One thread, then two of which one ends first: a thread alone executes several statements at
  // once.
  for (const int threads : {1, 2}) {
    const std::string keys = "rate = 7\nuntil_ms = 40\n";
    CardModel single_model = CardOf(Scan(threads) + "int t9() {\n  n = 1;\n}\n", keys);
    CardModel alone_model = CardOf(Scan(threads) + "int t9() {\n  n = 1;\n}\n", keys);
    CardWalk single(&single_model, false);
    CardWalk alone(&alone_model, false);
    int64_t most_at_once = 0;
    while (!alone.ended()) {
      const int thread = std::countr_zero(alone.choices());
      const int64_t taken = alone.StepAlone(thread, 5);
      most_at_once = std::max(most_at_once, taken);
      for (int64_t i = 0; i < taken; ++i) {
        ASSERT_EQ(single.choices(), uint32_t{1} << thread | single.choices());
        single.Step(thread);
      }
      ASSERT_EQ(single.choices(), alone.choices());
    }
    EXPECT_TRUE(single.ended());
    EXPECT_EQ(single.EndKey(), alone.EndKey());
    EXPECT_EQ(most_at_once > 1, threads == 1);
  }
}

}  // namespace
}  // namespace oncard::explore
