// What a search leaves out by default changes no answer: on random programs it has the verdict, the
// fault and the ends of the search of every state between two statements.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "explore/engines/dpor.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "tests/base/random_cases.h"

namespace oncard::explore {
namespace {

/// Two or three threads of statements that access globals or not, of loops that wait for a global,
/// that are bounded or alternate, and one requirement.
std::string RandomWaiters(uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](uint64_t n) { return static_cast<int>(random() % n); };
  constexpr const char* kRequirements[] = {
      "final: g[0] != 2",
      "final: ret0 < 2 || g[1] == 0",
      "final: page1.k == 0 || g[0] < 2",
      "never: g[0] == 1 && g[1] == 1",
      "always: g[2] < 2 || g[0] == 0",
      "never: page0.k == 1 && g[1] == 1",
      "always: ret1 == 0 || g[0] == 0",
      "eventually: g[0] == 1 && g[2] == 0",
      "eventually: page1.k == 2",
      "leads: g[0] == 1 -> g[1] == 1",
      "leads: page0.k == 1 -> g[1] > 0",
      "races: none",
      "races: benign",
      "livelock: any\n//@ never: g[0] == 2 && g[2] == 1",
      "endless\n//@ always: g[1] < 2 || g[2] > 0",
      "livelock: any\n//@ final: g[0] == g[1]",
  };
  std::string source = fmt::format(
      "int g[3];\n//@ {}\n", kRequirements[static_cast<size_t>(below(std::size(kRequirements)))]);
  const int threads = 2 + below(2);
  for (int thread = 0; thread < threads; ++thread) {
    source += fmt::format("int t{}() {{\n  int r, k, c;\n", thread);
    const int statements = 1 + below(threads == 2 ? 4 : 2);
    for (int i = 0; i < statements; ++i) {
      if (below(5) == 0) {
        source +=
            fmt::format("  //@ assert: g[{}] != {} || k < {}\n", below(3), below(3), 1 + below(3));
      }
      switch (below(9)) {
        case 0:
          source += fmt::format("  r = g[{}];\n", below(3));
          break;
        case 1:
          source += fmt::format("  g[{}] = {};\n", below(3), below(3));
          break;
        case 2:
          source += fmt::format("  g[{0}] = g[{0}] + 1;\n", below(3));
          break;
        case 3:
          source += "  k = k + 1;\n";
          break;
        case 4:
          source += fmt::format("  k = r & 1;\n  g[{}] = k;\n", below(3));
          break;
        case 5:
          source += fmt::format("W{0}:\n  c = g[{1}] == {2};\n  if (c) goto W{0};\n", i, below(3),
                                below(2));
          break;
        case 6:
          source += fmt::format("W{0}:\n  r = g[{1}];\n  c = r != 1;\n  if (c) goto W{0};\n", i,
                                below(3));
          break;
        case 7:
          source += fmt::format(
              "  k = 0;\nL{0}:\n  k = k + 1;\n  g[{1}] = k;\n  c = k < 2;\n  if (c) goto L{0};\n",
              i, below(3));
          break;
        default:
          source += fmt::format(
              "L{0}:\n  g[{1}] = 1;\n  g[{1}] = 0;\n  c = g[{2}] == 0;\n"
              "  if (c) goto L{0};\n",
              i, below(3), below(3));
          break;
      }
    }
    source += "  return r;\n}\n";
  }
  return source;
}

/// What two searches of one problem must agree about.
void ExpectSame(const Exploration& found, const Exploration& whole) {
  ASSERT_EQ(found.verdict, whole.verdict);
  ASSERT_EQ(found.failure.has_value(), whole.failure.has_value());
  if (!whole.failure) return;
  EXPECT_EQ(found.failure->livelock, whole.failure->livelock);
  EXPECT_EQ(found.failure->fault.kind, whole.failure->fault.kind);
}

/// ONCARD_RANDOM_WAITERS sets another number of random programs.
uint64_t Waiters() {
  const char* given = std::getenv("ONCARD_RANDOM_WAITERS");
  return given == nullptr ? RandomCases(uint64_t{1500}) : std::strtoull(given, nullptr, 10);
}

TEST(ReductionsTest, MergedStatementsAnswerAsSingleOnes) {
  uint64_t failed = 0;
  uint64_t merged_ones = 0;
  const uint64_t programs = Waiters();
  for (uint64_t seed = 0; seed < programs; ++seed) {
    const std::string source = RandomWaiters(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, source));
    const Problem problem = ProblemOf(source);
    const ExploreOptions single = {.engine = EngineKind::kStateful, .merge_private = false};
    const Exploration whole = Explore(problem, single).value();
    const Exploration found = Explore(problem, {.engine = EngineKind::kStateful}).value();
    failed += whole.failure ? 1 : 0;
    ExpectSame(found, whole);
    if (whole.failure) {
      // It is shown as if nothing had been merged.
      EXPECT_EQ(found.failure->steps, whole.failure->steps);
      EXPECT_EQ(found.failure->cycle, whole.failure->cycle);
      EXPECT_EQ(found.states->states, whole.states->states);
    }
    const auto merged = Explore(
        problem, {.engine = EngineKind::kStateful, .merge_private = true, .symmetry = false});
    if (merged.ok()) {
      ++merged_ones;
      ExpectSame(merged.value(), whole);
      EXPECT_EQ(merged.value().states->final_full, whole.states->final_full);
      EXPECT_EQ(merged.value().states->finals_within, whole.states->finals_within);
      // The last statements before a race are not merged.
      const bool races = whole.failure && whole.failure->fault.kind == Fault::Kind::kRace;
      if (whole.failure && !whole.failure->livelock && !races) {
        EXPECT_EQ(merged.value().failure->preemptions, whole.failure->preemptions);
      }
    }
    if (HasFailure()) return;
  }
  // Neither verdict is rare.
  EXPECT_GT(failed, programs / 8);
  EXPECT_LT(failed, programs * 7 / 8);
  EXPECT_GT(merged_ones, programs / 2);
}

