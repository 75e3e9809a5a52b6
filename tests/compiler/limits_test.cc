// Every limit of the language, at the limit and one beyond it.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "tests/compiler/compiler_support.h"

namespace oncard::compiler {
namespace {

using testing::HasSubstr;

using Codes = std::vector<int>;

std::string Repeat(int count, const std::function<std::string(int)>& piece) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece(i);
  return text;
}

std::string Function(const std::string& body) { return fmt::format("int t0() {{\n{}}}\n", body); }

TEST(Limits, Globals) {
  EXPECT_TRUE(CompileString("int a[1000]; TPid p; int b[16];\n" + Function("")).ok());
  EXPECT_EQ(
      CodesOf(CompileString("int a[1000]; TPid p; int b[16]; int c; int d;\n" + Function(""))),
      Codes{6});
}

TEST(Limits, Locals) {
  EXPECT_TRUE(CompileString("int t0(int p) { int a[1023]; a[0] = p; }\n").ok());
  EXPECT_EQ(CodesOf(CompileString("int t0(int p) { int a[1024]; int b; b = p; }\n")), Codes{7});
}

TEST(Limits, Functions) {
  const auto function = [](int i) { return fmt::format("int f{}() {{ return 0; }}\n", i); };
  EXPECT_TRUE(CompileString(Repeat(32, function)).ok());
  EXPECT_EQ(CodesOf(CompileString(Repeat(34, function))), Codes{10});
}

TEST(Limits, Parameters) {
  const auto parameter = [](int i) { return fmt::format("{}int p{}", i > 0 ? ", " : "", i); };
  EXPECT_TRUE(
      CompileString(fmt::format("int t0({}) {{ return 0; }}\n", Repeat(32, parameter))).ok());
  EXPECT_EQ(
      CodesOf(CompileString(fmt::format("int t0({}) {{ return 0; }}\n", Repeat(33, parameter)))),
      Codes{50});
}

TEST(Limits, Labels) {
  const auto label = [](int i) { return fmt::format("l{}:\n", i); };
  EXPECT_TRUE(CompileString(Function(Repeat(1024, label) + "return 0;\n")).ok());
  EXPECT_EQ(CodesOf(CompileString(Function(Repeat(1026, label) + "return 0;\n"))), Codes{9});
}

TEST(Limits, Macros) {
  const auto macro = [](int i) { return fmt::format("#define M{} 1\n", i); };
  EXPECT_TRUE(CompileString(Repeat(1024, macro) + Function("return M1023;\n")).ok());
  EXPECT_EQ(CodesOf(CompileString(Repeat(1026, macro) + Function("return M1024;\n"))), Codes{8});
}

TEST(Limits, Names) {
  const std::string longest(31, 'n');
  EXPECT_TRUE(CompileString(fmt::format("int {0};\nint t0() {{ {0} = 1; }}\n", longest)).ok());
  EXPECT_EQ(CodesOf(CompileString(fmt::format("int n{0};\nint t0() {{ n{0} = 1; }}\n", longest))),
            Codes{2});
}

TEST(Limits, Instructions) {
  const auto statement = [](int) { return std::string("v = 1;\n"); };
  const std::string begin = "int v; int t0() { start:\n";
  EXPECT_TRUE(CompileString(begin + Repeat(32766, statement) + "goto start;\n}\n").ok());
  EXPECT_EQ(CodesOf(CompileString(begin + Repeat(32767, statement) + "goto start; v = 2;\n}\n")),
            Codes{122});
}

TEST(Limits, ArraySizes) {
  EXPECT_TRUE(CompileString("int a[1024];\n" + Function("return a[1023];\n")).ok());
  EXPECT_EQ(CodesOf(CompileString("int a[1025];\n" + Function("return 0;\n"))), Codes{16});
  EXPECT_EQ(CodesOf(CompileString("int a[1024];\n" + Function("return a[1024];\n"))), Codes{17});
}

// The language has no sums at all: the message shows how to write them, as long as it can.
TEST(Limits, OperatorsInARow) {
  const auto sum = [](int terms) {
    return "int v;\n" +
           Function("v = v" + Repeat(terms - 1, [](int) { return std::string(" + v"); }) + ";\n");
  };
  EXPECT_EQ(CodesOf(CompileString(sum(201))), Codes{100});
  EXPECT_EQ(CodesOf(CompileString(sum(1000))), Codes{100});
  EXPECT_EQ(CodesOf(CompileString(sum(1001))), Codes{138});
  EXPECT_EQ(CodesOf(CompileString(sum(100'000))), Codes{138});
}

TEST(Limits, Errors) {
  std::string body;
  for (int i = 0; i < 60; ++i) body += fmt::format("u{} = 1;\n", i);
  Options options;
  const Compilation fifty = CompileString(Function(body), options);
  EXPECT_EQ(fifty.diagnostics.size(), 50u);
  ASSERT_EQ(fifty.diagnostics.back().notes.size(), 1u);
  EXPECT_THAT(fifty.diagnostics.back().notes[0].message.en, HasSubstr("10 more errors"));
  options.max_errors = 0;
  EXPECT_EQ(CompileString(Function(body), options).diagnostics.size(), 60u);
  options.max_errors = 1;
  EXPECT_EQ(CompileString(Function(body), options).diagnostics.size(), 1u);
}

}  // namespace
}  // namespace oncard::compiler
