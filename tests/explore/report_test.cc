// Reports for users and for programs (explore/reports/report.h).
#include "explore/reports/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "explore/reports/claim.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Findings FindingsWith(const Problem& problem, const Exploration& exploration,
                      const std::string& source = {}) {
  Findings findings = {SubjectOf(problem), exploration, {}, {source}};
  if (exploration.failure) findings.trail = Follow(problem, *exploration.failure);
  return findings;
}

/// Threads that each write another value to x.
std::string Writers(int threads) {
  std::string source = "int x;\n";
  for (int i = 1; i <= threads; ++i) {
    source += "int t" + std::to_string(i - 1) + "() {\n  x = " + std::to_string(i) +
              ";\n  return 0;\n}\n";
  }
  return source;
}

TEST(ReportTest, AFailureIsATableOfThreads) {
  const std::string source = Increments(2, 1);
  const Problem problem = ProblemOf(source);
  const auto exploration = Explore(problem, {.engine = EngineKind::kStateful});
  EXPECT_EQ(
      TextReport(FindingsWith(problem, exploration.value(), source), Language::kEnglish),
      "FAILED\n" + ClaimText(FindingsWith(problem, exploration.value()), Language::kEnglish) +
          "stateful: 41 states, 60 transitions, 1 bad, 2 different ends\n"
          "\n"
          "final: x == 2 does not hold: x is 1, expected 2\n"
          "thread 0 wrote x = 1 over thread 1's 1 at step 7, because it had read x = 0 at step 1, "
          "before thread 1 wrote it at step 4\n"
          "statements: 8, preemptions: 1; no schedule with fewer preemptions fails\n"
          "racing pair: thread 1 reads x in line 12, thread 0 writes it in line 7\n"
          "\n"
          "        thread 0 t0                         thread 1 t1\n"
          "     1     5  t = x;   [x = 0]   t: 0 -> 0\n"
          "     2                                        12  t = x;   [x = 0]   t: 0 -> 0   <- "
          "from here on every continuation fails\n"
          "     4                                        14  x = t;   x: 0 -> 1\n"
          "     7     7  x = t;   x: 1 -> 1\n"
          "statements that touch nothing shared are left out: 4 (--full shows them)\n");
}

TEST(ReportTest, AFullOneShowsEveryStatement) {
  const std::string source = Increments(2, 1);
  const Problem problem = ProblemOf(source);
  const auto exploration = Explore(problem, {.engine = EngineKind::kStateful});
  const std::string text = TextReport(FindingsWith(problem, exploration.value(), source),
                                      Language::kEnglish, {.full = true});
  EXPECT_THAT(text, HasSubstr("     6     6  t = t + 1;   [t = 0]   t: 0 -> 1\n"));
  EXPECT_THAT(text, Not(HasSubstr("left out")));
}

// Only the text says that executions were counted: the numbers are the same.
TEST(ReportTest, CountedExecutionsAreNotCalledExecuted) {
  const Findings findings = FindingsOf(Writers(8), ExploreOptions{.state_limit = 10});
  EXPECT_THAT(TextReport(findings, Language::kEnglish),
              HasSubstr("\ndpor: 40320 executions, counted without executing each; 0 bad, 8 "
                        "different ends\n"));
  EXPECT_THAT(TextReport(findings, Language::kChinese),
              HasSubstr("\ndpor：40320 次执行（由计数得出，并未逐一执行），错误 0，不同结局 8\n"));
  auto json = nlohmann::json::parse(JsonReport(findings));
  const Findings executed = FindingsOf(Writers(8), ExploreOptions{.engine = EngineKind::kDpor});
  const auto of_executed = nlohmann::json::parse(JsonReport(executed));
  for (const auto& [key, value] : of_executed.items()) EXPECT_EQ(json[key], value) << key;
}

