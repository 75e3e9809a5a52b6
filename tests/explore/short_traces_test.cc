// The search of short executions (explore/engines/short_traces.h) is the general one: the same
// executions in the same order, and the same progress at every interruption. ONCARD_TRACE_PROGRAMS
// sets the number of random programs.
#include "explore/engines/short_traces.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

constexpr uint64_t kTracePrograms = 300;

/// What a search has done.
struct Found {
  std::vector<std::vector<uint8_t>> executions;
  std::vector<StateKey> ends;
  int64_t blocked = 0;
  int64_t redundant = 0;
  bool complete = false;
  bool too_deep = false;
  std::vector<TraceUnit> units;  ///< after each interruption
  size_t numbered = 0;           ///< executions whose final states have numbers

  void ExpectSameAs(const Found& other) const {
    EXPECT_EQ(executions, other.executions);
    EXPECT_EQ(ends, other.ends);
    EXPECT_EQ(blocked, other.blocked);
    EXPECT_EQ(redundant, other.redundant);
    EXPECT_EQ(complete, other.complete);
    EXPECT_EQ(too_deep, other.too_deep);
    EXPECT_EQ(units, other.units);
  }
};

/// Explores a unit, interrupted after every `limits.executions` executions.
Found Explored(const Problem& problem, TraceUnit unit, const DporLimits& limits) {
  Model model = problem.model;
  Found found;
  for (int64_t before = -1; !found.complete && !found.too_deep &&
                            before < static_cast<int64_t>(found.executions.size());) {
    before = static_cast<int64_t>(found.executions.size());
    std::map<uint32_t, StateKey> numbers;
    const auto visit = [&](TraceEnd* end) {
      found.executions.push_back(end->Threads());
      EXPECT_EQ(end->Statements(), static_cast<int64_t>(found.executions.back().size()));
      const uint32_t number = end->StateNumber();
      found.ends.push_back(end->State().FinalKey());
      EXPECT_EQ(end->State().runnable(), 0u);
      if (number == TraceEnd::kNoNumber) return true;
      ++found.numbered;
      EXPECT_EQ(numbers.try_emplace(number, found.ends.back()).first->second, found.ends.back());
      return true;
    };
    const DporResult result = ExploreUnit(&model, &unit, limits, visit);
    found.blocked += result.blocked;
    found.redundant += result.redundant;
    found.complete = result.complete;
    found.too_deep = result.too_deep;
    found.units.push_back(unit);
    EXPECT_EQ(model.depth(), 0);
  }
  return found;
}

/// Explores a unit with both searches; returns what the one of short executions found.
Found ExpectSame(const Problem& problem, const TraceUnit& unit, DporLimits limits) {
  limits.count_redundant = true;
  const Found found = Explored(problem, unit, limits);
  limits.general = true;
  const Found expected = Explored(problem, unit, limits);
  EXPECT_EQ(expected.numbered, 0u);
  found.ExpectSameAs(expected);
  return found;
}

/// Every final state has a number: the general search was not needed.
void ExpectShort(const std::string& source) {
  const Found found = ExpectSame(ProblemOf(source), {}, {});
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.redundant, 0);
  EXPECT_EQ(found.numbered, found.executions.size());
}

/// The general search takes over, in the first execution or after some.
void ExpectHandover(const std::string& source, bool after_executions) {
  const Problem problem = ProblemOf(source);
  const Found found = ExpectSame(problem, {}, {});
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.numbered > 0, after_executions);
  EXPECT_LT(found.numbered, found.executions.size());
  for (const int64_t at_once : {1, 4}) {
    EXPECT_TRUE(ExpectSame(problem, {}, {.executions = at_once}).complete);
  }
}

uint64_t Programs() {
  const char* number = std::getenv("ONCARD_TRACE_PROGRAMS");
  return number == nullptr ? kTracePrograms : std::strtoull(number, nullptr, 10);
}

