// What the report says of an incomplete search (explore/reports/way_out.h).
#include "explore/reports/way_out.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "explore/reports/report.h"
#include "explore/scenario_exploration.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Thread 0 polls in line 4, thread 1 waits.
constexpr const char* kPolling =
    "int go, n;\n"
    "int t0() {\n"
    "L:\n"
    "  if (go) goto M;\n"
    "  goto L;\n"
    "M:\n"
    "  n = 1;\n"
    "}\n"
    "int t1() {\n"
    "  GT_Delay(20);\n"
    "  go = 1;\n"
    "}\n";

std::vector<std::string> EnglishOf(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(message.en);
  return texts;
}

// In the first cycle thread 1 executes its statement before, between or after 24 of thread 0, which
// are 49 states: the 60th is in the second cycle, at 0.5 ms.
TEST(WayOutTest, OfACardSaysHowFarItCameAndWhy) {
  const Findings findings =
      FindingsOf(kPolling, "never = [\"n == 2\", \"n == 1 && go == 0\"]\nfinal = [\"n == 1\"]\n",
                 {.engine = EngineKind::kStateful, .state_limit = 60});
  ASSERT_EQ(findings.exploration.verdict, Verdict::kIncomplete);
  const WayOut& way = findings.way_out;
  EXPECT_THAT(
      EnglishOf(way.reached),
      ElementsAre(HasSubstr("every schedule up to 0.5 ms; the next state: thread 0 at "
                            "program.c:"),
                  "held so far: never: n == 2", "no run came to where 'final: n == 1' is checked",
                  HasSubstr("'never: n == 1 && go == 0'")));
  EXPECT_THAT(EnglishOf(way.spent),
              ElementsAre("thread 0 polls at program.c:4: with GT_Delay(1) in its loop there are "
                          "far fewer states"));
  EXPECT_THAT(EnglishOf(way.next),
              ElementsAre("oncard explore test.toml --max-states=240",
                          "oncard explore test.toml --engine=stateful --shard 1/8 and so on up to "
                          "8/8, then --merge",
                          "oncard explore test.toml --engine=bounded",
                          "oncard explore test.toml --engine=pos --runs=100000",
                          "until_ms = 0.25 in the scenario"));
}

TEST(WayOutTest, SaysWhyEachStepIsExecuted) {
  const auto spent = [](const std::string& keys) {
    return EnglishOf(
        FindingsOf(kPolling, keys, {.engine = EngineKind::kStateful, .state_limit = 60})
            .way_out.spent);
  };
  const std::string slow = "each step is executed on the card, which is slow: ";
  EXPECT_THAT(spent("races = \"none\"\nsync = [\"go\"]\n"),
              Contains(slow + "races are looked for"));
  EXPECT_THAT(spent("always = [\"statements < 999\"]\n"),
              Contains(slow + "a condition counts statements"));
  EXPECT_THAT(spent(""), Not(Contains(HasSubstr(slow))));
  // Seen only in the search.
  LoadedScenario periodic = LoadedOf(kPolling, "until_ms = 9\n");
  periodic.scenario.threads[0].period_ms = 1;
  const auto findings = ExploreScenario(periodic.scenario, {}, periodic.object,
                                        {.engine = EngineKind::kStateful, .state_limit = 60});
  ASSERT_TRUE(findings.ok());
  EXPECT_THAT(EnglishOf(findings.value().way_out.spent),
              Contains(HasSubstr(slow + "a thread starts again and again, or a command")));
}

TEST(WayOutTest, OfASearchWithReductionsOffersMoreStates) {
  const Findings findings = FindingsOf(kPolling, "final = [\"n == 1\"]\n", {.state_limit = 60});
  ASSERT_EQ(findings.exploration.verdict, Verdict::kIncomplete);
  ASSERT_TRUE(findings.exploration.reduced);
  EXPECT_EQ(findings.way_out.next[0].en, "oncard explore test.toml --max-states=240");
}

