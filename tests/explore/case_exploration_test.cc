// Every case of a scenario's choices (explore/case_exploration.h), beside the same cases as
// scenarios of their own.
#include "explore/case_exploration.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "explore/failure_files.h"
#include "explore/scenario_exploration.h"
#include "explore_programs.h"
#include "tests/compiler/memory_files.h"

namespace oncard::explore {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Json = nlohmann::json;

/// Two threads that add to g what is chosen; the sum is 2x under every schedule.
std::string Adders(const std::string& comments) {
  return "int g, x;\n" + comments +
         "int t0() {\n  g = g + x;\n  return 0;\n}\nint t1() {\n  g = g + x;\n  return 0;\n}\n";
}

/// A thread that waits 10 ms; an input comes meanwhile, and passes its filter.
constexpr const char* kWaiter =
    "int t0() {\n  GT_Delay(10);\n  return 0;\n}\nint t1() {\n  GT_Delay(9);\n  return 0;\n}\n";

std::string Arrives(const std::string& when) {
  return "[[world.input]]\nindex = 1\nvalue = 1\n" + when + '\n';
}

TEST(CaseExploration, EveryValueOfAnInputIsProved) {
  const Findings all = FindingsOf(Adders("//@ input: x = -1..2\n//@ final: g == 2 * x\n"),
                                  {.engine = EngineKind::kStateful, .symmetry = false});
  EXPECT_EQ(all.exploration.verdict, Verdict::kProved);
  ASSERT_TRUE(all.cases);
  EXPECT_EQ(all.cases->cases, 4);
  EXPECT_EQ(all.cases->searched, 4);
  int64_t states = 0;
  int64_t transitions = 0;
  for (int x = -1; x <= 2; ++x) {
    const Findings one =
        FindingsOf(Adders(fmt::format("//@ init: x={}\n//@ final: g == 0\n", x)),
                   {.engine = EngineKind::kStateful, .merge_private = true, .symmetry = false});
    states += one.exploration.states->states;
    transitions += one.exploration.states->transitions;
  }
  EXPECT_EQ(all.exploration.states->states, states);
  EXPECT_EQ(all.exploration.states->transitions, transitions);
}

TEST(CaseExploration, TheReportSaysWhatWasChosenFrom) {
  const Findings all = FindingsOf(Adders("//@ input: x = -1..2\n//@ final: g == 2 * x\n"), {});
  EXPECT_THAT(TextReport(all, Language::kEnglish),
              HasSubstr("cases      for every choice of: x in -1..2: 4 cases\n"
                        "           the counts are sums over the first 4 cases\n"
                        "           covered: 4 of 4 values of x, -1 to 2\n"));
  EXPECT_THAT(TextReport(all, Language::kChinese), HasSubstr("x 取 -1..2：共 4 种情形"));
  EXPECT_THAT(HtmlReport(all, Language::kEnglish), HasSubstr("auto: 4 cases"));
  const Json json = Json::parse(JsonReport(all));
  EXPECT_EQ(json["choices"], Json::parse(R"(["x in -1..2"])"));
  EXPECT_EQ(json["cases"], 4);
  EXPECT_EQ(json["cases_searched"], 4);
  EXPECT_EQ(json["covered"], Json::parse(R"([{"name": "x", "from": -1, "to": 2,
                                              "values": 4, "covered": 4}])"));
}

// The second case, with the instant 10.25 ms, is begun, and a limit ends it.
TEST(CaseExploration, AValueCountsAsCoveredWhenItsCaseWasSearchedToItsEnd) {
  const std::string keys = "final = [\"clock > 9\"]\n" + Arrives("between_ms = [10, 11]");
  const auto states =
      static_cast<uint32_t>(FindingsOf(kWaiter, "final = [\"clock > 9\"]\n" + Arrives("at_ms = 10"),
                                       {.engine = EngineKind::kStateful})
                                .exploration.states->states);
  const Findings some =
      FindingsOf(kWaiter, keys, {.engine = EngineKind::kStateful, .state_limit = states + 2});
  EXPECT_EQ(some.exploration.verdict, Verdict::kIncomplete);
  EXPECT_EQ(some.cases->searched, 2);
  EXPECT_EQ(Json::parse(JsonReport(some))["covered"],
            Json::parse(R"([{"name": "gpi[1]", "from_ms": 10.0, "to_ms": 11.0,
                             "values": 5, "covered": 1}])"));
}

