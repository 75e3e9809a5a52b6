// Names in a scenario that its program does not have (runtime/scenario/run/scenario_errors.h).
#include "runtime/scenario/run/scenario_errors.h"

#include <gtest/gtest.h>

#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

Message ErrorsOf(const Scenario& scenario, const RunOptions& options = {}) {
  const auto result = RunScenario(scenario, CompileForTest(kCount), options);
  return result.ok() ? Message{"it fits", "相符"} : result.error().message;
}

TEST(ScenarioErrors, EverythingIsToldAtOnceInTheOrderOfTheFile) {
  const Scenario scenario = ScenarioForTest(
      "trace = [\"n\", \"nn\"]\n"
      "schedule = \"rrr\"\n"
      "expect = [\"n == 1\", \"m == 1\"]\n"
      "[globals]\n"
      "q = 1\n"
      "n = [1, 2]\n"
      "[[host]]\n"
      "at_ms = 1\n"
      "set = { z = 1 }\n"
      "[[thread]]\n"
      "function = \"f\"\n"
      "init = { k = 1e12, j = 1 }\n"
      "[[thread]]\n"
      "thread = 1\n"
      "page = 0\n"
      "function = \"f\"\n");
  const std::string told = ErrorsOf(scenario).en;
  EXPECT_EQ(told,
            "t.toml:2:15: nothing is named 'nn'; did you mean 'n'?\n"
            "    2 | trace = [\"n\", \"nn\"]\n"
            "      |               ^~~~\n"
            "t.toml:3:12: " +
                vm::ParsePolicy("rrr").error().message.en +
                "\n    3 | schedule = \"rrr\"\n"
                "      |            ^~~~~\n"
                "t.toml:4:21: nothing is named 'm'\n"
                "    4 | expect = [\"n == 1\", \"m == 1\"]\n"
                "      |                     ^~~~~~~~\n"
                "t.toml:6:1: nothing is named 'q'\n"
                "    6 | q = 1\n"
                "      | ^\n"
                "t.toml:7:1: 'n' takes 1 values, not 2\n"
                "    7 | n = [1, 2]\n"
                "      | ^\n"
                "t.toml:10:9: nothing is named 'z'\n"
                "   10 | set = { z = 1 }\n"
                "      |         ^\n"
                "t.toml:13:10: 1000000000000 does not fit 'page0.k'\n"
                "   13 | init = { k = 1e12, j = 1 }\n"
                "      |          ^\n"
                "t.toml:13:20: nothing is named 'j'\n"
                "   13 | init = { k = 1e12, j = 1 }\n"
                "      |                    ^\n"
                "t.toml:16:8: thread 1 cannot have page 0: another thread has it\n"
                "   16 | page = 0\n"
                "      |        ^");
}

// Without the thread, names of threads and pages have no meaning: they are not reported in
// addition.
TEST(ScenarioErrors, WhatFollowsFromAMissingThreadIsNotTold) {
  const Scenario scenario = ScenarioForTest(
      "expect = [\"thread3.result == page3.k\", \"m == 1\"]\n"
      "trace = [\"page3.k\"]\n"
      "[[thread]]\n"
      "thread = 3\n"
      "function = \"other\"\n"
      "init = { x = 1 }\n");
  EXPECT_EQ(ErrorsOf(scenario).zh,
            "t.toml:2:40: 没有名为“m”的量\n"
            "    2 | expect = [\"thread3.result == page3.k\", \"m == 1\"]\n"
            "      |                                        ^~~~~~~~\n"
            "t.toml:6:12: 程序中没有函数“other”：只有 f\n"
            "    6 | function = \"other\"\n"
            "      |            ^~~~~~~");
}

TEST(ScenarioErrors, JudgesWhatDoesNotDependOnAMissingThread) {
  ScenarioErrors errors;
  EXPECT_TRUE(errors.CanJudge("page0.k == 1"));
  errors.MissThread();
  for (const char* text : {"page0.k == 1", "n == thread12.result", "!(ret0 + 1)", "page7.a[2]"}) {
    EXPECT_FALSE(errors.CanJudge(text)) << text;
  }
  for (const char* text : {"", "n == 1", "pages == 2", "ret == 0", "thread_0 == 1", "axis1.prfPos",
                           "my_page0 == 3", "x.thread == 1"}) {
    EXPECT_TRUE(errors.CanJudge(text)) << text;
  }
}

// Text from the command line has no place: it is reported after the errors in the file.
TEST(ScenarioErrors, WhatStandsNowhereIsToldInWords) {
  Scenario scenario = ScenarioForTest("expect = [\"m == 1\"]\n");
  scenario.globals.push_back(ParseInitialValue("q=1").value());
  scenario.threads.push_back(ParseThreadStart("0=g").value());
  scenario.expectations.push_back(ParseExpectation("l == 1").value());
  RunOptions options;
  options.show = {"r"};
  EXPECT_EQ(ErrorsOf(scenario, options).en,
            "t.toml:2:11: nothing is named 'm'\n"
            "    2 | expect = [\"m == 1\"]\n"
            "      |           ^~~~~~~~\n"
            "the program has no function 'g': it has f\n"
            "nothing is named 'q'\n"
            "'l == 1': nothing is named 'l'\n"
            "nothing is named 'r'");
}

TEST(ScenarioErrors, SynchronisingVariablesAreGlobals) {
  const vm::Object object = CompileForTest("int x, f[2], g;\nint t0() {\n int l;\n l = x;\n}\n");
  Scenario scenario;
  scenario.sync = {"flags", "f", "l"};
  ScenarioErrors errors;
  EXPECT_EQ(SyncGlobals(scenario, object, &errors), (std::vector<bool>{false, true, true}));
  ASSERT_TRUE(errors.Failure());
  EXPECT_EQ(errors.Failure()->message.en,
            "no global variable is named 'flags'\n"
            "no global variable is named 'l'");
}

TEST(ScenarioErrors, IsLookedAtWithoutARun) {
  const vm::Object object = CompileForTest(kCount);
  EXPECT_TRUE(CheckScenario(ScenarioForTest("expect = [\"n == 1\"]"), object).ok());
  const Scenario other = ScenarioForTest("expect = [\"m == 1\"]\n[globals]\nq = 1\n");
  const auto checked = CheckScenario(other, object);
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.error().message.en, ErrorsOf(other).en);
}

}  // namespace
}  // namespace oncard::runtime
