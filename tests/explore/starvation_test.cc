// Livelocks with one variable as the reason (explore/reports/starvation.h).
#include "explore/reports/starvation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

/// What the report says of the failure.
std::string ReasonOf(const std::string& source) {
  const Findings findings = FindingsOf(source, {.engine = EngineKind::kStateful});
  return nlohmann::json::parse(JsonReport(findings))["reason"].get<std::string>();
}

/// Thread 0 waits until `m` is 0 and takes it; thread 1 executes the statements.
std::string WaitingForALock(const std::string& other) {
  return "int m;\n//@ init: m=1\nint t0() {\nL:\n  if (m) goto L;\n  m = 1;\n}\nint t1() {\n" +
         other + "}\n";
}

TEST(StarvationTest, NamesALockThatIsNeverGivenBack) {
  EXPECT_EQ(ReasonOf(WaitingForALock("  m = 1;\n")),
            "starvation: thread 0 finds m taken each time it looks");
}

TEST(StarvationTest, ShowsTheLoopOnce) {
  const Findings findings = FindingsOf(WaitingForALock("  m = 1;\n"), {});
  EXPECT_EQ(findings.trail.cycle.size(), 1u);
  EXPECT_THAT(TextReport(findings, Language::kEnglish), HasSubstr("and then for ever:\n"));
  EXPECT_THAT(TextReport(findings, Language::kChinese),
              HasSubstr("饥饿：线程 0 每次查看时 m 都被占用\n"));
}

TEST(StarvationTest, NamesEachThreadThatPollsForAnother) {
  const std::string flags =
      "int a, b;\nint t0() {\nL:\n  if (a) goto M;\n  goto L;\nM:\n  b = 1;\n}\n"
      "int t1() {\nL:\n  if (b) goto M;\n  goto L;\nM:\n  a = 1;\n}\n";
  EXPECT_EQ(ReasonOf(flags),
            "starvation: thread 0 finds a = 0 each time it looks, thread 1 finds b = 0 each time "
            "it looks");
}

TEST(StarvationTest, ThreadsThatGiveWayToEachOtherHaveNoSingleVariable) {
  const std::string polite = [] {
    std::string source = "int f0, f1;\n";
    for (const std::string own : {"0", "1"}) {
      const std::string other = own == "0" ? "1" : "0";
      source += "int t" + own + "() {\n  int o;\nL:\n  f" + own + " = 1;\n  o = f" + other +
                ";\n  if (o) goto Y;\n  return 0;\nY:\n  f" + own + " = 0;\n  goto L;\n}\n";
    }
    return source;
  }();
  EXPECT_EQ(ReasonOf(polite), "livelock: the threads can run for ever without any of them ending");
}

TEST(StarvationTest, AThreadThatLooksAtTwoVariablesIsNoReason) {
  EXPECT_EQ(ReasonOf("int a, b;\nint t0() {\n  int s;\nL:\n  s = a + b;\n  s = s == 0;\n"
                     "  if (s) goto L;\n}\n"),
            "livelock: the threads can run for ever without any of them ending");
}

}  // namespace
}  // namespace oncard::explore
