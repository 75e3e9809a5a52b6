#include <gtest/gtest.h>

#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

Expectation Parse(const std::string& text) {
  auto parsed = ParseExpectation(text);
  EXPECT_TRUE(parsed.ok()) << text;
  return parsed.ok() ? parsed.value() : Expectation();
}

TEST(ParseExpectation, ReadsNameOperatorAndNumber) {
  const Expectation e = Parse("  sum==5050 ");
  EXPECT_EQ(e.text, "sum==5050");
  EXPECT_EQ(e.left, "sum");
  EXPECT_EQ(e.comparison, Comparison::kEqual);
  EXPECT_EQ(std::get<double>(e.right), 5050);
  EXPECT_FALSE(e.at_us.has_value());
}

TEST(ParseExpectation, ReadsNumbersAsUsersWriteThem) {
  EXPECT_EQ(std::get<double>(Parse("a == 0x1F").right), 31);
  EXPECT_EQ(std::get<double>(Parse("a == -0x10").right), -16);
  EXPECT_EQ(std::get<double>(Parse("a == -2.5").right), -2.5);
  EXPECT_EQ(std::get<double>(Parse("a == +3").right), 3);
}

TEST(ParseExpectation, ReadsANameOnTheRight) {
  EXPECT_EQ(std::get<std::string>(Parse("thread0.result == a[3]").right), "a[3]");
}

TEST(ParseExpectation, ReadsATolerance) {
  const Expectation e = Parse("x == 1.5 +- 0.25");
  EXPECT_EQ(std::get<double>(e.right), 1.5);
  EXPECT_EQ(e.tolerance, 0.25);
}

TEST(ParseExpectation, ReadsAnInstant) {
  EXPECT_EQ(Parse("gpo == 4 @ 12.5ms").at_us, 12500);
  EXPECT_EQ(Parse("gpo == 4 @1.5 s").at_us, 1500000);
  EXPECT_EQ(Parse("gpo == 4@0ms").at_us, 0);
}

TEST(ParseExpectation, RejectsWhatItCannotRead) {
  for (const char* text :
       {"", "sum", "sum =", "== 3", "sum == ", "sum == 3 3", "sum = 3", "sum == 3 @",
        "sum == 3 @ 5", "sum == 3 @ -1ms", "x == 1 +- -1", "x < 1 +- 1", "x == 1 +-", "3 == x",
        "sum === 3", "sum == 0x", "sum == --3"}) {
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
    testing::Values(ComparisonCase{"seven == 7", true}, ComparisonCase{"seven == 8", false},
                    ComparisonCase{"seven != 7", false}, ComparisonCase{"seven != 8", true},
                    ComparisonCase{"seven < 7", false}, ComparisonCase{"seven < 8", true},
                    ComparisonCase{"seven <= 7", true}, ComparisonCase{"seven <= 6", false},
                    ComparisonCase{"seven > 6", true}, ComparisonCase{"seven > 7", false},
                    ComparisonCase{"seven >= 7", true}, ComparisonCase{"seven >= 8", false},
                    ComparisonCase{"x == 1.25 +- 0.25", true},
                    ComparisonCase{"x == 1.25 +- 0.125", false},
                    ComparisonCase{"x != 1.25 +- 0.125", true},
                    ComparisonCase{"thread0.result == seven", true},
                    ComparisonCase{"x == seven", false}));

TEST(Expectation, TellsTheActualValues) {
  const ScenarioResult result =
      RunForTest("int a;\ndouble x;\nint f()\n{\n  a = 3;\n  x = 2.5;\n  return 0;\n}\n",
                 "expect = [\"a == 4\", \"a == x\"]");
  ASSERT_EQ(result.failures.size(), 2u);
  EXPECT_EQ(result.failures[0].expectation, "a == 4");
  EXPECT_EQ(result.failures[0].message.en, "a is 3");
  EXPECT_EQ(result.failures[1].message.en, "a is 3, x is 2.5");
  EXPECT_EQ(result.failures[1].message.zh, "a 为 3，x 为 2.5");
}

}  // namespace
}  // namespace oncard::runtime
