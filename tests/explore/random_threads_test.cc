// Random programs with a few statements and variables: the executions of the dpor engine are the
// traces found by brute force, and both engines find the same ends.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "explore/engines/dpor.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

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
      result = ExploreUnit(&model, &unit, {.executions = 2}, [](const Model&) { return true; });
      executions += result.executions;
    } while (!result.complete);
  }
  return executions;
}

class RandomThreadsTest : public ::testing::TestWithParam<int> {};

TEST_P(RandomThreadsTest, EnginesAgreeWithBruteForce) {
  constexpr int kPerBatch = 50;
  for (int i = 0; i < kPerBatch; ++i) {
    const auto seed = static_cast<uint64_t>(GetParam() * kPerBatch + i);
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Problem problem = ProblemOf(RandomThreads(seed));
    const BruteForce all(problem.model);
    const auto dpor = Explore(problem, {.engine = EngineKind::kDpor});
    const auto stateful = Explore(problem, {.engine = EngineKind::kStateful});
    const TraceCounts& traces = *dpor.value().traces;
    ASSERT_EQ(traces.executions, static_cast<int64_t>(all.traces()));
    ASSERT_EQ(traces.blocked, 0);
    ASSERT_EQ(traces.redundant, 0);
    ASSERT_EQ(traces.final_full, static_cast<int64_t>(all.ends()));
    ASSERT_EQ(stateful.value().states->final_full, traces.final_full);
    ASSERT_EQ(stateful.value().verdict, dpor.value().verdict);
    const auto merged = Explore(problem, {.engine = EngineKind::kStateful, .merge_private = true});
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
