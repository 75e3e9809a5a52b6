// A verdict on a card's runs is no surer than how far they were followed
// (explore/models/horizon.h).
#include "explore/models/horizon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

constexpr const char* kJogging =
    "int n;\nint t0() { GT_AxisOn(1); GT_PrfJog(1); GT_SetVel(1, 10); GT_Update(1); return 0; }\n";
/// A move of 40 pulses at up to 10 pulses per ms and 1 pulse per ms2: it ends before 20 ms.
constexpr const char* kMove =
    "int n;\nint t0() { TTrapPrm trap; GT_AxisOn(1); GT_PrfTrap(1); GT_GetTrapPrm(1, &trap);"
    " trap.acc = 1; trap.dec = 1; GT_SetTrapPrm(1, &trap); GT_SetVel(1, 10); GT_SetPos(1, 40);"
    " GT_Update(1); return 0; }\n";
constexpr const char* kEndless = "int n;\nint t0() { return 0; }\nint t1() { L: n = 1; goto L; }\n";

struct HorizonCase {
  const char* name;
  const char* source;
  const char* keys;
  const char* why;  ///< empty: a proof
};

class HorizonTest : public ::testing::TestWithParam<HorizonCase> {};

TEST_P(HorizonTest, IsNamedWhereSomethingStillGoesOn) {
  const HorizonCase& c = GetParam();
  const Exploration found = FindingsOf(c.source, c.keys, {}).exploration;
  EXPECT_EQ(found.verdict, *c.why == 0 ? Verdict::kProved : Verdict::kPassed);
  EXPECT_EQ(found.why.en, c.why);
}

INSTANTIATE_TEST_SUITE_P(
    Verdicts, HorizonTest,
    ::testing::Values(
        HorizonCase{"AnAxisMovesAtUntil", kJogging,
                    "until_ms = 30\nalways = [\"axis1.prfPos < 5000\"]",
                    "no failure up to 30 ms: axis 1 still moves"},
        HorizonCase{"WhateverIsRequired", kJogging, "until_ms = 30\nfinal = [\"n == 0\"]",
                    "no failure up to 30 ms: axis 1 still moves"},
        HorizonCase{"AnAxisHasCome", kMove, "until_ms = 30\nalways = [\"axis1.prfPos < 5000\"]",
                    ""},
        HorizonCase{"AThreadRunsAtUntil", kEndless, "until_ms = 1\nrate = 8",
                    "no failure up to 1 ms: thread 1 still runs"},
        HorizonCase{"AThreadWaitsAtUntil", "int t0() { GT_Delay(50); return 0; }\n", "until_ms = 1",
                    "no failure up to 1 ms: thread 0 still runs"},
        HorizonCase{"BothAtUntil",
                    "int t0() { GT_PrfJog(2); GT_SetVel(2, 10); GT_Update(2); GT_Delay(50);"
                    " return 0; }\n",
                    "until_ms = 2",
                    "no failure up to 2 ms: axis 2 still moves, thread 0 still runs"},
        HorizonCase{"AllCardStatesWithoutUntil", kJogging, "always = [\"axis1.prfPos < 5000\"]",
                    "no failure up to the end of the threads: axis 1 still moves"},
        HorizonCase{"VariablesRestWithoutUntil", kJogging, "always = [\"n == 0\"]", ""},
        HorizonCase{"AnInstantWithoutUntil", kJogging, "expect = [\"axis1.moving == 1 @ 30ms\"]",
                    ""}),
    [](const auto& test) { return test.param.name; });

TEST(HorizonReport, SaysSoInEveryForm) {
  const Findings findings =
      FindingsOf(kJogging, "until_ms = 30\nalways = [\"axis1.prfPos < 5000\"]", {});
  EXPECT_THAT(TextReport(findings, Language::kEnglish),
              HasSubstr("PASSED\nno failure up to 30 ms: axis 1 still moves\n"));
  EXPECT_THAT(TextReport(findings, Language::kChinese),
              HasSubstr("PASSED\n未出错，到 30 ms 为止：轴 1 仍在运动\n"));
  EXPECT_THAT(HtmlReport(findings, Language::kEnglish),
              HasSubstr("</strong>no failure up to 30 ms: axis 1 still moves</p>"));
  const auto json = nlohmann::json::parse(JsonReport(findings));
  EXPECT_EQ(json["verdict"], "PASSED");
  EXPECT_EQ(json["why"], "no failure up to 30 ms: axis 1 still moves");
  EXPECT_EQ(json["horizon"]["ms"], 30);
  EXPECT_EQ(json["horizon"]["moving_axes"], nlohmann::json::array({1}));
  EXPECT_EQ(json["horizon"]["running_threads"], nlohmann::json::array());
}

