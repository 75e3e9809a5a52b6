// Requirements under `leads` and `within`: their definition, their form, and one run.
#include "runtime/scenario/run/response.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "runtime/scenario/run/requirement_watch.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// --- The definition ------------------------------------------------------------------------------

struct Seen {
  bool left = false;
  bool right = false;
  int64_t ns = 0;
};

/// The first state that is too late, by the definition: for each state with the left side there is
/// this or a later one with the right side whose clock is at most `limit_ns` greater.
std::optional<size_t> FirstLate(const std::vector<Seen>& run, int64_t limit_ns) {
  std::optional<size_t> first;
  for (size_t i = 0; i < run.size(); ++i) {
    if (!run[i].left) continue;
    bool answered = false;
    std::optional<size_t> late;
    for (size_t j = i; j < run.size(); ++j) {
      const bool in_time = run[j].ns <= run[i].ns + limit_ns;
      answered = answered || (run[j].right && in_time);
      if (!in_time && !late) late = j;
    }
    if (!answered && late && (!first || *late < *first)) first = late;
  }
  return first;
}

/// Whether a state with the left side has no later one with the right side.
bool Unanswered(const std::vector<Seen>& run) {
  for (size_t i = 0; i < run.size(); ++i) {
    bool answered = !run[i].left;
    for (size_t j = i; j < run.size(); ++j) answered = answered || run[j].right;
    if (!answered) return true;
  }
  return false;
}

TEST(Response, OweWhatTheDefinitionSays) {
  std::mt19937 random(1);
  int late_runs = 0;
  int unanswered_runs = 0;
  for (int n = 0; n < 20'000; ++n) {
    std::vector<Seen> run;
    int64_t ns = 0;
    for (size_t i = 0; i < 2 + random() % 12; ++i) {
      ns += random() % 2 == 0 ? 0 : 250'000;
      run.push_back({random() % 4 == 0, random() % 5 == 0, ns});
    }
    const Requirement leads = {.scope = Scope::kLeads, .text = "p", .then = "q"};
    // 0 to 1.2 ms: also between two cycles.
    const Requirement within = {.scope = Scope::kWithin,
                                .text = "p",
                                .then = "q",
                                .within_us = static_cast<int64_t>(random() % 13) * 100};
    Owed owed;
    Owed ever;
    std::optional<size_t> late;
    for (size_t i = 0; i < run.size(); ++i) {
      owed.Observe(within, run[i].left, run[i].right, run[i].ns, 0);
      ever.Observe(leads, run[i].left, run[i].right, run[i].ns, 0);
      if (owed.late && !late) late = i;
    }
    ASSERT_EQ(late, FirstLate(run, within.within_us * 1000)) << "run " << n;
    ASSERT_EQ(ever.pending, Unanswered(run)) << "run " << n;
    ASSERT_FALSE(ever.late);
    late_runs += late ? 1 : 0;
    unanswered_runs += ever.pending ? 1 : 0;
  }
  EXPECT_GT(late_runs, 1000);
  EXPECT_GT(unanswered_runs, 1000);
}

// --- The form ------------------------------------------------------------------------------------

TEST(Response, IsReadFromBothKeysAndWrittenAsItWas) {
  const Scenario scenario = ScenarioForTest(
      "leads = [\" x == 1->y == 2 \"]\n"
      "within = [{ after = \"x == 1\", then = \"y == 2\", ms = 2.5 }]\n");
  const std::vector<Requirement> read = RequirementsOf(scenario);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].Title(), "leads: x == 1 -> y == 2");
  EXPECT_EQ(read[1].Title(), "within 2.5 ms: x == 1 -> y == 2");
  EXPECT_EQ(read[1].within_us, 2500);
  Scenario again;
  AddRequirements(read, &again);
  EXPECT_EQ(again.within, scenario.within);
  EXPECT_EQ(again.leads, std::vector<std::string>{"x == 1 -> y == 2"});
  const std::string text = FormatScenario(scenario);
  EXPECT_THAT(text, HasSubstr("within = [{ after = \"x == 1\", then = \"y == 2\", ms = 2.5 }]\n"));
  EXPECT_EQ(FormatScenario(ParseScenario(text, "t.toml").value()), text);
}

