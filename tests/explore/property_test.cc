// Expressions over a program's variables (explore/models/property.h).
#include "explore/models/property.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explore_programs.h"
#include "runtime/conditions/card_condition.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

/// The values of a text for a model or a card.
template <typename Bound, typename Names>
Result<Bound> Read(std::string_view text, const Names& names) {
  auto condition = runtime::ParseCondition(text);
  if (!condition.ok()) return condition.error();
  return Bound::Bind(std::move(condition).value(), names);
}

class PropertyTest : public ::testing::Test {
 protected:
  PropertyTest()
      : problem_(ProblemOf("int x, a[3];\ndouble d;\n//@ init: x=6\n"
                           "int t0() {\n  int v;\n  v = 9;\n  a[1] = v;\n  d = 2.5;\n"
                           "  return 11;\n}\n")) {
    while (problem_.model.Running(0)) problem_.model.Step(0);
  }
  bool Holds(const char* text) {
    auto property = Read<Property>(text, problem_.model);
    EXPECT_TRUE(property.ok()) << text << ": " << property.error().message.en;
    return property.ok() && property.value().Holds(problem_.model);
  }
  std::string Error(const char* text) {
    auto property = Read<Property>(text, problem_.model);
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

// Names of structured C; `m[1]` is an element on the card.
TEST(PropertyNames, OfStructuredC) {
  Problem problem = ProblemOf(
      "//@ structured\nstruct axis { int target; double gains[2]; } axis[3];\nint m[2][3];\n"
      "//@ init: axis[2].target=6, m[0][1]=4\n"
      "void t0() {\n  struct axis old = axis[2];\n  old.target++;\n"
      "  axis[1].gains[1] = 2.5;\n  m[1][2] = old.target;\n}\n");
  while (problem.model.Running(0)) problem.model.Step(0);
  const auto read = [&problem](const char* text) -> std::string {
    const auto property = Read<Property>(text, problem.model);
    if (!property.ok()) return property.error().message.en;
    return property.value().Holds(problem.model) ? "holds" : "does not hold";
  };
  EXPECT_EQ(read("axis[2].target == 6 && axis[1].gains[1] == 2.5"), "holds");
  EXPECT_EQ(read("m[1][2] == 7 && m[5] == 7 && m[0][1] == 4 && m[1] == 4"), "holds");
  EXPECT_EQ(read("axis[1].target == 6"), "does not hold");
  EXPECT_EQ(read("page0.old.target == 7"), "holds");
  EXPECT_EQ(read("axis[2].taget == 6"), "'axis[2]' has no member 'taget'; did you mean 'target'?");
  EXPECT_EQ(read("axis[2] == 6"),
            "'axis[2]' has 3 elements: write one of them, such as 'axis[2].target'");
  EXPECT_EQ(read("axis[3].target == 6"), "'axis' has elements 0 to 2, not 3");
  const auto in_thread = runtime::ParseCondition("old.target == 7 && axis[2].target == 6");
  const auto property = Property::BindInThread(in_thread.value(), 0, problem.model);
  ASSERT_TRUE(property.ok()) << property.error().message.en;
  EXPECT_TRUE(property.value().Holds(problem.model));
}

/// Words that libraries read as numbers, and names with another meaning if there is no such global.
class AGlobalsName : public ::testing::TestWithParam<const char*> {};

TEST_P(AGlobalsName, IsThatGlobalEvenIf) {
  const std::string name = GetParam();
  const std::string declaration = "int " + name + ";\n";
  const std::string text = name + " == 5";

  const Problem problem =
      ProblemOf(declaration + "//@ init: " + name + "=5\nint t0() {\n  return 7;\n}\n");
  const auto property = Read<Property>(text, problem.model);
  ASSERT_TRUE(property.ok()) << property.error().message.en;
  EXPECT_TRUE(property.value().Holds(problem.model));

  CardModel card =
      CardOf(declaration + "int t0() {\n  return 7;\n}\n", "[globals]\n" + name + " = 5\n");
  card.Load(card.Start());
  const auto of_card = Read<runtime::CardCondition>(text, card.controller());
  ASSERT_TRUE(of_card.ok()) << of_card.error().message.en;
  EXPECT_TRUE(of_card.value().Holds(card.controller()));
}

INSTANTIATE_TEST_SUITE_P(PropertyTest, AGlobalsName,
                         ::testing::Values("inf", "nan", "infinity", "INF", "NaN", "ret0", "e5",
                                           "clock", "x"));

TEST_F(PropertyTest, WordsAreNoNumbers) {
  for (const char* word : {"inf", "nan", "infinity", "-inf", "-nan"}) {
    EXPECT_THAT(Error((std::string("x < ") + word).c_str()), HasSubstr("no variable"));
  }
}

// The operators are tested with the language; here they are applied to the model's values.
TEST_F(PropertyTest, Operators) {
  EXPECT_TRUE(Holds("-x + 6 == 0 && !(d > 2.5) && a[1] * 2 == 18"));
  EXPECT_TRUE(Holds("d == 2.75 +- 0.25"));
  EXPECT_FALSE(Holds("x == 5"));
}

TEST_F(PropertyTest, ErrorsSayWhatToDo) {
  EXPECT_THAT(Error("y == 1"), HasSubstr("no variable 'y'"));
  EXPECT_THAT(Error("x =="), HasSubstr("missing"));
  EXPECT_THAT(Error("x == 1 @ 5ms"), HasSubstr("only 'expect'"));
  EXPECT_THAT(Error("a == 1"), HasSubstr("3 elements"));
  EXPECT_THAT(Error("a[3] == 1"), HasSubstr("elements 0 to 2"));
  EXPECT_THAT(Error("ret7 == 1"), HasSubstr("no thread 7"));
  EXPECT_THAT(Error("page0.w == 1"), HasSubstr("'w'"));
}

}  // namespace
}  // namespace oncard::explore
