// Exactly one execution per Mazurkiewicz trace (explore/engines/dpor.h). The expected counts are
// known: for increments from other tools and from brute force, for readers and writers by
// calculation.
#include "explore/engines/dpor.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

DporResult Count(const std::string& source, const DporLimits& limits = {.count_redundant = true}) {
  Problem problem = ProblemOf(source);
  problem.model.TrackKey(false);
  return ExploreTraces(&problem.model, limits, [](TraceEnd*) { return true; });
}

void ExpectTraces(const std::string& source, int64_t traces) {
  const DporResult result = Count(source);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.executions, traces);
  EXPECT_EQ(result.blocked, 0);
  EXPECT_EQ(result.redundant, 0);
}

TEST(DporTest, LostUpdates) {
  ExpectTraces(Increments(2, 1), 4);
  ExpectTraces(Increments(2, 2), 34);
  ExpectTraces(Increments(3, 1), 36);
  ExpectTraces(Increments(3, 2), 7134);
}

TEST(DporTest, IndependentThreadsAreOneTrace) {
  std::string source = "int a[4];\n";
  for (int i = 0; i < 4; ++i) {
    source += fmt::format("int t{0}() {{\n  a[{0}] = 1;\n  a[{0}] = 2;\n  return 0;\n}}\n", i);
  }
  ExpectTraces(source, 1);
}

// n writers of one variable have n! orders.
TEST(DporTest, WritersOfOneVariable) {
  std::string source = "int x;\n";
  int64_t orders = 1;
  for (int i = 0; i < 6; ++i) {
    source += fmt::format("int t{0}() {{\n  x = {0};\n  return 0;\n}}\n", i);
    orders *= i + 1;
    ExpectTraces(source, orders);
  }
}

// Each of n readers comes before or after the single write.
TEST(DporTest, ReadersOfOneWrite) {
  std::string source = "int x;\nint t0() {\n  x = 1;\n  return 0;\n}\n";
  for (int readers = 1; readers <= 7; ++readers) {
    source += fmt::format("int t{}() {{\n  int r;\n  r = x;\n  return r;\n}}\n", readers);
    ExpectTraces(source, int64_t{1} << readers);
  }
}

// The cell of an element is only known when the statement is executed.
TEST(DporTest, ElementsWithVariableIndices) {
  ExpectTraces(
      "int a[2], i;\n"
      "int t0() {\n  i = 1;\n  return 0;\n}\n"
      "int t1() {\n  int k;\n  k = i;\n  a[k] = 1;\n  return 0;\n}\n"
      "int t2() {\n  a[0] = 2;\n  return 0;\n}\n",
      3);
}

TEST(DporTest, ALimitLeavesTheSearchIncomplete) {
  const DporResult result = Count(Increments(3, 2), {.executions = 100});
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.executions, 100);
}

// However often a search is interrupted, its executions are those of an uninterrupted one.
TEST(DporTest, AnInterruptedSearchGoesOn) {
  for (const int64_t at_once : {1, 3, 100}) {
    Problem problem = ProblemOf(Increments(3, 1));
    TraceUnit whole;
    int64_t executions = 0;
    std::set<std::pair<uint64_t, uint64_t>> ends;
    DporResult result;
    do {
      result = ExploreUnit(&problem.model, &whole, {.executions = at_once, .count_redundant = true},
                           [&](TraceEnd* end) {
                             const StateKey key = end->State().FinalKey();
                             ends.insert({key.low, key.high});
                             return true;
                           });
      executions += result.executions;
      EXPECT_EQ(result.blocked, 0);
    } while (!result.complete);
    EXPECT_EQ(executions, 36);
    EXPECT_EQ(ends.size(), 3u);
  }
}

TEST(DporTest, UnitsHaveEveryTraceOnce) {
  for (const size_t count : {size_t{1}, size_t{2}, size_t{7}, size_t{40}, size_t{1000}}) {
    Problem problem = ProblemOf(Increments(3, 1));
    std::vector<TraceUnit> units = SplitTraces(&problem.model, count);
    EXPECT_EQ(units, SplitTraces(&problem.model, count));
    int64_t executions = 0;
    for (TraceUnit& unit : units) {
      executions +=
          ExploreUnit(&problem.model, &unit, {}, [](TraceEnd*) { return true; }).executions;
    }
    EXPECT_EQ(executions, 36) << count;
  }
}

TEST(DporTest, AnExecutionThatDoesNotEndIsGivenUp) {
  const DporResult result =
      Count("int x;\nint t0() {\nL:\n  x = x + 1;\n  goto L;\n}\n", {.depth = 1000});
  EXPECT_FALSE(result.complete);
  EXPECT_TRUE(result.too_deep);
}

/// A thread that waits for `x` to be `value`.
std::string Waits(int thread, int value) {
  return fmt::format(
      "int t{}() {{\n  int c;\nW:\n  c = x != {};\n  if (c) goto W;\n  return 0;\n}}\n", thread,
      value);
}

// A thread looks again only after a write: it sees the write at once, or each value before it at
// most once.
TEST(DporTest, AWaitingThreadLooksAgainAfterWrites) {
  const std::string setter = "int x;\nint t0() {\n  x = 1;\n  return 0;\n}\n";
  ExpectTraces(setter + Waits(1, 1), 2);
  ExpectTraces(setter + Waits(1, 1) + Waits(2, 1), 4);
  ExpectTraces("int x;\nint t0() {\n  x = 1;\n  x = 2;\n  return 0;\n}\n" + Waits(1, 2), 4);
}

TEST(DporTest, ThreadsThatWaitForEverEndAnExecution) {
  // Thread 1 looks at x before, between or after the writes; it ends if it sees 1.
  Problem problem =
      ProblemOf("int x;\nint t0() {\n  x = 1;\n  x = 2;\n  return 0;\n}\n" + Waits(1, 1));
  int ended = 0;
  int waiting = 0;
  const DporResult result = ExploreTraces(&problem.model, {}, [&](TraceEnd* end) {
    ++(end->State().runnable() == 0 ? ended : waiting);
    return true;
  });
  EXPECT_TRUE(result.complete);
  // Seen: 1; 0 1. Not seen: 2; 0 2.
  EXPECT_EQ(ended, 2);
  EXPECT_EQ(waiting, 2);
}

TEST(DporTest, TheModelIsLeftWhereItWas) {
  Problem problem = ProblemOf(Increments(2, 2));
  const StateKey before = problem.model.key();
  ExploreTraces(&problem.model, {}, [](TraceEnd*) { return true; });
  EXPECT_EQ(problem.model.key(), before);
  EXPECT_EQ(problem.model.depth(), 0);
}

}  // namespace
}  // namespace oncard::explore
