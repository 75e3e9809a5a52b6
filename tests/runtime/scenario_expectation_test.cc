#include <gtest/gtest.h>

#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

TEST(ParseExpectation, ReadsAConditionAndItsInstant) {
  const auto parsed = ParseExpectation("  gpo==4 @ 12.5ms ");
  ASSERT_TRUE(parsed.ok());
  EXPECT_EQ(parsed.value().text(), "gpo==4 @ 12.5ms");
  EXPECT_EQ(parsed.value().at_us, 12500);
  EXPECT_FALSE(ParseExpectation("gpo == 4").value().at_us.has_value());
}

// One error of each kind; the tests of the condition language have the others.
TEST(ParseExpectation, RejectsWhatItCannotRead) {
  for (const char* text :
       {"", "sum =", "== 3", "sum == ", "sum == 3 3", "sum = 3", "sum == 3 @", "sum == 3 @ 5",
        "sum == 3 @ -1ms", "x == 1 +- -1", "x < 1 +- 1", "x == 1 +-", "sum === 3", "sum == 0x"}) {
    EXPECT_FALSE(ParseExpectation(text).ok()) << text;
  }
}

struct ComparisonCase {
  const char* text;
  bool holds;
};

class ComparisonTest : public testing::TestWithParam<ComparisonCase> {};

TEST_P(ComparisonTest, Decides) {
  const ScenarioResult result =
      RunForTest("int seven;\ndouble x;\nint f()\n{\n  seven = 7;\n  x = 1.5;\n  return 7;\n}\n",
                 std::string("expect = [\"") + GetParam().text + "\"]");
  EXPECT_EQ(result.passed(), GetParam().holds) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Comparisons, ComparisonTest,
    testing::Values(
        ComparisonCase{"seven == 7", true}, ComparisonCase{"seven == 8", false},
        ComparisonCase{"seven != 7", false}, ComparisonCase{"seven != 8", true},
        ComparisonCase{"seven < 7", false}, ComparisonCase{"seven < 8", true},
        ComparisonCase{"seven <= 7", true}, ComparisonCase{"seven <= 6", false},
        ComparisonCase{"seven > 6", true}, ComparisonCase{"seven > 7", false},
        ComparisonCase{"seven >= 7", true}, ComparisonCase{"seven >= 8", false},
        ComparisonCase{"x == 1.25 +- 0.25", true}, ComparisonCase{"x == 1.25 +- 0.125", false},
        ComparisonCase{"x != 1.25 +- 0.125", true}, ComparisonCase{"thread0.result == seven", true},
        ComparisonCase{"x == seven", false}, ComparisonCase{"seven == 7 && x == 1.5", true},
        ComparisonCase{"seven == 8 || x == 1.5", true}, ComparisonCase{"seven + x == 8.5", true},
        ComparisonCase{"2 * x == ret0 - 4", true}, ComparisonCase{"!(seven == 7 && x > 1)", false},
        ComparisonCase{"seven", true}, ComparisonCase{"!seven", false}));

TEST(Expectation, TellsTheActualValues) {
  const ScenarioResult result =
      RunForTest("int a;\ndouble x;\nint f()\n{\n  a = 3;\n  x = 2.5;\n  return 0;\n}\n",
                 "expect = [\"a == 4\", \"a == x\", \"a == 4 || x > 5 && a\", \"1 == 2\"]");
  ASSERT_EQ(result.failures.size(), 4u);
  EXPECT_EQ(result.failures[0].expectation, "a == 4");
  EXPECT_EQ(result.failures[0].message.en, "a is 3");
  EXPECT_EQ(result.failures[1].message.en, "a is 3, x is 2.5");
  EXPECT_EQ(result.failures[1].message.zh, "a 为 3，x 为 2.5");
  EXPECT_EQ(result.failures[2].message.en, "a is 3, x is 2.5");
  EXPECT_EQ(result.failures[3].message.en, "it names nothing that has a value");
}

// A thread's fault is not a failure if an expectation is about the thread's error.
TEST(Expectation, OfAFaultAllowsIt) {
  const char* program = "int a, z;\nint f()\n{\n  a = 1 / z;\n  return 0;\n}\n";
  for (const char* text :
       {"thread0.error == 100", "100 == thread0.error", "a == 0 && thread0.error == 100"}) {
    EXPECT_TRUE(RunForTest(program, std::string("expect = [\"") + text + "\"]").passed()) << text;
  }
  EXPECT_FALSE(RunForTest(program, "expect = [\"a == 0\"]").passed());
}

}  // namespace
}  // namespace oncard::runtime