TEST(ReportTest, JsonHasTheCounts) {
  const Problem problem = ProblemOf(Increments(2, 1));
  const auto exploration = Explore(problem, {});
  const auto json = nlohmann::json::parse(JsonReport(FindingsWith(problem, exploration.value())));
  EXPECT_EQ(json["verdict"], "FAILED");
  EXPECT_EQ(json["executions"], 4);
  EXPECT_EQ(json["blocked"], 0);
  EXPECT_EQ(json["redundant"], 0);
  EXPECT_EQ(json["traces"], 4);
  EXPECT_EQ(json["bad_traces"], 2);
  EXPECT_EQ(json["states"], 41);
  EXPECT_EQ(json["transitions"], 60);
  EXPECT_EQ(json["bad_states"], 1);
  EXPECT_EQ(json["final_globals"], 2);
  EXPECT_EQ(json["final_full"], 2);
  EXPECT_EQ(json["finals_pb0"], 1);
  EXPECT_EQ(json["finals_pb1"], 2);
  EXPECT_EQ(json["min_preemptions_to_bad"], 1);
  EXPECT_EQ(json["min_steps_to_bad"], 8);
  EXPECT_EQ(json["schedule"].size(), 3u);
  EXPECT_EQ(json["actual"], "x is 1, expected 2");
  EXPECT_THAT(json["culprit"].get<std::string>(), HasSubstr("because it had read x = 0"));
}

// Of the two engines of `auto` either may be the first to answer: a limit of the other one makes
// it.
TEST(ReportTest, APageDoesNotShowWhichEngineAnswered) {
  for (const char* requirement : {"//@ final: x >= 2\n", ""}) {
    std::string source = Increments(3, 2);
    source = requirement + source.substr(0, source.find("//@")) +
             source.substr(source.find('\n', source.find("//@")) + 1);
    const Findings both = FindingsOf(source, {});
    ASSERT_EQ(both.exploration.verdict, Verdict::kProved);
    const Findings traces = FindingsOf(source, {.state_limit = 10});
    ASSERT_EQ(traces.exploration.engine, EngineKind::kDpor);
    const Findings states = FindingsOf(source, {.execution_limit = 10});
    ASSERT_EQ(states.exploration.engine, EngineKind::kStateful);
    const std::string page = HtmlReport(both, Language::kEnglish);
    EXPECT_EQ(HtmlReport(traces, Language::kEnglish), page);
    EXPECT_EQ(HtmlReport(states, Language::kEnglish), page);
  }
}

TEST(ReportTest, ThePageNeedsNothingElse) {
  const std::string source = Increments(2, 1);
  const Problem problem = ProblemOf(source);
  const auto exploration = Explore(problem, {.engine = EngineKind::kStateful});
  const Findings findings = FindingsWith(problem, exploration.value(), source);
  const std::string page = HtmlReport(findings, Language::kEnglish);
  EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, HasSubstr("<th>thread 0 t0</th><th>thread 1 t1</th>"));
  EXPECT_THAT(
      page,
      HasSubstr("<td class=\"number\">4</td><td class=\"line\">14</td><td></td>"
                "<td class=\"statement\">x = t;   <span class=\"written\">x: 0 -&gt; 1</span>"));
  EXPECT_THAT(HtmlReport(findings, Language::kChinese), HasSubstr("线程 0 t0"));
}

TEST(ReportTest, TraceEventsHaveABarPerStatement) {
  const std::string source = Increments(2, 1);
  const Problem problem = ProblemOf(source);
  const auto exploration = Explore(problem, {.engine = EngineKind::kStateful});
  const auto json =
      nlohmann::json::parse(ChromeReport(FindingsWith(problem, exploration.value(), source)));
  const auto& events = json["traceEvents"];
  ASSERT_EQ(events.size(), 2u + 8u);
  EXPECT_EQ(events[0]["args"]["name"], "thread 0 t0");
  EXPECT_EQ(events[5]["name"], "x = t;");
  EXPECT_EQ(events[5]["tid"], 1);
  EXPECT_EQ(events[5]["ts"], 3);
  EXPECT_EQ(events[5]["args"]["written"]["x"], (nlohmann::json{"0", "1"}));
}

TEST(ReportTest, TheScheduleJoinsStepsOfAThread) {
  const Problem problem = ProblemOf(Increments(2, 1));
  Failure failure;
  failure.steps = {0, 1, 1, 0};
  const vm::Schedule schedule = ScheduleOf(SubjectOf(problem), failure);
  EXPECT_EQ(schedule.segments, (std::vector<vm::ScheduleSegment>{{0, 1}, {1, 2}, {0, 1}}));
  EXPECT_EQ(schedule.program_hash, problem.model.image().hash);
}

}  // namespace
}  // namespace oncard::explore
