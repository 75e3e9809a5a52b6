// The requirements of a scenario on all schedules, checked in one run.
#include "runtime/scenario/run/requirement_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

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

// --- A card whose program comes later ------------------------------------------------------------

/// A card as a host has it, with the requirements of a scenario on it.
class HostedCard {
 public:
  explicit HostedCard(const std::string& scenario)
      : watch_(RequirementsOf(ScenarioForTest(scenario)), "") {
    card_.ObserveStates([this] { watch_.ObserveState(card_); });
    Pass(0);
  }

  /// Time that passes before a call of the host.
  void Pass(int64_t cycles) {
    watch_.Follow(card_);
    for (int64_t i = 0; i < cycles; ++i) card_.RunCycle();
  }
  void Download(const char* program) { EXPECT_TRUE(card_.Load(CompileForTest(program)).ok()); }
  void Start() {
    EXPECT_EQ(card_.machine().Bind(0, 1, 0), vm::kOk);
    EXPECT_EQ(card_.machine().Run(0), vm::kOk);
  }
  Controller& card() { return card_; }

  /// All that is said at the end of the host, line by line.
  std::vector<std::string> End() {
    watch_.Follow(card_);
    watch_.End(card_);
    std::vector<std::string> said;
    for (const ScenarioFailure& failure : watch_.failures()) {
      said.push_back(failure.expectation + ": " + failure.message.en);
    }
    ScenarioErrors errors;
    watch_.AddUnchecked({}, &errors);
    if (const auto failure = errors.Failure()) said.push_back(failure->message.en);
    for (const Message& held : watch_.DescribeHeld()) said.push_back(held.en);
    return said;
  }

 private:
  Controller card_;
  RequirementWatch watch_;
};

// A cycle shows its beginning, then each statement. kBlip has six.
TEST(RequirementWatch, ChecksACardAtOnceAndItsProgramFromItsStart) {
  HostedCard host(
      "always = [\"axis1.prfPos == 0\", \"y < 6\"]\nnever = [\"x == 2\"]\n"
      "final = [\"thread0.result == 3\"]\neventually = [\"y == 5\"]");
  host.Pass(2);
  host.Download(kBlip);
  host.Pass(2);
  host.Start();
  host.Pass(1);
  // At 0 ms, after the download, at the start; five cycles, and the six statements.
  EXPECT_THAT(host.End(),
              ElementsAre("'final: thread0.result == 3': held at the end, 1.25 ms",
                          "'always: axis1.prfPos == 0': held in all 14 states from 0 ms on",
                          "'always: y < 6': held in all 8 states from 1 ms on",
                          "'never: x == 2': held in none of 8 states from 1 ms on",
                          "'eventually: y == 5': held at 1.25 ms"));
}

TEST(RequirementWatch, LetsAHostSetVariablesBeforeTheStart) {
  HostedCard host("always = [\"x != 0 || y != 0\"]");
  host.Download(kBlip);
  host.Pass(3);
  const vm::Symbol* x = vm::FindGlobal(*host.card().machine().image(), "x");
  ASSERT_NE(x, nullptr);
  EXPECT_TRUE(host.card().machine().Write({.global = true, .id = x->id}, 1));
  host.Start();
  host.Pass(1);
  EXPECT_THAT(host.End(), ElementsAre(HasSubstr("held in all")));
}

TEST(RequirementWatch, SaysWhatAHostsProgramDoesNotObserve) {
  HostedCard host("always = [\"x == 0\"]\nnever = [\"x + y == 6\"]");
  host.Download(kBlip);
  host.Start();
  host.Pass(1);
  EXPECT_THAT(
      host.End(),
      ElementsAre("always: x == 0: does not hold after thread 0 has executed p.c:5, at 0.25 ms: "
                  "x is 1",
                  "never: x + y == 6: holds after thread 0 has executed p.c:5, at 0.25 ms: x is 1, "
                  "y is 5"));
}

// A requirement that nothing was checked for is not one that holds.
TEST(RequirementWatch, SaysWhatWasNeverChecked) {
  const char* scenario = "always = [\"z == 1\"]\nfinal = [\"y == 5\"]";
  HostedCard unnamed(scenario);
  unnamed.Download(kBlip);
  unnamed.Start();
  unnamed.Pass(1);
  EXPECT_THAT(unnamed.End(),
              ElementsAre(HasSubstr("t.toml:2:11: never checked: nothing is named 'z'\n"),
                          "'final: y == 5': held at the end, 0.25 ms"));

  HostedCard not_started(scenario);
  not_started.Download(kBlip);
  not_started.Pass(1);
  EXPECT_THAT(not_started.End(),
              ElementsAre(HasSubstr("t.toml:3:10: never checked: no thread of a program has been "
                                    "started\n")));
  EXPECT_THAT(HostedCard(scenario).End(), ElementsAre(HasSubstr("nothing is named 'y'")));
}

// The names belong to the program that is there.
TEST(RequirementWatch, FollowsAHostFromProgramToProgram) {
  HostedCard host("never = [\"y == 7\"]");
  host.Download(kBlip);
  host.Start();
  host.Pass(1);
  host.Download("int x, z;\nint f()\n{\n  z = 7;\n  return 0;\n}\n");
  host.Start();
  host.Pass(1);
  host.card().Reset();
  host.Pass(1);
  host.Download("int w, z, y;\nint f()\n{\n  y = 7;\n  return 0;\n}\n");
  host.Start();
  host.Pass(1);
  EXPECT_THAT(host.End(), ElementsAre(HasSubstr("holds after thread 0 has executed p.c:4")));
}

}  // namespace
}  // namespace oncard::runtime
