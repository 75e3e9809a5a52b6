// The page of an exploration as a document: its sections and what they say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "explore/reports/report.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// What a reader sees of a page, a line for each heading, paragraph, item and row. Hashes, counts
/// of states and versions are left out.
std::string Shown(const std::string& page) {
  std::string text = page.substr(page.find("<body>"));
  const std::pair<const char*, const char*> marks[] = {
      {"\n", "\n"},
      {"<h1>", "# "},
      {"<h2>", "\n## "},
      {"<h3>", "### "},
      {"<li>", "- "},
      {"</t[hd]><t[hd][^>]*>", " | "},
      {"</strong>", ": "},
      {"<[^>]*>", ""},
      {"&lt;", "<"},
      {"&gt;", ">"},
      {"&quot;", "\""},
      {"&amp;", "&"},
      {"\n\n+", "\n"},
      {"[0-9a-f]{16}", "H"},
      {"[0-9]+ states, [0-9]+ tr", "N states, N tr"},
      {"oncard [0-9.]+,", "oncard V,"},
      {"\n##", "\n\n##"}};
  for (const auto& [from, to] : marks) text = std::regex_replace(text, std::regex(from), to);
  return text;
}

std::vector<std::string> HeadingsOf(const std::string& page) {
  std::vector<std::string> headings;
  const std::regex heading("<h2>([^<]*)</h2>");
  for (std::sregex_iterator i(page.begin(), page.end(), heading), end; i != end; ++i) {
    headings.push_back((*i)[1]);
  }
  return headings;
}

Findings Proved() {
  // x is 9 in no state.
  const std::string source = NeverFive() + "//@ final: x == 0\n//@ never: x == 9 && x == 8\n";
  Findings findings = FindingsOf(source, {.engine = EngineKind::kStateful, .merge_private = false});
  findings.source = {source};
  findings.repetition.command = "oncard explore program.c --engine=stateful";
  return findings;
}

TEST(HtmlReport, AProofIsADocument) {
  EXPECT_EQ(
      Shown(HtmlReport(Proved(), Language::kEnglish)),
      "\noncard explore: report of a search for schedules that fail\n"
      "# program.c\n"
      "PROVED: no schedule fails, under the assumptions and within the bounds of this report\n"
      "\n"
      "## Question\n"
      "must hold | as written | result\n"
      "at the end of every run x == 0 holds | final: x == 0 | holds\n"
      "x == 9 && x == 8 holds in no state | never: x == 9 && x == 8 | holds\n"
      "Also asked:\n"
      "- no thread fault, no deadlock, no livelock\n"
      "Not asked: data races\n"
      "\n"
      "## Assumptions\n"
      "- any thread may execute the next statement; no time passes\n"
      "- stateful: a state that is reached again is not searched again; states are told apart by "
      "keys of 128 bits\n"
      "\n"
      "## Bounds\n"
      "- none: every schedule was searched\n"
      "- stateful: N states, N transitions, 0 bad, 1 different ends\n"
      "\n"
      "## Coverage\n"
      "- t0: 3 of 4 lines reached, 1 of 2 ways of conditions; cannot be reached: 6; one way only: "
      "5\n"
      "● reached, ◐ reached and a condition went one way only, ○ not reached\n"
      "1 |  | int x;\n"
      "2 |  | int t0() {\n"
      "3 |  |   int c;\n"
      "4 | ● |   c = x != 5;\n"
      "5 | ◐ |   if (c) goto E;\n"
      "6 | ○ |   x = 7;\n"
      "7 |  | E:\n"
      "8 | ● |   return 0;\n"
      "9 |  | }\n"
      "10 |  | //@ final: x == 0\n"
      "11 |  | //@ never: x == 9 && x == 8\n"
      "\n"
      "## Not put to the test\n"
      "- 'never: x == 9 && x == 8' was met by its left side alone: 'x == 9' never held\n"
      "\n"
      "## What was searched\n"
      "- program.c, object H\n"
      "- threads 0 t0\n"
      "- oncard V, engine stateful\n"
      "\n"
      "## How to repeat it\n"
      "oncard explore program.c --engine=stateful\n");
}

TEST(HtmlReport, SaysTheSameInChinese) {
  const std::string page = HtmlReport(Proved(), Language::kChinese);
  EXPECT_THAT(page, HasSubstr("<html lang=\"zh\">"));
  EXPECT_THAT(HeadingsOf(page), ElementsAre("要求", "前提", "范围", "覆盖", "未经检验的内容",
                                            "搜索对象", "如何重复"));
  EXPECT_THAT(Shown(page), HasSubstr("\n每次运行结束时 x == 0 成立 | final: x == 0 | 成立\n"));
}

