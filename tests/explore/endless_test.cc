// Safety alone: programs that are meant to run for ever, and livelocks and deadlocks that are no
// failures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compiler/compiler.h"
#include "explore/reports/claim.h"
#include "explore/scenario_exploration.h"
#include "explore_programs.h"
#include "tests/compiler/memory_files.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

/// Two threads that alternate for ever: `go` is the thread whose turn it is, `inside` the number
/// of threads at work.
std::string Alternating(const std::string& comments) {
  std::string source = "int go, inside;\n" + comments;
  for (const char* own : {"0", "1"}) {
    const std::string other = *own == '0' ? "1" : "0";
    source +=
        std::string("int t") + own + "() {\n  int w;\nL:\n  w = go == " + other +
        ";\n  if (w) goto L;\n  inside = inside + 1;\n  inside = inside - 1;\n  go = " + other +
        ";\n  goto L;\n}\n";
  }
  return source;
}

constexpr const char* kForEver = "int n;\nint t0() {\nL:\n  n = 1 - n;\n  goto L;\n}\n";
constexpr const char* kCardForEver =
    "int n;\nint t0() {\nL:\n  n = 1 - n;\n  GT_Delay(1);\n  goto L;\n}\n";

/// Each of two threads occupies its own place, and then waits for the other's.
constexpr const char* kTwoPlaces =
    "int a, b;\n"
    "int t0() { a = 1; GT_WaitForVarEq(&b, 0); a = 0; return 0; }\n"
    "int t1() { b = 1; GT_WaitForVarEq(&a, 0); b = 0; return 0; }\n";

Verdict VerdictOf(const std::string& source, const ExploreOptions& options = {}) {
  return FindingsOf(source, options).exploration.verdict;
}

Verdict VerdictWithCard(const std::string& source, const std::string& keys,
                        const ExploreOptions& options = {}) {
  return FindingsOf(source, keys, options).exploration.verdict;
}

// --- Without a card ------------------------------------------------------------------------------

TEST(EndlessTest, AFiniteGraphIsProvedThoughNoRunEnds) {
  EXPECT_EQ(VerdictOf(Alternating("//@ never: inside > 1\n")), Verdict::kFailed);
  for (const char* may_last : {"//@ endless\n", "//@ livelock: any\n"}) {
    const std::string comments = std::string("//@ never: inside > 1\n") + may_last;
    for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful}) {
      EXPECT_EQ(VerdictOf(Alternating(comments), {.engine = engine}), Verdict::kProved);
    }
    EXPECT_EQ(VerdictOf(Alternating(comments), {.engine = EngineKind::kBounded}), Verdict::kPassed);
    EXPECT_EQ(
        VerdictOf(Alternating(comments), {.engine = EngineKind::kStateful, .merge_private = true}),
        Verdict::kProved);
  }
}

TEST(EndlessTest, WhatMustNotHappenIsFoundAllTheSame) {
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful, EngineKind::kBounded,
                                  EngineKind::kRandom, EngineKind::kPct, EngineKind::kPos}) {
    const Findings findings =
        FindingsOf(Alternating("//@ endless\n//@ never: inside == 1 && go == 1\n"),
                   {.engine = engine, .depth_limit = 1000, .runs = 20});
    EXPECT_EQ(findings.exploration.verdict, Verdict::kFailed) << EngineName(engine);
    EXPECT_FALSE(findings.exploration.failure->livelock) << EngineName(engine);
  }
}

TEST(EndlessTest, ExecutionsWithoutAnEndAreNoProof) {
  EXPECT_EQ(VerdictOf(std::string("//@ endless\n") + kForEver,
                      {.engine = EngineKind::kDpor, .depth_limit = 1000}),
            Verdict::kIncomplete);
}