struct WrongResponse {
  const char* keys;
  const char* message;  ///< how it begins
};

class WrongResponseTest : public testing::TestWithParam<WrongResponse> {};

TEST_P(WrongResponseTest, IsAnErrorAtItsPlace) {
  const std::string keys = GetParam().keys;
  auto scenario = ParseScenario("program = \"p.c\"\n" + keys, "t.toml");
  const std::string message =
      scenario.ok() ? RunWithRequirements(scenario.value(),
                                          CompileForTest("int x, y;\nint f()\n{\n  GT_Delay(1);\n"
                                                         "  return 0;\n}\n"),
                                          {})
                          .error()
                          .message.en
                    : scenario.error().message.en;
  EXPECT_THAT(message, testing::StartsWith(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Forms, WrongResponseTest,
    testing::Values(
        WrongResponse{"leads = [\"x == 1\"]",
                      "t.toml:2:10: 'x == 1' must be two conditions with '->'"},
        WrongResponse{"leads = [\"-> x\"]",
                      "t.toml:2:10: ' -> x' must be two conditions with '->'"},
        WrongResponse{"leads = [\"x ->\"]", "t.toml:2:10: 'x' must be two conditions with '->'"},
        WrongResponse{"leads = [\"x -> y -> x\"]",
                      "t.toml:2:10: 'x -> y -> x' has more than one '->'"},
        WrongResponse{"leads = [\"x -> z\"]", "t.toml:2:10: nothing is named 'z'"},
        WrongResponse{"leads = [\"x -> y = 1\"]", "t.toml:2:10: '=' is not expected in 'y = 1'"},
        WrongResponse{"within = [{ after = \"x\", then = \"z\", ms = 1 }]",
                      "t.toml:2:33: nothing is named 'z'"},
        WrongResponse{"within = [{ after = \"w\", then = \"y\", ms = 1 }]",
                      "t.toml:2:21: nothing is named 'w'"},
        WrongResponse{"within = [{ after = \"x -> y\", then = \"y\", ms = 1 }]",
                      "t.toml:2:21: 'x -> y -> y' has more than one '->'"},
        WrongResponse{"within = [{ after = \"x\", then = \"y\", ms = -1 }]",
                      "t.toml:2:43: 'ms' must be a time in ms, from 0 to 1000000000"},
        WrongResponse{"within = [{ after = \"x\", then = \"y\", ms = \"1\" }]",
                      "t.toml:2:43: 'ms' must be a time in ms, from 0 to 1000000000"},
        WrongResponse{"within = [{ after = \"x\", then = \"y\" }]",
                      "t.toml:2:11: 'ms' is missing: a response is written as in { after = "},
        WrongResponse{"within = [{ after = \"x\", ms = 1 }]", "t.toml:2:11: 'then' is missing"},
        WrongResponse{"within = [\"x -> y\"]", "t.toml:2:"},
        WrongResponse{
            "within = [{ after = \"x\", then = \"y\", ms = 70000 }]",
            "t.toml:2:43: nothing can be late: the run ends after 60000 ms at the latest"},
        WrongResponse{"until_ms = 4\nwithin = [{ after = \"x\", then = \"y\", ms = 4.001 }]",
                      "t.toml:3:43: nothing can be late: the run ends after 4 ms at the latest"}));

TEST(Response, NeedsTimeThatPasses) {
  const char* program = "int x;\nint f()\n{\n  x = 1;\n  return 0;\n}\n";
  const std::string keys = "within = [{ after = \"x\", then = \"!x\", ms = 1 }]\n";
  const auto none = RunWithRequirements(ScenarioForTest(keys), CompileForTest(program), {});
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error().message.en,
              testing::StartsWith("t.toml:2:44: no time passes in a program that calls no GT "
                                  "commands: use 'leads', or give the run an end with 'until_ms'"));
  const auto ends =
      RunWithRequirements(ScenarioForTest("until_ms = 2\n" + keys), CompileForTest(program), {});
  ASSERT_TRUE(ends.ok());
  EXPECT_EQ(ends.value().failures.size(), 1u);
}

// --- One run -------------------------------------------------------------------------------------

// With 100 statements per ms, each of the parts before a delay is executed in one cycle: x is 1
// from 0.25 ms on, y from the cycle on in which a delay of 2 ms is over.
constexpr const char* kAnswer =
    "int x, y;\nint f()\n{\n  x = 1;\n  GT_Delay(2);\n  y = 1;\n  x = 0;\n  GT_Delay(2);\n"
    "  return 0;\n}\n";

std::vector<std::string> Failures(const std::string& keys) {
  std::vector<std::string> texts;
  const auto run = RunWithRequirements(ScenarioForTest(keys), CompileForTest(kAnswer), {});
  if (!run.ok()) return {run.error().message.en};
  for (const ScenarioFailure& failure : run.value().failures) {
    texts.push_back(failure.expectation + ": " + failure.message.en);
  }
  return texts;
}

std::string Within(const char* ms) {
  return std::string("within = [{ after = \"x == 1\", then = \"y == 1\", ms = ") + ms + " }]\n";
}

TEST(Response, IsGivenUpToItsLastInstant) {
  // y is 1 in the cycle that begins at 2.25 ms, two after that of x.
  EXPECT_THAT(Failures(Within("2")), ElementsAre());
  EXPECT_THAT(Failures(Within("2.249")), ElementsAre());
  EXPECT_THAT(
      Failures(Within("1.999")),
      ElementsAre("within 1.999 ms: x == 1 -> y == 1: 'x == 1' held after thread 0 has executed "
                  "p.c:4, at 0.25 ms, and 'y == 1' did not within 1.999 ms; too late at 2.25 ms: y "
                  "is 0"));
  // In the same cycle.
  EXPECT_THAT(Failures("within = [{ after = \"y == 1\", then = \"x == 0\", ms = 0 }]\n"),
              ElementsAre());
  EXPECT_THAT(Failures(Within("0")).size(), 1u);
}

TEST(Response, IsNotLateBeforeItsTimeIsOver) {
  const std::string keys = "within = [{ after = \"x == 1\", then = \"y == 2\", ms = 1.5 }]\n";
  EXPECT_THAT(Failures("until_ms = 1.75\n" + keys), ElementsAre());
  EXPECT_EQ(Failures("until_ms = 2\n" + keys).size(), 1u);
}

TEST(Response, MustComeBeforeTheEnd) {
  EXPECT_THAT(Failures("leads = [\"x == 1 -> y == 1\"]\n"), ElementsAre());
  // The state after line 6 answers itself; the one after line 7 waits.
  EXPECT_THAT(
      Failures("leads = [\"y == 1 -> x == 1\"]\n"),
      ElementsAre("leads: y == 1 -> x == 1: 'y == 1' held after thread 0 has executed p.c:7, at "
                  "2.25 ms, and 'x == 1' neither then nor later: x is 0"));
  EXPECT_EQ(Failures("until_ms = 1\nleads = [\"x == 1 -> y == 1\"]\n").size(), 1u);
}

TEST(Response, IsUntestedWhereItsLeftSideNeverHeld) {
  const auto warnings = [](const std::string& keys) {
    std::vector<std::string> texts;
    const auto run = RunWithRequirements(ScenarioForTest(keys), CompileForTest(kAnswer), {});
    for (const Message& warning : run.value().warnings) texts.push_back(warning.en);
    return texts;
  };
  EXPECT_THAT(warnings("leads = [\"x == 2 -> y == 1\"]\n"),
              ElementsAre("'leads: x == 2 -> y == 1' was met by its left side alone: 'x == 2' "
                          "never held"));
  EXPECT_THAT(warnings("within = [{ after = \"y == 2\", then = \"x == 1\", ms = 1 }]\n"),
              ElementsAre("'within 1 ms: y == 2 -> x == 1' was met by its left side alone: 'y == "
                          "2' never held"));
  EXPECT_THAT(warnings("leads = [\"x == 1 -> y == 1\"]\n"), ElementsAre());
}

}  // namespace
}  // namespace oncard::runtime
