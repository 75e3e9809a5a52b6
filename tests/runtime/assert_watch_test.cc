// Asserts in one run: checked when their statement is executed, in the state before it.
#include "runtime/scenario/run/assert_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/scenario/run/requirement_watch.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kOneThread = "[[thread]]\nfunction = \"f\"\n";

ScenarioResult RunOf(const std::string& program, const std::string& scenario = kOneThread) {
  auto result = RunWithRequirements(ScenarioForTest(scenario), CompileForTest(program), {});
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message.en);
  return result.ok() ? std::move(result).value() : ScenarioResult();
}

/// `assert: message` of every failure.
std::vector<std::string> AssertFailures(const std::string& program,
                                        const std::string& scenario = kOneThread) {
  std::vector<std::string> texts;
  for (const ScenarioFailure& failure : RunOf(program, scenario).failures) {
    texts.push_back(failure.expectation + ": " + failure.message.en);
  }
  return texts;
}

TEST(AssertWatchTest, LooksAtTheStateBeforeTheStatement) {
  EXPECT_THAT(AssertFailures("int x;\nint f() {\n  //@ assert: x == 0\n  x = 5;\n"
                             "  //@ assert: x == 5\n  x = 6;\n  return 0;\n}\n"),
              IsEmpty());
  EXPECT_THAT(AssertFailures("int x;\nint f() {\n  x = 5;\n  //@ assert: x < 3\n"
                             "  x = 1;\n  return 0;\n}\n"),
              ElementsAre("assert: x < 3: does not hold at p.c:5 in thread 0: x is 5"));
}

TEST(AssertWatchTest, IsReportedOnceForAllPasses) {
  EXPECT_THAT(AssertFailures("int x;\nint f() {\n  int c;\nagain:\n  //@ assert: x != 1 && x != 2\n"
                             "  x = x + 1;\n  c = x < 4;\n  if (c) goto again;\n  return 0;\n}\n"),
              ElementsAre("assert: x != 1 && x != 2: does not hold at p.c:6 in thread 0: x is 1"));
}

// The thread of g stands at its statement from the start.
TEST(AssertWatchTest, DoesNotLookWhileAThreadOnlyStandsThere) {
  const std::string program =
      "int x;\nint f() {\n  x = 1;\n  return 0;\n}\nint g() {\n  //@ assert: x == 1\n"
      "  x = 2;\n  return 0;\n}\n";
  EXPECT_THAT(AssertFailures(program,
                             "[[thread]]\nfunction = \"f\"\n"
                             "[[thread]]\nthread = 1\nfunction = \"g\"\n"),
              IsEmpty());
  EXPECT_THAT(AssertFailures(program,
                             "[[thread]]\nfunction = \"g\"\n"
                             "[[thread]]\nthread = 1\nfunction = \"f\"\n"),
              testing::SizeIs(1));
}

TEST(AssertWatchTest, TakesALocalOfItsThread) {
  const std::string program =
      "int other;\nint f(int n, int k) {\n  //@ assert: n == k\n  k = 9;\n  return n;\n}\n";
  EXPECT_THAT(AssertFailures(program,
                             "[[thread]]\nfunction = \"f\"\ninit = { n = 4, k = 4 }\n"
                             "[[thread]]\nthread = 3\npage = 5\nfunction = \"f\"\n"
                             "init = { n = 7, k = 8 }\n"),
              ElementsAre("assert: n == k: does not hold at p.c:4 in thread 3: n is 7, k is 8"));
}

// The sum is 5 when the assert is reached the last time; the loop variable has another name.
TEST(AssertWatchTest, SpeaksOfStructuredCAsItsSourceDoes) {
  EXPECT_THAT(AssertFailures("//@ structured\nint t[2][2];\nint add(int n) {\n"
                             "  //@ assert: n < 2 && t[1][0] == 0\n  return n + 1;\n}\n"
                             "int f() {\n  int i, sum = 0;\n"
                             "  for (i = 0; i < 3; ++i) sum += add(i);\n  return sum;\n}\n"),
              ElementsAre("assert: n < 2 && t[1][0] == 0: does not hold at p.c:5 in thread 0: "
                          "n is 2, t[1][0] is 0"));
}

TEST(AssertWatchTest, SeesTheCardAndOtherNames) {
  EXPECT_THAT(AssertFailures("int f() {\n  //@ assert: axis1.moving == 1 || clock > 100\n"
                             "  return 0;\n}\n"),
              ElementsAre("assert: axis1.moving == 1 || clock > 100: does not hold at p.c:3 in "
                          "thread 0: axis1.moving is 0, clock is 0"));
}

TEST(AssertWatchTest, GivesValuesTheirUnits) {
  EXPECT_THAT(AssertFailures("int f() {\n  //@ assert: axis1.prfPos > 1\n  return 0;\n}\n",
                             std::string(kOneThread) + "[[world.axis]]\naxis = 1\nunit = \"mm\"\n"
                                                       "pulses_per_unit = 1000\n"),
              ElementsAre(testing::ContainsRegex("axis1.prfPos is 0[.0]* mm$")));
}

TEST(AssertWatchTest, SaysWhatWasNeverTested) {
  const ScenarioResult result = RunOf(
      "int x;\nint f() {\n  if (x) goto E;\n  return 0;\nE:\n  //@ assert: x < 3\n  return "
      "1;\n}\n");
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_EQ(result.warnings[0].en, "'assert: x < 3' was never tested: no thread executed p.c:7");
  EXPECT_TRUE(result.passed());
}

TEST(AssertWatchTest, RefusesWhatIsNoConditionOfTheThread) {
  for (const auto& [condition, why] : std::vector<std::pair<std::string, std::string>>{
           {"x <", "p.c:4: assert: x <"}, {"z == 1", "p.c:4: assert: z == 1"}}) {
    const auto checked = CheckWithRequirements(
        ScenarioForTest(kOneThread),
        CompileForTest("int x;\nint f() {\n  //@ assert: " + condition + "\n  return x;\n}\n"));
    ASSERT_FALSE(checked.ok()) << condition;
    EXPECT_THAT(checked.error().message.en, HasSubstr(why));
  }
}

}  // namespace
}  // namespace oncard::runtime
