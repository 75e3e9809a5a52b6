// Random schedules: they are reproducible, reach bad states as often as calculated, and find
// failures repeatedly.
#include "explore/engines/sampler.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "explore/engines/state_graph.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

/// The probability that a uniform random walk ends in a bad state, calculated with the state graph.
double ChanceOfBad(const Problem& problem) {
  Model model = problem.model;
  const StateGraph graph = BuildStateGraph(
      &model, {}, [&](const Model& state) { return FindFault(problem, state) ? kBad : 0u; });
  // The probability of every state, after those of all its predecessors.
  std::vector<int> waits_for(graph.size());
  for (uint32_t state = 0; state < graph.size(); ++state) {
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next != StateGraph::kNone) ++waits_for[next];
    }
  }
  std::vector<double> chance(graph.size());
  chance[0] = 1;
  std::vector<uint32_t> ready = {0};
  double bad = 0;
  while (!ready.empty()) {
    const uint32_t state = ready.back();
    ready.pop_back();
    if ((graph.flags[state] & kBad) != 0) bad += chance[state];
    int ways = 0;
    for (int thread = 0; thread < graph.threads; ++thread) {
      ways += graph.Next(state, thread) != StateGraph::kNone ? 1 : 0;
    }
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next == StateGraph::kNone) continue;
      chance[next] += chance[state] / ways;
      if (--waits_for[next] == 0) ready.push_back(next);
    }
  }
  return bad;
}

TEST(Sampler, TheRandomWalkHitsAsOftenAsItShould) {
  for (const auto& source : {Increments(2, 1), Increments(2, 2), Increments(3, 1)}) {
    const Problem problem = ProblemOf(source);
    const double chance = ChanceOfBad(problem);
    const SampleCounts counts = Sample(problem, {.runs = 20'000, .seed = 7});
    const double sigma = std::sqrt(chance * (1 - chance) / 20'000);
    EXPECT_NEAR(static_cast<double>(counts.bad) / 20'000, chance, 3 * sigma);
    EXPECT_EQ(counts.cut, 0);
  }
}

// PCT finds a fault of depth d in n threads and k statements with a probability of at least
// 1 / (n k^(d-1)); a lost update has depth 2.
TEST(Sampler, PctKeepsItsPromise) {
  for (const int times : {1, 2, 3}) {
    const Problem problem = ProblemOf(Increments(2, times));
    const SampleCounts counts =
        Sample(problem, {.kind = SamplerKind::kPct, .runs = 20'000, .seed = 3, .depth = 2});
    const double promised = 1.0 / (2.0 * static_cast<double>(counts.longest));
    const double sigma = std::sqrt(promised * (1 - promised) / 20'000);
    EXPECT_GT(static_cast<double>(counts.bad) / 20'000, promised - 3 * sigma) << times;
  }
}

TEST(Sampler, WithoutChangesPctRunsOneThreadAfterTheOther) {
  const SampleCounts counts =
      Sample(ProblemOf(Increments(3, 2)), {.kind = SamplerKind::kPct, .runs = 200, .depth = 1});
  EXPECT_EQ(counts.bad, 0);
  EXPECT_EQ(counts.ends.size(), 1u);
}

TEST(Sampler, EveryKindFindsALostUpdateAgainAndAgain) {
  const Problem problem = ProblemOf(Increments(2, 1));
  for (const SamplerKind kind : {SamplerKind::kRandom, SamplerKind::kPct, SamplerKind::kPos}) {
    const SampleOptions options = {.kind = kind, .runs = 1000, .seed = 5};
    const SampleCounts first = Sample(problem, options);
    EXPECT_GT(first.bad, 0);
    EXPECT_EQ(first.ends.size(), 2u);
    const SampleCounts second = Sample(problem, options);
    EXPECT_EQ(second.bad, first.bad);
    EXPECT_EQ(second.failing, first.failing);
    Model model = problem.model;
    for (const uint8_t thread : first.failing) model.Step(thread);
    EXPECT_TRUE(FindFault(problem, model));
  }
}

TEST(Sampler, ARunThatDoesNotEndIsGivenUp) {
  const SampleCounts counts = Sample(ProblemOf(MutualWait()), {.runs = 10, .statement_limit = 500});
  EXPECT_EQ(counts.cut, 10);
  EXPECT_EQ(counts.longest, 500);
  EXPECT_EQ(counts.bad, 0);
}

TEST(Sampler, TriesCards) {
  CardModel model = CardOf(Increments(2, 1), "expect = [\"x == 2\"]\n");
  const SampleCounts counts = SampleCard(&model, {.runs = 300});
  EXPECT_GT(counts.bad, 0);
  EXPECT_LT(counts.bad, 300);
  EXPECT_EQ(counts.ends.size(), 2u);
}

TEST(Sampler, ARunThatGoesWrongOnTheWayHasNoEnd) {
  CardModel model = CardOf(Increments(2, 1), "never = [\"x == 1\"]\n");
  const SampleCounts counts = SampleCard(&model, {.runs = 20});
  EXPECT_EQ(counts.bad, 20);
  EXPECT_EQ(counts.ends.size(), 0u);
}

TEST(Sampler, TheVerdictIsNeverAProof) {
  const auto passed =
      Explore(ProblemOf("int a;\n//@ final: a == 1\nint t0() { a = 1; return 0; }\n"),
              {.engine = EngineKind::kRandom, .runs = 10});
  EXPECT_EQ(passed.value().verdict, Verdict::kPassed);
  const auto failed = Explore(ProblemOf(Increments(2, 1)), {.engine = EngineKind::kPos});
  EXPECT_EQ(failed.value().verdict, Verdict::kFailed);
  EXPECT_EQ(failed.value().failure->preemptions, 1);
}

}  // namespace
}  // namespace oncard::explore
