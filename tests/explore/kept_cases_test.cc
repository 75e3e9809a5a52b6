// Searches of scenarios with a card or choices that are kept in files
// (explore/kept_cases.h), beside the same searches in one piece.
#include "explore/kept_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explore/scenario_exploration.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

/// Two threads that add to g what is chosen; the sum is 2x, or x where an addition is lost.
constexpr const char* kLosers =
    "int g, x;\n"
    "int t0() {\n  int r;\n  GT_AxisOn(1);\n  r = g;\n  r = r + x;\n  g = r;\n  return 0;\n}\n"
    "int t1() {\n  int r;\n  r = g;\n  r = r + x;\n  g = r;\n  return 0;\n}\n";
constexpr const char* kFour = "[globals]\nx = { any = [1, 4] }\n";
constexpr const char* kHolds = "final = [\"g <= 2 * x\"]\n";
/// Thrice the number where three are chosen: 6 is 2 * 3.
constexpr const char* kFails = "final = [\"g != 6\"]\n";

/// Two threads that count, and read how far the other one is, five statements a cycle for both.
constexpr const char* kCounters =
    "int a, b;\n"
    "int t0() {\n  int n, r;\nlbl_next:\n  a = a + 1;\n  n = b;\n  r = a < 12;\n"
    "  if (r) goto lbl_next;\n  return n;\n}\n"
    "int t1() {\n  int n, r;\nlbl_next:\n  b = b + 1;\n  n = a;\n  r = b < 12;\n"
    "  if (r) goto lbl_next;\n  return n;\n}\n"
    "int t2() { GT_AxisOn(1); return 0; }\n";
constexpr const char* kSlowCounters = "rate = 20\n";

class KeptCases : public ::testing::Test {
 protected:
  void Load(const std::string& source, const std::string& keys) {
    loaded_ = LoadedOf(source, keys);
  }
  SearchedScenario Searched() const {
    return {loaded_.scenario, loaded_.requirements, loaded_.object};
  }
  Findings Whole(const ExploreOptions& options) const {
    auto found = ExploreScenario(loaded_.scenario, loaded_.requirements, loaded_.object, options);
    EXPECT_TRUE(found.ok());
    return std::move(found).value();
  }
  SearchFile Begin(const ExploreOptions& options, const SearchPart& part = {}) const {
    auto begun = BeginByCases(Searched(), options, part);
    EXPECT_TRUE(begun.ok()) << begun.error().message.en;
    return std::move(begun).value();
  }
  /// Goes on with what is read back from the file.
  Findings GoOn(const ExploreOptions& options, SearchFile* file) const {
    auto read = ParseSearchFile(FormatSearchFile(*file));
    EXPECT_TRUE(read.ok()) << read.error().message.en;
    *file = std::move(read).value();
    const auto checked = CheckByCases(Searched(), *file);
    EXPECT_TRUE(checked.ok()) << checked.error().message.en;
    auto found = GoOnByCases(
        Searched(), options, [](const SearchFile&) { return true; }, file);
    EXPECT_TRUE(found.ok()) << found.error().message.en;
    return std::move(found).value();
  }
  /// The parts, merged from the last one to the first.
  SearchFile Merged(const ExploreOptions& options, int parts) const {
    std::optional<SearchFile> all;
    for (int part = parts; part >= 1; --part) {
      SearchFile file = Begin(options, {part, parts});
      GoOn(options, &file);
      if (!all) {
        all = std::move(file);
      } else {
        EXPECT_TRUE(MergeInto(&*all, file).ok());
      }
    }
    return *std::move(all);
  }
  Findings Concluded(const SearchFile& file) const {
    auto found = ConcludeByCases(Searched(), {}, file);
    EXPECT_TRUE(found.ok()) << found.error().message.en;
    return std::move(found).value();
  }
  static std::string Report(const Findings& findings) {
    return TextReport(findings, Language::kEnglish);
  }

  LoadedScenario loaded_;
};

TEST_F(KeptCases, PartsOfTheCasesAreReportedAsTheWhole) {
  Load(kLosers, std::string(kHolds) + kFour);
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful, EngineKind::kBounded}) {
    const ExploreOptions options = {.engine = engine};
    const Findings whole = Whole(options);
    for (const int parts : {1, 2, 3, 4}) {
      const SearchFile file = Merged(options, parts);
      EXPECT_TRUE(file.done() && file.whole());
      EXPECT_EQ(Report(Concluded(file)), Report(whole)) << parts;
    }
  }
}

