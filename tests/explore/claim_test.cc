// The text about what a verdict covers (explore/reports/claim.h), and results without requirements
// (ends.h).
#include "explore/reports/claim.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "explore/reports/report.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using Json = nlohmann::json;

/// Hashes and versions change with every program and release.
std::string Masked(std::string text) {
  text = std::regex_replace(text, std::regex("[0-9a-f]{16}"), "HASH");
  return std::regex_replace(text, std::regex("oncard [0-9][0-9.]*"), "oncard VERSION");
}

std::string TextOf(const Findings& findings, Language language = Language::kEnglish) {
  return Masked(ClaimText(findings, language));
}

Json JsonOf(const Findings& findings) { return Json::parse(JsonReport(findings)); }

/// Two threads that take a number each; either may get the lower one.
constexpr const char* kTakeANumber =
    "int next;\nint unused;\n"
    "int t0() {\n  int own;\n  next = next + 1;\n  own = next;\n  return own;\n}\n"
    "int t1() {\n  int own;\n  next = next + 1;\n  own = next;\n  return own;\n}\n";

TEST(ClaimTest, ListsWhatWasAskedOfAProgram) {
  const std::string source =
      "int g;\n//@ final: g == 1\n//@ never: g == 7\n//@ races: none\n//@ sync: g\n"
      "int t0() {\n  g = 1;\n}\nint t1() {\n  g = 1;\n}\n";
  EXPECT_EQ(TextOf(FindingsOf(source, {})),
            "asked    final: g == 1\n"
            "         never: g == 7\n"
            "         no thread fault, no deadlock, no livelock\n"
            "         no data race; synchronising: g\n"
            "program  program.c, object HASH\n"
            "         threads 0 t0, 1 t1\n"
            "assumes  any thread may execute the next statement; no time passes\n"
            "bounds   none: every schedule was searched\n"
            "by       oncard VERSION, engine stateful\n");
}

TEST(ClaimTest, ListsTheConditionsOfACard) {
  const std::string source = "int t0() {\nL:\n  GT_AxisOn(1);\n  goto L;\n}\n";
  EXPECT_EQ(TextOf(FindingsOf(source,
                              "until_ms = 1\nrate = 8\ncycle_us = 500\naxes = 4\n"
                              "never = [\"axis2.moving == 1\"]\n",
                              {})),
            "asked      never: axis2.moving == 1\n"
            "           no thread fault, no deadlock\n"
            "not asked  livelock, data races\n"
            "program    program.c, object HASH\n"
            "           scenario test.toml, HASH\n"
            "           threads 0 t0\n"
            "assumes    any thread may execute the next statement, and each executes at least one "
            "in every cycle\n"
            "           rate 8 statements per ms, cycle 500 us, 4 axes\n"
            "           world: ideal drives, inputs off, no events\n"
            "bounds     the first 1 ms\n"
            "by         oncard VERSION, engine stateful\n");
}

TEST(ClaimTest, BoundsAreThoseOfTheEngine) {
  struct Case {
    ExploreOptions options;
    std::string bounds;
    bool livelock;
  };
  const std::string source = std::string(kTakeANumber) + "//@ final: next == 2\n";
  for (const Case& c :
       {Case{{.engine = EngineKind::kDpor}, "none: every schedule was searched", true},
        Case{{.engine = EngineKind::kBounded, .preemption_limit = 1},
             "preemptions: at most 1",
             false},
        Case{{.engine = EngineKind::kPct, .runs = 20, .seed = 9},
             "20 random schedules of the engine pct, seed 9",
             false}}) {
    const Json json = JsonOf(FindingsOf(source, c.options));
    EXPECT_EQ(json["bounds"], Json::array({c.bounds}));
    EXPECT_EQ(json["asked"]["livelock"], c.livelock) << c.bounds;
  }
}

TEST(ClaimTest, CountsSayWhetherStatesAreThoseOfMergedStatements) {
  const std::string source = std::string(kTakeANumber) + "//@ final: next == 2\n";
  const Findings merged = FindingsOf(source, {.engine = EngineKind::kStateful});
  EXPECT_EQ(JsonOf(merged)["bounds"], Json::array({"none: every schedule was searched"}));
  EXPECT_EQ(JsonOf(merged)["states_merged"], true);
  EXPECT_THAT(TextReport(merged, Language::kEnglish), HasSubstr(" merged states, "));
  const Findings single =
      FindingsOf(source, {.engine = EngineKind::kStateful, .merge_private = false});
  EXPECT_FALSE(JsonOf(single).contains("states_merged"));
  EXPECT_THAT(TextReport(single, Language::kEnglish), Not(HasSubstr(" merged states, ")));
}

