// Random programs with a few statements and variables: the executions of the dpor engine are the
// traces found by brute force, the graph of states is that of a plain search, and both engines find
// the same ends.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "explore/engines/dpor.h"
#include "explore/engines/state_graph.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "tests/base/random_cases.h"

namespace oncard::explore {
namespace {

/// The traces among all interleavings: for each the order of dependent statements, as the
/// predecessors of every statement.
class BruteForce {
 public:
  explicit BruteForce(Model model) : model_(std::move(model)) { Go(); }
  size_t traces() const { return traces_.size(); }
  size_t ends() const { return ends_.size(); }

 private:
  struct Event {
    int thread;
    AccessSet access;
  };

  void Go() {
    if (model_.runnable() == 0) {
      traces_.insert(Trace());
      const StateKey key = model_.FinalKey();
      ends_.insert({key.low, key.high});
      return;
    }
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (!model_.Running(thread)) continue;
      events_.push_back({thread, model_.NextAccess(thread)});
      model_.Step(thread);
      Go();
      model_.Undo();
      events_.pop_back();
    }
  }

  /// For every event, written as (thread, number), the earlier events on which it depends.
  std::string Trace() const {
    std::map<std::pair<int, int>, std::set<std::pair<int, int>>> before;
    std::map<int, int> numbers;
    std::vector<std::pair<int, int>> names;
    for (size_t i = 0; i < events_.size(); ++i) {
      names.emplace_back(events_[i].thread, numbers[events_[i].thread]++);
      auto& set = before[names[i]];
      for (size_t j = 0; j < i; ++j) {
        if (events_[j].access.DependsOn(events_[i].access)) set.insert(names[j]);
      }
    }
    std::string text;
    for (const auto& [event, set] : before) {
      text += fmt::format("{}.{}:", event.first, event.second);
      for (const auto& [thread, number] : set) text += fmt::format("{}.{},", thread, number);
    }
    return text;
  }

  Model model_;
  std::vector<Event> events_;
  std::set<std::string> traces_;
  std::set<std::pair<uint64_t, uint64_t>> ends_;
};

/// The graph of states, depth first, by a search that looks nothing up in advance.
class PlainSearch {
 public:
  PlainSearch(const Problem& problem, bool merge, uint32_t limit)
      : problem_(problem), model_(problem.model), merge_(merge), limit_(limit) {
    graph_.threads = model_.thread_count();
    for (int thread = 0; thread < graph_.threads; ++thread) Merge(thread);
    Visit();
    graph_.complete = graph_.size() < limit_;
  }
  const StateGraph& graph() const { return graph_; }

 private:
  void Merge(int thread) {
    if (merge_) model_.StepPrivate(thread, kMergedMax);
  }
  uint32_t Visit() {
    const auto [known, added] = numbers_.try_emplace(model_.key(), graph_.size());
    const uint32_t state = known->second;
    if (!added) return state;
    graph_.flags.Append(
        1, (model_.runnable() == 0 ? kTerminal : 0u) | (FindFault(problem_, model_) ? kBad : 0u));
    const auto threads = static_cast<size_t>(graph_.threads);
    graph_.successors.Append(threads, StateGraph::kNone);
    const Model here = model_;
    for (size_t thread = 0; thread < threads && graph_.size() < limit_; ++thread) {
      const int number = static_cast<int>(thread);
      if (!here.Running(number)) continue;
      model_ = here;
      model_.Step(number);
      Merge(number);
      ++graph_.transitions;
      const uint32_t next = Visit();
      graph_.successors[state * threads + thread] = next;
    }
    return state;
  }

  const Problem& problem_;
  Model model_;
  bool merge_;
  uint32_t limit_;
  StateGraph graph_;
  std::map<StateKey, uint32_t> numbers_;
};

TEST(RandomGraphsTest, AreThoseOfAPlainSearch) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const Problem problem = ProblemOf(RandomThreads(seed));
    // The requirements apply to ends.
    ASSERT_FALSE(problem.HasInvariants());
    for (const bool merge : {false, true}) {
      for (const uint32_t limit : {1u, 7u, 60u, 1'000'000u}) {
        const PlainSearch plain(problem, merge, limit);
        for (const Judged judged : {Judged::kEveryState, Judged::kEnds}) {
          SCOPED_TRACE(fmt::format("seed {}, merge {}, limit {}, judged {}", seed, merge, limit,
                                   static_cast<int>(judged)));
          Model model = problem.model;
          const StateGraph graph = BuildStateGraph(
              &model, {.states = limit, .merge_private = merge},
              [&](const Model& state) { return FindFault(problem, state) ? kBad : 0u; }, judged);
          EXPECT_EQ(graph.flags, plain.graph().flags);
          EXPECT_EQ(graph.successors, plain.graph().successors);
          EXPECT_EQ(graph.transitions, plain.graph().transitions);
          EXPECT_EQ(graph.complete, plain.graph().complete);
          EXPECT_EQ(model.depth(), 0);
        }
      }
    }
  }
}

