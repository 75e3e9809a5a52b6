// The number of traces without an execution for each (explore/engines/trace_count.h) is the number
// of executions of dpor.h, and a search that uses it (trace_search.h) has the same results.
// ONCARD_TRACE_PROGRAMS sets the number of random programs.
#include "explore/engines/trace_count.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "explore/engines/dpor.h"
#include "explore/engines/trace_search.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

constexpr uint64_t kRandomPrograms = 300;

uint64_t RandomPrograms() {
  const char* number = std::getenv("ONCARD_TRACE_PROGRAMS");
  return number == nullptr ? kRandomPrograms : std::strtoull(number, nullptr, 10);
}

/// What a search of all traces has found.
struct TraceTotals {
  int64_t traces = 0;
  std::set<StateKey> ends;
  int64_t longest = 0;  ///< statements of an execution; only known if each is executed

  bool operator==(const TraceTotals& other) const {
    return traces == other.traces && ends == other.ends;
  }
};

std::optional<TraceTotals> CountOf(const std::string& source, const TraceCountLimits& limits = {}) {
  const Problem problem = ProblemOf(source);
  TraceTotals found;
  const auto count = CountTraces(problem.model, limits, [&](const Model& end) {
    EXPECT_EQ(end.runnable(), 0u);
    found.ends.insert(end.FinalKey());
    return true;
  });
  if (!count) return std::nullopt;
  found.traces = count->traces;
  return found;
}

TraceTotals ExecutionsOf(const std::string& source) {
  Problem problem = ProblemOf(source);
  problem.model.TrackKey(false);
  TraceTotals found;
  const DporResult result = ExploreTraces(&problem.model, {}, [&](TraceEnd* end) {
    found.ends.insert(end->State().FinalKey());
    found.longest = std::max(found.longest, end->Statements());
    return true;
  });
  EXPECT_TRUE(result.complete);
  found.traces = result.executions;
  return found;
}

void ExpectExact(const std::string& source) {
  const auto counted = CountOf(source);
  ASSERT_TRUE(counted);
  EXPECT_TRUE(*counted == ExecutionsOf(source));
}