/// Two to four threads, of which two or more have the same statements, and one requirement.
std::string RandomEquals(uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](uint64_t n) { return static_cast<int>(random() % n); };
  constexpr const char* kRequirements[] = {
      "final: g[0] != 2",
      "final: g[0] < 3",
      "final: g[0] + g[1] != 3",
      "final: ret0 < 2 || g[1] == 0",
      "final: page1.k == 0 || g[0] < 2",
      "never: g[0] == 2 && g[1] == 1",
      "always: g[1] < 3 || g[0] == 0",
      "eventually: g[0] > 0",
      "races: benign",
      "livelock: any\n//@ never: g[0] == 2 && g[1] == 1",
  };
  std::string source = "int g[2];\n";
  // One of three asks for nothing: all results are compared.
  if (below(3) != 0) {
    source += fmt::format("//@ {}\n",
                          kRequirements[static_cast<size_t>(below(std::size(kRequirements)))]);
  }
  const auto body = [&](int statements) {
    std::string text;
    for (int i = 0; i < statements; ++i) {
      switch (below(8)) {
        case 0:
          text += fmt::format("  r = g[{}];\n", below(2));
          break;
        case 1:
          text += fmt::format("  g[{}] = r + {};\n", below(2), below(2));
          break;
        case 2:
          text += fmt::format("  g[{0}] = g[{0}] + 1;\n", below(2));
          break;
        case 3:
          text += "  k = k + 1;\n";
          break;
        case 4:
          text += fmt::format("  k = r & 1;\n  g[{}] = k;\n", below(2));
          break;
        case 5:
          text += fmt::format("  c = g[{1}] == {2};\n  if (c) goto S{0};\n  k = 2;\nS{0}:\n", i,
                              below(2), below(2));
          break;
        case 6:
          text += fmt::format("  r = g[{0}];\n  r = r + 1;\n  g[{0}] = r;\n", below(2));
          break;
        default:
          if (below(4) != 0) break;
          text += fmt::format("W{0}:\n  c = g[{1}] == {2};\n  if (c) goto W{0};\n", i, below(2),
                              below(2));
          break;
      }
    }
    return text + (below(2) == 0 ? "  return r;\n}\n" : "  return k;\n}\n");
  };
  const int threads = 2 + below(3);
  const std::string same = body(threads == 4 ? 1 + below(2) : 1 + below(3));
  const int other = threads > 2 && below(2) == 0 ? below(static_cast<uint64_t>(threads)) : -1;
  for (int thread = 0; thread < threads; ++thread) {
    source += fmt::format("int t{}() {{\n  int r, k, c;\n", thread);
    source += thread == other ? body(1) : same;
  }
  return source;
}