TEST(HtmlReport, AFailureComesAfterTheQuestionWithItsTableAndItsSchedule) {
  const std::string source = Increments(2, 1);
  Findings findings = FindingsOf(source, {.engine = EngineKind::kStateful});
  findings.source = {source};
  findings.repetition = {"oncard explore program.c", "oncard-schedule 1\nrun 0 1 <\n", {}};
  const std::string page = HtmlReport(findings, Language::kEnglish);
  EXPECT_THAT(HeadingsOf(page),
              ElementsAre("Question", "Failure", "Assumptions", "Bounds", "Coverage",
                          "Not put to the test", "What was searched", "How to repeat it"));
  const std::string text = Shown(page);
  EXPECT_THAT(text, HasSubstr("\nFAILED: final: x == 2 does not hold: x is 1, expected 2\n"));
  EXPECT_THAT(text, HasSubstr(" | final: x == 2 | violated\n"));
  EXPECT_THAT(text, HasSubstr(" |  | thread 0 t0 | thread 1 t1\n"
                              "1 | 5 | t = x;   [x = 0]   t: 0 -> 0\n"
                              "2 | 12 |  | t = x;   [x = 0]   t: 0 -> 0\n"
                              "4 | 14 |  | x = t;   x: 0 -> 1\n"
                              "7 | 7 | x = t;   x: 1 -> 1\n"
                              "From the red line on, every continuation fails.\n"));
  EXPECT_THAT(text, HasSubstr("\n## Not put to the test\n"
                              "- not said of a search that a failure has ended\n"));
  EXPECT_THAT(text, HasSubstr("\noncard explore program.c\n"
                              "The failing run alone, with this text in program.schedule:\n"
                              "oncard replay program.schedule\n"
                              "oncard-schedule 1\nrun 0 1 <\n"));
}

TEST(HtmlReport, ALongScheduleIsLeftToItsFile) {
  Findings findings = FindingsOf(Increments(2, 1), {});
  findings.repetition.command = "oncard explore program.c";
  for (int i = 0; i < 500; ++i) findings.repetition.schedule += "run 0 1\n";
  const std::string text = Shown(HtmlReport(findings, Language::kEnglish));
  EXPECT_THAT(text, HasSubstr("The failing run alone; program.schedule has 500 lines:\n"
                              "oncard explore program.c --save program.schedule\n"
                              "oncard replay program.schedule\n"));
  EXPECT_THAT(text, Not(HasSubstr("run 0 1")));
}

/// The result that the page gives of a requirement that always holds.
std::string ResultOf(const std::string& program, const ExploreOptions& options) {
  const std::string title = "always: x < 9";
  const Findings findings = FindingsOf("//@ " + title + "\n" + program, options);
  const std::string text = Shown(HtmlReport(findings, Language::kEnglish));
  const size_t at = text.find(title + " | ") + title.size() + 3;
  return text.substr(at, text.find('\n', at) - at);
}

TEST(HtmlReport, NoResultIsSurerThanTheVerdict) {
  EXPECT_EQ(ResultOf(Increments(1, 2), {}), "holds");
  // Another requirement fails.
  EXPECT_EQ(ResultOf(Increments(2, 2), {}), "not decided");
  EXPECT_EQ(ResultOf(Increments(1, 2), {.engine = EngineKind::kRandom, .runs = 5}),
            "no violation was found");
  EXPECT_EQ(ResultOf(Increments(1, 2),
                     {.engine = EngineKind::kStateful, .state_limit = 3, .merge_private = false}),
            "not decided");
}

TEST(HtmlReport, WhatWasTestedIsSaidOnlyWhereItIsKnown) {
  const auto untested = [](const Findings& findings) {
    const std::string text = Shown(HtmlReport(findings, Language::kEnglish));
    const std::string head = "## Not put to the test\n- ";
    const size_t at = text.find(head) + head.size();
    return text.substr(at, text.find('\n', at) - at);
  };
  Findings all = FindingsOf("//@ always: x < 9\n" + Increments(1, 2), {});
  EXPECT_THAT(untested(all), testing::StartsWith("nothing: "));
  all.knows_untested = false;
  EXPECT_EQ(untested(all), "not noted by this search");
}

TEST(HtmlReport, SearchFilesHaveTheirHashes) {
  Findings findings = Proved();
  findings.repetition.searches = {"a.search, 00000000000000ab"};
  EXPECT_THAT(HtmlReport(findings, Language::kEnglish),
              HasSubstr("<li>search file a.search, 00000000000000ab</li>"));
}

}  // namespace
}  // namespace oncard::explore