std::string Replaced(std::string text, std::string_view from, std::string_view to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Every thread does everything twice, in a loop.
std::string Twice(const std::string& source) {
  return Replaced(Replaced(source, "int r, k, c;\n", "int r, k, c, n;\nL:\n"), "  return r;\n",
                  "  n = n + 1;\n  c = n < 2;\n  if (c) goto L;\n  return r;\n");
}

/// Two threads that write the same value to x so often: each order of the writes is a trace.
std::string Writes(int first, int second) {
  std::string source = "int x;\n";
  for (const auto& [thread, times] : {std::pair(0, first), std::pair(1, second)}) {
    source += fmt::format("int t{}() {{\n", thread);
    for (int i = 0; i < times; ++i) source += "  x = 1;\n";
    source += "  return 0;\n}\n";
  }
  return source;
}

/// A thread that writes `x` and others that read it.
std::string Readers(int readers) {
  std::string source = "int x;\nint t0() {\n  x = 1;\n  return 0;\n}\n";
  for (int thread = 1; thread <= readers; ++thread) {
    source += fmt::format("int t{}() {{\n  int r;\n  r = x;\n  return r;\n}}\n", thread);
  }
  return source;
}

/// Increments whose threads each do it `times` times, with another requirement on the sum.
std::string SumsThatAre(const std::string& required, int threads, int times) {
  return Replaced(Increments(threads, times), fmt::format("x == {}", threads * times), required);
}

TEST(TraceCountTest, LostUpdatesHaveTheCountsOfOtherTools) {
  struct Case {
    int threads;
    int times;
    int64_t traces;
  };
  for (const Case& c : {Case{2, 1, 4}, Case{2, 2, 34}, Case{2, 3, 328}, Case{3, 1, 36},
                        Case{3, 2, 7134}, Case{3, 3, 1824912}}) {
    const auto counted = CountOf(Increments(c.threads, c.times));
    ASSERT_TRUE(counted);
    EXPECT_EQ(counted->traces, c.traces);
  }
}

TEST(TraceCountTest, RandomProgramsHaveTheCountAndTheEndsOfTheirExecutions) {
  for (uint64_t seed = 0; seed < RandomPrograms(); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    ExpectExact(RandomThreads(seed));
    ExpectExact(Twice(RandomThreads(seed)));
    if (HasFailure()) return;
  }
}

TEST(TraceCountTest, StatementsThatAccessSeveralVariables) {
  ExpectExact(
      "int a, b, c;\n"
      "int t0() {\n  a = b;\n  b = a + c;\n  return a;\n}\n"
      "int t1() {\n  b = a + b;\n  c = a;\n  return b;\n}\n"
      "int t2() {\n  c = b - a;\n  return c;\n}\n");
}

TEST(TraceCountTest, ThreadsThatFail) {
  ExpectExact(
      "int x, a[2];\n"
      "int t0() {\n  int r;\n  r = 1 / x;\n  x = 7 / r;\n  return 0;\n}\n"
      "int t1() {\n  int k;\n  x = 1;\n  k = x + 1;\n  a[k] = 3;\n  a[0] = 1;\n  return 0;\n}\n"
      "int t2() {\n  x = 1 / x;\n  x = 2;\n  return 0;\n}\n");
}

TEST(TraceCountTest, ThreadsWithoutSharedVariables) {
  ExpectExact("int t0() {\n  int r;\n  r = 1;\n  return r;\n}\nint t1() {\n  return 2;\n}\n");
}

// With 2^63 or more traces there is no count: binomial(66, 33) is below, binomial(67, 33) above.
TEST(TraceCountTest, AsManyAsANumberCanHold) {
  const auto most = CountOf(Writes(33, 33));
  ASSERT_TRUE(most);
  EXPECT_EQ(most->traces, 7'219'428'434'016'265'740);
  EXPECT_FALSE(CountOf(Writes(34, 33)));
}

// As many threads as there can be, most of which have nothing to do with each other.
TEST(TraceCountTest, ThirtyTwoThreads) {
  std::string source = "int x;\nint t0() {\n  x = 1;\n  return 0;\n}\n";
  for (int thread = 1; thread < kThreadMax; ++thread) {
    source += fmt::format("int a{0};\nint t{0}() {{\n  a{0} = {1};\n  return 0;\n}}\n", thread,
                          thread < 10 ? "x" : "1");
  }
  const auto counted = CountOf(source);
  ASSERT_TRUE(counted);
  EXPECT_EQ(counted->traces, 1 << 9);
}

// A local that nothing reads any more does not tell states apart, unless it is asked for.
TEST(TraceCountTest, EndsThatDifferInLocalsAreVisitedOnRequest) {
  const Problem problem = ProblemOf(Increments(2, 3));
  std::set<std::pair<StateKey, int64_t>> executed;
  const auto note = [](const Model& end, std::set<std::pair<StateKey, int64_t>>* ends) {
    ends->insert({end.FinalKey(), end.ThreadCells(0).front()});
    return true;
  };
  Model model = problem.model;
  model.TrackKey(false);
  ExploreTraces(&model, {}, [&](TraceEnd* end) { return note(end->State(), &executed); });
  for (const bool tells : {false, true}) {
    std::set<std::pair<StateKey, int64_t>> visited;
    const auto count = CountTraces(problem.model, {.tells_locals = tells},
                                   [&](const Model& end) { return note(end, &visited); });
    ASSERT_TRUE(count);
    EXPECT_EQ(count->traces, 328);
    EXPECT_EQ(visited.size(), tells ? executed.size() : 5u);
    EXPECT_TRUE(std::ranges::includes(executed, visited));
  }
}

TEST(TraceCountTest, WithTooManyPairsThereIsNoCount) {
  const Problem problem = ProblemOf(Increments(2, 2));
  const auto good = [](const Model&) { return true; };
  const auto whole = CountTraces(problem.model, {}, good);
  ASSERT_TRUE(whole);
  const auto exact = CountTraces(problem.model, {.pairs = whole->pairs}, good);
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->traces, 34);
  for (size_t pairs = 0; pairs < whole->pairs; ++pairs) {
    EXPECT_FALSE(CountTraces(problem.model, {.pairs = pairs}, good)) << pairs;
  }
}