TEST(CaseExploration, TheFirstFailureEndsItAndSaysItsChoice) {
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful, EngineKind::kBounded}) {
    const Findings all =
        FindingsOf(Adders("//@ input: x = 0..3\n//@ never: g == 4\n"), {.engine = engine});
    EXPECT_EQ(all.exploration.verdict, Verdict::kFailed);
    EXPECT_EQ(all.cases->searched, 3);
    EXPECT_EQ(all.cases->failing.en, "x = 2");
    EXPECT_THAT(TextReport(all, Language::kEnglish),
                HasSubstr("\nnever: g == 4 holds: g is 4\nchoice: x = 2\n"));
    EXPECT_EQ(Json::parse(JsonReport(all))["choice"], "x = 2");
    EXPECT_EQ(Json::parse(JsonReport(all))["cases_searched"], 3);
    EXPECT_EQ(all.cases->covered.front().covered, 3);
  }
}

TEST(CaseExploration, AllCasesAreSearchedWhereAllFailuresAreAskedFor) {
  const Findings all = FindingsOf(Adders("//@ input: x = 0..3\n//@ final: g < 4\n"),
                                  {.engine = EngineKind::kDpor, .all = true});
  EXPECT_EQ(all.exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(all.cases->searched, 4);
  EXPECT_EQ(all.cases->failing.en, "x = 2");
  // One trace for each of the two orders; those of x = 2 and x = 3 are bad. For x = 0, too, the
  // additions are conflicts.
  EXPECT_EQ(all.exploration.traces->executions, 8);
  EXPECT_EQ(all.exploration.traces->bad_traces, 4);
}

TEST(CaseExploration, AnEventAtAnyInstantIsTheSumOfAllInstants) {
  // Seen at the end of the filter, 0.75 ms after the last of 5 ms.
  const std::string never = "never = [\"gpi[1] == 1 && clock < 3\"]\n";
  const std::string eventually = "eventually = [\"gpi[1] == 1 && clock < 6\"]\n";
  const Findings all = FindingsOf(kWaiter, never + eventually + Arrives("between_ms = [3, 5]"),
                                  {.engine = EngineKind::kStateful});
  EXPECT_EQ(all.exploration.verdict, Verdict::kProved);
  EXPECT_EQ(all.cases->cases, 9);
  int64_t states = 0;
  for (int quarter = 12; quarter <= 20; ++quarter) {
    const Findings one =
        FindingsOf(kWaiter, never + eventually + Arrives(fmt::format("at_ms = {}", quarter / 4.0)),
                   {.engine = EngineKind::kStateful});
    EXPECT_EQ(one.exploration.verdict, Verdict::kProved);
    states += one.exploration.states->states;
  }
  EXPECT_EQ(all.exploration.states->states, states);
}

TEST(CaseExploration, OneInstantOfManyIsFound) {
  // Events from 4 ms on are seen too late.
  const std::string keys = "eventually = [\"gpi[1] == 1 && clock < 4.5\"]\n";
  int first_bad = -1;
  for (int quarter = 8; quarter <= 24 && first_bad < 0; ++quarter) {
    const Findings one =
        FindingsOf(kWaiter, keys + Arrives(fmt::format("at_ms = {}", quarter / 4.0)), {});
    if (one.exploration.failure) first_bad = quarter;
  }
  ASSERT_GT(first_bad, 8);
  const Findings all = FindingsOf(kWaiter, keys + Arrives("between_ms = [2, 6]"), {});
  EXPECT_EQ(all.exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(all.cases->failing.en, fmt::format("gpi[1] = 1 at {} ms", first_bad / 4.0));
  EXPECT_EQ(all.cases->searched, first_bad - 8 + 1);
}

TEST(CaseExploration, EitherLevelIsTried) {
  const std::string input = "[[world.input]]\nindex = 1\nvalue = \"any\"\nat_ms = 1\n";
  const Findings all = FindingsOf(kWaiter, "never = [\"gpi[1] == 1\"]\n" + input, {});
  EXPECT_EQ(all.exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(all.cases->failing.en, "gpi[1] = 1 at 1 ms");
}

TEST(CaseExploration, OneCaseUpToAHorizonIsNoProofOfAll) {
  // Up to 9.5 ms thread 0 still waits, whatever comes.
  const Findings all = FindingsOf(
      kWaiter, "until_ms = 9.5\nalways = [\"clock < 20\"]\n" + Arrives("between_ms = [3, 5]"), {});
  EXPECT_EQ(all.exploration.verdict, Verdict::kPassed);
  EXPECT_EQ(all.exploration.why.en, "no failure up to 9.5 ms: thread 0 still runs");
}

TEST(CaseExploration, LimitsAreForAllCasesTogether) {
  const std::string source = Adders("//@ input: x = 0..3\n//@ final: g == 2 * x\n");
  const int64_t whole =
      FindingsOf(source, {.engine = EngineKind::kStateful}).exploration.states->states;
  ExploreOptions options = {.engine = EngineKind::kStateful,
                            .state_limit = static_cast<uint32_t>(whole / 2 + 1)};
  const Findings half = FindingsOf(source, options);
  EXPECT_EQ(half.exploration.verdict, Verdict::kIncomplete);
  EXPECT_EQ(half.cases->searched, 3);
  EXPECT_LE(half.exploration.states->states, whole / 2 + 1);
  EXPECT_THAT(half.exploration.why.en, HasSubstr("; 3 of 4 cases were begun"));
}

TEST(CaseExploration, AStoppedSearchSaysSo) {
  SearchProgress progress;
  progress.stop = true;
  ExploreOptions options;
  options.progress = &progress;
  const Findings none = FindingsOf(Adders("//@ input: x = 0..3\n//@ final: g == 2 * x\n"), options);
  EXPECT_EQ(none.exploration.verdict, Verdict::kIncomplete);
  EXPECT_EQ(none.exploration.why.en, "it was interrupted; 1 of 4 cases were begun");
}

TEST(CaseExploration, RandomRunsAreDividedAmongTheCases) {
  const std::string source = Adders("//@ input: x = 0..3\n//@ final: g == 2 * x\n");
  const Findings all = FindingsOf(source, {.engine = EngineKind::kRandom, .runs = 10});
  EXPECT_EQ(all.exploration.verdict, Verdict::kPassed);
  EXPECT_EQ(all.exploration.samples->runs, 10);
  EXPECT_EQ(all.exploration.why.en, "none of 10 random schedules fails; others were not tried");
}

/// A source with comments, read as for a search.
struct Asked {
  CommentProblem problem;
  vm::Object object;
};

Asked AskedIn(const std::string& source) {
  auto compilation = compiler::CompileText("program.c", source, {}, compiler::NoFiles());
  return {ReadComments("program.c", source, *compilation.object).value(), *compilation.object};
}

TEST(CaseExploration, FewerRandomRunsThanCasesAreRefused) {
  const Asked asked = AskedIn(Adders("//@ input: x = 0..3\n//@ final: g == 2 * x\n"));
  const auto found = ExploreScenario(asked.problem.scenario, asked.problem.requirements,
                                     asked.object, {.engine = EngineKind::kPos, .runs = 3});
  ASSERT_FALSE(found.ok());
  EXPECT_THAT(found.error().message.en, HasSubstr("3 random runs are not enough for 4 cases"));
}

TEST(CaseExploration, TheLargestValueMustFitBeforeTheFirstIsSearched) {
  const Asked asked = AskedIn(Adders("//@ input: x = 0..2147483648\n"));
  const auto large = ExploreScenario(asked.problem.scenario, {}, asked.object, {});
  ASSERT_FALSE(large.ok());
  EXPECT_THAT(large.error().message.en, HasSubstr("2147483649 cases"));
  const Asked far = AskedIn(Adders("//@ input: x = 2147483640..2147483648\n"));
  const auto unfit = ExploreScenario(far.problem.scenario, {}, far.object, {});
  ASSERT_FALSE(unfit.ok());
  EXPECT_THAT(unfit.error().message.en, HasSubstr("program.c:2:12: 2147483648 does not fit 'x'"));
}

TEST(CaseExploration, AnInputThatIsAlsoInitialisedIsRefused) {
  for (const char* comments :
       {"//@ input: x = 0..3\n//@ init: x=1\n", "//@ init: x=1\n//@ input: x = 0..3\n",
        "//@ input: x = 0..3, x = 1..2\n"}) {
    const Asked asked = AskedIn(Adders(comments));
    const auto found = ExploreScenario(asked.problem.scenario, {}, asked.object, {});
    ASSERT_FALSE(found.ok()) << comments;
    EXPECT_THAT(found.error().message.en, HasSubstr("'x' has a choice, and another value too"));
  }
}

TEST(CaseExploration, AFailureIsSavedWithItsChoice) {
  const std::string source = Adders("//@ input: x = 0..3\n//@ never: g == 4\n");
  const Asked asked = AskedIn(source);
  const runtime::Scenario& scenario = asked.problem.scenario;
  const auto found = ExploreScenario(scenario, asked.problem.requirements, asked.object, {});
  ASSERT_TRUE(found.ok());
  const Explored explored = {scenario, asked.problem.requirements, asked.object, source};
  const auto schedule = FailureSchedule(explored, found.value(), "s.schedule");
  ASSERT_TRUE(schedule.ok()) << schedule.error().message.en;
  EXPECT_THAT(schedule.value(), HasSubstr("\"x\" = 2"));
  const auto regression = RegressionScenario(explored, found.value(), "s.toml", "s.schedule");
  ASSERT_TRUE(regression.ok());
  EXPECT_THAT(regression.value(), HasSubstr("\"x\" = 2"));
}

TEST(CaseExploration, AScheduleIsFollowedInOneCaseOnly) {
  const Asked asked = AskedIn(Adders("//@ input: x = 0..3\n"));
  const auto found = FollowSchedule(asked.problem.scenario, {}, asked.object, "", {});
  ASSERT_FALSE(found.ok());
  EXPECT_THAT(found.error().message.en, HasSubstr("leaves choices open"));
}

TEST(CaseExploration, ARemarkNeedsAllCases) {
  // Where x is 1 the right side matters.
  const Findings some =
      FindingsOf(Adders("//@ input: x = 0..1\n//@ never: g == 2 && x == 5\n"), {});
  EXPECT_THAT(some.untested, testing::IsEmpty());
  const Findings none =
      FindingsOf(Adders("//@ input: x = 0..1\n//@ never: g == 7 && x == 5\n"), {});
  EXPECT_EQ(none.untested.size(), 1u);
  // Each case says it of another instant.
  const Findings late =
      FindingsOf(kWaiter, "final = [\"clock > 9\"]\n" + Arrives("between_ms = [500, 501]"), {});
  ASSERT_EQ(late.untested.size(), 1u);
  EXPECT_THAT(late.untested[0].en, HasSubstr("[[world.input]] at 500 ms"));
}

}  // namespace
}  // namespace oncard::explore
