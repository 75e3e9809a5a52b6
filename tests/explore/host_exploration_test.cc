// Explorations of the threads that a recorded host has started: its calls are the surroundings.
#include "explore/host_exploration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/runtime/recording_host.h"

namespace oncard::explore {
namespace {

using runtime::RecordingHost;
using testing::HasSubstr;

/// Functions 1 and 2 of a program on threads 0 and 1, which are started in the same cycle.
void StartBoth(RecordingHost* host) {
  host->Wait(100);
  host->Call("GT_Bind", {0, 1, 0});
  host->Call("GT_Bind", {1, 2, 1});
  host->Call("GT_RunThread", {0});
  host->Call("GT_RunThread", {1});
}

/// A host that starts both functions of a program and waits for a millisecond.
std::string RecordOf(const std::string& source) {
  RecordingHost host;
  host.Download("program", source);
  StartBoth(&host);
  host.Wait(1000);
  host.Close();
  return host.text();
}

Findings Explored(const std::string& record) {
  auto findings = ExploreRecord(record, "host.calls", {});
  EXPECT_TRUE(findings.ok()) << findings.error().message.en;
  return findings.ok() ? std::move(findings).value() : Findings{};
}

std::string RefusalOf(const std::string& record) {
  const auto findings = ExploreRecord(record, "host.calls", {});
  return findings.ok() ? "" : findings.error().message.en;
}

/// Two functions that add 1 to x, one or two statements each.
std::string Adding(const std::string& statements) {
  const std::string body = "()\n{\n  int t;\n  " + statements + "\n  return 0;\n}\n";
  return "//@ final: x == 2\nint x;\nint f" + body + "int g" + body;
}

// --- What is found -------------------------------------------------------------------------------

TEST(HostExplorationTest, ProvesWhatTheCommentsOfTheSourcesAskFor) {
  const Findings findings = Explored(RecordOf(Adding("x = x + 1;")));
  EXPECT_EQ(findings.exploration.verdict, Verdict::kProved);
  ASSERT_EQ(findings.subject.requirements.size(), 1U);
  EXPECT_EQ(findings.subject.requirements[0].text, "x == 2");
}

TEST(HostExplorationTest, ComplainsOfNoDeadlockThatTheSourceAllows) {
  const std::string waiting =
      "int x;\nint f()\n{\n  GT_WaitForVarEq(&x, 1);\n  return 0;\n}\n"
      "int g()\n{\n  return 0;\n}\n";
  // The host closes the card after the last thread that ends.
  EXPECT_EQ(Explored(RecordOf(waiting)).exploration.verdict, Verdict::kFailed);
  EXPECT_NE(Explored(RecordOf("//@ deadlock: any\n" + waiting)).exploration.verdict,
            Verdict::kFailed);
}

TEST(HostExplorationTest, FindsAnInterleavingThatTheRecordedRunDidNotHave) {
  const Findings findings = Explored(RecordOf(Adding("t = x;\n  x = t + 1;")));
  EXPECT_EQ(findings.exploration.verdict, Verdict::kFailed);
  const std::string report = TextReport(findings, Language::kEnglish, {});
  EXPECT_THAT(report, HasSubstr("final: x == 2 does not hold"));
  EXPECT_THAT(report, HasSubstr("x is 1"));
}

TEST(HostExplorationTest, SaysWhatTheHostIsTakenFor) {
  const std::string report =
      TextReport(Explored(RecordOf(Adding("x = x + 1;"))), Language::kEnglish, {});
  EXPECT_THAT(report, HasSubstr("every call of the host is answered with its recorded code"));
  EXPECT_THAT(report, HasSubstr("host of host.calls: 5 calls"));
  EXPECT_THAT(report,
              HasSubstr("the host makes its recorded calls, each in the cycle of the record"));
}

// --- What the host does --------------------------------------------------------------------------

TEST(HostExplorationTest, TheHostGoesOnWhileThreadsRun) {
  RecordingHost host;
  host.Download("program",
                "//@ final: n > 0 && done == 1\nint n, done;\n"
                "int f()\n{\nL:\n  n = 1;\n  goto L;\n}\n"
                "int g()\n{\n  done = 1;\n  return 0;\n}\n");
  StartBoth(&host);
  host.Wait(1000);
  host.Call("GT_StopThread", {0});
  host.Close();
  const Findings findings = Explored(host.text());
  EXPECT_EQ(findings.exploration.verdict, Verdict::kProved);
}

TEST(HostExplorationTest, ThreadsThatAreBoundLaterAreExploredToo) {
  RecordingHost host;
  host.Download("program", Adding("t = x;\n  x = t + 1;"));
  host.Wait(150);
  host.Call("GT_Bind", {0, 1, 0});
  host.Call("GT_RunThread", {0});
  host.Call("GT_Bind", {1, 2, 1});
  host.Call("GT_RunThread", {1});
  host.Wait(1000);
  host.Close();
  const Findings findings = Explored(host.text());
  EXPECT_EQ(findings.subject.threads.size(), 2U);
  EXPECT_EQ(findings.exploration.verdict, Verdict::kFailed);
}

// In the record thread 0 had ended when the host started it again; it need not have.
TEST(HostExplorationTest, ACallThatIsAnsweredOtherwiseIsAFailure) {
  RecordingHost host;
  host.Download("program",
                "int x;\nint f()\n{\n  int i, c;\n  i = 0;\nL:\n  i = i + 1;\n  c = i < 3;\n"
                "  if (c) goto L;\n  return 0;\n}\n"
                "int g()\n{\n  int i, c;\n  i = 0;\nL:\n  i = i + 1;\n  c = i < 20;\n"
                "  if (c) goto L;\n  return 0;\n}\n");
  StartBoth(&host);
  host.Wait(500);
  host.Call("GT_RunThread", {0});
  host.Wait(5000);
  host.Close();
  const Findings findings = Explored(host.text());
  EXPECT_EQ(findings.exploration.verdict, Verdict::kFailed);
  const std::string report = TextReport(findings, Language::kEnglish, {});
  EXPECT_THAT(report, HasSubstr("the card does not answer GT_RunThread(0) as in the record"));
}

TEST(HostExplorationTest, AFailureShowsWhatTheHostChangesInBetween) {
  RecordingHost host;
  host.Download("program",
                "//@ never: x == 1 && stopped == 1\nint x, stopped;\n"
                "int f()\n{\n  GT_Delay(1);\n  x = 1;\n  return 0;\n}\n"
                "int g()\n{\n  GT_Delay(3);\n  stopped = 1;\n  return 0;\n}\n");
  StartBoth(&host);
  host.Wait(1500);
  host.Call("GT_SetDo", {12, 5});
  host.Wait(3000);
  host.Close();
  const Findings findings = Explored(host.text());
  ASSERT_EQ(findings.exploration.verdict, Verdict::kFailed);
  const std::string report = TextReport(findings, Language::kEnglish, {});
  const size_t started = report.find("ms  host: GT_RunThread(1)\n");
  const size_t first = report.find("x = 1;", started);
  const size_t output = report.find("ms  host: GT_SetDo(12, 0x5)\n", first);
  EXPECT_NE(report.find("stopped = 1;", output), std::string::npos) << report;
  EXPECT_THAT(HtmlReport(findings, Language::kEnglish, {}), HasSubstr("host: GT_SetDo(12, 0x5)"));
}

TEST(HostExplorationTest, ARunThatTheHostCutsOffEndsThere) {
  const Findings findings = Explored(
      RecordOf("//@ always: n == 0 || n == 1\nint n;\nint f()\n{\nL:\n  n = 1;\n  goto L;\n}\n"
               "int g()\n{\n  return 0;\n}\n"));
  EXPECT_EQ(findings.exploration.verdict, Verdict::kPassed);
  EXPECT_THAT(TextReport(findings, Language::kEnglish, {}), HasSubstr("the first 1.25 ms"));
}

// --- What is refused -----------------------------------------------------------------------------

TEST(HostExplorationTest, RefusesAHostThatStartsNoThread) {
  RecordingHost host;
  host.Call("GT_AxisOn", {1});
  host.Close();
  EXPECT_THAT(RefusalOf(host.text()), HasSubstr("the host starts no thread"));
}

TEST(HostExplorationTest, RefusesACardWithoutMotionPrograms) {
  RecordingHost host("GE-300-SG");
  host.Call("GT_AxisOn", {1});
  host.Close();
  EXPECT_THAT(RefusalOf(host.text()), HasSubstr("a GE-300-SG executes no motion programs"));
}

TEST(HostExplorationTest, RefusesAnotherProgramAfterTheStart) {
  RecordingHost host;
  for (const char* name : {"first", "second"}) {
    host.Download(name, Adding("x = x + 1;"));
    StartBoth(&host);
    host.Wait(1000);
  }
  host.Close();
  EXPECT_THAT(RefusalOf(host.text()), HasSubstr("changes the program"));
}

TEST(HostExplorationTest, RefusesInitialValuesInComments) {
  EXPECT_THAT(RefusalOf(RecordOf("//@ init: x=1\n" + Adding("x = x + 1;"))),
              HasSubstr("what the host writes"));
}

TEST(HostExplorationTest, RefusesAssertsWhichAnObjectFileDoesNotHave) {
  EXPECT_THAT(RefusalOf(RecordOf(Adding("\n//@ assert: x < 3\nx = x + 1;"))),
              HasSubstr("write '//@ always:' outside of functions"));
}

TEST(HostExplorationTest, RefusesDataRaces) {
  EXPECT_THAT(RefusalOf(RecordOf("//@ races: none\n" + Adding("x = x + 1;"))),
              HasSubstr("not looked for where a recorded host starts the threads"));
}

TEST(HostExplorationTest, RefusesDataRacesOfAnySource) {
  std::string record = RecordOf("//@ races: none\n" + Adding("x = x + 1;"));
  const std::string one = R"("sources":[{)";
  const size_t at = record.find(one);
  ASSERT_NE(at, std::string::npos);
  const size_t end = record.find("}]", at);
  record.insert(end + 1, R"(,{"path":"/programs/more.c","text":"//@ final: x == 2\n"})");
  EXPECT_THAT(RefusalOf(record),
              HasSubstr("not looked for where a recorded host starts the threads"));
}

TEST(HostExplorationTest, RefusesARecordWhoseCallsTheCardAnswersOtherwise) {
  std::string record = RecordOf(Adding("x = x + 1;"));
  const size_t bind = record.find("GT_Bind");
  const size_t code = record.find("\"code\":0", bind);
  ASSERT_NE(code, std::string::npos);
  record.replace(code, 8, "\"code\":7");
  EXPECT_THAT(RefusalOf(record), HasSubstr("GT_Bind(0, 1, 0) returns 0 instead of 7"));
}

TEST(HostExplorationTest, RefusesSeveralCards) {
  const std::string record = RecordOf(Adding("x = x + 1;"));
  const std::string again = record.substr(record.find('\n') + 1);
  EXPECT_THAT(RefusalOf(record + again), HasSubstr("2 openings of cards"));
}

}  // namespace
}  // namespace oncard::explore
