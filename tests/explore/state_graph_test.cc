// The graph of all states (explore/engines/state_graph.h) and its evaluation.
#include "explore/engines/state_graph.h"

#include <gtest/gtest.h>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

StateGraph GraphOf(const std::string& source, const StateLimits& limits = {}) {
  Problem problem = ProblemOf(source);
  Model model = problem.model;
  return BuildStateGraph(&model, limits,
                         [&](const Model& state) { return FindFault(problem, state) ? kBad : 0u; });
}

int64_t CountFlags(const StateGraph& graph, uint32_t flag) {
  return std::count_if(graph.flags.begin(), graph.flags.end(),
                       [&](uint32_t flags) { return (flags & flag) != 0; });
}

TEST(StateGraphTest, CountsOfLostUpdates) {
  const StateGraph graph = GraphOf(Increments(2, 1));
  EXPECT_TRUE(graph.complete);
  EXPECT_EQ(graph.size(), 41u);
  EXPECT_EQ(graph.transitions, 60);
  EXPECT_EQ(CountFlags(graph, kBad), 1);
  EXPECT_EQ(FewestPreemptions(graph, kBad).preemptions, 1);
  EXPECT_EQ(FewestSteps(graph, kBad).steps.size(), 8u);
}

// With one statement per thread, the states are the subsets of threads that have executed it.
TEST(StateGraphTest, IndependentThreadsSpanACube) {
  const StateGraph graph = GraphOf(
      "int a, b, c;\nint t0() {\n a = 1;\n}\nint t1() {\n b = 1;\n}\nint t2() {\n c = 1;\n}\n");
  EXPECT_EQ(graph.size(), 8u);
  EXPECT_EQ(graph.transitions, 12);
  EXPECT_EQ(CountFlags(graph, kTerminal), 1);
}

struct LongSearch {
  const char* name;
  std::string source;
};

/// Threads that write as many different elements as make more accesses than are remembered.
std::string ManyElements() {
  std::string source = "int x, a[70];\n";
  for (int thread = 0; thread < 2; ++thread) {
    source += "int t" + std::to_string(thread) + "() {\n  int v;\n  v = 1;\n";
    for (int i = thread; i < 70; i += 2) source += "  a[" + std::to_string(i) + "] = v;\n";
    source += "  x = x + v;\n  return x;\n}\n";
  }
  return source;
}

const LongSearch kLongSearches[] = {
    // Element by element, each thread accesses what the other one does not know.
    {"Accesses", ManyElements()},
    {"States",
     "int x;\nint t0() {\n  int i, c;\nL:\n  i = i + 1;\n  c = i < 100000;\n  if (c) goto L;\n"
     "  x = x + 1;\n  return 0;\n}\nint t1() {\n  int v;\n  v = 1 / x;\n  return v;\n}\n"},
    {"ElementsChosenByGlobals",
     "int x, a[3];\nint t0() {\n  a[x] = 1;\n  x = a[2];\n  return 0;\n}\n"
     "int t1() {\n  x = 2;\n  a[x] = 7;\n  x = 5;\n  return 0;\n}\n"},
};

// Where steps are not remembered any more, the search goes on by executing them.
class LongSearchTest : public ::testing::TestWithParam<LongSearch> {};
TEST_P(LongSearchTest, IsTheSameWithRememberedSteps) {
  const Problem problem = ProblemOf(GetParam().source);
  StateGraph graphs[2];
  for (const Judged judged : {Judged::kEveryState, Judged::kEnds}) {
    Model model = problem.model;
    graphs[static_cast<int>(judged)] = BuildStateGraph(
        &model, {}, [&](const Model& state) { return FindFault(problem, state) ? kBad : 0u; },
        judged);
    EXPECT_EQ(model.depth(), 0);
  }
  EXPECT_GT(graphs[0].size(), 10u);
  EXPECT_TRUE(graphs[0].complete);
  EXPECT_EQ(graphs[1].flags, graphs[0].flags);
  EXPECT_EQ(graphs[1].successors, graphs[0].successors);
  EXPECT_EQ(graphs[1].transitions, graphs[0].transitions);
}
INSTANTIATE_TEST_SUITE_P(Programs, LongSearchTest, ::testing::ValuesIn(kLongSearches),
                         [](const auto& searched) { return searched.param.name; });

TEST(StateGraphTest, ThePathWithTheFewestPreemptionsLeadsThere) {
  Problem problem = ProblemOf(Increments(3, 1));
  Model model = problem.model;
  const StateGraph graph = BuildStateGraph(
      &model, {}, [&](const Model& state) { return FindFault(problem, state) ? kBad : 0u; });
  const Path path = FewestPreemptions(graph, kBad);
  ASSERT_TRUE(path.found);
  EXPECT_EQ(path.steps.size(), 12u);
  for (const uint8_t thread : path.steps) model.Step(thread);
  EXPECT_TRUE(FindFault(problem, model));
}

TEST(StateGraphTest, PreemptionsToEveryState) {
  const StateGraph graph = GraphOf(Increments(2, 1));
  const std::vector<uint8_t> fewest = PreemptionsTo(graph, 5);
  EXPECT_EQ(fewest[0], 0);
  // Both have read 0 and written 1, and neither has returned: one is preempted after its read, the
  // other after its write.
  EXPECT_EQ(*std::max_element(fewest.begin(), fewest.end()), 2);
}

TEST(StateGraphTest, AFairCycleIsALivelock) {
  const Lasso lasso = FindFairCycle(GraphOf(MutualWait()));
  ASSERT_TRUE(lasso.found);
  for (uint8_t thread = 0; thread < 2; ++thread) {
    EXPECT_NE(std::find(lasso.cycle.begin(), lasso.cycle.end(), thread), lasso.cycle.end());
  }
}

// A thread waits forever only if the other is never scheduled.
TEST(StateGraphTest, WaitingThatOnlyUnfairSchedulesProlongIsNone) {
  const StateGraph graph = GraphOf(Peterson(false));
  EXPECT_TRUE(graph.complete);
  EXPECT_FALSE(FindFairCycle(graph).found);
  EXPECT_EQ(CountFlags(graph, kBad), 0);
}

TEST(StateGraphTest, ARunThatNeverEndsIsACycle) {
  EXPECT_FALSE(IsCyclic(GraphOf(Increments(2, 1))));
  EXPECT_TRUE(IsCyclic(GraphOf(Peterson(false))));
  EXPECT_TRUE(IsCyclic(GraphOf("int t0() {\nL:\n goto L;\n}\n")));
}

TEST(StateGraphTest, TheLastEscapeIsBeforeTheUpdateIsLost) {
  const StateGraph graph = GraphOf(Increments(2, 1));
  // Thread 0 reads, thread 1 reads: from here on one of the increments is lost.
  EXPECT_EQ(LastEscape(graph, {0, 1, 1, 1, 1, 0, 0, 0}), 1);
  // One after the other: from every state a good end can be reached.
  EXPECT_EQ(LastEscape(graph, {0, 0, 0, 0, 1, 1, 1, 1}), 8);
}

TEST(StateGraphTest, ALimitLeavesItIncomplete) {
  const StateGraph graph = GraphOf(Increments(3, 1), {.states = 100});
  EXPECT_FALSE(graph.complete);
  EXPECT_EQ(graph.size(), 100u);
}

}  // namespace
}  // namespace oncard::explore