TEST_F(KeptCases, ProgramsWithoutACardHaveCasesToo) {
  Load("int g, x;\nint t0() { g = g + x; return 0; }\nint t1() { g = g + x; return 0; }\n",
       std::string("final = [\"g == 2 * x\"]\n") + kFour);
  for (const EngineKind engine : {EngineKind::kDpor, EngineKind::kStateful}) {
    const ExploreOptions options = {.engine = engine};
    EXPECT_EQ(Report(Concluded(Merged(options, 3))), Report(Whole(options)));
  }
  const auto begun = BeginByCases(Searched(), {.engine = EngineKind::kDpor}, {1, 5});
  ASSERT_FALSE(begun.ok());
  EXPECT_THAT(begun.error().message.en, HasSubstr("4 cases to be divided, and 5 parts"));
}

TEST_F(KeptCases, AFailureOfOnePartIsThatOfTheWhole) {
  Load(kLosers, std::string(kFails) + kFour);
  const Findings whole = Whole({});
  ASSERT_EQ(whole.exploration.verdict, Verdict::kFailed);
  for (const int parts : {1, 2, 4}) {
    const SearchFile file = Merged({}, parts);
    const Findings all = Concluded(file);
    EXPECT_EQ(all.exploration.verdict, Verdict::kFailed);
    EXPECT_EQ(all.cases->failing.en, whole.cases->failing.en);
    EXPECT_EQ(all.exploration.failure->steps, whole.exploration.failure->steps);
  }
  // The part that fails says the same alone.
  SearchFile second = Begin({}, {3, 4});
  EXPECT_EQ(GoOn({}, &second).exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(Concluded(second).cases->failing.en, "x = 3");
  SearchFile first = Begin({}, {1, 4});
  EXPECT_EQ(GoOn({}, &first).exploration.verdict, Verdict::kPassed);
}

TEST_F(KeptCases, APartThatIsMissingOrNotCompleteIsNoProof) {
  Load(kLosers, std::string(kHolds) + kFour);
  SearchFile all = Begin({}, {1, 3});
  GoOn({}, &all);
  SearchFile third = Begin({}, {3, 3});
  GoOn({}, &third);
  ASSERT_TRUE(MergeInto(&all, third).ok());
  EXPECT_EQ(MissingParts(all), "2");
  EXPECT_EQ(Concluded(all).exploration.verdict, Verdict::kPassed);
  EXPECT_THAT(Concluded(all).exploration.why.en, HasSubstr("no failure in these of 3 parts: 1, 3"));
  const SearchFile second = Begin({}, {2, 3});
  ASSERT_TRUE(MergeInto(&all, second).ok());
  EXPECT_EQ(Concluded(all).exploration.verdict, Verdict::kIncomplete);
  EXPECT_EQ(Concluded(all).cases->searched, 3);
  EXPECT_THAT(Report(Concluded(all)), HasSubstr("3 cases were searched; the counts are sums\n"));
  // What is left can be searched in the merged file.
  EXPECT_EQ(GoOn({}, &all).exploration.verdict, Verdict::kProved);
}

TEST_F(KeptCases, ItGoesOnWhereALimitEndedIt) {
  const std::pair<std::string, std::string> searches[] = {{kLosers, std::string(kHolds) + kFour},
                                                          {kCounters, kSlowCounters}};
  for (const auto& [source, keys] : searches) {
    Load(source, keys);
    const ExploreOptions options = {.engine = EngineKind::kStateful};
    SearchFile whole = Begin(options);
    const std::string expected = Report(GoOn(options, &whole));
    const int64_t states = whole.units->found->states->states;
    ExploreOptions few = options;
    few.state_limit = static_cast<uint32_t>(states / 2);
    SearchFile file = Begin(options);
    EXPECT_EQ(file.units->units(), 4);
    const Findings begun = GoOn(few, &file);
    EXPECT_EQ(begun.exploration.verdict, Verdict::kIncomplete);
    EXPECT_THAT(begun.exploration.why.en, HasSubstr("were searched"));
    EXPECT_FALSE(file.done());
    EXPECT_LT(file.units->left.size(), 4u);
    EXPECT_EQ(Report(GoOn(options, &file)), expected);
  }
}

TEST_F(KeptCases, ASearchThatIsToldToEndKeepsItsUnits) {
  Load(kLosers, std::string(kHolds) + kFour);
  SearchProgress progress;
  const ExploreOptions options = {.engine = EngineKind::kStateful, .progress = &progress};
  SearchFile file = Begin(options);
  int kept = 0;
  const auto found = GoOnByCases(
      Searched(), options,
      [&](const SearchFile&) {
        progress.interrupted = ++kept == 2;
        progress.stop = progress.interrupted.load();
        return true;
      },
      &file);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found.value().exploration.verdict, Verdict::kIncomplete);
  EXPECT_EQ(found.value().exploration.why.en, "it was interrupted; 2 of 4 cases were searched");
  EXPECT_EQ(file.units->left, (std::vector<int64_t>{2, 3}));
  EXPECT_EQ(Report(GoOn({}, &file)), Report(Whole({.engine = EngineKind::kStateful})));
}

