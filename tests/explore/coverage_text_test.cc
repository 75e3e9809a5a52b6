// What reports say of the statements that were executed (explore/reports/coverage_text.h).
#include "explore/reports/coverage_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

/// Another thread sets x to 1.
std::string BesideOne() {
  return NeverFive() +
         "int t1() {\n"
         "  x = 1;\n"
         "  return 0;\n"
         "}\n"
         "//@ final: x == 1\n";
}

TEST(CoverageTextTest, OfAProofLinesThatWereNotReachedCannotBe) {
  const auto lines = DescribeCoverage(FindingsOf(BesideOne(), {}));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].en,
            "t0: 3 of 4 lines reached, 1 of 2 ways of conditions; cannot be reached: 6; one way "
            "only: 5");
  EXPECT_EQ(lines[0].zh, "t0：到达 3/4 行，条件分支 1/2；不可到达的行：6；只走一个分支的行：5");
  EXPECT_EQ(lines[1].en, "t1: 2 of 2 lines reached, 0 of 0 ways of conditions");
}

TEST(CoverageTextTest, OfRunsThatAreCutTheTimeIsSaid) {
  Findings findings = FindingsOf(BesideOne(), {});
  findings.exploration.horizon.at_ms = 60;
  const Message line = DescribeCoverage(findings).front();
  EXPECT_THAT(line.en, HasSubstr("; cannot be reached in this time: 6;"));
  EXPECT_THAT(line.zh, HasSubstr("；在此时间内不可到达的行：6；"));
}

TEST(CoverageTextTest, OfOtherVerdictsItIsNotSaid) {
  const Findings tried = FindingsOf(BesideOne(), {.engine = EngineKind::kRandom, .runs = 100});
  ASSERT_EQ(tried.exploration.verdict, Verdict::kPassed);
  EXPECT_THAT(DescribeCoverage(tried)[0].en, HasSubstr("; not noted as reached: 6;"));
}

TEST(CoverageTextTest, ASearchThatNotesNothingSaysSo) {
  Findings findings = FindingsOf(BesideOne(), {});
  findings.exploration.coverage = {};
  const auto lines = DescribeCoverage(findings);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].en, "not noted by this search");
  EXPECT_FALSE(nlohmann::json::parse(JsonReport(findings)).contains("coverage"));
}

TEST(CoverageTextTest, LinesOfTheSourceAreMarked) {
  using enum LineMark;
  Findings findings = FindingsOf(BesideOne(), {});
  EXPECT_TRUE(MarksOf(findings).empty());
  findings.source = {BesideOne()};
  EXPECT_THAT(MarksOf(findings),
              testing::ElementsAre(kNone, kNone, kNone, kReached, kOneWay, kMissed, kNone, kReached,
                                   kNone, kNone, kReached, kReached, kNone, kNone, kNone));
  // The lines of the functions are those of another file.
  findings.source.file = "other.c";
  for (const LineMark mark : MarksOf(findings)) EXPECT_EQ(mark, kNone);
}

TEST(CoverageTextTest, ThePageAndTheJsonHaveIt) {
  const Findings findings = FindingsOf(BesideOne(), {});
  EXPECT_THAT(HtmlReport(findings, Language::kEnglish), HasSubstr("<li>t0: 3 of 4 lines reached"));
  const auto json = nlohmann::json::parse(JsonReport(findings))["coverage"];
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["function"], "t0");
  EXPECT_EQ(json[0]["lines"], 4);
  EXPECT_EQ(json[0]["lines_reached"], 3);
  EXPECT_EQ(json[0]["ways"], 2);
  EXPECT_EQ(json[0]["ways_gone"], 1);
  EXPECT_EQ(json[0]["not_reached"], nlohmann::json({6}));
  EXPECT_EQ(json[0]["one_way"], nlohmann::json({5}));
}

}  // namespace
}  // namespace oncard::explore
