// The requirements of a scenario on all schedules, checked in one run.
#include "runtime/scenario/requirement_watch.h"

#include <gtest/gtest.h>

#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

// x is 1 for one statement, twice. Lines 5 to 8.
constexpr const char* kBlip =
    "int x, y;\nint f()\n{\n  y = 5;\n  x = 1;\n  x = 0;\n  x = 1;\n  x = 0;\n  return 3;\n}\n";

ScenarioResult WatchedRun(const std::string& program, const std::string& scenario) {
  auto result = RunWithRequirements(ScenarioForTest(scenario), CompileForTest(program), {});
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message.en);
  return result.ok() ? std::move(result).value() : ScenarioResult();
}

/// `requirement: message` of every failure.
std::vector<std::string> FailuresOf(const std::string& program, const std::string& scenario) {
  std::vector<std::string> texts;
  for (const ScenarioFailure& failure : WatchedRun(program, scenario).failures) {
    texts.push_back(failure.expectation + ": " + failure.message.en);
  }
  return texts;
}

struct WatchCase {
  const char* scenario;
  std::vector<std::string> failures;
};

class RequirementWatchTest : public testing::TestWithParam<WatchCase> {};

TEST_P(RequirementWatchTest, FindsWhatDoesNotHold) {
  EXPECT_EQ(FailuresOf(kBlip, GetParam().scenario), GetParam().failures) << GetParam().scenario;
}

// Statements of the first cycle begin at 0.25 ms.
INSTANTIATE_TEST_SUITE_P(
    Scopes, RequirementWatchTest,
    testing::Values(
        WatchCase{"always = [\"x < 2\"]\nnever = [\"x == 2\"]\nfinal = [\"y == 5\"]\n"
                  "eventually = [\"x == 1 && y == 5\"]",
                  {}},
        WatchCase{"always = [\"x == 0\"]",
                  {"always: x == 0: does not hold after thread 0 has executed p.c:5, at 0.25 ms: "
                   "x is 1"}},
        WatchCase{
            "never = [\"x + y == 6\"]",
            {"never: x + y == 6: holds after thread 0 has executed p.c:5, at 0.25 ms: x is 1, "
             "y is 5"}},
        WatchCase{"always = [\"x == 1\"]", {"always: x == 1: does not hold at 0 ms: x is 0"}},
        WatchCase{"final = [\"y == 6 || x != 0\"]",
                  {"final: y == 6 || x != 0: does not hold at the end: y is 5, x is 0"}},
        WatchCase{"eventually = [\"x == 2\"]",
                  {"eventually: x == 2: held in no state of the run; at its end: x is 0"}},
        WatchCase{"final = [\"thread0.result == 3 && axis1.prfPos == 0\"]", {}}));

// The state between two statements is checked even if no other thread runs between them.
TEST(RequirementWatch, SeesEveryStatementUnderEveryPolicy) {
  for (const char* schedule : {"rr", "rr:3", "priority", "random:3", "pct:1:2"}) {
    const std::string scenario =
        std::string("never = [\"x == 1\"]\nschedule = \"") + schedule +
        "\"\n[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"f\"\n";
    EXPECT_EQ(FailuresOf(kBlip, scenario).size(), 1u) << schedule;
  }
}

TEST(RequirementWatch, ARunIsTheSameWhetherItIsWatchedOrNot) {
  const char* program =
      "int n;\nint f(int k)\n{\n  int cc;\nlbl:\n  n = n + k;\n  GT_Delay(3);\n  k = k - 1;\n"
      "  cc = k > 0;\n  if (cc) goto lbl;\n  return n;\n}\n";
  for (const char* schedule : {"rr", "rr:3", "priority", "random:3", "pct:1:2"}) {
    std::string scenario = std::string("schedule = \"") + schedule + "\"\nrate = 30\n";
    const std::string threads =
        "[[thread]]\nfunction = \"f\"\ninit = { k = 70 }\n"
        "[[thread]]\nthread = 1\nfunction = \"f\"\ninit = { k = 50 }\n";
    const ScenarioResult plain = WatchedRun(program, scenario + threads);
    const ScenarioResult watched =
        WatchedRun(program, scenario + "always = [\"n >= 0\"]\n" + threads);
    EXPECT_EQ(watched.hash, plain.hash) << schedule;
    EXPECT_EQ(watched.end_ms, plain.end_ms) << schedule;
    EXPECT_TRUE(watched.passed()) << schedule;
  }
}

TEST(RequirementWatch, SeesTheCardMoveAfterTheThreads) {
  // From rest at 1 pulse/ms^2 to 50 pulse/ms: 50 ms and 1250 pulses; 3000 are passed after 85 ms.
  const char* program =
      "int f()\n{\n  TJogPrm jog;\n  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_GetJogPrm(1, &jog);\n"
      "  jog.acc = 1;\n  jog.dec = 1;\n  GT_SetJogPrm(1, &jog);\n  GT_SetVel(1, 50);\n"
      "  GT_Update(1);\n  return 0;\n}\n";
  EXPECT_TRUE(WatchedRun(program, "until_ms = 80\nnever = [\"axis1.prfPos > 3000\"]").passed());
  EXPECT_EQ(WatchedRun(program, "until_ms = 90\nnever = [\"axis1.prfPos > 3000\"]").failures.size(),
            1u);
}

TEST(RequirementWatch, RefusesWhatIsNoExpression) {
  Scenario scenario = ScenarioForTest("always = [\"z == 1\"]");
  const auto result = RunWithRequirements(scenario, CompileForTest(kBlip), {});
  ASSERT_FALSE(result.ok());
  const std::string& placed = result.error().message.en;
  EXPECT_EQ(placed,
            "t.toml:2:11: nothing is named 'z'\n    2 | always = [\"z == 1\"]\n"
            "      |           ^~~~~~~~");

  // A requirement that is not from a file is reported by its text.
  scenario.text_places.clear();
  const auto named = RunWithRequirements(scenario, CompileForTest(kBlip), {});
  ASSERT_FALSE(named.ok());
  EXPECT_EQ(named.error().message.en, "'always: z == 1': nothing is named 'z'");
}

// The final requirements of a run that did not end are not checked.
TEST(RequirementWatch, LeavesTheEndOfAFailedRunAlone) {
  const char* spin = "int n;\nint f()\n{\nlbl:\n  n = n + 1;\n  goto lbl;\n}\n";
  const ScenarioResult result = WatchedRun(spin, "limit_ms = 2\nfinal = [\"n == -1\"]");
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_EQ(result.failures[0].expectation, "");
}

}  // namespace
}  // namespace oncard::runtime
