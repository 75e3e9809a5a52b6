// The language of conditions, without a card (runtime/conditions/condition.h).
#include "runtime/conditions/condition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace oncard::runtime {
namespace {

using ::testing::Not;

using testing::ElementsAre;
using testing::HasSubstr;

/// Evaluates the condition with these values for the names.
bool HoldsHere(const Condition& condition) {
  static const std::map<std::string, double> kValues = {{"x", 6},
                                                        {"y", 0.5},
                                                        {"zero", 0},
                                                        {"a[3]", 9},
                                                        {"s.member", -2},
                                                        {"ret0", 11},
                                                        {"inf", 5},
                                                        {"page0.a[1]", 4},
                                                        {"e5", 7},
                                                        {"_n", 1},
                                                        {"word", 4294967295.0},
                                                        {"axis1.prfPos", 50000.004}};
  return condition.Holds([&](size_t name) { return kValues.at(condition.names()[name]); });
}

std::string ConditionError(const std::string& text) {
  const auto parsed = ParseCondition(text);
  return parsed.ok() ? "" : parsed.error().message.en;
}

struct Meaning {
  const char* text;
  bool holds;
};

class ConditionMeaning : public testing::TestWithParam<Meaning> {};

TEST_P(ConditionMeaning, Is) {
  const auto condition = ParseCondition(GetParam().text);
  ASSERT_TRUE(condition.ok()) << GetParam().text << ": " << condition.error().message.en;
  EXPECT_EQ(HoldsHere(condition.value()), GetParam().holds) << GetParam().text;
  EXPECT_EQ(condition.value().text(), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(Names, ConditionMeaning,
                         testing::Values(Meaning{"x == 6", true}, Meaning{"x", true},
                                         Meaning{"zero", false}, Meaning{"a[3] == 9", true},
                                         Meaning{"a [ 3 ]==9", true},
                                         Meaning{"s.member == -2", true},
                                         Meaning{"page0.a[1] == 4", true},
                                         Meaning{"ret0 == 11", true}, Meaning{"_n == 1", true},
                                         // Words that look like numbers.
                                         Meaning{"inf == 5", true}, Meaning{"e5 == 7", true}));

INSTANTIATE_TEST_SUITE_P(Numbers, ConditionMeaning,
                         testing::Values(Meaning{"y == .5", true}, Meaning{"y == 5e-1", true},
                                         Meaning{"x == 6.", true}, Meaning{"x == 0x6", true},
                                         Meaning{"0x1e-3 == 27", true}, Meaning{"x == +6", true},
                                         Meaning{"s.member == -0x2", true},
                                         Meaning{"2e3 == 2000", true},
                                         Meaning{"1E+2-x == 94", true},
                                         Meaning{"word == 0xFFFFFFFF", true}));

INSTANTIATE_TEST_SUITE_P(
    Operators, ConditionMeaning,
    testing::Values(Meaning{"x == 5", false}, Meaning{"x != 6", false}, Meaning{"x != 5", true},
                    Meaning{"x < 6", false}, Meaning{"x < 7", true}, Meaning{"x <= 6", true},
                    Meaning{"x <= 5", false}, Meaning{"x > 6", false}, Meaning{"x > 5", true},
                    Meaning{"x >= 6", true}, Meaning{"x >= 7", false}, Meaning{"x + 1 == 7", true},
                    Meaning{"x - 1 == 5", true}, Meaning{"x * 2 == 12", true}, Meaning{"!x", false},
                    Meaning{"!zero", true}, Meaning{"-x == -6", true}, Meaning{"+x == 6", true},
                    Meaning{"zero || x", true}, Meaning{"zero || 0", false},
                    Meaning{"x && y", true}, Meaning{"x && zero", false}));

// As in C: one row for every two neighbouring levels, and the associativity of operators.
INSTANTIATE_TEST_SUITE_P(
    Precedence, ConditionMeaning,
    testing::Values(Meaning{"1 || 0 && 0", true}, Meaning{"(1 || 0) && 0", false},
                    Meaning{"0 && 0 == 0", false}, Meaning{"(0 && 0) == 0", true},
                    Meaning{"1 < 2 == 1", true}, Meaning{"0 == 1 < 2", false},
                    Meaning{"1 < 1 + 1", true}, Meaning{"1 + 2 * 3 == 7", true},
                    Meaning{"(1 + 2) * 3 == 9", true}, Meaning{"-2 * 3 == -6", true},
                    Meaning{"!0 + 1 == 2", true}, Meaning{"!(0 + 1)", false},
                    Meaning{"- - 3 == 3", true}, Meaning{"--3 == 3", true},
                    Meaning{"!!x == 1", true}, Meaning{"-(1 + 2) == -3", true},
                    Meaning{"5 - 2 - 1 == 2", true}, Meaning{"2 == 2 == 1", true},
                    Meaning{"3 > 2 > 1", false}, Meaning{"x == 5 || x == 6 && y == 0.5", true}));

INSTANTIATE_TEST_SUITE_P(
    Tolerances, ConditionMeaning,
    testing::Values(Meaning{"x == 6.25 +- 0.25", true}, Meaning{"x == 6.25+-0.125", false},
                    Meaning{"x != 6.25 +- 0.25", false}, Meaning{"x != 6.25 +- 0.125", true},
                    Meaning{"x == 6 +- 0", true}, Meaning{"x == 6.25 +- +0.25", true},
                    Meaning{"axis1.prfPos == 50000 +- 0.01", true},
                    // The tolerance belongs to the whole comparison, and only to this one.
                    Meaning{"x == 5 + 1.25 +- 0.25", true},
                    Meaning{"x == 7 +- 1 && y == 0.5", true},
                    Meaning{"y == 0 || x == 7 +- 1", true},
                    Meaning{"x == 6 && !(x == 6.25 +- 0.25)", false},
                    // With a blank between them, `+` and `-` are a sum with a negative number.
                    Meaning{"x == 7 + -1", true}));

// Values are doubles: they do not wrap as on the card.
INSTANTIATE_TEST_SUITE_P(Doubles, ConditionMeaning,
                         testing::Values(Meaning{"2147483647 + 1 == 2147483648", true},
                                         Meaning{"word + 1 == 4294967296", true},
                                         Meaning{"65536 * 65536 == 4294967296", true},
                                         Meaning{"1e308 * 10 == 1e308 * 10", true},
                                         Meaning{"1e308 * 10 == 1e308 * 10 +- 1", true}));

struct Mistake {
  const char* text;
  const char* error;
};

class ConditionMistake : public testing::TestWithParam<Mistake> {};

TEST_P(ConditionMistake, IsNamed) {
  EXPECT_EQ(ConditionError(GetParam().text), GetParam().error) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Operands, ConditionMistake,
    testing::Values(
        Mistake{"", "a variable or a number is missing in ''"},
        Mistake{"x ==", "a variable or a number is missing in 'x =='"},
        Mistake{"(", "a variable or a number is missing in '('"},
        Mistake{"()", "a variable or a number is missing in '()'"},
        Mistake{"== 3", "a variable or a number is missing before '==' in '== 3'"},
        Mistake{"x + * 3", "a variable or a number is missing before '*' in 'x + * 3'"},
        Mistake{"x == @ 3ms", "a variable or a number is missing in 'x == @ 3ms'"},
        Mistake{"x == 3x",
                "'3x' in 'x == 3x' is not a number: write it as in 12, 1.5, 2e3 or 0x1F"},
        Mistake{"x == 0x",
                "'0x' in 'x == 0x' is not a number: write it as in 12, 1.5, 2e3 or 0x1F"},
        Mistake{"x == 1e999",
                "'1e999' in 'x == 1e999' is not a number: write it as in 12, 1.5, 2e3 or 0x1F"},
        Mistake{"1.2.3", "'1.2.3' in '1.2.3' is not a number: write it as in 12, 1.5, 2e3 or 0x1F"},
        Mistake{"a[i] == 1", "an index in 'a[i] == 1' is not a number"},
        Mistake{"a[-1] == 1", "an index in 'a[-1] == 1' is not a number"},
        Mistake{"a[1.5] == 1", "an index in 'a[1.5] == 1' is not a number"},
        Mistake{"a[99999999999] == 1", "an index in 'a[99999999999] == 1' is not a number"},
        Mistake{"a[] == 1", "an index in 'a[] == 1' is not a number"},
        Mistake{"a[", "an index in 'a[' is not a number"},
        Mistake{"a[1 == 1", "']' is missing in 'a[1 == 1'"}));

INSTANTIATE_TEST_SUITE_P(
    Operators, ConditionMistake,
    testing::Values(
        Mistake{"x = 3", "'=' is not expected in 'x = 3'; a comparison is written '=='"},
        Mistake{"x === 3", "'=' is not expected in 'x === 3'; a comparison is written '=='"},
        Mistake{"x == 3 3", "'3' is not expected in 'x == 3 3'"},
        Mistake{"x y", "'y' is not expected in 'x y'"},
        Mistake{"x == 1 ?", "'?' is not expected in 'x == 1 ?'"},
        Mistake{"x / 2 == 3", "'/' is not expected in 'x / 2 == 3'"},
        Mistake{"x & 1", "'&' is not expected in 'x & 1'"},
        Mistake{"a[0](1) == 1", "'(' is not expected in 'a[0](1) == 1'"},
        Mistake{"轴 == 1", "'轴' is not expected in '轴 == 1'"},
        Mistake{"(x == 1", "')' is missing in '(x == 1'"},
        Mistake{"(x == 1 @ 3ms", "')' is missing in '(x == 1 @ 3ms'"},
        Mistake{"x == 1)", "')' is not expected in 'x == 1)'"}));

constexpr const char* kAloneTolerance =
    "the tolerance '+-' does not belong to '==' or '!='; a sum with a negative number is written "
    "with a blank: '+ -'";

TEST(ConditionTolerance, StandsAfterAnEqualityOnly) {
  for (const char* text : {"x < 1 +- 1", "x +- 1", "x +- 1 == 3", "x == 1 +- 1 +- 1",
                           "x == (1 +- 1)", "x == 1 || y +- 1"}) {
    EXPECT_THAT(ConditionError(text), HasSubstr(kAloneTolerance)) << text;
  }
  for (const char* text : {"x == 1 +-", "x == 1 +- -1", "x == 1 +- y", "x == 1 +- (1)"}) {
    EXPECT_THAT(ConditionError(text), HasSubstr("a positive number is missing after '+-'")) << text;
  }
  EXPECT_EQ(ConditionError("x == 1 +- 1 + 1"), "'+' is not expected in 'x == 1 +- 1 + 1'");
}

TEST(ConditionTolerance, IsKnown) {
  EXPECT_TRUE(ParseCondition("x > 1 && x == 1 +- 2").value().HasTolerance());
  EXPECT_FALSE(ParseCondition("x > 1 && x == 1 + 2").value().HasTolerance());
}

TEST(ConditionErrors, AreInBothLanguages) {
  EXPECT_EQ(ParseCondition("x = 3").error().message.zh, "“x = 3”中不应出现“=”；比较应写成“==”");
  EXPECT_EQ(ParseCondition("(x").error().message.zh, "“(x”中缺少“)”");
}

TEST(ConditionInstant, IsReadWhereItIsAllowed) {
  struct Case {
    const char* text;
    int64_t at_us;
  };
  for (const Case& test : {Case{"x == 6 @ 12.5ms", 12500}, Case{"x == 6 @1.5 s", 1500000},
                           Case{"x == 6@0ms", 0}, Case{" (x == 6) && 1 @ 1e9ms ", 1000000000000}}) {
    const auto parsed = ParseTimedCondition(test.text);
    ASSERT_TRUE(parsed.ok()) << test.text << ": " << parsed.error().message.en;
    EXPECT_EQ(parsed.value().at_us, test.at_us) << test.text;
    EXPECT_TRUE(HoldsHere(parsed.value().condition)) << test.text;
  }
  EXPECT_EQ(ParseTimedCondition("x == 6").value().at_us, std::nullopt);
  EXPECT_EQ(ParseTimedCondition("  x==6 @ 5ms ").value().condition.text(), "x==6 @ 5ms");
  for (const char* text : {"x == 3 @", "x == 3 @ 5", "x == 3 @ -1ms", "x == 3 @ infms",
                           "x == 3 @ 1ms @ 2ms", "x == 3 @ 2e9ms"}) {
    const auto parsed = ParseTimedCondition(text);
    ASSERT_FALSE(parsed.ok()) << text;
    EXPECT_THAT(parsed.error().message.en, HasSubstr("a time in ms or s is missing after '@'"))
        << text;
  }
  EXPECT_EQ(ConditionError("x == 3 @ 5ms"),
            "'x == 3 @ 5ms' has an instant, which only 'expect' can have: leave out '@' and what "
            "follows it");
}

TEST(Condition, NamesEachOnceInTheirOrder) {
  const auto condition = ParseCondition("b + a[1] == 0 || a[1] + a == b");
  ASSERT_TRUE(condition.ok());
  EXPECT_THAT(condition.value().names(), ElementsAre("b", "a[1]", "a"));
}

TEST(Condition, NamesOfStructuredC) {
  const auto condition =
      ParseCondition("axis[ 2 ].target == m[1] [2] && page0.list[1].inner.y[3] > .5");
  ASSERT_TRUE(condition.ok()) << condition.error().message.en;
  EXPECT_THAT(condition.value().names(),
              ElementsAre("axis[2].target", "m[1][2]", "page0.list[1].inner.y[3]"));
}

TEST(Condition, KnowsASimpleComparison) {
  const auto comparison = ParseCondition("x >= -2.5").value().AsComparison();
  ASSERT_TRUE(comparison.has_value());
  EXPECT_EQ(comparison->left, 0u);
  EXPECT_EQ(comparison->comparison, Condition::Kind::kGreaterEqual);
  EXPECT_EQ(std::get<double>(comparison->right), -2.5);
  EXPECT_EQ(comparison->tolerance, 0);

  const auto names = ParseCondition("(x) != y +- 0.25").value().AsComparison();
  ASSERT_TRUE(names.has_value());
  EXPECT_EQ(std::get<size_t>(names->right), 1u);
  EXPECT_EQ(names->tolerance, 0.25);

  for (const char* text : {"x", "3 == x", "x + 3", "!x", "x == -y", "x == 1 + 2", "x == 1 && y"}) {
    EXPECT_FALSE(ParseCondition(text).value().AsComparison().has_value()) << text;
  }
}

std::string Times(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

/// Untrusted text must not use up memory or stack.
TEST(ConditionLimits, DeepAndLongTextsAreRefused) {
  constexpr int kDepth = Condition::kNestingMax;
  EXPECT_EQ(ConditionError(Times(kDepth, "(") + "x" + Times(kDepth, ")")), "");
  EXPECT_THAT(ConditionError(Times(kDepth + 1, "(") + "x" + Times(kDepth + 1, ")")),
              HasSubstr("nested too deeply: at most 100"));
  // Closed parentheses do not count any more.
  EXPECT_THAT(ConditionError(Times(60, "(!x) + -y + ") + "1"), Not(HasSubstr("too deeply")));
  for (const char* prefix : {"(", "!", "-", "+ ", "!("}) {
    const std::string error = ConditionError(Times(100'000, prefix) + "x");
    EXPECT_THAT(error, HasSubstr("nested too deeply: at most 100")) << prefix;
    EXPECT_LT(error.size(), 200u);
  }
  EXPECT_EQ(ConditionError("x" + Times(63, "+x")), "");
  EXPECT_EQ(ConditionError("x" + Times(64, "+x")),
            "'x" + Times(39, "+x") + "+...' is too long: at most 128 names, numbers and operators");
  EXPECT_THAT(ConditionError("x" + Times(100'000, "+x")), HasSubstr("too long: at most 128"));
  EXPECT_LT(ConditionError(Times(100'000, "轴")).size(), 300u);
  EXPECT_LT(ConditionError(Times(100'000, "9") + "x").size(), 300u);
}

// A zero byte is treated like any other invalid character.
TEST(ConditionLimits, AByte0IsNotTheEnd) {
  EXPECT_FALSE(ParseCondition(std::string_view("x == 6\0 x", 9)).ok());
  EXPECT_FALSE(ParseTimedCondition(std::string_view("x == 6 @ 5ms\0", 13)).ok());
}

}  // namespace
}  // namespace oncard::runtime