TEST(ClaimTest, AWorldIsNamedByItsHash) {
  const std::string source = "int t0() {\n  GT_AxisOn(1);\n}\n";
  const auto world = [&](const std::string& keys) {
    return JsonOf(FindingsOf(source, keys, {}))["assumptions"]["world"].get<std::string>();
  };
  EXPECT_EQ(world(""), "nothing happens");
  const std::string input = "[[world.input]]\nat_ms = 1\ntype = \"gpi\"\nvalue = ";
  EXPECT_EQ(world(input + "1\n"), world(input + "1\n"));
  EXPECT_NE(world(input + "1\n"), world(input + "2\n"));
}

TEST(ClaimTest, WithoutARequirementTheResultsAreShown) {
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kDpor, EngineKind::kStateful}) {
    const std::string text = TextOf(FindingsOf(kTakeANumber, {.engine = engine}));
    EXPECT_THAT(text, HasSubstr("not asked  the results, data races\n"));
    EXPECT_THAT(text,
                HasSubstr("there is no requirement on the results; 3 different ones were found:\n"
                          "  next = 2, ret0 = 1, ret1 = 2\n"
                          "  next = 2, ret0 = 2, ret1 = 1\n"
                          "  next = 2, ret0 = 2, ret1 = 2\n"
                          "require the intended one with a line in the source, for example\n"
                          "  //@ final: next == 2\n"));
  }
  const Json json = JsonOf(FindingsOf(kTakeANumber, {}));
  EXPECT_EQ(json["verdict"], "PROVED");
  EXPECT_EQ(json["asked"]["requirements"], Json::array());
  EXPECT_EQ(json["results"][0], Json({{"next", 2}, {"ret0", 1}, {"ret1", 2}}));
  EXPECT_EQ(json["ask"], "//@ final: next == 2");
}

// The explorer accepts the offered line, and running the threads one after the other meets it.
TEST(ClaimTest, TheOfferedRequirementIsThatOfTheThreadsInTurn) {
  const std::string lost =
      "int g;\nint t0() {\n  int r;\n  r = g;\n  g = r + 1;\n}\n"
      "int t1() {\n  int r;\n  r = g;\n  g = r + 1;\n}\n";
  const Json json = JsonOf(FindingsOf(lost, {}));
  EXPECT_EQ(json["results"].size(), 2u);
  EXPECT_EQ(json["ask"], "//@ final: g == 2");
  EXPECT_EQ(FindingsOf(lost + "//@ final: g == 2\n", {}).exploration.verdict, Verdict::kFailed);
}

TEST(ClaimTest, AScenarioIsAskedInItsOwnWords) {
  const Json json = JsonOf(
      FindingsOf("double v;\nint t0() {\n  v = 2.5;\n  GT_AxisOn(1);\n}\n", "rate = 100\n", {}));
  EXPECT_EQ(json["ask"], "final = [\"v == 2.5\"]");
  const Json nothing = JsonOf(FindingsOf("int t0() {\n  GT_AxisOn(1);\n}\n", "rate = 100\n", {}));
  EXPECT_EQ(nothing["ask"], "final = [\"ret0 == 0\"]");
}

TEST(ClaimTest, AFailureShowsNoResults) {
  const Json json = JsonOf(FindingsOf(MutualWait(), {}));
  EXPECT_EQ(json["verdict"], "FAILED");
  EXPECT_FALSE(json.contains("results"));
}

TEST(ClaimTest, ThePageSaysTheSame) {
  const Findings findings = FindingsOf(kTakeANumber, {});
  const std::string page = HtmlReport(findings, Language::kEnglish);
  for (const char* part :
       {"<li>no thread fault, no deadlock, no livelock</li>",
        "<li><code>next = 2, ret0 = 1, ret1 = 2</code></li>", "<pre>//@ final: next == 2</pre>"}) {
    EXPECT_THAT(page, HasSubstr(part));
  }
}

TEST(ClaimTest, SpeaksChinese) {
  const std::string text = TextOf(FindingsOf(kTakeANumber, {}), Language::kChinese);
  EXPECT_THAT(text, StartsWith("要求    无线程故障，无死锁，无活锁\n未要求  运行结果、数据竞争\n"));
  EXPECT_THAT(text, HasSubstr("未对结果提出要求；发现 3 种不同结果：\n"));
}

TEST(EndSetTest, KeepsTheSmallestWhateverTheOrder) {
  EndSet up;
  EndSet down;
  for (int64_t i = 0; i < 40; ++i) {
    up.Add({i});
    up.Add({i});
    down.Add({39 - i});
  }
  EXPECT_EQ(up.ends().size(), EndSet::kKept);
  EXPECT_EQ(up.ends().front(), End{0});
  EXPECT_EQ(up.ends(), down.ends());
}

}  // namespace
}  // namespace oncard::explore