TEST_F(KeptCases, SchedulesOfOneCaseAreDivided) {
  Load(kCounters, kSlowCounters);
  const ExploreOptions options = {.engine = EngineKind::kStateful};
  const Findings whole = Whole(options);
  const SearchFile file = Merged(options, 3);
  EXPECT_EQ(file.units->groups, 3);
  const Findings all = Concluded(file);
  EXPECT_EQ(all.exploration.verdict, Verdict::kProved);
  EXPECT_EQ(all.exploration.ends, whole.exploration.ends);
  EXPECT_THAT(Report(all), HasSubstr("; some counted in several groups of schedules\n"));
}

TEST_F(KeptCases, RandomRunsInPartsAreThoseInOnePiece) {
  for (const char* asked : {kHolds, kFails}) {
    Load(kLosers, std::string(asked) + kFour);
    for (const EngineKind engine : {EngineKind::kRandom, EngineKind::kPct, EngineKind::kPos}) {
      ExploreOptions options = {.engine = engine, .all = true, .runs = 23, .seed = 5};
      const Findings whole = Whole(options);
      for (const int parts : {1, 2, 5}) {
        const Findings all = Concluded(Merged(options, parts));
        EXPECT_EQ(all.exploration.verdict, whole.exploration.verdict);
        EXPECT_EQ(all.exploration.samples->runs, 23);
        EXPECT_EQ(all.exploration.samples->bad, whole.exploration.samples->bad);
        EXPECT_EQ(all.exploration.samples->ends, whole.exploration.samples->ends);
        EXPECT_EQ(all.cases->failing.en, whole.cases->failing.en);
      }
    }
  }
}

TEST_F(KeptCases, WhatIsRefusedAndUntestedIsKept) {
  Load("int g, x;\nint t0() {\n  GT_AxisOn(9);\n  g = x;\n  return 0;\n}\n",
       std::string("never = [\"g == 7 && x == 0\"]\n") + kFour);
  const Findings whole = Whole({});
  ASSERT_EQ(whole.refused.size(), 1u);
  ASSERT_EQ(whole.untested.size(), 1u);
  const Findings all = Concluded(Merged({}, 2));
  ASSERT_EQ(all.refused.size(), 1u);
  EXPECT_EQ(all.refused.front().count, whole.refused.front().count);
  EXPECT_EQ(all.refused.front().call.zh, whole.refused.front().call.zh);
  EXPECT_EQ(all.refused.front().place.line, whole.refused.front().place.line);
  ASSERT_EQ(all.untested.size(), 1u);
  EXPECT_EQ(all.untested.front().en, whole.untested.front().en);
}

TEST_F(KeptCases, TheHashIsOfAllThatDecides) {
  const auto hash = [&](const std::string& source, const std::string& keys) {
    Load(source, keys);
    return HashByCases(Searched()).value();
  };
  const uint64_t first = hash(kLosers, std::string(kHolds) + kFour);
  EXPECT_EQ(hash(kLosers, std::string(kHolds) + kFour), first);
  EXPECT_EQ(hash(kLosers, std::string("explore = \"prove\"\n") + kHolds + kFour), first);
  EXPECT_NE(hash(kLosers, std::string(kFails) + kFour), first);
  EXPECT_NE(hash(kLosers, std::string("rate = 50\n") + kHolds + kFour), first);
  EXPECT_NE(hash(kLosers, std::string(kHolds) + "[globals]\nx = { any = [1, 5] }\n"), first);
  std::string source = kLosers;
  source.replace(source.find("r + x"), 5, "r + 1");
  EXPECT_NE(hash(source, std::string(kHolds) + kFour), first);
}

TEST_F(KeptCases, AFileThatDoesNotFitIsRefused) {
  Load(kLosers, std::string(kHolds) + kFour);
  const SearchFile units = Begin({});
  SearchFile file = units;
  file.units->cases = 5;
  EXPECT_FALSE(CheckByCases(Searched(), file).ok());
  file = units;
  file.units.reset();
  file.engine = EngineKind::kDpor;
  EXPECT_FALSE(CheckByCases(Searched(), file).ok());
  file = units;
  file.units->found.emplace().ends = {{1, 2, 3, 4, 5, 6, 7}};
  EXPECT_FALSE(CheckByCases(Searched(), file).ok());
  SearchFile runs = Begin({.engine = EngineKind::kRandom, .runs = 8});
  runs.failing_case = 4;
  EXPECT_FALSE(CheckByCases(Searched(), runs).ok());
  runs.failing_case = 0;
  runs.samples.bad = 1;
  runs.samples.failing = {0, 1};
  EXPECT_FALSE(CheckByCases(Searched(), runs).ok());
  // A unit that is said to fail and does not.
  file = units;
  file.units->failing = 0;
  const auto found = ConcludeByCases(Searched(), {}, file);
  ASSERT_FALSE(found.ok());
  EXPECT_THAT(found.error().message.en, HasSubstr("the file says that unit 0 fails"));
}

}  // namespace
}  // namespace oncard::explore