// Whatever the limit, there is a count exactly if all executions are shorter. The longest does not
// come first, and not on every way to a state.
TEST(TraceCountTest, WithALongerExecutionThereIsNoCount) {
  const std::string source =
      "int x;\n"
      "int t0() {\n  int r;\n  r = x == 0;\n  if (r) goto E;\n  r = 1;\n  r = r - 1;\nE:\n"
      "  r = 0;\n  x = 5;\n  return r;\n}\n"
      "int t1() {\n  int r;\n  x = 3;\n  r = x;\n  r = 1;\n  return r;\n}\n";
  const int64_t longest = ExecutionsOf(source).longest;
  for (int64_t depth = 0; depth < longest + 5; ++depth) {
    EXPECT_EQ(CountOf(source, {.depth = depth}).has_value(), depth > longest) << depth;
  }
}

TEST(TraceCountTest, WhatDoesNotEndHasNoCount) {
  for (const std::string& source :
       {MutualWait(), Peterson(false), Peterson(true),
        // Waits for ever only if it begins late.
        std::string("int x;\nint t0() {\n  int c;\nL:\n  c = x == 1;\n  if (c) goto L;\n"
                    "  return 0;\n}\nint t1() {\n  x = 1;\n  return 0;\n}\n"),
        // Through ever new states, and without shared variables.
        std::string("int x;\nint t0() {\nL:\n  x = x + 1;\n  goto L;\n  return 0;\n}\n"),
        std::string("int x;\nint t0() {\nL:\n  goto L;\n  return 0;\n}\nint t1() {\n  x = 1;\n"
                    "  return 0;\n}\n")}) {
    EXPECT_FALSE(CountOf(source)) << source;
  }
}

TEST(TraceCountTest, WhatCannotBeRememberedHasNoCount) {
  EXPECT_FALSE(
      CountOf("int a[2], i;\nint t0() {\n  i = 1;\n  return 0;\n}\n"
              "int t1() {\n  a[i] = 1;\n  return 0;\n}\n"));
  std::string many = "int a[70];\nint t0() {\n";
  for (int i = 0; i < 70; ++i) many += fmt::format("  a[{}] = 1;\n", i);
  EXPECT_FALSE(CountOf(many + "  return 0;\n}\n"));
}

TEST(TraceCountTest, ItEndsWhenItIsTold) {
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(CountOf(Increments(2, 2), {.stop = &stop}));
  int visits = 0;
  EXPECT_FALSE(CountTraces(ProblemOf(Increments(2, 2)).model, {},
                           [&](const Model&) { return ++visits < 2; }));
  EXPECT_EQ(visits, 2);
}

// --- Searches that count -------------------------------------------------------------------------

TraceSearch SearchOf(const std::string& source, const TraceSearchLimits& limits) {
  TraceSearch search;
  SearchTraces(ProblemOf(source), limits, &search);
  return search;
}

/// A search that may count finds what one that executes each trace finds. True if it has counted.
bool SearchesAlike(const std::string& source, TraceSearchLimits limits = {}) {
  const TraceSearch executed = SearchOf(source, limits);
  limits.counts = true;
  const TraceSearch found = SearchOf(source, limits);
  EXPECT_FALSE(executed.counted);
  EXPECT_EQ(found.units, executed.units);
  EXPECT_EQ(found.executions, executed.executions);
  EXPECT_EQ(found.blocked, executed.blocked);
  EXPECT_EQ(found.redundant, executed.redundant);
  EXPECT_EQ(found.bad, executed.bad);
  EXPECT_EQ(found.too_deep, executed.too_deep);
  EXPECT_EQ(found.globals, executed.globals);
  EXPECT_EQ(found.full, executed.full);
  EXPECT_EQ(found.ends.ends(), executed.ends.ends());
  EXPECT_EQ(found.failing, executed.failing);
  return found.counted;
}

TEST(CountingSearchTest, FindsWhatASearchOfExecutionsFinds) {
  EXPECT_TRUE(SearchesAlike(SumsThatAre("x <= 10", 2, 5)));
  EXPECT_TRUE(SearchesAlike(Replaced(Increments(2, 5), "//@ final: x == 10\n", "")));
  EXPECT_FALSE(SearchesAlike(SumsThatAre("x <= 6", 3, 2))) << "few executions";
}