/// The first case has few states; in the others thread 0 polls.
TEST(WayOutTest, OfCasesIsThatOfTheOneThatEndedTheSearch) {
  std::string source = kPolling;
  source.replace(source.find("go = 1"), 6, "go = go");
  const Findings findings =
      FindingsOf(source, "until_ms = 5\n[globals]\ngo = { any = [-1, 6] }\n",
                 {.engine = EngineKind::kStateful, .state_limit = 400, .all = true});
  ASSERT_EQ(findings.exploration.verdict, Verdict::kIncomplete);
  ASSERT_EQ(findings.cases->searched, 2);
  const std::vector<std::string> reached = EnglishOf(findings.way_out.reached);
  ASSERT_GE(reached.size(), 2u);
  EXPECT_EQ(reached[0], "in the case go = 0:");
  EXPECT_THAT(reached[1], HasSubstr("every schedule up to"));
  // The limit of all cases, and their choices are enough to be divided.
  EXPECT_EQ(findings.way_out.next[0].en, "oncard explore test.toml --max-states=1600");
  EXPECT_EQ(findings.way_out.next[1].en,
            "oncard explore test.toml --shard 1/8 and so on up to 8/8, then --merge");
}

TEST(WayOutTest, TheInstantThatIsOfferedIsReached) {
  const ExploreOptions options = {.engine = EngineKind::kStateful, .state_limit = 60};
  EXPECT_EQ(FindingsOf(kPolling, "until_ms = 0.25\n", options).exploration.verdict,
            Verdict::kPassed);
}

TEST(WayOutTest, ALoopThatWaitsIsNotNamed) {
  std::string waiting = kPolling;
  waiting.replace(waiting.find("  goto L;"), 9, "  GT_Delay(1); goto L;");
  const Findings findings =
      FindingsOf(waiting, "", {.engine = EngineKind::kStateful, .state_limit = 5});
  ASSERT_EQ(findings.exploration.verdict, Verdict::kIncomplete);
  EXPECT_THAT(findings.way_out.spent, IsEmpty());
}

TEST(WayOutTest, OfAProgramNamesItsLoops) {
  const std::string counting =
      "int n, m;\n//@ never: n == 9999 && m == 1\n//@ never: m == 9\n"
      "int t0() {\nL:\n  n = n + 1;\n  goto L;\n}\n";
  const Findings findings = FindingsOf(
      counting, {.engine = EngineKind::kStateful, .state_limit = 100, .merge_private = false});
  ASSERT_EQ(findings.exploration.verdict, Verdict::kIncomplete);
  EXPECT_THAT(EnglishOf(findings.way_out.reached),
              ElementsAre("held so far: never: m == 9", HasSubstr("n == 9999 && m == 1")));
  EXPECT_THAT(EnglishOf(findings.way_out.spent),
              ElementsAre("thread 0 repeats the loop at program.c:6"));
  EXPECT_THAT(EnglishOf(findings.way_out.next),
              ElementsAre("oncard explore program.c --engine=stateful --merge-private",
                          "oncard explore program.c --max-states=400",
                          "oncard explore program.c --engine=bounded",
                          "oncard explore program.c --engine=pos --runs=100000"));
}

TEST(WayOutTest, IsInEveryReportOfAnIncompleteSearchAlone) {
  const ExploreOptions options = {.engine = EngineKind::kStateful, .state_limit = 60};
  const Findings findings = FindingsOf(kPolling, "", options);
  EXPECT_THAT(TextReport(findings, Language::kEnglish), HasSubstr("\nspent on   thread 0 polls"));
  EXPECT_THAT(TextReport(findings, Language::kChinese), HasSubstr("线程 0 在 program.c:4 处轮询"));
  EXPECT_THAT(HtmlReport(findings, Language::kEnglish), HasSubstr("<h3>What to try</h3>"));
  const auto json = nlohmann::json::parse(JsonReport(findings));
  EXPECT_EQ(json["try"].size(), 5u);
  EXPECT_EQ(JsonReport(FindingsOf(kPolling, "", options)), JsonReport(findings));
  const Findings proved = FindingsOf(Increments(2, 1) + "//@ never: x == 3\n", {.all = true});
  EXPECT_FALSE(nlohmann::json::parse(JsonReport(proved)).contains("try"));
}

}  // namespace
}  // namespace oncard::explore