TEST(HorizonReport, EnginesThatTrySomeSchedulesHaveOneToo) {
  const char* keys = "until_ms = 30\nalways = [\"axis1.prfPos < 5000\"]";
  EXPECT_EQ(FindingsOf(kJogging, keys, {.engine = EngineKind::kBounded, .preemption_limit = 1})
                .exploration.why.en,
            "no schedule with at most 1 preemptions fails; up to 30 ms: axis 1 still moves");
  EXPECT_EQ(
      FindingsOf(kJogging, keys, {.engine = EngineKind::kRandom, .runs = 3}).exploration.why.en,
      "none of 3 random schedules fails; others were not tried; up to 30 ms: axis 1 still moves");
}

// --- What was not put to the test ----------------------------------------------------------------

std::vector<std::string> UntestedOf(const Findings& findings) {
  std::vector<std::string> texts;
  for (const Message& text : findings.untested) texts.push_back(text.en);
  return texts;
}

TEST(UntestedTest, ALeftSideThatNeverHoldsIsSaidBesideAProof) {
  const std::string threads = "int t0() {\n  x = 1;\n}\nint t1() {\n  y = x;\n}\n";
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful}) {
    const auto untested = [&](const std::string& requirement) {
      return UntestedOf(
          FindingsOf("int x, y;\n//@ " + requirement + "\n" + threads, {.engine = engine}));
    };
    EXPECT_THAT(untested("never: x == 2 && y == 0"),
                testing::ElementsAre("'never: x == 2 && y == 0' was met by its left side alone: "
                                     "'x == 2' never held"));
    EXPECT_THAT(untested("final: !(x == 2) || y == 7"),
                testing::ElementsAre("'final: !(x == 2) || y == 7' was met by its left side alone: "
                                     "'!(x == 2)' always held"));
    EXPECT_THAT(untested("never: x == 1 && y == 2"), testing::IsEmpty());
    // A requirement that fails has been put to the test.
    EXPECT_THAT(untested("never: x == 2 && y == 0\n//@ final: y == 1"), testing::IsEmpty());
  }
}

TEST(UntestedTest, ACardAlsoTellsOfLateEvents) {
  const char* keys =
      "never = [\"axis1.moving == 1 && n == 1\", \"axis2.moving == 1 && n == 0\"]\nuntil_ms = 30\n"
      "[[world.input]]\nat_ms = 500\ntype = \"gpi\"\nindex = 1\nvalue = 1\n";
  const Findings findings = FindingsOf(kMove, keys, {});
  EXPECT_THAT(UntestedOf(findings),
              testing::ElementsAre(
                  "'never: axis2.moving == 1 && n == 0' was met by its left side alone: "
                  "'axis2.moving == 1' never held",
                  "no run lasts until [[world.input]] at 500 ms: the last one ends at 30 ms "
                  "('until_ms' makes it last longer)"));
  EXPECT_THAT(TextReport(findings, Language::kEnglish), HasSubstr("PROVED\nremark: 'never: axis2"));
  EXPECT_THAT(TextReport(findings, Language::kChinese), HasSubstr("PROVED\n注意：“never: axis2"));
  EXPECT_EQ(nlohmann::json::parse(JsonReport(findings))["untested"].size(), 2u);
  EXPECT_THAT(HtmlReport(findings, Language::kEnglish), HasSubstr("<li>no run lasts until"));
}

TEST(HorizonText, NamesSeveralAndSpeaksChinese) {
  const Message text = DescribeHorizon({500.0, 0b101, 0b1100});
  EXPECT_EQ(text.en, "up to 500 ms: axes 1, 3 still move, threads 2, 3 still run");
  EXPECT_EQ(text.zh, "到 500 ms 为止：轴 1, 3 仍在运动，线程 2, 3 仍在运行");
}

}  // namespace
}  // namespace oncard::explore
