// The interface of the lowering: limits that take long programs, the costs, and the places of C
// that lines of the lowered text have. The constructs are tested by tests/lang/structured and
// tests/differential.
#include "compiler/lowering/lowering.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/compiler/memory_files.h"

namespace oncard::compiler {
namespace {

using testing::HasSubstr;

using Codes = std::vector<int>;

Lowering Lower(const std::string& program, const LoweringOptions& options = {}) {
  return LowerText("p.c", program, {}, options, NoFiles());
}

// One error of the given code, in the given line, and no text.
void ExpectError(const std::string& program, const Codes& codes, int line,
                 const std::string& words) {
  const Lowering lowering = Lower(program);
  EXPECT_FALSE(lowering.text.has_value());
  Codes reported;
  for (const Diagnostic& diagnostic : lowering.diagnostics) {
    reported.push_back(diagnostic.info->code);
  }
  ASSERT_EQ(reported, codes);
  const Diagnostic& diagnostic = lowering.diagnostics[0];
  EXPECT_EQ(lowering.files[0].LineOf(diagnostic.range.begin), line);
  EXPECT_THAT(diagnostic.message.en, HasSubstr(words));
}

TEST(LoweringLimits, LabelsOfAFunction) {
  std::string loops;
  for (int i = 0; i < 513; ++i) loops += "  while (v > 0) v = v - 1;\n";
  ExpectError("int v;\nvoid t0() {\n" + loops + "}\n", Codes{238}, 2, "1026 labels");
}

// Each function calls the next one four times: 4^12 copies of the last.
TEST(LoweringLimits, CopiesOfCalledFunctions) {
  std::string functions = "int v;\nvoid f0() { v++; }\n";
  for (int i = 1; i <= 12; ++i) {
    functions += fmt::format("void f{0}() {{ f{1}(); f{1}(); f{1}(); f{1}(); }}\n", i, i - 1);
  }
  ExpectError(functions, Codes{239}, 14, "'f12'");
}

TEST(LoweringLimits, LevelsOfCalls) {
  std::string functions = "int v;\nvoid f0() { v++; }\n";
  for (int i = 1; i <= 16; ++i) functions += fmt::format("void f{}() {{ f{}(); }}\n", i, i - 1);
  ExpectError(functions, Codes{130}, 18, "16 levels");
}

TEST(LoweringLimits, SlotsOfTheGlobalsNameTheLargest) {
  ExpectError("int a[100], b[700],\n  c[300];\nvoid t0() { a[0] = b[0] + c[0]; }\n", Codes{237}, 2,
              "1100 slots of 1024; the largest: b (700), c (300), a (100)");
}

TEST(Lowering, CountsWhatAFunctionTakes) {
  const Lowering lowering =
      Lower("int v, list[3];\nvoid t0(int n) {\n  while (n > 0) v += n--;\n}\n");
  ASSERT_EQ(lowering.costs.size(), 1u);
  const FunctionCost& cost = lowering.costs[0];
  EXPECT_EQ(cost.name, "t0");
  EXPECT_EQ(cost.statements, 6);
  EXPECT_EQ(cost.labels, 2);
  EXPECT_EQ(cost.temporaries, 1);
  EXPECT_EQ(cost.page_slots, 2);
  EXPECT_EQ(lowering.global_slots, 4);
}

TEST(Lowering, LinesKnowWhereTheyComeFrom) {
  const std::string program = "int v;\nvoid t0(int n) {\n  v = n * 2 + 1;\n}\n";
  const Lowering lowering = Lower(program);
  const SourceFile text("lowered.c", lowering.text.value());
  ASSERT_EQ(static_cast<size_t>(text.line_count()), lowering.origins.size());
  for (int line = 1; line <= text.line_count(); ++line) {
    if (text.Line(line) != "  tmp1 = n * 2;") continue;
    const SourceRange origin = lowering.origins[static_cast<size_t>(line) - 1];
    EXPECT_EQ(program.substr(origin.begin, origin.end - origin.begin), "n * 2");
    return;
  }
  FAIL() << *lowering.text;
}

// The command is checked in the lowered text.
TEST(Lowering, MessagesAboutTheLoweredTextHavePlacesOfC) {
  ExpectError("int v;\nvoid t0() {\n  if (v)\n    GT_SetVel(1);\n}\n", Codes{43}, 4,
              "GT_SetVel takes 2 arguments");
}

}  // namespace
}  // namespace oncard::compiler
