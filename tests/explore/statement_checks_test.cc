// Asserts, and `always` and `never` in the search of traces, on random programs: every engine finds
// a failure exactly where a search without any reduction meets a state that violates them.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "explore/engines/dpor.h"
#include "explore/engines/trace_count.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "tests/base/random_cases.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

/// RandomThreads() with asserts before some statements, and one requirement on every state.
std::string CheckedThreads(uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](uint64_t n) { return static_cast<int>(random() % n); };
  const std::string plain = RandomThreads(seed);
  std::string source;
  for (size_t begin = 0; begin < plain.size();) {
    const size_t end = plain.find('\n', begin) + 1;
    const std::string line = plain.substr(begin, end - begin);
    begin = end;
    if (line.starts_with("//@")) {
      // The values that the variables can have are few, so that about half of them fail.
      switch (seed % 4) {
        case 0:
          source += fmt::format("//@ never: g[{}] == {} && g[{}] == {}\n", below(3), 1 + below(2),
                                below(3), below(3));
          break;
        case 1:
          source +=
              fmt::format("//@ always: g[{}] + g[{}] < {}\n", below(3), below(3), 2 + below(3));
          break;
        default:
          source += "//@ final: g[0] < 9\n";
      }
      continue;
    }
    const bool statement = line.starts_with("  ") && !line.starts_with("  int");
    if (statement && seed % 4 != 0 && below(3) == 0) {
      source += fmt::format("  //@ assert: g[{}] != {} || {} == {}\n", below(3), below(3),
                            below(2) == 0 ? "r" : fmt::format("g[{}]", below(3)), below(2));
    }
    source += line;
  }
  return source;
}

/// The source without its asserts; its lines stay where they are.
std::string WithoutAsserts(std::string source) {
  for (size_t at = 0; (at = source.find("//@ assert", at)) != std::string::npos; ++at) {
    source.replace(at, 10, "// removed");
  }
  return source;
}

/// Looks at every reachable state of a program without asserts, and at what its threads are about
/// to execute there.
class PlainSearchOfChecks {
 public:
  PlainSearchOfChecks(const std::string& source, const vm::Object& with_asserts)
      : problem_(ProblemOf(WithoutAsserts(source))), model_(problem_.model) {
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      const auto function = static_cast<size_t>(model_.setup(thread).function);
      for (const vm::Assert& each : with_asserts.functions[function].asserts) {
        auto condition = runtime::ParseCondition(each.condition);
        auto property = Property::BindInThread(std::move(condition).value(), thread, model_);
        asserts_.push_back({thread, each.position, std::move(property).value()});
      }
    }
    Visit();
  }
  bool bad() const { return bad_; }

 private:
  struct Placed {
    int thread;
    int position;
    Property property;
  };

  void Visit() {
    if (!known_.insert({model_.key().low, model_.key().high}).second) return;
    bad_ = bad_ || FindFault(problem_, model_);
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (!model_.Running(thread)) continue;
      for (const Placed& each : asserts_) {
        const bool here = each.thread == thread && each.position == model_.Position(thread);
        bad_ = bad_ || (here && !each.property.Holds(model_));
      }
      model_.Step(thread);
      Visit();
      model_.Undo();
    }
  }

  Problem problem_;
  Model model_;
  std::vector<Placed> asserts_;
  std::set<std::pair<uint64_t, uint64_t>> known_;
  bool bad_ = false;
};

bool Fails(const Problem& problem, const ExploreOptions& options) {
  auto explored = Explore(problem, options);
  EXPECT_TRUE(explored.ok()) << explored.error().message.en;
  const Verdict verdict = explored.value().verdict;
  EXPECT_TRUE(verdict == Verdict::kProved || verdict == Verdict::kFailed);
  return verdict == Verdict::kFailed;
}

TEST(StatementChecksTest, AllEnginesAgreeWithAPlainSearch) {
  int bad = 0;
  const int programs = RandomCases(2400);
  for (int seed = 0; seed < programs; ++seed) {
    const std::string source = CheckedThreads(static_cast<uint64_t>(seed));
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, source));
    const Problem problem = ProblemOf(source);
    const bool expected = PlainSearchOfChecks(source, problem.model.image().object).bad();
    bad += expected ? 1 : 0;
    EXPECT_EQ(Fails(problem, {.engine = EngineKind::kDpor}), expected);
    for (const bool merge : {false, true}) {
      EXPECT_EQ(Fails(problem, {.engine = EngineKind::kStateful, .merge_private = merge}),
                expected);
    }
    EXPECT_EQ(Fails(problem, {.engine = EngineKind::kAuto, .all = true}), expected);

    const Model start = ModelOfTraces(problem);
    bool found = static_cast<bool>(FindFault(problem, start));
    CountTraces(start, {}, [&](const Model& end) {
      found = found || FindFault(problem, end);
      return true;
    });
    EXPECT_EQ(found, expected);
    Model model = start;
    found = static_cast<bool>(FindFault(problem, start));
    ExploreTraces(&model, {.general = true}, [&](TraceEnd* end) {
      found = found || FindFault(problem, end->State());
      return true;
    });
    EXPECT_EQ(found, expected);
    if (HasFailure()) return;
  }
  // Neither verdict is rare.
  EXPECT_GT(bad, programs / 8);
  EXPECT_LT(bad, programs * 7 / 8);
}

