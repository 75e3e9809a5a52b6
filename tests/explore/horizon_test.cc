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

constexpr const char* kJog =
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
        HorizonCase{"AnAxisMovesAtUntil", kJog, "until_ms = 30\nalways = [\"axis1.prfPos < 5000\"]",
                    "no failure up to 30 ms: axis 1 still moves"},
        HorizonCase{"WhateverIsRequired", kJog, "until_ms = 30\nfinal = [\"n == 0\"]",
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
        HorizonCase{"AllCardStatesWithoutUntil", kJog, "always = [\"axis1.prfPos < 5000\"]",
                    "no failure up to the end of the threads: axis 1 still moves"},
        HorizonCase{"VariablesRestWithoutUntil", kJog, "always = [\"n == 0\"]", ""},
        HorizonCase{"AnInstantWithoutUntil", kJog, "expect = [\"axis1.moving == 1 @ 30ms\"]", ""}),
    [](const auto& test) { return test.param.name; });

TEST(HorizonReport, SaysSoInEveryForm) {
  const Findings findings =
      FindingsOf(kJog, "until_ms = 30\nalways = [\"axis1.prfPos < 5000\"]", {});
  EXPECT_THAT(TextReport(findings, Language::kEnglish),
              HasSubstr("PASSED\nno failure up to 30 ms: axis 1 still moves\n"));
  EXPECT_THAT(TextReport(findings, Language::kChinese),
              HasSubstr("PASSED\n未出错，到 30 ms 为止：轴 1 仍在运动\n"));
  EXPECT_THAT(HtmlReport(findings, Language::kEnglish),
              HasSubstr("<p>no failure up to 30 ms: axis 1 still moves</p>"));
  const auto json = nlohmann::json::parse(JsonReport(findings));
  EXPECT_EQ(json["verdict"], "PASSED");
  EXPECT_EQ(json["why"], "no failure up to 30 ms: axis 1 still moves");
  EXPECT_EQ(json["horizon"]["ms"], 30);
  EXPECT_EQ(json["horizon"]["moving_axes"], nlohmann::json::array({1}));
  EXPECT_EQ(json["horizon"]["running_threads"], nlohmann::json::array());
}

TEST(HorizonReport, EnginesThatTrySomeSchedulesHaveOneToo) {
  const char* keys = "until_ms = 30\nalways = [\"axis1.prfPos < 5000\"]";
  EXPECT_EQ(FindingsOf(kJog, keys, {.engine = EngineKind::kBounded, .preemption_limit = 1})
                .exploration.why.en,
            "no schedule with at most 1 preemptions fails; up to 30 ms: axis 1 still moves");
  EXPECT_EQ(
      FindingsOf(kJog, keys, {.engine = EngineKind::kRandom, .runs = 3}).exploration.why.en,
      "none of 3 random schedules fails; others were not tried; up to 30 ms: axis 1 still moves");
}

TEST(HorizonText, NamesSeveralAndSpeaksChinese) {
  const Message text = DescribeHorizon({500.0, 0b101, 0b1100});
  EXPECT_EQ(text.en, "up to 500 ms: axes 1, 3 still move, threads 2, 3 still run");
  EXPECT_EQ(text.zh, "到 500 ms 为止：轴 1, 3 仍在运动，线程 2, 3 仍在运行");
}

}  // namespace
}  // namespace oncard::explore