TEST(ReductionsTest, EqualThreadsAnswerAsDifferentOnes) {
  uint64_t failed = 0;
  uint64_t symmetric = 0;
  const uint64_t programs = Waiters();
  for (uint64_t seed = 0; seed < programs; ++seed) {
    const std::string source = RandomEquals(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, source));
    const Problem problem = ProblemOf(source);
    const ExploreOptions single = {.engine = EngineKind::kStateful, .merge_private = false};
    const Exploration whole = Explore(problem, single).value();
    for (const bool dead_locals : {false, true}) {
      const Exploration found =
          Explore(problem, {.engine = EngineKind::kStateful, .dead_locals = dead_locals}).value();
      ExpectSame(found, whole);
      EXPECT_EQ(found.states->final_globals, whole.states->final_globals);
      EXPECT_EQ(found.states->final_full, whole.states->final_full);
      EXPECT_EQ(found.ends, whole.ends);
      EXPECT_EQ(found.coverage, whole.coverage);
      if (whole.failure) {
        EXPECT_FALSE(found.states->symmetric);
        EXPECT_EQ(found.failure->steps, whole.failure->steps);
      }
      symmetric += dead_locals && found.states->symmetric ? 1 : 0;
    }
    failed += whole.failure ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_GT(failed, programs / 16);
  EXPECT_GT(symmetric, programs / 4);
}

/// The executions of a split search whose parts are interrupted again and again.
int64_t ExecutionsOfParts(const Problem& problem, bool general) {
  Model model = ModelOfTraces(problem);
  int64_t executions = 0;
  for (TraceUnit& unit : SplitTraces(&model, 5)) {
    DporResult result;
    do {
      result = ExploreUnit(&model, &unit, {.executions = 2, .general = general},
                           [](TraceEnd*) { return true; });
      executions += result.executions;
    } while (!result.complete && !result.too_deep);
  }
  return executions;
}

// The search of traces ends where threads wait for others. It gives up loops that do more than
// that.
TEST(ReductionsTest, TracesWithWaitingLoopsAnswerAsStates) {
  uint64_t answered = 0;
  uint64_t endless = 0;
  const uint64_t programs = Waiters();
  for (uint64_t seed = 0; seed < programs; ++seed) {
    const std::string source = RandomWaiters(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, source));
    const Problem problem = ProblemOf(source);
    if (!CanSearchTraces(problem) || problem.races == RaceRule::kBenign) continue;
    const ExploreOptions single = {.engine = EngineKind::kStateful, .merge_private = false};
    const Exploration whole = Explore(problem, single).value();
    const Exploration found =
        Explore(problem, {.engine = EngineKind::kDpor, .depth_limit = 300}).value();
    EXPECT_EQ(found.traces->blocked, 0);
    EXPECT_EQ(found.traces->redundant, 0);
    if (found.verdict == Verdict::kIncomplete) continue;
    ++answered;
    ASSERT_EQ(found.verdict, whole.verdict);
    // A failing check ends its thread before the statement, but not in the graph of states.
    if (found.verdict == Verdict::kProved) {
      EXPECT_EQ(found.traces->final_full, whole.states->final_full);
    }
    if (found.traces->complete && found.traces->executions < 200) {
      for (const bool general : {false, true}) {
        EXPECT_EQ(ExecutionsOfParts(problem, general), found.traces->executions);
      }
    }
    if (found.failure && found.failure->livelock) {
      ++endless;
      // The statements of the loop lead back to where it began.
      Model model = problem.model;
      for (const uint8_t thread : found.failure->steps) model.Step(thread);
      const StateKey begin = model.key();
      for (const uint8_t thread : found.failure->cycle) model.Step(thread);
      EXPECT_EQ(model.key(), begin);
      EXPECT_FALSE(found.failure->cycle.empty());
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(answered, programs / (PercentOfRandomCases() < 100 ? 6 : 3));
  EXPECT_GT(endless, programs / 50);
}

}  // namespace
}  // namespace oncard::explore
