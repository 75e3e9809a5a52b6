// Every phase of a search ends soon after it is told to, and what it has found is kept. That a
// phase is told before it begins, or between two of its results, takes the place of a clock.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "explore/engines/dpor.h"
#include "explore/engines/estimate.h"
#include "explore/engines/first_look.h"
#include "explore/engines/sampler.h"
#include "explore/engines/shrink.h"
#include "explore/engines/state_search.h"
#include "explore/search/explorer.h"
#include "explore/search/search_pair.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

const std::atomic<bool> kTold{true};

TEST(TimeLimitTest, ARandomRunDoesNotGoOnToItsEnd) {
  const Problem endless = ProblemOf(MutualWait());
  for (const SamplerKind kind : {SamplerKind::kRandom, SamplerKind::kPct, SamplerKind::kPos}) {
    const SampleCounts counts =
        Sample(endless, {.kind = kind, .statement_limit = INT64_MAX, .stop = &kTold});
    EXPECT_EQ(counts.runs, 0);
  }
}

TEST(TimeLimitTest, TheThreadsInTurnAreNotRunToTheFault) {
  const std::string endless = "int t0() {\nL:\n  goto L;\n}\n";
  CardModel whole = CardOf(endless, "limit_ms = 50\n");
  ASSERT_TRUE(LookFirstAtCard(&whole, nullptr).found());
  CardModel told = CardOf(endless, "limit_ms = 50\n");
  EXPECT_FALSE(LookFirstAtCard(&told, &kTold).found());
}

TEST(TimeLimitTest, TheNumberOfTracesIsNotEstimated) {
  Problem problem = ProblemOf(Increments(2, 2));
  EXPECT_GT(EstimateTraces(&problem.model, 10, 1, 1000).traces, 0);
  EXPECT_EQ(EstimateTraces(&problem.model, 10, 1, 1000, &kTold).traces, 0);
}

TEST(TimeLimitTest, AFailureIsShownAsItWasFound) {
  const Problem problem = ProblemOf(Increments(2, 2));
  const std::vector<uint8_t> steps = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  ASSERT_LT(Shrink(problem, steps).preemptions, 10);
  const Failure shown = Shrink(problem, steps, &kTold);
  EXPECT_TRUE(shown.fault);
  EXPECT_GE(shown.preemptions, 10);
}

/// The reversals that are not planned when a search of traces is told to end are planned when it
/// goes on.
TEST(TimeLimitTest, ASearchOfTracesThatIsStoppedAfterEachOneLosesNone) {
  for (const bool general : {false, true}) {
    Problem problem = ProblemOf(Increments(3, 2));
    const auto all = [](TraceEnd*) { return true; };
    const int64_t traces = ExploreTraces(&problem.model, {.general = general}, all).executions;
    ASSERT_GT(traces, 100);
    std::atomic<bool> stop{false};
    const auto tell = [&](TraceEnd*) {
      stop = true;
      return true;
    };
    TraceUnit unit;
    int64_t found = 0;
    for (bool complete = false; !complete;) {
      stop = false;
      const DporResult part =
          ExploreUnit(&problem.model, &unit, {.general = general, .stop = &stop}, tell);
      ASSERT_LE(part.executions, 1);
      found += part.executions;
      complete = part.complete;
    }
    EXPECT_EQ(found, traces) << (general ? "statement by statement" : "by steps");
  }
}

TEST(TimeLimitTest, AHurriedAnalysisOfStatesShowsTheFirstWayToAFault) {
  const Problem problem = ProblemOf(Increments(2, 2));
  SearchProgress progress;
  progress.hurried = true;
  const auto found = Explore(problem, {.engine = EngineKind::kStateful, .progress = &progress});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found.value().verdict, Verdict::kFailed);
  ASSERT_TRUE(found.value().failure);
  EXPECT_EQ(found.value().failure->fault.kind, Fault::Kind::kRequirement);
  EXPECT_FALSE(found.value().failure->fewest_preemptions);
}

TEST(TimeLimitTest, TheFirstWayToAFaultHasItsPreemptionsWhereStatesAreMissing) {
  const Problem problem = ProblemOf(Increments(2, 2));
  // The search ends in the first state that is bad: what else follows those before is not known.
  StateSearch search;
  for (uint32_t states = 1; search.counts.bad_states == 0; ++states) {
    search = SearchStates(problem, {.states = states});
  }
  ASSERT_FALSE(search.counts.complete);
  const auto failure = FailureIn(problem, search, &kTold);
  ASSERT_TRUE(failure);
  Model model = problem.model;
  EXPECT_EQ(failure->preemptions, CountPreemptions(&model, failure->steps));
}

TEST(TimeLimitTest, AHurriedAnalysisOfStatesProvesNothing) {
  const Problem problem = ProblemOf(Peterson(false));
  const ExploreOptions options = {.engine = EngineKind::kStateful};
  ASSERT_EQ(Explore(problem, options).value().verdict, Verdict::kProved);
  SearchProgress progress;
  ExploreOptions hurried = options;
  hurried.progress = &progress;
  progress.hurried = true;
  EXPECT_EQ(Explore(problem, hurried).value().verdict, Verdict::kIncomplete);
}

/// A search of states with an answer, and one of traces that goes on until it is told to end.
SearchPair AnswerAndEndless() {
  return {.traces =
              [](const std::atomic<bool>* stop, const SearchPair::TakesPause&) {
                while (!*stop) {
                }
                return TraceSearch{};
              },
          .states =
              [](const std::atomic<bool>*, const std::atomic<uint32_t>*) {
                StateSearch answer;
                answer.counts.complete = true;
                answer.graph.may_cycle = false;
                return answer;
              }};
}

TEST(TimeLimitTest, TheOtherSearchDoesNotCountBeyondTheLimit) {
  SearchProgress progress;
  progress.interrupted = true;
  SearchPair pair = AnswerAndEndless();
  pair.grace_part = 1e9;
  pair.progress = &progress;
  EXPECT_EQ(RunPair(pair).first, PairResult::First::kStates);
}

TEST(TimeLimitTest, WithoutThreadsTheSearchesTakeTurns) {
  pthread_attr_t usual;
  ASSERT_EQ(::pthread_getattr_default_np(&usual), 0);
  pthread_attr_t large;
  ASSERT_EQ(::pthread_attr_init(&large), 0);
  ASSERT_EQ(::pthread_attr_setstacksize(&large, size_t{1} << 47), 0);
  ASSERT_EQ(::pthread_setattr_default_np(&large), 0);  // no thread has this much room
  const PairResult result = RunPair(AnswerAndEndless());
  ::pthread_setattr_default_np(&usual);
  EXPECT_EQ(result.first, PairResult::First::kStates);
  EXPECT_FALSE(result.traces);
}

}  // namespace
}  // namespace oncard::explore
