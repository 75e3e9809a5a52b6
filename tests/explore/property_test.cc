// Expressions over a program's variables (explore/property.h).
#include "explore/property.h"

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
