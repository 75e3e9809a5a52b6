// The interface of the lowering: limits that take long programs, the costs, and the places of C
// that lines of the lowered text have. The constructs are tested by tests/lang/structured and
// tests/differential.
#include "compiler/lowering/lowering.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/limits.h"
#include "tests/compiler/memory_files.h"

namespace oncard::compiler {
namespace {

using testing::HasSubstr;

using Codes = std::vector<int>;

Lowering Lower(const std::string& program, const LoweringOptions& options = {}) {
  return LowerText("p.c", program, {}, options, NoFiles());
}

// One error of the given code, in the given line, and no text.
void ExpectError(const std::string& program, const Codes& codes, int line, const std::string& words,
                 const LoweringOptions& options = {}) {
  const Lowering lowering = Lower(program, options);
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

// What is done for a function must not grow with the number of all functions.
TEST(LoweringLimits, TenThousandFunctions) {
  std::string functions;
  for (int i = 0; i < 10000; ++i) {
    functions += fmt::format("int f{0}(int a) {{ int b = a + {0}; return b; }}\n", i);
  }
  ExpectError(functions, Codes{10}, 33, "'f32' is one too many");
}

// Each function calls the next one four times: 4^12 copies of the last if calls are inlined.
TEST(LoweringLimits, CopiesOfCalledFunctions) {
  std::string functions = "int v;\nvoid f0() { v++; }\n";
  for (int i = 1; i <= 12; ++i) {
    functions += fmt::format("void f{0}() {{ f{1}(); f{1}(); f{1}(); f{1}(); }}\n", i, i - 1);
  }
  ExpectError(functions, Codes{239}, 14, "'f12'", {.optimize = false});
  EXPECT_TRUE(Lower(functions).text.has_value());
}

// Three hundred copies of two loops have 1200 labels.
TEST(LoweringLimits, LabelsOfCopiesAreFewerWithJumps) {
  std::string program =
      "int v;\nvoid pass(int n) {\n  while (n > 0) { v += n; n--; }\n"
      "  while (n < 9) { v -= n; n++; }\n}\nvoid t0() {\n";
  for (int i = 0; i < 300; ++i) program += fmt::format("  pass({});\n", i);
  program += "}\n";
  ExpectError(program, Codes{238}, 6, "1200 labels", {.optimize = false});
  const Lowering lowering = Lower(program);
  ASSERT_TRUE(lowering.text.has_value());
  ASSERT_EQ(lowering.costs[0].jumps.size(), 1u);
  EXPECT_EQ(lowering.costs[0].jumps[0].name, "pass");
  EXPECT_EQ(lowering.costs[0].jumps[0].calls, 300);
}

TEST(LoweringLimits, LevelsOfCalls) {
  std::string functions = "int v;\nvoid f0() { v++; }\n";
  for (int i = 1; i <= 16; ++i) functions += fmt::format("void f{}() {{ f{}(); }}\n", i, i - 1);
  ExpectError(functions, Codes{130}, 18, "16 levels");
}

std::string Times(int count, const std::string& piece) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

std::string Assigning(const std::string& value) {
  return "int v;\nvoid t0() {\n  v = " + value + ";\n}\n";
}

// A row is not nested: its length has a limit of its own.
TEST(LoweringLimits, OperatorsInARow) {
  for (const char* next : {" + v", " - v", ", v"}) {
    EXPECT_TRUE(Lower(Assigning("v" + Times(999, next))).text.has_value()) << next;
    ExpectError(Assigning("v" + Times(1000, next)), Codes{138}, 3, "1000");
  }
  // Each of these takes a level or a label more.
  for (const char* next : {" - v * v", " && v", " ? v : v"}) {
    EXPECT_TRUE(Lower(Assigning("v" + Times(300, next))).text.has_value()) << next;
    ExpectError(Assigning("v" + Times(1000, next)), Codes{138}, 3, "1000");
  }
  ExpectError(Assigning("v" + Times(100'000, " + v")), Codes{138}, 3, "1000");
  ExpectError(Assigning("v" + Times(100'000, " ? v : v")), Codes{138}, 3, "1000");
  // Every level is short and not deep, but all of them together are a high tree.
  ExpectError(Assigning(Times(99, "(") + "v" + Times(99, Times(20, " + v") + ")")), Codes{138}, 3,
              "1000");
}

TEST(LoweringLimits, LevelsOfParentheses) {
  const auto nested = [](int count) {
    return Assigning(Times(count, "(v + ") + "v" + Times(count, ")"));
  };
  EXPECT_TRUE(Lower(nested(99)).text.has_value());
  ExpectError(nested(100), Codes{130}, 3, "200");
}

TEST(LoweringLimits, StructuresInStructures) {
  struct Nesting {
    const char* begin;
    const char* innermost;
    const char* end;
    const char* name;
    int count;
  };
  // As members, in the sizes of members, and in the values of an enum. A definition in a size is
  // refused by itself, too.
  for (const Nesting& nesting : {Nesting{"struct { ", "int a; ", "} m; ", "", 250},
                                 {"struct { int a[sizeof(", "int", ")]; } ", "x; ", 150},
                                 {"struct { enum { A = sizeof(", "int", ") } e; } ", "x; ", 150}}) {
    const auto nested = [&nesting](int count) {
      return Lower(Times(count, nesting.begin) + nesting.innermost + Times(count, nesting.end) +
                   nesting.name + "\nint v;\nvoid t0() { v = 1; }\n");
    };
    const Lowering lowering = nested(nesting.count);
    EXPECT_FALSE(lowering.text.has_value());
    EXPECT_EQ(std::ranges::count(lowering.diagnostics, 130,
                                 [](const Diagnostic& found) { return found.info->code; }),
              1)
        << nesting.begin;
    EXPECT_FALSE(nested(6'000).text.has_value());
  }
}

TEST(LoweringLimits, BranchesInARow) {
  const auto ladder = [](int count) {
    return "int v;\nvoid t0() {\n  if (v == 1) v = 2;\n" +
           Times(count - 1, "else if (v == 3) v = 4;\n") + "}\n";
  };
  EXPECT_TRUE(Lower(ladder(300)).text.has_value());
  // The last 1000 of them would fit.
  ExpectError(ladder(20'000), Codes{138}, 2 + 20'000 - 1000, "1000");
}

// What a program becomes is longer than the program, and no limit of the card.
TEST(LoweringLimits, TheLoweredTextIsLongerThanAProgramMayBe) {
  const std::string statement =
      "a_sum_of_products_of_long_names = a_left_factor_with_a_long_name_ * "
      "a_right_factor_with_a_long_name + a_sum_of_products_of_long_names;\n";
  std::string text =
      "int a_sum_of_products_of_long_names, a_left_factor_with_a_long_name_,\n"
      "    a_right_factor_with_a_long_name;\n";
  for (int function = 0; function < 32; ++function) {
    text += fmt::format("void t{}() {{\n", function);
    for (int i = 0; i < 900; ++i) text += statement;
    text += "}\n";
  }
  ASSERT_LT(text.size(), kSourceKind.bytes_max);
  const Lowering lowering = Lower(text, {.comments = false});
  ASSERT_TRUE(lowering.object.has_value()) << lowering.diagnostics[0].message.en;
  EXPECT_GT(lowering.text->size(), kSourceKind.bytes_max);
}

// Each thread function has the comments of what it calls.
TEST(LoweringLimits, TheLoweredTextHasALimitOfItsOwn) {
  std::string text = "int v;\nstatic void called() {\n  /*\n";
  for (int line = 0; line < 24'000; ++line) text += std::string(95, '.') + "\n";
  text += "  */\n  v++;\n}\n";
  for (int function = 0; function < 32; ++function) {
    text += fmt::format("void t{}() {{ called(); }}\n", function);
  }
  EXPECT_TRUE(Lower(text, {.comments = false}).object.has_value());
  ExpectError(text, Codes{239}, 1, "'p.c' becomes too long");
}

TEST(LoweringLimits, SlotsOfTheGlobalsNameTheLargest) {
  ExpectError("int a[100], b[700],\n  c[300];\nvoid t0() { a[0] = b[0] + c[0]; }\n", Codes{237}, 2,
              "1100 slots of 1024; the largest: b (700), c (300), a (100)");
}

TEST(Lowering, NamesTheMemberThatIsMeant) {
  const Lowering lowering = Lower(
      "struct size { int width; };\nstruct size s = {.widht = 1};\nvoid t0() { s.widht = 2; }\n");
  ASSERT_EQ(lowering.diagnostics.size(), 2u);
  for (const Diagnostic& diagnostic : lowering.diagnostics) {
    ASSERT_EQ(diagnostic.notes.size(), 1u);
    EXPECT_EQ(diagnostic.notes[0].message.en, "did you mean 'width'?");
  }
}

TEST(Lowering, CommandsTakeTheAddressOfAStructure) {
  const Lowering lowering =
      Lower("TTrapPrm traps[2];\nvoid t0(int i) { GT_SetTrapPrm(1, (traps[i])); }\n");
  ASSERT_EQ(lowering.diagnostics.size(), 1u);
  EXPECT_THAT(lowering.diagnostics[0].message.en,
              testing::EndsWith("expected its address: '&traps[i]'"));
  EXPECT_THAT(lowering.diagnostics[0].message.zh, testing::HasSubstr("它的地址：'&traps[i]'"));
}

TEST(Lowering, ValuesAndFunctionsAreNoPlaces) {
  const Lowering lowering = Lower(
      "struct pair { int x; } a;\nstruct pair make() { return a; }\n"
      "void t0() { make().x = 1; a = make; }\n");
  ASSERT_EQ(lowering.diagnostics.size(), 2u);
  const Message& value = lowering.diagnostics[0].message;
  EXPECT_THAT(value.en,
              testing::HasSubstr("is a value and cannot stand here; expected a variable"));
  EXPECT_THAT(value.zh, testing::HasSubstr("变量、数组元素或它们的成员"));
  const Message& function = lowering.diagnostics[1].message;
  EXPECT_THAT(function.en,
              testing::HasSubstr("is a function and cannot stand here; expected a call"));
  EXPECT_THAT(function.zh, testing::HasSubstr("函数调用：'make(...)'"));
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

// A thread function that calls each of some functions three times.
std::string ManyCalls(int functions) {
  std::string text = "int g, h;\n";
  std::string calls;
  for (int i = 0; i < functions; ++i) {
    text += fmt::format(
        "int f{0}(int a) {{ int b = a ^ g, c = b * {0};\n  if (b > c) h += a;\n"
        "  g -= c; h ^= b; g += a * c; h -= b | a;\n  return g + c; }}\n",
        i);
    calls += fmt::format("  g = f{0}(h);\n  h = f{0}(g) + f{0}(1);\n", i);
  }
  return text + "void t0() {\n" + calls + "}\n";
}

// Of a long program not every choice of calls is tried, so the work grows as the program does.
TEST(Lowering, TriesToShortenCallsInLinearTime) {
  const auto tried = [](int functions) { return Lower(ManyCalls(functions)).tried_statements; };
  const int64_t some = tried(50);
  EXPECT_GT(some, 0);
  EXPECT_LE(tried(100), some * 21 / 10);
}

TEST(Lowering, SharesTheBodiesOfManyFunctions) {
  const Lowering lowering = Lower(ManyCalls(100));
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_EQ(lowering.costs[0].jumps.size(), 100u);
}

TEST(Lowering, LocalsThatOnlyFeedThemselvesAreLeftOut) {
  const Lowering lowering = Lower(
      "int v;\nvoid t0() {\n  int n = 0, m = 0;\n  while (v > 0) { v--; n = n + m; m = n + 1; "
      "}\n}\n");
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_THAT(*lowering.text, testing::Not(HasSubstr("\n  n = ")));
}

// Each of the calls is decided only when the result of the one before it is known.
TEST(Lowering, WhatIsKnownOutlivesBranchesThatAreDecided) {
  std::string calls;
  for (int i = 0; i < 200; ++i) calls += "  x += limited(x);\n";
  const Lowering lowering = Lower(
      "int v;\nstatic int limited(int a) { if (a > 900) return 900; return 3; }\n"
      "void t0() {\n  int x = 0;\n" +
      calls + "  v = x;\n}\n");
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_THAT(*lowering.text, HasSubstr("  v = 600;\n"));
  EXPECT_EQ(lowering.costs[0].statements, 1);
}

TEST(Lowering, WhatIsKnownEndsWhereSeveralWaysMeet) {
  const Lowering branch =
      Lower("int v;\nvoid t0() {\n  int x = 1;\n  if (v) x = 2;\n  v = x;\n}\n");
  ASSERT_TRUE(branch.text.has_value());
  EXPECT_THAT(*branch.text, HasSubstr("  v = x;\n"));
  const Lowering loop = Lower(
      "int v;\nvoid t0() {\n  int x = 1;\nagain:\n  v = x;\n  x = 2;\n  if (v) goto again;\n}\n");
  ASSERT_TRUE(loop.text.has_value());
  EXPECT_THAT(*loop.text, HasSubstr("  v = x;\n"));
}

TEST(Lowering, ABranchWhoseWaysMeetAtOnceIsLeftOut) {
  const Lowering lowering = Lower(
      "int v, w, h;\nvoid t0() {\n  while (v) {\n    v--;\n    if (w) {\n"
      "      if (w > 3) continue;\n      continue;\n    }\n    h = 1;\n  }\n}\n");
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_THAT(*lowering.text, testing::Not(HasSubstr("= w > 3;")));
}

// The calls of the first thread function that are jumps: `f 2, g 3`.
std::string JumpsOf(const std::string& program) {
  const Lowering lowering = Lower(program);
  EXPECT_TRUE(lowering.text.has_value()) << program;
  std::string jumps;
  for (const JumpCalls& calls : lowering.costs.at(0).jumps) {
    jumps += fmt::format("{}{} {}", jumps.empty() ? "" : ", ", calls.name, calls.calls);
  }
  return jumps;
}

TEST(Lowering, CallsAreJumpsWhereThatIsShorter) {
  struct Row {
    std::string functions;
    std::string body;
    std::string jumps;
  };
  const std::string array =
      "int sum(int v[], int n) { int s = 0; while (n > 0) { n--; s += v[n]; } return s; }\n";
  const std::string step =
      "int step(int x) { if (x > 9) x -= g; if (x < h) x += k; return x * x + g; }\n";
  for (const Row& row : std::vector<Row>{
           // A long body called twice is shorter once, a short one or a single call is not.
           {step, "g = step(h); h = step(g); k = step(h);", "step 3"},
           {step, "g = step(h);", ""},
           {"int twice(int x) { return x + x; }\n", "g = twice(h); h = twice(g); k = twice(h);",
            ""},
           // Calls within each other, and in loops.
           {step, "g = step(step(step(h)));", "step 3"},
           {step, "for (int i = 0; i < 5; i++) { g = step(h); h = step(g); k = step(i); }",
            "step 3"},
           // Each array has its own body; one that begins at a computed element has none.
           {array, "g = sum(a, 4); h = sum(a, 5); g -= sum(a, g);", "sum 3"},
           {array, "g = sum(a, 4); h = sum(b, 5);", ""},
           {array,
            "g = sum(a, 4); h = sum(b, 4); g += sum(a, 3); h -= sum(b, 3); g ^= sum(a, h); "
            "h ^= sum(b, g);",
            "sum 3, sum 3"},
           {array, "for (int i = 0; i < 4; i++) { g += sum(&a[i], 2); h += sum(&a[i], 1); }", ""},
           // What is never reached is no call.
           {step, "if (0) g = step(h); h = step(g); k = step(h); g = step(k);", "step 3"},
           {step, "return; g = step(h); h = step(g); k = step(h);", ""},
           // A function that is called by one that is itself shared.
           {step + "int both(int x, int y) { return step(x) * step(y) - step(x + y); }\n",
            "g = both(g, h); h = both(h, k); k = both(k, g);", "step 3, both 3"}}) {
    EXPECT_EQ(
        JumpsOf("int g, h, k, a[8], b[8];\n" + row.functions + "void t0() { " + row.body + " }\n"),
        row.jumps)
        << row.functions << row.body;
  }
}

// The line of the lowered program with a command, after its #define lines.
std::string CommandOf(const std::string& program) {
  const Lowering lowering = Lower(program);
  EXPECT_TRUE(lowering.text.has_value()) << program;
  const SourceFile text("lowered.c", lowering.text.value_or(""));
  std::string found;
  for (int line = 1; line <= text.line_count(); ++line) {
    const std::string_view words = text.Line(line);
    if (words.starts_with("#define ")) found += std::string(words.substr(8)) + "; ";
    if (words.starts_with("  GT_")) return found + std::string(words.substr(2));
  }
  return found;
}

TEST(Lowering, ConstantsKeepTheirNamesAsArgumentsOfCommands) {
  struct Row {
    std::string before;
    std::string command;
    std::string lowered;
  };
  const std::string axis = "#define AXIS 1\n";
  for (const Row& row : std::vector<Row>{
           {axis, "GT_AxisOn(AXIS);", "AXIS 1; GT_AxisOn(AXIS);"},
           {axis + "#define SPEED 2.5\n", "GT_SetVel(AXIS, (SPEED));",
            "AXIS 1; SPEED 2.5; GT_SetVel(AXIS, SPEED);"},
           {axis + "#define NEXT AXIS + 1\n", "GT_AxisOn(NEXT);", "NEXT 2; GT_AxisOn(NEXT);"},
           {"#define BACK (-7)\n", "GT_SetPos(1, BACK);", "BACK -7; GT_SetPos(1, BACK);"},
           {"enum { kLeft, kRight };\n", "GT_AxisOn(kRight);", "kRight 1; GT_AxisOn(kRight);"},
           {"const int AXIS = 3;\n", "GT_AxisOn(AXIS);", "AXIS 3; GT_AxisOn(AXIS);"},
           // What is no name, or another value.
           {axis, "GT_AxisOn(AXIS + 1);", "GT_AxisOn(2);"},
           {axis, "GT_SetVel(1, AXIS);", "GT_SetVel(1, 1.0);"},
           {"#define BIT(a) (1 << (a))\n", "GT_Update(BIT(2));", "GT_Update(4);"},
           {axis, "GT_AxisOn(1);", "GT_AxisOn(1);"},
           // Another use of the name.
           {axis, "GT_AxisOn(AXIS);\n#undef AXIS\n#define AXIS 2\nGT_AxisOn(AXIS);",
            "GT_AxisOn(1);"},
           {"enum { kLeft = 1 };\nvoid t1(int kLeft) { kLeft = 1; }\n", "GT_AxisOn(kLeft);",
            "GT_AxisOn(1);"},
           {"enum { here = 1 };\n", "GT_AxisOn(here); here: if (v) goto here;", "GT_AxisOn(1);"},
           {"#define bool 1\n", "GT_AxisOn(bool);", "GT_AxisOn(1);"},
           {"#define GT_Close 1\n", "GT_AxisOn(GT_Close);", "GT_AxisOn(1);"},
           {"#define A_NAME_OF_MORE_THAN_THIRTY_ONE_LETTERS 1\n",
            "GT_AxisOn(A_NAME_OF_MORE_THAN_THIRTY_ONE_LETTERS);", "GT_AxisOn(1);"}}) {
    EXPECT_EQ(CommandOf(row.before + "int v;\nvoid t0() {\n" + row.command + "\n}\n"), row.lowered)
        << row.before << row.command;
  }
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

// The explorer reads a program's requirements from such lines, wherever they stand.
// The lowered text has as many lines as the card's language can name; comments would be more.
TEST(Lowering, FortyThousandStatementsHaveTheirLines) {
  constexpr int kFunctions = 4;
  constexpr int kStatements = 10'000;
  std::string program = "//@ structured\nint v;\n";
  for (int f = 0; f < kFunctions; ++f) {
    program += fmt::format("void f{}() {{\n", f) + Times(kStatements, "  v++; // more\n") + "}\n";
  }
  const Compilation compilation = CompileText("p.c", program, {}, NoFiles());
  ASSERT_TRUE(compilation.ok());
  for (int f = 0; f < kFunctions; ++f) {
    const vm::Function& function = compilation.object->functions[static_cast<size_t>(f)];
    const int first = 4 + f * (kStatements + 2);
    for (int i = 0; i < kStatements; ++i) {
      ASSERT_EQ(function.lines[static_cast<size_t>(i)], first + i) << function.name;
    }
  }
}

TEST(Lowering, CommentsForToolsAreKept) {
  const Lowering lowering = Lower(
      "//@ structured\n//@ init: v=1\r\n// about v\nint v;\nvoid t0() {\n  /*\n"
      "  //@ always: v < 3 \\\n  */\n  v++;\n}\n//@ final: v == 2");
  EXPECT_EQ(lowering.text.value(),
            "//@ init: v=1\n//@ always: v < 3 \\\n//@ final: v == 2\n\n// about v\nint v;\n\n"
            "void t0() {\n  // 9: v++;\n  v = v + 1;\n}\n");
  EXPECT_EQ(lowering.files[0].LineOf(lowering.origins[1].begin), 7);
}

TEST(Lowering, OnlyCommentsForToolsStandBeforeAFunction) {
  EXPECT_EQ(Lower("//@ races: none \\\nint v;\nvoid t0() {}\n").text.value(),
            "//@ races: none \\\n\nvoid t0() {\n}\n");
}

// The second byte of the first comment's last character is that of a backslash, in GBK (0xD45C).
TEST(Lowering, LinesOfCEndWithoutABackslashButNotWithHalfACharacter) {
  const Lowering lowering =
      Lower("int a, b;\nvoid t0() {\n  a = 1; // \xD4\\\n  b = 2; /* \\ \\\n */\n}\n");
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_THAT(*lowering.text, HasSubstr("  // 3: a = 1; // \xD4\\\n"));
  EXPECT_THAT(*lowering.text, HasSubstr("  // 4: b = 2; /*\n"));
}

// The static local gets another name because of the local of t0; that does not rename locals of t1.
TEST(Lowering, LocalsKeepTheirNamesBesideStatics) {
  const Lowering lowering = Lower(
      "int v;\nvoid t0() { int t1_n; t1_n = v + 1; v = t1_n; v = t1_n; }\n"
      "void t1() { static int n; int t1_n; n++; t1_n = n + v; v = t1_n; v = t1_n; }\n");
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_THAT(*lowering.text, HasSubstr("  t1_n_2 = t1_n_2 + 1;\n  t1_n = t1_n_2 + v;\n"));
}

// The command is checked in the lowered text.
TEST(Lowering, MessagesAboutTheLoweredTextHavePlacesOfC) {
  ExpectError("int v;\nvoid t0() {\n  if (v)\n    GT_SetVel(1);\n}\n", Codes{43}, 4,
              "GT_SetVel takes 2 arguments");
}

// The names of variables whose names in C are others, as `a_x: a[3].x`.
std::vector<std::string> Written(const std::vector<vm::Symbol>& symbols) {
  std::vector<std::string> names;
  for (const vm::Symbol& symbol : symbols) {
    if (!symbol.written.empty()) names.push_back(symbol.name + ": " + symbol.written);
  }
  return names;
}

TEST(LoweringNames, Globals) {
  const Lowering lowering = Lower(
      "typedef int row[4];\n"
      "struct point { int x; row y[2]; };\n"
      "struct axis { double at; struct point to[3]; TTrapPrm trap; } axis;\n"
      "struct point p, list[2][5];\n"
      "struct jog { TJogPrm jog; } jogs[2][3];\n"
      "TJogPrm spare[4];\n"
      "int v, data[4], m[2][3], list_x;\n"
      "void t0() { static struct point last; last.x++; static int n; n++; }\n");
  ASSERT_TRUE(lowering.object.has_value());
  EXPECT_THAT(
      Written(lowering.object->globals),
      testing::ElementsAre("axis_at: axis.at", "axis_to_x: axis.to[3].x",
                           "axis_to_y: axis.to[3].y[2][4]", "axis_trap.acc: axis.trap.acc",
                           "axis_trap.dec: axis.trap.dec", "axis_trap.velStart: axis.trap.velStart",
                           "axis_trap.smoothTime: axis.trap.smoothTime", "p_x: p.x",
                           "p_y: p.y[2][4]", "list_x_2: list[2][5].x", "list_y: list[2][5].y[2][4]",
                           "jogs_jog_acc: jogs[2][3].jog.acc", "jogs_jog_dec: jogs[2][3].jog.dec",
                           "jogs_jog_smooth: jogs[2][3].jog.smooth", "spare_acc: spare[4].acc",
                           "spare_dec: spare[4].dec", "spare_smooth: spare[4].smooth", "m: m[2][3]",
                           "t0_last_x: t0_last.x", "t0_last_y: t0_last.y[2][4]"));
}

// Two locals of a thread function may be called alike, and like a global.
TEST(LoweringNames, Locals) {
  const Lowering lowering = Lower(
      "struct point { int x; int y; } p;\n"
      "int sum(struct point a) { return a.x + a.y; }\n"
      "void t0(int n) {\n"
      "  struct point p = {n, 2}, q[2];\n"
      "  TJogPrm j, k[2], l[2][1];\n"
      "  int m[2][2], d[4];\n"
      "  { struct point p = {n, 4}; q[n] = p; m[n][1] = d[n] = sum(p); }\n"
      "  GT_SetVel(q[1].y, sum(p) + m[1][n] + d[n]);\n"
      "  GT_SetJogPrm(1, &k[n]);\n  GT_SetJogPrm(1, &j);\n  l[n][0].dec = 1;\n"
      "}\n",
      {.optimize = false});
  ASSERT_TRUE(lowering.object.has_value());
  EXPECT_THAT(Written(lowering.object->functions[0].variables),
              testing::ElementsAre("p_x_2: p.x", "p_y_2: p.y", "q_x: q[2].x", "q_y: q[2].y",
                                   "k_acc: k[2].acc", "k_dec: k[2].dec", "k_smooth: k[2].smooth",
                                   "l_dec: l[2][1].dec", "m: m[2][2]", "p_x_3: p_2.x",
                                   "p_y_3: p_2.y", "sum_a_x: sum_a.x", "sum_a_y: sum_a.y"));
}

// The lowered program has no names of C.
TEST(LoweringNames, InComments) {
  const Lowering lowering = Lower(
      "//@ structured\n"
      "//@ always: axis[1].target < 0x10 && m[1][2] + m[1] == axis_target[1] * 2e3\n"
      "//@ final: page0.old.gains[1] == 2.5 && p == 3 && axis1.prfPos == 0\n"
      "//@ sync: axis, q\n"
      "//@ never: move[2].trap.acc > 1.5 || one.smooth == jogs[0][1].smooth\n"
      "//@ within 5 ms: q[1].x -> q[0].y\n"
      "struct axis { int target; double gains[2]; } axis[3];\n"
      "struct { int x; int y; } q[2];\nint m[2][3], p, within;\n"
      "struct { TTrapPrm trap; } move[3];\nTJogPrm one, jogs[1][2];\n"
      "void t0() { struct axis old = axis[1]; GT_SetVel(1, old.gains[1]); }\n");
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_THAT(*lowering.text,
              testing::StartsWith(
                  "//@ always: axis_target[1] < 0x10 && m[5] + m[1] == axis_target[1] * 2e3\n"
                  "//@ final: page0.old_gains[1] == 2.5 && p == 3 && axis1.prfPos == 0\n"
                  "//@ sync: axis_target, axis_gains, q_x, q_y\n"
                  "//@ never: move_trap_acc[2] > 1.5 || one.smooth == jogs_smooth[1]\n"
                  "//@ within 5 ms: q_x[1] -> q_y[0]\n"));
}

}  // namespace
}  // namespace oncard::compiler
