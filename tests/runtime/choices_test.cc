// What scenarios leave open, and the cases of that.
#include "runtime/scenario/run/choices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Choices ChoicesOf(const std::string& scenario) {
  return Choices::Of(ScenarioForTest(scenario)).value();
}

std::string RefusalOf(const std::string& scenario) {
  const auto choices = Choices::Of(ScenarioForTest(scenario));
  return choices.ok() ? "" : choices.error().message.en;
}

std::vector<std::string> TextsOf(const Choices& choices) {
  std::vector<std::string> texts;
  for (const Message& text : choices.Describe()) texts.push_back(text.en);
  return texts;
}

constexpr const char* kStop =
    "[[world.input]]\nindex = 1\nvalue = \"any\"\nbetween_ms = [10, 40]\n";

TEST(Choices, ThereAreNoneWhereNothingIsOpen) {
  const Choices choices = ChoicesOf("[[world.input]]\nindex = 1\nvalue = 1\nat_ms = 5\n");
  EXPECT_TRUE(choices.empty());
  EXPECT_EQ(choices.cases(), 1);
}

// Cycles of 250 us begin at 10, 10.25, ..., 40 ms: 30 / 0.25 + 1 of them.
TEST(Choices, AnEventComesWithAnyCycleBothEndsIncluded) {
  const Scenario scenario =
      ScenarioForTest("[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [10, 40]\n");
  const Choices choices = Choices::Of(scenario).value();
  EXPECT_EQ(choices.cases(), 121);
  EXPECT_THAT(TextsOf(choices), ElementsAre("gpi[1] at 10..40 ms (121 instants)"));
  EXPECT_EQ(choices.CaseOf(scenario, 0).world.inputs[0].at_us, 10'000);
  EXPECT_EQ(choices.CaseOf(scenario, 3).world.inputs[0].at_us, 10'750);
  EXPECT_EQ(choices.CaseOf(scenario, 120).world.inputs[0].at_us, 40'000);
  EXPECT_FALSE(choices.CaseOf(scenario, 3).world.inputs[0].last_us);
}

// Cases 0 to 120 are those of n = 1, and case 121 the first one of n = 2.
TEST(Choices, AValueIsCoveredByAnyCaseThatHasIt) {
  const Choices choices = ChoicesOf(
      "globals = { n = { any = [1, 10] } }\n"
      "[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [10, 40]\n");
  const auto after = [&](size_t cases) {
    std::vector<bool> searched(static_cast<size_t>(choices.cases()));
    for (size_t i = 0; i < cases; ++i) searched[i] = true;
    std::vector<std::string> texts;
    for (const CoveredChoice& choice : choices.Covered(searched)) {
      texts.push_back(DescribeCovered(choice).en);
    }
    return texts;
  };
  EXPECT_THAT(after(0), ElementsAre("0 of 121 instants of gpi[1], 10 to 40 ms",
                                    "0 of 10 values of n, 1 to 10"));
  EXPECT_THAT(after(36), ElementsAre("36 of 121 instants of gpi[1], 10 to 40 ms",
                                     "1 of 10 values of n, 1 to 10"));
  EXPECT_THAT(after(122), ElementsAre("121 of 121 instants of gpi[1], 10 to 40 ms",
                                      "2 of 10 values of n, 1 to 10"));
  std::vector<bool> last(1210);
  last.back() = true;
  const CoveredChoice instants = choices.Covered(last).front();
  EXPECT_EQ(instants.covered, 1);
  EXPECT_EQ(DescribeCovered(instants).zh, "gpi[1] 在 10 至 40 ms 的 121 个时刻中的 1 个");
}

// Of cycles of 1 ms those of 11 to 12 ms begin in this time.
TEST(Choices, OnlyCyclesThatBeginInTheTimeCount) {
  EXPECT_THAT(TextsOf(ChoicesOf("cycle_us = 1000\n[[world.input]]\nindex = 1\nvalue = 1\n"
                                "between_ms = [10.1, 12.9]\n")),
              ElementsAre("gpi[1] at 11..12 ms (2 instants)"));
}

TEST(Choices, FaultsBeginAtAnyInstantToo) {
  const Scenario scenario = ScenarioForTest(
      "[[world.fault]]\nkind = \"stall\"\naxis = 2\nbetween_ms = [1, 2]\nuntil_ms = 3\n");
  const Choices choices = Choices::Of(scenario).value();
  EXPECT_EQ(choices.cases(), 5);
  EXPECT_EQ(choices.DescribeCase(1).en, "axis2.stall at 1.25 ms");
  EXPECT_EQ(choices.CaseOf(scenario, 4).world.faults[0].at_us, 2000);
  EXPECT_EQ(choices.CaseOf(scenario, 4).world.faults[0].until_us, 3000);
}

TEST(Choices, ValuesAreAllWholeNumbersOfTheRange) {
  const Scenario scenario = ScenarioForTest(
      "globals = { mode = { any = [-1, 1] } }\n"
      "[[thread]]\nfunction = \"f\"\ninit = { k = { any = [1, 10] } }\n");
  const Choices choices = Choices::Of(scenario).value();
  EXPECT_EQ(choices.cases(), 30);
  EXPECT_THAT(TextsOf(choices), ElementsAre("mode in -1..1", "k in 1..10"));
  EXPECT_EQ(choices.DescribeCase(29).en, "mode = 1; k = 10");
  const Scenario last = choices.CaseOf(scenario, 29);
  EXPECT_THAT(last.globals[0].values, ElementsAre(1));
  EXPECT_THAT(last.threads[0].values[0].values, ElementsAre(10));
  EXPECT_TRUE(Choices::Of(last).value().empty());
}

TEST(Choices, LocalsOfOneNameAreNamedWithTheirPages) {
  EXPECT_THAT(TextsOf(ChoicesOf("[[thread]]\nfunction = \"f\"\ninit = { k = { any = [1, 2] } }\n"
                                "[[thread]]\nthread = 3\nfunction = \"f\"\n"
                                "init = { k = { any = [1, 3] } }\n")),
              ElementsAre("page0.k in 1..2", "page3.k in 1..3"));
}

// Neighbours differ in the instant of the first event.
TEST(Choices, TheFirstInstantChangesFastest) {
  const Choices choices = ChoicesOf(std::string("globals = { n = { any = [1, 10] } }\n") + kStop);
  EXPECT_EQ(choices.cases(), 2420);
  EXPECT_EQ(choices.DescribeCase(0).en, "gpi[1] = 0 at 10 ms; n = 1");
  EXPECT_EQ(choices.DescribeCase(1).en, "gpi[1] = 0 at 10.25 ms; n = 1");
  EXPECT_EQ(choices.DescribeCase(121).en, "gpi[1] = 1 at 10 ms; n = 1");
  EXPECT_EQ(choices.DescribeCase(242).en, "gpi[1] = 0 at 10 ms; n = 2");
  EXPECT_EQ(choices.DescribeCase(2419).zh, "gpi[1] = 1（40 ms）；n = 10");
}

TEST(Choices, AnInstantCanBeFixedWhereTheLevelIsOpen) {
  const Scenario scenario =
      ScenarioForTest("[[world.input]]\ntype = \"home\"\nindex = 2\nvalue = \"any\"\nat_ms = 3\n");
  const Choices choices = Choices::Of(scenario).value();
  EXPECT_THAT(TextsOf(choices), ElementsAre("home[2] in 0..1 at 3 ms"));
  EXPECT_EQ(choices.DescribeCase(1).en, "home[2] = 1 at 3 ms");
  EXPECT_EQ(choices.CaseOf(scenario, 1).world.inputs[0].value, 1u);
  EXPECT_EQ(choices.CaseOf(scenario, 1).world.inputs[0].at_us, 3000);
}

TEST(Choices, EventsOfACaseAreInOrderOfTime) {
  const Scenario scenario = ScenarioForTest(
      "[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [1, 3]\n"
      "[[world.input]]\nindex = 2\nvalue = 1\nat_ms = 2\n");
  const Choices choices = Choices::Of(scenario).value();
  EXPECT_EQ(choices.CaseOf(scenario, 0).world.inputs[0].index, 1);
  EXPECT_EQ(choices.CaseOf(scenario, 8).world.inputs[0].index, 2);
  EXPECT_EQ(choices.CaseOf(scenario, 8).world.inputs[1].at_us, 3000);
}

TEST(Choices, EveryCaseIsDifferent) {
  const Scenario scenario = ScenarioForTest(
      "globals = { n = { any = [1, 3] } }\n[[world.input]]\nindex = 1\nvalue = \"any\"\n"
      "between_ms = [0, 1]\n");
  const Choices choices = Choices::Of(scenario).value();
  std::set<std::string> texts;
  std::set<std::string> scenarios;
  for (int64_t number = 0; number < choices.cases(); ++number) {
    texts.insert(choices.DescribeCase(number).en);
    scenarios.insert(FormatScenario(choices.CaseOf(scenario, number)));
  }
  EXPECT_EQ(choices.cases(), 30);
  EXPECT_EQ(texts.size(), 30u);
  EXPECT_EQ(scenarios.size(), 30u);
}

TEST(Choices, SeedsDrawAllCases) {
  const Choices choices = ChoicesOf("globals = { n = { any = [1, 3] }, m = { any = [0, 1] } }\n");
  std::set<int64_t> drawn;
  for (uint64_t seed = 0; seed < 100; ++seed) drawn.insert(choices.Draw(seed));
  EXPECT_THAT(drawn, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(choices.Draw(7), choices.Draw(7));
}

// --- Mistakes ------------------------------------------------------------------------------------

struct WrongChoice {
  const char* scenario;
  const char* message;
};

class WrongChoices : public ::testing::TestWithParam<WrongChoice> {};

TEST_P(WrongChoices, AreRefused) {
  EXPECT_THAT(RefusalOf(GetParam().scenario), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongChoices,
    ::testing::Values(
        WrongChoice{
            "[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [1.1, 1.2]\n",
            ":5:14: no cycle begins in the time of gpi[1] from 1.1 to 1.2 ms, a cycle takes 0.25 "
            "ms: make 'between_ms' longer, or use 'at_ms'"},
        WrongChoice{"until_ms = 20\n[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [10, 40]\n",
                    ":6:14: gpi[1] comes from 10 to 40 ms, and the run ends at 20 ms ('until_ms')"},
        WrongChoice{
            "limit_ms = 30\n[[world.fault]]\nkind = \"stall\"\naxis = 1\nbetween_ms = [10, "
            "40]\n",
            ":6:14: axis1.stall comes from 10 to 40 ms, and the run ends at 30 ms ('limit_ms')"},
        WrongChoice{"globals = { a = [1, 2], \"a[1]\" = { any = [0, 1] } }\n",
                    "'a[1]' has a choice, and another value too: remove one of them"},
        WrongChoice{
            "globals = { n = { any = [1, 2000] }, m = { any = [1, 501] } }\n",
            ":2:13: the choices have 1002000 cases together, and there can be 1000000; n: 2000, "
            "m: 501"}));

// The later event of the two is the first one in the file.
TEST(Choices, ErrorsAreAtTheKeyOfTheirEvent) {
  EXPECT_THAT(
      RefusalOf("until_ms = 20\n[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [10, 40]\n"
                "[[world.input]]\nindex = 2\nvalue = \"any\"\nat_ms = 5\n"),
      HasSubstr(":6:14: gpi[1] comes from 10 to 40 ms"));
}

TEST(Choices, ThereAreAtMostAHundred) {
  const auto open = [](int count) {
    std::string scenario;
    for (int i = 0; i < count; ++i) {
      scenario += "globals.n" + std::to_string(i) + " = { any = [0, 0] }\n";
    }
    return scenario;
  };
  EXPECT_EQ(RefusalOf(open(100)), "");
  EXPECT_THAT(RefusalOf(open(101)),
              HasSubstr(":102:9: there are 101 choices, and there can be 100"));
}

// --- Runs ----------------------------------------------------------------------------------------

constexpr const char* kOpenCount =
    "[[thread]]\nfunction = \"f\"\ninit = { k = { any = [3, 9] } }\n";

TEST(Choices, ARunTakesTheFirstCaseAndSaysSo) {
  const ScenarioResult result = RunForTest(kCount, kOpenCount);
  EXPECT_EQ(result.values[0].elements[0], "3");
  EXPECT_EQ(result.choice.en, "k = 3");
  ASSERT_NE(result.chosen, nullptr);
  EXPECT_THAT(result.chosen->threads[0].values[0].values, ElementsAre(3));
}

TEST(Choices, ASeedDrawsTheCaseOfARun) {
  std::set<std::string> values;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    RunOptions options;
    options.seed = seed;
    const ScenarioResult result = RunForTest(kCount, kOpenCount, options);
    EXPECT_EQ(result.choice.en, "k = " + result.values[0].elements[0]);
    values.insert(result.values[0].elements[0]);
  }
  EXPECT_THAT(values, ElementsAre("3", "4", "5", "6", "7", "8", "9"));
}

TEST(Choices, ASeedWithoutChoicesIsAMistake) {
  RunOptions options;
  options.seed = 1;
  const auto run = RunScenario(ScenarioForTest(""), CompileForTest(kCount), options);
  ASSERT_FALSE(run.ok());
  EXPECT_THAT(run.error().message.en, HasSubstr("the seed draws choices"));
}

struct UnfitChoice {
  const char* scenario;
  const char* message;
};

class UnfitChoices : public ::testing::TestWithParam<UnfitChoice> {};

/// Although only the first case is run.
TEST_P(UnfitChoices, AreRefusedByARun) {
  const auto run = RunScenario(ScenarioForTest(GetParam().scenario),
                               CompileForTest("int n, a[3];\nint f()\n{\n  return n;\n}\n"));
  ASSERT_FALSE(run.ok());
  EXPECT_THAT(run.error().message.en, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, UnfitChoices,
    ::testing::Values(UnfitChoice{"globals = { none = { any = [0, 1] } }\n", "none"},
                      UnfitChoice{"globals = { n = { any = [2147483640, 2147483648] } }\n",
                                  "2147483648 does not fit 'n'"},
                      UnfitChoice{"globals = { n = { any = [-2147483649, -2147483640] } }\n",
                                  "-2147483649 does not fit 'n'"},
                      UnfitChoice{"globals = { a = { any = [0, 1] } }\n",
                                  "'a' is an array: choose for one of its elements"}));

}  // namespace
}  // namespace oncard::runtime