constexpr const char* kLateReader =
    "int x;\n"
    "int t0() {\n  x = 5;\n  x = 1;\n  return 0;\n}\n"
    "int t1() {\n  int r;\n  r = 2;\n  //@ assert: x < 3 && r == 2\n  r = x;\n  return r;\n}\n";

class LateReaderTest : public testing::TestWithParam<EngineKind> {};

TEST_P(LateReaderTest, FailsInOneState) {
  const Findings findings = FindingsOf(kLateReader, {.engine = GetParam()});
  ASSERT_EQ(findings.exploration.verdict, Verdict::kFailed);
  const Failure& failure = *findings.exploration.failure;
  EXPECT_EQ(failure.fault.kind, Fault::Kind::kRequirement);
  EXPECT_EQ(failure.fault.thread, 1);
  // The last statement is the one that the assert stands before.
  EXPECT_EQ(findings.trail.steps.back().log.line, 11);
  EXPECT_EQ(findings.trail.actual.en, "x is 5, r is 2");
  EXPECT_THAT(TextReport(findings, Language::kEnglish),
              HasSubstr("assert: x < 3 && r == 2 does not hold at program.c:11 in thread 1: x is "
                        "5, r is 2\n"));
}

INSTANTIATE_TEST_SUITE_P(Engines, LateReaderTest,
                         testing::Values(EngineKind::kAuto, EngineKind::kDpor,
                                         EngineKind::kStateful, EngineKind::kBounded,
                                         EngineKind::kRandom, EngineKind::kPct, EngineKind::kPos));

TEST(StatementChecksTest, AreMadeWithACard) {
  const Findings findings = FindingsOf(kLateReader, "until_ms = 2\n", {});
  ASSERT_EQ(findings.exploration.verdict, Verdict::kFailed);
  EXPECT_TRUE(findings.trail.with_card);
  EXPECT_EQ(findings.trail.steps.back().log.line, 11);
  EXPECT_EQ(findings.trail.actual.en, "x is 5, r is 2");
}

TEST(StatementChecksTest, AreNoRaces) {
  const std::string source =
      "//@ races: none\nint x, y;\nint t0() {\n  x = 1;\n  return 0;\n}\n"
      "int t1() {\n  //@ assert: x < 3\n  y = 1;\n  return 0;\n}\n";
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kDpor, EngineKind::kStateful}) {
    EXPECT_EQ(FindingsOf(source, {.engine = engine}).exploration.verdict, Verdict::kProved);
  }
}

TEST(StatementChecksTest, SaySoIfTheyWereNotMade) {
  const std::string source =
      "int x;\nint t0() {\n  if (x) goto E;\n  return 0;\nE:\n  //@ assert: x < 3\n  return "
      "1;\n}\n";
  for (const char* keys : {"", "until_ms = 1\n"}) {
    const Findings findings = FindingsOf(source, keys, {});
    EXPECT_NE(findings.exploration.verdict, Verdict::kFailed);
    ASSERT_EQ(findings.untested.size(), 1u) << keys;
    EXPECT_EQ(findings.untested[0].en,
              "'assert: x < 3' was never tested: no thread executed program.c:7");
  }
}

TEST(StatementChecksTest, OfOtherThreadsNeedTheGraphOfStates) {
  const std::string source =
      "int x;\nint t0() {\n  int k;\n  k = 1;\n  k = 2;\n  return 3;\n}\n"
      "int t1() {\n  //@ assert: page0.k != 1\n  x = 1;\n  return 0;\n}\n";
  const Problem problem = ProblemOf(source);
  EXPECT_FALSE(Explore(problem, {.engine = EngineKind::kDpor}).ok());
  EXPECT_FALSE(Explore(problem, {.engine = EngineKind::kStateful, .merge_private = true}).ok());
  EXPECT_TRUE(Fails(problem, {.engine = EngineKind::kStateful}));
  EXPECT_TRUE(Fails(problem, {}));
}

// The program of the measurement in the commit: the graph of its states is too large for `auto`.
TEST(StatementChecksTest, LetTheSearchOfTracesProveWhatHoldsInEveryState) {
  std::string source = "int d, a[6];\n//@ always: d < 2\n";
  for (int thread = 0; thread < 6; ++thread) {
    source += fmt::format(
        "int t{0}() {{\n  int i, c;\nL:\n  a[{0}] = a[{0}] + 1;\n"
        "  i = i + 1;\n  c = i < 9;\n  if (c) goto L;\n{1}  return 0;\n}}\n",
        thread, thread == 0 ? "  d = 1;\n" : "");
  }
  const Problem problem = ProblemOf(source);
  const auto explored = Explore(problem, {.state_limit = 600'000});
  ASSERT_TRUE(explored.ok());
  EXPECT_EQ(explored.value().verdict, Verdict::kProved);
  EXPECT_EQ(explored.value().engine, EngineKind::kDpor);
  EXPECT_EQ(explored.value().traces->executions, 1);
}

}  // namespace
}  // namespace oncard::explore
