// Fix-its are real edits: applying those of one diagnostic after the other leads to a program that
// compiles, and what it computes is what C would have computed.
#include <gtest/gtest.h>

#include "runtime/controller.h"
#include "tests/compiler/compiler_support.h"
#include "vm/verifier.h"

namespace oncard::compiler {
namespace {

// Some constructs hold many others; each round mends one.
constexpr int kRoundMax = 60;

// Applies the fix-its of the first error until there is none, or an error has no fix-it.
std::string Mend(std::string text, std::string* trace) {
  for (int round = 0; round < kRoundMax; ++round) {
    const Compilation compilation = CompileString(text);
    if (compilation.ok()) return text;
    const Diagnostic& first = compilation.diagnostics.front();
    *trace += DiagnosticName(first.info->code) + ": " + first.message.en + "\n" + text + "\n";
    if (first.fixits.empty()) return text;
    text = ApplyFixIts(text, first);
  }
  return text;
}

// Every global `v`, `w`, ... of the mended program after a run of its first function.
double RunAndRead(const vm::Object& object, const std::string& name) {
  runtime::Controller controller;
  EXPECT_TRUE(controller.Load(object).ok());
  EXPECT_EQ(controller.machine().Bind(0, 1, 0), 0);
  EXPECT_EQ(controller.machine().Run(0), 0);
  EXPECT_EQ(controller.RunUntilQuiet(4000), runtime::RunEnd::kQuiet);
  for (const vm::Symbol& symbol : object.globals) {
    if (symbol.name != name) continue;
    vm::SlotAddress slot;
    slot.global = true;
    slot.id = symbol.id;
    slot.type = symbol.type;
    return controller.machine().Read(slot);
  }
  ADD_FAILURE() << name;
  return 0;
}

struct Foreign {
  const char* name;
  const char* body;  ///< of `int t0()`, after declarations of i, j, k and x
  double v;          ///< what C gives
};

// Values follow from C's rules by hand.
const Foreign kBodies[] = {
    {"nested", "i = 3; j = 4; v = i * j + 5;", 17},
    {"parentheses", "i = 3; v = (i + 1) * (i - 1);", 8},
    {"deeper", "i = 2; v = ((i + 1) * 2 + i) * (i + (i - 1));", 24},
    {"compound", "v = 4; v += 3; v *= 2; v -= 1; v /= 2; v <<= 3; v %= 7; v |= 8; v &= 12; v ^= 5;",
     9},
    {"compound_nested", "i = 2; v = 1; v += i * 3;", 7},
    {"increment", "v = 4; v++; ++v; v--; v++;", 6},
    {"increment_used", "i = 4; v = i++ * 2 + i;", 13},
    {"minus", "i = 5; v = -i;", -5},
    {"minus_nested", "i = 5; v = 2 * -i;", -10},
    {"plus", "i = 5; v = +i;", 5},
    {"not_nested", "i = 5; v = !(i > 3) + 2;", 2},
    {"chain", "i = j = v = 3; v = i + j;", 6},
    {"comma", "i = 1, j = 2; v = i + j;", 3},
    {"choice", "i = 5; v = i > 3 ? 10 : 20;", 10},
    {"choice_nested", "i = 1; v = (i > 3 ? 10 : i > 0 ? 15 : 20) + 1;", 16},
    {"relation_of_sums", "i = 5; v = i + 1 > i * 2;", 0},
    {"logic", "i = 5; v = i > 3 && i < 7 || i == 100;", 1},
    {"element_as_index", "a[1] = 2; a[2] = 7; v = a[a[1]];", 7},
    {"expression_as_index", "i = 1; a[2] = 9; v = a[i + 1];", 9},
    {"target_index", "i = 1; a[i + 1] = 8; v = a[2];", 8},
    {"double_index", "x = 2.5; a[2] = 6; v = a[x];", 6},
    {"to_int", "x = 2.75; v = x;", 2},
    {"to_double", "i = 3; x = i; x = x / 2; v = (int) (x * 2);", 3},
    {"mixed", "i = 3; x = i * 0.5; v = x * 2;", 3},
    {"mixed_variables", "i = 3; x = 0.5; x = x + i; v = (int) x;", 3},
    {"int_from_literal", "v = 2.5;", 2},
    {"double_from_ints", "x = 1 + 2; v = x;", 3},
    {"cast_of_sum", "i = 3; x = (double) (i + 1); v = x;", 4},
    {"abs_nested", "i = 3; v = abs(i - 10) + 1;", 8},
    {"fabs_of_int", "x = -1.5; x = fabs(x); v = (int) (x + x);", 3},
    {"abs_of_double", "x = -2.0; x = abs(x); v = x;", 2},
    {"while_loop", "i = 1; while (i <= 10) { v = v + i; i = i + 1; }", 55},
    {"while_single", "while (v < 7) v = v + 2;", 8},
    {"while_truth", "i = 3; while (i) { v = v + 10; i--; }", 30},
    {"while_not", "while (!v) { v = 3; }", 3},
    {"while_forever", "while (1) { v++; if (v == 5) break; }", 5},
    {"while_continue", "while (i < 10) { i++; if (i % 2) continue; v += i; }", 30},
    {"while_never", "v = 1; while (0) { v = 9; }", 1},
    {"while_empty", "v = 3; while (0); v = v + 1;", 4},
    {"for_loop", "for (i = 1; i <= 10; i++) { v = v + i; }", 55},
    {"for_single", "for (i = 0; i < 4; i++) v += i;", 6},
    {"for_declares", "for (int n = 0; n < 3; n++) v += n; for (int n = 0; n < 3; n++) v += n;", 6},
    {"for_two_counters", "for (i = 0, j = 10; i < j; i++, j--) v++;", 5},
    {"for_forever", "for (;;) { v = v + 1; if (v > 3) break; }", 4},
    {"for_continue", "for (i = 0; i < 5; i++) { if (i == 2) continue; v += i; }", 8},
    {"for_nested", "for (i = 0; i < 3; i++) for (j = 0; j < 3; j++) if (i != j) v++;", 6},
    {"for_nested_break",
     "for (i = 0; i < 3; i++) { for (j = 0; j < 9; j++) { if (j > i) break; v++; } }", 6},
    {"do_loop", "do { v = v + 3; } while (v < 10);", 12},
    {"do_once", "do v = v + 1; while (0); v = v + 1;", 2},
    {"do_break", "do { v++; if (v == 4) break; } while (1);", 4},
    {"do_continue", "do { i++; if (i == 2) continue; v += i; } while (i < 4);", 8},
    {"if_assignment", "i = 2; if (i > 1) v = 4; if (i > 2) v = 5;", 4},
    {"if_block", "i = 2; if (i) { v = 4; v = v + 1; }", 5},
    {"if_else", "i = 5; j = 10; if (i > j) v = i - j; else v = j - i;", 5},
    {"if_else_blocks", "i = 5; if (i == 5) { v = 1; } else { v = 2; }", 1},
    {"if_else_chain", "i = 2; if (i == 1) v = 10; else if (i == 2) v = 20; else v = 30;", 20},
    {"if_dangling", "i = 0; if (1) if (i) v = 1; else v = 2;", 2},
    {"if_goto", "i = 3; if (i > 2) goto done; v = 1; done: v = v + 5;", 5},
    {"if_double", "x = 0.5; if (x) goto done; v = 1; done: v = v + 5;", 5},
    {"if_element", "a[1] = 1; if (a[1]) goto done; v = 1; done: v = v + 5;", 5},
    {"if_return", "v = 1; if (v == 1) return 0; v = 2;", 1},
    {"if_return_sum", "v = 1; i = 0; if (i) return v / i; v = 2;", 2},
    {"if_constant", "if (1) goto done; v = 1; done: v = v + 5;", 5},
    {"if_never", "if (0) goto done; v = 1; done: v = v + 5;", 6},
    {"return_sum", "v = 4; return v + 1;", 4},
    {"return_double", "v = 4; return 2.5;", 4},
    {"switch_case",
     "i = 2; switch (i) { case 1: v = 10; break; case 2: v = 20; break; default: v = 30; }", 20},
    {"switch_default", "i = 9; switch (i) { case 1: v = 10; break; default: v = 30; break; }", 30},
    {"switch_falls", "i = 1; switch (i) { case 1: v += 1; case 2: v += 2; break; case 3: v = 9; }",
     3},
    {"switch_none", "switch (i + 7) { case 1: v = 1; }", 0},
    {"switch_in_loop",
     "for (i = 0; i < 4; i++) { switch (i) { case 1: continue; case 2: v += 10; break; default: "
     "v++; } v += 100; }",
     312},
    {"block", "{ v = 1; { v = v + 1; } }", 2},
    {"late", "v = 1; int n = v + 4; v = n;", 5},
    {"late_many", "v = 1; int n = 1, m = 2, o = 3, p = 4, q = 5; v = n + m + o + p + q;", 15},
    {"late_in_block", "i = 1; if (i) { int n; n = 3; v = n; }", 3},
    {"late_array", "v = 1; int n[2] = {4, 5}; v = n[0] + n[1];", 9},
    {"missing_semicolon", "v = 1\nv = v + 1;", 2},
    {"label_at_end", "v = 3; goto done; v = 4; done:", 3},
    {"wrong_label", "v = 3; goto don; v = 4; done: return 0;", 3},
    {"wrong_name", "v = 3; cuonter = 2; v = counter;", 2},
    {"octal", "v = 010;", 10},
    {"command_result", "i = GT_Delay(1); v = 2;", 2},
    {"command_argument", "i = 1; GT_Delay(i * 2 - 1); v = 2;", 2},
    {"command_in_loop", "for (i = 0; i < 2; i++) GT_Delay(i + 1); v = i;", 2},
    {"command_missing", "GT_GetClock(&i); v = 2;", 2},
    {"command_address", "GT_GetClock(i, &j); v = 2;", 2},
    {"command_value", "i = 1; GT_Delay(&i); v = 2;", 2},
    {"command_extra", "GT_Delay(1, 2); v = 2;", 2},
    {"command_misspelt", "GT_Dealy(1); v = 2;", 2},
    {"everything",
     "for (int n = 0; n < 5; n++) { if (n % 2 == 0) { v += n * 2; } else if (n == 3) { "
     "while (v > 1) v -= 2; } else { switch (n) { case 1: v++; break; } } }",
     9},
};

class RewriterTest : public testing::TestWithParam<Foreign> {};

TEST_P(RewriterTest, MendsTheProgramToWhatCMeans) {
  const std::string text = std::string(
                               "int v, counter;\nint a[4];\nint t0() {\n  int i, j, k;\n"
                               "  double x;\n  v = 0;\n  ") +
                           GetParam().body + "\n}\n";
  std::string trace;
  const std::string mended = Mend(text, &trace);
  const Compilation compilation = CompileString(mended);
  ASSERT_TRUE(compilation.ok()) << trace << compilation.diagnostics.front().message.en << '\n'
                                << mended;
  const CatalogueShapes shapes;
  const Result<void> verified = vm::Verify(*compilation.object, shapes);
  ASSERT_TRUE(verified.ok()) << verified.error().message.en;
  EXPECT_EQ(RunAndRead(*compilation.object, "v"), GetParam().v) << trace << mended;
}

INSTANTIATE_TEST_SUITE_P(Bodies, RewriterTest, testing::ValuesIn(kBodies),
                         [](const testing::TestParamInfo<Foreign>& body) {
                           return std::string(body.param.name);
                         });

struct Whole {
  const char* name;
  const char* text;
};

// Programs whose errors are not in statements.
const Whole kPrograms[] = {
    {"unsigned_long", "unsigned long v; float f; char c; static int s; int t0() { return v; }\n"},
    {"global_initialiser", "int v = 5; int t0() { return v; }\n"},
    {"two_dimensions",
     "int m[2][3]; int v; int t0() { int i; i = 1; m[i][2] = 4; v = m[1][i + 1] * 2; }\n"},
    {"two_dimensions_in_loop",
     "int m[2][3]; int t0() { int i; while (m[i][1] < 3) { m[i][1] = m[i][1] + 1; } if (m[i][0]) i "
     "= 2; "
     "else i = m[1][i]; switch (m[0][i]) { case 1: i = 1; } return m[i][i]; }\n"},
    {"sized_by_values", "int t0() { int n[] = {1, 2, 3}; return n[2]; }\n"},
    {"constants", "int t0() { GT_SetDo(MC_GPO, 1); GT_SetDo(MC_GPO, 2); return 0; }\n"},
    {"macro_inside", "int t0() {\n#define N 3\n  return N;\n}\n"},
    {"void_value", "void t0() { return 5; }\n"},
    {"implicit_parameter", "int t0(a) { return a; }\n"},
    {"stray_brace", "int t0() { return 0; } }\n"},
    {"no_index", "int a[3]; int t0() { a = 1; return a; }\n"},
    {"misspelt_type", "itn v; int t0() { return v; }\n"},
    {"misspelt_member", "TTrapPrm t; int t0() { t.ac = 0.5; t->dec = 0.5; return 0; }\n"},
    {"full_width", "int v；\nint t0() { v ＝ 1； return v； }\n"},
    {"open_comment", "int t0() { return 0; }\n/* and so on"},
    {"missing_brace", "int t0() return 0; }\n"},
    {"missing_bracket", "int a 3]; int t0() { return a[0]; }\n"},
    {"windows_lines", "int v;\r\nint t0() {\r\n  v = 1 + 2 * 3;\r\n  while (v) v--;\r\n}\r\n"},
    {"no_declarations", "int v; int t0() {\n  v = v * v + 1;\n}\n"},
    {"one_line", "int v; int t0() { v = v * v + 1; while (v) v--; }"},
};

class ProgramTest : public testing::TestWithParam<Whole> {};

TEST_P(ProgramTest, CanBeMended) {
  std::string trace;
  const std::string mended = Mend(GetParam().text, &trace);
  const Compilation compilation = CompileString(mended);
  EXPECT_TRUE(compilation.ok()) << trace << compilation.diagnostics.front().message.en << '\n'
                                << mended;
}

INSTANTIATE_TEST_SUITE_P(Programs, ProgramTest, testing::ValuesIn(kPrograms),
                         [](const testing::TestParamInfo<Whole>& program) {
                           return std::string(program.param.name);
                         });

TEST(Rewriter, KeepsTheCommentsOfABody) {
  const Compilation compilation =
      CompileString("int v;\nint t0() {\n  while (v < 3) {\n    v = v + 1;  // count\n  }\n}\n");
  ASSERT_EQ(CodesOf(compilation), std::vector<int>{101});
  const std::string mended = ApplyFixIts(compilation.files[0].text(), compilation.diagnostics[0]);
  EXPECT_NE(mended.find("v = v + 1;  // count\n"), std::string::npos) << mended;
}

TEST(Rewriter, ShowsTheManualsFormOfALoop) {
  const Compilation compilation =
      CompileString("int v;\nint t0() {\n  int i;\n  while (i <= 10) v = i;\n}\n");
  ASSERT_EQ(compilation.diagnostics.size(), 1u);
  EXPECT_EQ(ApplyFixIts(compilation.files[0].text(), compilation.diagnostics[0]),
            "int v;\nint t0() {\n  int i;\n  int cc;\n  lbl_loop:\n  cc = i > 10;\n"
            "  if (cc) goto lbl_end;\n  v = i;\n  goto lbl_loop;\n  lbl_end:\n  return;\n}\n");
}

TEST(Rewriter, TakesNamesThatAreFree) {
  const Compilation compilation =
      CompileString("int tmp, tmp1;\nint t0() {\n  tmp = tmp * 2 + tmp1;\n}\n");
  ASSERT_EQ(compilation.diagnostics.size(), 1u);
  EXPECT_NE(compilation.diagnostics[0].fixits[0].text.find("int tmp2;"), std::string::npos);
}

}  // namespace
}  // namespace oncard::compiler