/// The fewest preemptions to every state, by shortening ways through (state, last thread) until
/// none becomes shorter.
std::vector<uint8_t> PlainPreemptions(const StateGraph& graph, int bound) {
  const auto none = static_cast<size_t>(graph.threads);  // has stepped last
  std::vector<std::vector<int>> ways(graph.size(), std::vector<int>(none + 1, bound + 1));
  ways[0][none] = 0;
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (uint32_t state = 0; state < graph.size(); ++state) {
      for (size_t last = 0; last <= none; ++last) {
        const bool goes_on =
            last != none && graph.Next(state, static_cast<int>(last)) != StateGraph::kNone;
        for (size_t thread = 0; thread < none; ++thread) {
          const uint32_t next = graph.Next(state, static_cast<int>(thread));
          if (next == StateGraph::kNone) continue;
          const int way = ways[state][last] + (goes_on && thread != last ? 1 : 0);
          if (way >= ways[next][thread]) continue;
          ways[next][thread] = way;
          shorter = true;
        }
      }
    }
  }
  std::vector<uint8_t> fewest;
  for (const std::vector<int>& way : ways) {
    fewest.push_back(static_cast<uint8_t>(std::ranges::min(way)));
  }
  return fewest;
}

TEST(RandomGraphsTest, PreemptionsAreThoseOfTheShortestWays) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const PlainSearch plain(ProblemOf(RandomThreads(seed)), false, 1'000'000);
    for (const int bound : {0, 1, 3}) {
      EXPECT_EQ(PreemptionsTo(plain.graph(), bound), PlainPreemptions(plain.graph(), bound))
          << "seed " << seed << ", bound " << bound;
    }
  }
}

/// The races found in states are those found by clocks in all traces.
TEST(RandomRacesTest, StatesAndClocksAgree) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    for (const bool synchronised : {false, true}) {
      Problem problem = ProblemOf(RandomThreads(seed));
      problem.requirements.clear();
      problem.races = RaceRule::kNone;
      if (synchronised) problem.sync = {true, true, false};
      const auto dpor = Explore(problem, {.engine = EngineKind::kDpor});
      const auto stateful = Explore(problem, {.engine = EngineKind::kStateful});
      ASSERT_EQ(stateful.value().verdict, dpor.value().verdict);
    }
  }
}

/// The executions of a split search whose parts are interrupted again and again.
int64_t ExecutionsOfUnits(const Problem& problem, size_t count) {
  Model model = problem.model;
  int64_t executions = 0;
  for (TraceUnit& unit : SplitTraces(&model, count)) {
    DporResult result;
    do {
      result = ExploreUnit(&model, &unit, {.executions = 2}, [](TraceEnd*) { return true; });
      executions += result.executions;
    } while (!result.complete);
  }
  return executions;
}

class RandomThreadsTest : public ::testing::TestWithParam<int> {};

TEST_P(RandomThreadsTest, EnginesAgreeWithBruteForce) {
  const int per_batch = RandomCases(50);
  for (int i = 0; i < per_batch; ++i) {
    const auto seed = static_cast<uint64_t>(GetParam() * per_batch + i);
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Problem problem = ProblemOf(RandomThreads(seed));
    const BruteForce all(problem.model);
    const auto dpor = Explore(problem, {.engine = EngineKind::kDpor});
    const auto stateful =
        Explore(problem, {.engine = EngineKind::kStateful, .merge_private = false});
    const TraceCounts& traces = *dpor.value().traces;
    ASSERT_EQ(traces.executions, static_cast<int64_t>(all.traces()));
    ASSERT_EQ(traces.blocked, 0);
    ASSERT_EQ(traces.redundant, 0);
    ASSERT_EQ(traces.final_full, static_cast<int64_t>(all.ends()));
    ASSERT_EQ(stateful.value().states->final_full, traces.final_full);
    ASSERT_EQ(stateful.value().verdict, dpor.value().verdict);
    const auto merged = Explore(
        problem, {.engine = EngineKind::kStateful, .merge_private = true, .symmetry = false});
    ASSERT_EQ(merged.value().verdict, stateful.value().verdict);
    ASSERT_EQ(merged.value().states->final_full, traces.final_full);
    ASSERT_EQ(merged.value().states->finals_within, stateful.value().states->finals_within);
    ASSERT_LE(merged.value().states->states, stateful.value().states->states);
    if (stateful.value().failure) {
      const Failure& failure = *merged.value().failure;
      ASSERT_EQ(failure.preemptions, stateful.value().failure->preemptions);
      ASSERT_EQ(failure.fault.kind, stateful.value().failure->fault.kind);
    }
    ASSERT_EQ(ExecutionsOfUnits(problem, 6), traces.executions);
    // With as many preemptions as statements, all schedules are searched.
    const auto bounded = Explore(problem, {.engine = EngineKind::kBounded, .preemption_limit = 50});
    ASSERT_EQ(bounded.value().verdict == Verdict::kFailed,
              stateful.value().verdict == Verdict::kFailed);
    if (stateful.value().failure) {
      ASSERT_EQ(bounded.value().failure->preemptions, stateful.value().failure->preemptions);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Batches, RandomThreadsTest, ::testing::Range(0, 20));

}  // namespace
}  // namespace oncard::explore