// With as many pairs as fit at the second time.
TEST(CountingSearchTest, CountsAgainWithALargerBound) {
  const TraceSearch found = SearchOf(SumsThatAre("x > 0", 3, 4), {.counts = true});
  EXPECT_TRUE(found.counted);
  EXPECT_EQ(found.executions, 517'957'530);
  EXPECT_EQ(found.full.size(), 11u);
}

// Readers sleep in many ways, so that there are more pairs than traces.
TEST(CountingSearchTest, ExecutesAllWhereThatIsLessWork) {
  EXPECT_FALSE(SearchesAlike(Readers(14)));
}

// Executions that fail are executed: their schedules, and how far the search continues, are the
// same. The first failure is among the first executions, or far behind them.
TEST(CountingSearchTest, ExecutesThoseOfProgramsThatFail) {
  EXPECT_FALSE(SearchesAlike(Increments(2, 5)));
  const std::string late = SumsThatAre("page1.t != 2", 2, 5);
  EXPECT_FALSE(SearchesAlike(late));
  EXPECT_FALSE(SearchesAlike(late, {.statements_after_bad = 1000}));
  const TraceSearch first = SearchOf(late, {.statements_after_bad = 0, .counts = true});
  EXPECT_GT(first.executions, 10'000);
  EXPECT_EQ(first.bad, 1);
}

TEST(CountingSearchTest, SeesTheLocalsThatAreRequired) {
  EXPECT_TRUE(SearchesAlike(SumsThatAre("page0.t > 1", 2, 5)));
  EXPECT_FALSE(SearchesAlike(SumsThatAre("page1.t != 2", 2, 5)));
}

TEST(CountingSearchTest, ObservesTheLimitOfStatements) {
  const std::string source = SumsThatAre("x <= 10", 2, 5);
  const int64_t longest = ExecutionsOf(source).longest;
  for (int64_t depth = longest - 1; depth < longest + 2; ++depth) {
    EXPECT_EQ(SearchesAlike(source, {.depth = depth}), depth > longest);
  }
}

TEST(CountingSearchTest, WhatWasStoppedGoesOnByExecutions) {
  const Problem problem = ProblemOf(SumsThatAre("x <= 10", 2, 5));
  const std::atomic<bool> stop = true;
  TraceSearch search;
  SearchTraces(problem, {.counts = true, .stop = &stop}, &search);
  EXPECT_EQ(search.executions, 1);
  SearchTraces(problem, {.counts = true}, &search);
  EXPECT_TRUE(search.complete());
  EXPECT_FALSE(search.counted);
  EXPECT_EQ(search.executions, CountOf(SumsThatAre("x <= 10", 2, 5))->traces);
}

// The states are too many, so that the traces decide.
TEST(CountingSearchTest, AutoReportsWhatDporReports) {
  const Problem problem = ProblemOf(SumsThatAre("x <= 10", 2, 5));
  const auto found = Explore(problem, {.state_limit = 10}).value();
  const auto executed = Explore(problem, {.engine = EngineKind::kDpor}).value();
  EXPECT_TRUE(found.traces->counted);
  EXPECT_FALSE(executed.traces->counted);
  EXPECT_EQ(found.verdict, Verdict::kProved);
  EXPECT_EQ(found.verdict, executed.verdict);
  EXPECT_EQ(found.engine, executed.engine);
  EXPECT_EQ(found.traces->executions, executed.traces->executions);
  EXPECT_EQ(found.traces->final_globals, executed.traces->final_globals);
  EXPECT_EQ(found.traces->final_full, executed.traces->final_full);
  EXPECT_EQ(found.traces->complete, executed.traces->complete);
  EXPECT_EQ(found.ends, executed.ends);
}

// A limit of executions is one of those that are executed.
TEST(CountingSearchTest, AutoDoesNotCountWhereExecutionsAreLimited) {
  const Problem problem = ProblemOf(SumsThatAre("x <= 10", 2, 5));
  const auto found = Explore(problem, {.execution_limit = 20'000, .state_limit = 10}).value();
  EXPECT_EQ(found.verdict, Verdict::kIncomplete);
  EXPECT_EQ(found.traces->executions, 20'000);
}

}  // namespace
}  // namespace oncard::explore