TEST(ShortTracesTest, RandomProgramsAreExploredInTheSameOrder) {
  for (uint64_t seed = 0; seed < Programs(); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Problem problem = ProblemOf(RandomThreads(seed));
    const Found whole = ExpectSame(problem, {}, {});
    ASSERT_TRUE(whole.complete);
    ASSERT_EQ(whole.numbered, whole.executions.size());
    for (const int64_t at_once : {1, 2, 5}) {
      const Found parts = ExpectSame(problem, {}, {.executions = at_once});
      ASSERT_EQ(parts.executions, whole.executions);
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ShortTracesTest, UnitsAreExploredInTheSameOrder) {
  for (uint64_t seed = 0; seed < Programs(); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Problem problem = ProblemOf(RandomThreads(seed));
    Model model = problem.model;
    for (const TraceUnit& unit : SplitTraces(&model, 6)) {
      ExpectSame(problem, unit, {});
      ExpectSame(problem, unit, {.executions = 2});
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ShortTracesTest, LostUpdates) {
  ExpectShort(Increments(2, 3));
  ExpectShort(Increments(3, 2));
}

TEST(ShortTracesTest, StatementsThatAccessSeveralVariables) {
  ExpectShort(
      "int a, b, c;\n"
      "int t0() {\n  a = b;\n  b = a + c;\n  return a;\n}\n"
      "int t1() {\n  b = a + b;\n  c = a;\n  return b;\n}\n"
      "int t2() {\n  c = b - a;\n  return c;\n}\n");
}

TEST(ShortTracesTest, ThreadsThatFail) {
  ExpectShort(
      "int x, a[2];\n"
      "int t0() {\n  int r;\n  r = 1 / x;\n  x = 7 / r;\n  return 0;\n}\n"
      "int t1() {\n  int k;\n  x = 1;\n  k = x + 1;\n  a[k] = 3;\n  a[0] = 1;\n  return 0;\n}\n"
      "int t2() {\n  x = 1 / x;\n  x = 2;\n  return 0;\n}\n");
}

TEST(ShortTracesTest, LoopsOverLocals) {
  ExpectShort(
      "int x;\n"
      "int t0() {\n  int i, c;\nL:\n  x = x + i;\n  i = i + 1;\n  c = i < 3;\n  if (c) goto L;\n"
      "  return i;\n}\n"
      "int t1() {\n  int i, c;\nL:\n  i = i + 1;\n  c = i < 9;\n  if (c) goto L;\n  x = i;\n"
      "  return 0;\n}\n");
}

// Whatever the limit, the same executions fit into it.
TEST(ShortTracesTest, TheLimitOfStatementsIsTheSame) {
  const Problem problem = ProblemOf(
      "int x;\n"
      "int t0() {\n  int r;\n  r = x == 0;\n  if (r) goto E;\n  x = 1;\n  x = 2;\n  r = r + 1;\n"
      "  r = r + 1;\nE:\n  return r;\n}\n"
      "int t1() {\n  int r;\n  r = 1;\n  x = 3;\n  r = x;\n  return r;\n}\n");
  bool short_ones = false;
  for (int64_t depth = 0; depth < 20; ++depth) {
    SCOPED_TRACE(fmt::format("depth {}", depth));
    const Found found = ExpectSame(problem, {}, {.depth = depth});
    short_ones = short_ones || (found.too_deep && !found.executions.empty());
  }
  EXPECT_TRUE(short_ones);
  const Found endless = ExpectSame(
      ProblemOf(
          "int x;\nint t0() {\nL:\n  goto L;\n  return 0;\n}\nint t1() {\n  x = 1;\n  x = 2;\n"
          "  return 0;\n}\n"),
      {}, {.depth = 50});
  EXPECT_TRUE(endless.too_deep);
  const Found turning =
      ExpectSame(ProblemOf("int x;\nint t0() {\nL:\n  x = 1;\n  x = 0;\n  goto L;\n}\n"
                           "int t1() {\n  int c;\nW:\n  c = x != 2;\n  if (c) goto W;\n}\n"),
                 {}, {.depth = 1000});
  EXPECT_TRUE(turning.too_deep);
}

/// A thread that writes y many times if it finds that value of x.
std::string LongIf(int value, int times) {
  std::string source =
      "int x, y, z;\nint t0() {\n  z = 1;\n  x = 1;\n  z = 2;\n  return 0;\n}\nint t1() {\n  int "
      "c;\n";
  source += fmt::format("  c = x == {};\n  if (c) goto L;\n  return 0;\nL:\n", value);
  for (int i = 0; i < times; ++i) source += "  y = y + 1;\n";
  return source + "  return 0;\n}\nint t2() {\n  int r;\n  r = y;\n  z = 3;\n  return r;\n}\n";
}

TEST(ShortTracesTest, LongExecutionsAreHandedOver) {
  ExpectHandover(LongIf(1, 60), false);
  ExpectHandover(LongIf(0, 60), true);
}

// An execution of exactly 64 steps is still a short one.
TEST(ShortTracesTest, ExecutionsOfSixtyFourSteps) {
  const auto writes = [](int times) {
    std::string source = "int x, y;\nint t0() {\n";
    for (int i = 0; i < times; ++i) source += "  x = x + 1;\n";
    return source + "  return 0;\n}\nint t1() {\n  int r;\n  r = x;\n  return r;\n}\n";
  };
  ExpectShort(writes(63));
  const Found found = ExpectSame(ProblemOf(writes(64)), {}, {});
  EXPECT_EQ(found.executions.size(), 65u);
  EXPECT_EQ(found.numbered, 0u);
}

// One thread can read 41 values and uses each as an index.
TEST(ShortTracesTest, ManyDifferentAccessesAreHandedOver) {
  std::string source = "int x, a[50];\nint t0() {\n";
  for (int i = 0; i < 40; ++i) source += "  x = x + 1;\n";
  source += "  return 0;\n}\nint t1() {\n  int k, r;\n  k = x;\n  a[k] = 1;\n  r = a[k];\n";
  ExpectHandover(source + "  return r;\n}\n", true);
}

TEST(ShortTracesTest, GlobalIndicesAreHandedOver) {
  ExpectHandover(
      "int a[2], i;\n"
      "int t0() {\n  i = 1;\n  return 0;\n}\n"
      "int t1() {\n  a[i] = 1;\n  return 0;\n}\n"
      "int t2() {\n  a[0] = 2;\n  return 0;\n}\n",
      false);
}

}  // namespace
}  // namespace oncard::explore