TEST(EndlessTest, ALivelockThatIsAllowedHidesNoFailureOfRunsThatEnd) {
  const std::string polite =
      "int f0, f1, n;\n//@ livelock: any\n//@ final: n == 1\n"
      "int t0() {\n  int o;\nL:\n  f0 = 1;\n  o = f1;\n  if (o) goto Y;\n  n = n + 1;\n"
      "  f0 = 0;\n  return 0;\nY:\n  f0 = 0;\n  goto L;\n}\n"
      "int t1() {\n  int o;\nL:\n  f1 = 1;\n  o = f0;\n  if (o) goto Y;\n  n = n + 1;\n"
      "  f1 = 0;\n  return 0;\nY:\n  f1 = 0;\n  goto L;\n}\n";
  const Findings findings = FindingsOf(polite, {.engine = EngineKind::kStateful});
  EXPECT_EQ(findings.exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(findings.exploration.failure->fault.kind, Fault::Kind::kRequirement);
}

// `leads` concerns runs without an end, too, whether they are allowed or not.
TEST(EndlessTest, ResponsesAreSoughtInRunsThatNeverEnd) {
  const auto findings = [](const std::string& then, EngineKind engine) {
    return FindingsOf("//@ endless\n//@ leads: n == 1 -> " + then + '\n' + kForEver,
                      {.engine = engine});
  };
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful}) {
    const Findings never = findings("n == 2", engine);
    ASSERT_EQ(never.exploration.verdict, Verdict::kFailed) << EngineName(engine);
    EXPECT_TRUE(never.exploration.failure->livelock) << EngineName(engine);
    const Findings given = findings("n == 0", engine);
    EXPECT_EQ(given.exploration.verdict, Verdict::kProved) << EngineName(engine);
    const std::string claim = ClaimText(given, Language::kEnglish);
    EXPECT_THAT(claim, HasSubstr("leads: no thread that can run waits for ever"));
    EXPECT_THAT(claim, testing::Not(HasSubstr("leads: only runs that end")));
  }
  EXPECT_THAT(ClaimText(findings("n == 0", EngineKind::kBounded), Language::kEnglish),
              HasSubstr("leads: only runs that end"));
}

// Such as those of a caller in Python.
TEST(EndlessTest, RequirementsOnTheEndAreRefusedWhereverTheyComeFrom) {
  const auto compiled = compiler::CompileText("program.c", kForEver, {}, compiler::NoFiles());
  runtime::Scenario scenario;
  scenario.endless = true;
  scenario.threads = {{.thread = 0, .function = "t0", .page = 0, .values = {}}};
  EXPECT_TRUE(ExploreScenario(scenario, {{Scope::kNever, "n == 2"}}, *compiled.object, {}).ok());
  const auto found = ExploreScenario(scenario, {{Scope::kFinal, "n == 0"}}, *compiled.object, {});
  ASSERT_FALSE(found.ok());
  EXPECT_THAT(found.error().message.en, HasSubstr("'final: n == 0' is about the end of runs"));
}

// --- With a card ---------------------------------------------------------------------------------

TEST(EndlessTest, ACardIsSearchedUpToItsHorizon) {
  EXPECT_EQ(VerdictWithCard(kCardForEver, "limit_ms = 5\n"), Verdict::kFailed);
  for (const std::string may_last : {"endless = true\n", "livelock = \"any\"\n"}) {
    EXPECT_EQ(VerdictWithCard(kCardForEver, may_last + "until_ms = 5\n"), Verdict::kPassed);
    for (const EngineKind engine :
         {EngineKind::kAuto, EngineKind::kStateful, EngineKind::kBounded, EngineKind::kPos}) {
      const Findings findings =
          FindingsOf(kCardForEver, may_last + "limit_ms = 5\n", {.engine = engine, .runs = 20});
      EXPECT_EQ(findings.exploration.verdict, Verdict::kPassed) << EngineName(engine);
      EXPECT_THAT(findings.exploration.why.en, HasSubstr("up to 5 ms: thread 0 still runs"));
    }
  }
}

