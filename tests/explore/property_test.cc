// Expressions over a program's variables (explore/models/property.h).
#include "explore/models/property.h"

#include <gtest/gtest.h>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

class PropertyTest : public ::testing::Test {
 protected:
  PropertyTest()
      : problem_(ProblemOf("int x, a[3];\ndouble d;\n//@ init: x=6\n"
                           "int t0() {\n  int v;\n  v = 9;\n  a[1] = v;\n  d = 2.5;\n"
                           "  return 11;\n}\n")) {
    while (problem_.model.Running(0)) problem_.model.Step(0);
  }
  bool Holds(const char* text) {
    auto property = Property::Parse(text, problem_.model);
    EXPECT_TRUE(property.ok()) << text << ": " << property.error().message.en;
    return property.ok() && property.value().Holds(problem_.model);
  }
  std::string Error(const char* text) {
    auto property = Property::Parse(text, problem_.model);
    EXPECT_FALSE(property.ok()) << text;
    return property.ok() ? "" : property.error().message.en;
  }

  Problem problem_;
};

TEST_F(PropertyTest, Names) {
  EXPECT_TRUE(Holds("x == 6"));
  EXPECT_TRUE(Holds("a[1] == 9"));
  EXPECT_TRUE(Holds("d == 2.5"));
  EXPECT_TRUE(Holds("page0.v == 9"));
  EXPECT_TRUE(Holds("ret0 == 11"));
  EXPECT_TRUE(Holds("thread0.result == 11"));
}

/// Words that libraries take for numbers, and names that mean something else without the global.
class AGlobalsName : public ::testing::TestWithParam<const char*> {};

TEST_P(AGlobalsName, IsThatGlobalEvenIf) {
  const std::string name = GetParam();
  const std::string declaration = "int " + name + ";\n";
  const std::string text = name + " == 5";

  const Problem problem =
      ProblemOf(declaration + "//@ init: " + name + "=5\nint t0() {\n  return 7;\n}\n");
  const auto property = Property::Parse(text, problem.model);
  ASSERT_TRUE(property.ok()) << property.error().message.en;
  EXPECT_TRUE(property.value().Holds(problem.model));

  CardModel card =
      CardOf(declaration + "int t0() {\n  return 7;\n}\n", "[globals]\n" + name + " = 5\n");
  card.Load(card.Start());
  const auto of_card = Property::Parse(text, card.controller());
  ASSERT_TRUE(of_card.ok()) << of_card.error().message.en;
  EXPECT_TRUE(of_card.value().Holds(card.controller()));
}

INSTANTIATE_TEST_SUITE_P(PropertyTest, AGlobalsName,
                         ::testing::Values("inf", "nan", "infinity", "INF", "NaN", "ret0", "e5",
                                           "clock", "x"));

TEST_F(PropertyTest, WordsAreNoNumbers) {
  for (const char* word : {"inf", "nan", "infinity", "-inf", "-nan"}) {
    EXPECT_NE(Error((std::string("x < ") + word).c_str()).find("no variable"), std::string::npos);
  }
}

TEST_F(PropertyTest, HexadecimalNumbers) { EXPECT_TRUE(Holds("x == 0x6")); }

/// Neither memory nor stack is used up by a text that somebody else has written.
TEST_F(PropertyTest, DeepAndLongTextsAreRefused) {
  const auto nested = [](int count) {
    return std::string(static_cast<size_t>(count), '(') + "x" +
           std::string(static_cast<size_t>(count), ')');
  };
  EXPECT_TRUE(Holds((nested(Property::kNestingMax) + " == 6").c_str()));
  EXPECT_NE(Error(nested(Property::kNestingMax + 1).c_str()).find("nested too deeply"),
            std::string::npos);
  for (const char* prefix : {"(", "!", "-", "!("}) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += prefix;
    const std::string error = Error((text + "x").c_str());
    EXPECT_NE(error.find("nested too deeply: at most 100"), std::string::npos) << prefix;
    EXPECT_LT(error.size(), 200u);
  }
  std::string sum = "x";
  for (int i = 0; i < 100'000; ++i) sum += "+x";
  EXPECT_NE(Error(sum.c_str()).find("too long: at most 128"), std::string::npos);
}

TEST_F(PropertyTest, OperatorsBindAsInC) {
  EXPECT_TRUE(Holds("1 + 2 * 3 == 7"));
  EXPECT_TRUE(Holds("(1 + 2) * 3 == 9"));
  EXPECT_TRUE(Holds("1 || 0 && 0"));
  EXPECT_TRUE(Holds("1 < 2 == 1"));
  EXPECT_TRUE(Holds("!(x != 6)"));
  EXPECT_TRUE(Holds("-x + 6 == 0"));
  EXPECT_TRUE(Holds("5 - 2 - 1 == 2"));
  EXPECT_TRUE(Holds("x <= 6 && x >= 6 && !(x < 6) && !(x > 6)"));
  EXPECT_FALSE(Holds("x == 5"));
}

TEST_F(PropertyTest, ErrorsSayWhatToDo) {
  EXPECT_NE(Error("y == 1").find("no variable 'y'"), std::string::npos);
  EXPECT_NE(Error("x ==").find("missing"), std::string::npos);
  EXPECT_NE(Error("(x == 1").find("')' is missing"), std::string::npos);
  EXPECT_NE(Error("x == 1 ?").find("'?'"), std::string::npos);
  EXPECT_NE(Error("a == 1").find("3 elements"), std::string::npos);
  EXPECT_NE(Error("a[3] == 1").find("3 elements"), std::string::npos);
  EXPECT_NE(Error("ret7 == 1").find("no thread 7"), std::string::npos);
  EXPECT_NE(Error("page0.w == 1").find("'w'"), std::string::npos);
}

}  // namespace
}  // namespace oncard::explore
