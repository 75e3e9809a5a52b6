// Conditions bound to a card (runtime/conditions/card_condition.h).
#include "runtime/conditions/card_condition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using testing::HasSubstr;

class CardConditionTest : public testing::Test {
 protected:
  CardConditionTest() {
    EXPECT_TRUE(controller_
                    .Load(CompileForTest("int sum, a[3], one[1], ret5;\ndouble d;\nint f()\n{\n"
                                         "  sum = 3;\n  a[1] = 9;\n  d = 2.5;\n  ret5 = 8;\n"
                                         "  return 11;\n}\n"))
                    .ok());
    controller_.machine().Bind(0, 1, 0);
    controller_.machine().Run(0);
    controller_.AdvanceUs(1000);
  }

  Result<CardCondition> Bind(const char* text) {
    auto condition = ParseCondition(text);
    EXPECT_TRUE(condition.ok()) << text;
    return CardCondition::Bind(std::move(condition).value(), controller_);
  }
  std::string ErrorOf(const char* text) {
    const auto bound = Bind(text);
    EXPECT_FALSE(bound.ok()) << text;
    return bound.ok() ? "" : bound.error().message.en;
  }

  Controller controller_;
};

TEST_F(CardConditionTest, ReadsWhatCanBeObserved) {
  for (const char* text :
       {"sum == 3", "a[1] == 9", "one == 0", "d == 2.5", "thread0.result == 11", "ret0 == 11",
        "ret5 == 8", "axis1.prfPos == 0", "gpo[1] == 0 || gpo[1] == 1", "clock == 1"}) {
    const auto bound = Bind(text);
    ASSERT_TRUE(bound.ok()) << text << ": " << bound.error().message.en;
    EXPECT_TRUE(bound.value().Holds(controller_)) << text;
  }
}

TEST_F(CardConditionTest, SaysWhichNameIsWrong) {
  EXPECT_EQ(ErrorOf("sam == 3"), "nothing is named 'sam'; did you mean 'sum'?");
  EXPECT_EQ(ErrorOf("sum == 3 && zz"), "nothing is named 'zz'");
  EXPECT_EQ(ErrorOf("a == 3"), "'a' is an array of 3 elements: write one of them, such as 'a[0]'");
  EXPECT_EQ(ErrorOf("a[3] == 3"), "'a' has elements 0 to 2, not 3");
  EXPECT_THAT(ErrorOf("ret32 == 3"), HasSubstr("threads are numbered 0 to 31"));
  EXPECT_EQ(ErrorOf("inf == 3"), "nothing is named 'inf'");
}

TEST_F(CardConditionTest, DescribesTheValuesOfItsNames) {
  const auto bound = Bind("sum == 4 && d < a[1] || sum == ret0");
  ASSERT_TRUE(bound.ok());
  EXPECT_EQ(bound.value().DescribeValues(controller_).en,
            "sum is 3, d is 2.5, a[1] is 9, thread0.result is 11");
  EXPECT_EQ(bound.value().DescribeValues(controller_).zh,
            "sum 为 3，d 为 2.5，a[1] 为 9，thread0.result 为 11");
  EXPECT_EQ(Bind("1 == 2").value().DescribeValues(controller_).en, "");
}

}  // namespace
}  // namespace oncard::runtime