TEST(EndlessTest, ARunThatIsCutHasNoEndToJudge) {
  const std::string keys = "livelock = \"any\"\nlimit_ms = 5\n";
  EXPECT_EQ(VerdictWithCard(kCardForEver, keys + "final = [\"n == 7\"]\n"), Verdict::kPassed);
  EXPECT_EQ(VerdictWithCard(kCardForEver, keys + "never = [\"n == 1\"]\n"), Verdict::kFailed);
}

TEST(EndlessTest, ADeadlockThatIsAllowedIsAnEnd) {
  EXPECT_EQ(VerdictWithCard(kTwoPlaces, ""), Verdict::kFailed);
  const std::string keys = "deadlock = \"any\"\n";
  for (const EngineKind engine : {EngineKind::kAuto, EngineKind::kStateful}) {
    EXPECT_EQ(VerdictWithCard(kTwoPlaces, keys, {.engine = engine}), Verdict::kProved);
  }
  for (const EngineKind engine : {EngineKind::kBounded, EngineKind::kRandom, EngineKind::kPct}) {
    EXPECT_EQ(VerdictWithCard(kTwoPlaces, keys, {.engine = engine, .runs = 20}), Verdict::kPassed);
  }
  // What must hold at the end is checked there.
  EXPECT_EQ(VerdictWithCard(kTwoPlaces, keys + "final = [\"a == 0\"]\n"), Verdict::kFailed);
  EXPECT_EQ(VerdictWithCard(kTwoPlaces, keys + "final = [\"a == b\"]\n"), Verdict::kProved);
  // Nothing goes on there.
  EXPECT_EQ(VerdictWithCard(kTwoPlaces, keys + "until_ms = 5\n"), Verdict::kProved);
}

// --- What the report says ------------------------------------------------------------------------

TEST(EndlessTest, TheClaimSaysWhatWasNotAsked) {
  const auto claim = [](const Findings& findings, Language language) {
    return ClaimText(findings, language);
  };
  const Findings endless = FindingsOf(std::string("//@ endless\n") + kForEver, {});
  EXPECT_THAT(claim(endless, Language::kEnglish),
              HasSubstr("asked      no thread fault, no deadlock\n"
                        "not asked  the results, that runs end (endless), livelock, data races\n"));
  EXPECT_THAT(claim(endless, Language::kEnglish), testing::Not(HasSubstr("//@ final")));
  EXPECT_THAT(claim(endless, Language::kChinese), HasSubstr("运行会结束（endless）、活锁"));
  const auto json = nlohmann::json::parse(JsonReport(endless));
  EXPECT_EQ(json["asked"]["endless"], true);
  EXPECT_EQ(json["asked"]["livelock"], false);

  const Findings awaited =
      FindingsOf(std::string("//@ livelock: any\n//@ eventually: n == 7\n") + kForEver, {});
  EXPECT_THAT(claim(awaited, Language::kEnglish),
              HasSubstr("not asked  livelock, 'eventually' in runs that never end, data races\n"));

  const Findings waiting = FindingsOf(kTwoPlaces, "deadlock = \"any\"\n", {});
  EXPECT_THAT(claim(waiting, Language::kEnglish),
              HasSubstr("asked      no thread fault, all threads end before 60000 ms\n"
                        "not asked  the results, livelock, deadlock, data races\n"));
  EXPECT_EQ(nlohmann::json::parse(JsonReport(waiting))["asked"]["deadlock"], false);

  const Findings cut = FindingsOf(kCardForEver, "endless = true\nlimit_ms = 5\n", {});
  EXPECT_THAT(claim(cut, Language::kEnglish), HasSubstr("bounds     the first 5 ms\n"));
  const Findings sampled = FindingsOf(std::string("//@ endless\n") + kForEver,
                                      {.engine = EngineKind::kPos, .depth_limit = 100, .runs = 3});
  EXPECT_THAT(claim(sampled, Language::kEnglish),
              HasSubstr("the first 100 statements of those that do not end: 3\n"));
}

}  // namespace
}  // namespace oncard::explore
