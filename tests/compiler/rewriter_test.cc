// Fix-its are valid edits: applying those of one diagnostic after the other results in a program
// that compiles, and that computes what C would have computed.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/sim/controller.h"
#include "tests/compiler/compiler_support.h"
#include "vm/verifier.h"

namespace oncard::compiler {
namespace {

using testing::HasSubstr;

// Some constructs contain many others; each round corrects one.
constexpr int kRoundMax = 60;

// Applies the fix-its of the first error with any (or of the last one), until there are none left.
std::string CorrectOneByOne(std::string text, std::string* trace, bool from_last = false) {
  for (int round = 0; round < kRoundMax; ++round) {
    const Compilation compilation = CompileString(text);
    if (compilation.ok()) return text;
    std::vector<const Diagnostic*> correctable;
    for (const Diagnostic& diagnostic : compilation.diagnostics) {
      if (!diagnostic.fixits.empty()) correctable.push_back(&diagnostic);
    }
    if (correctable.empty()) return text;
    const Diagnostic& next = from_last ? *correctable.back() : *correctable.front();
    *trace += DiagnosticName(next.info->code) + ": " + next.message.en + "\n" + text + "\n";
    text = ApplyFixIts(text, next);
  }
  return text;
}

// A global of the corrected program (`v`, `w`, ...) after a run of its first function.
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
  double v;          ///< the result in C
};

// The values are derived by hand from the rules of C.
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
    {"octal", "v = 010;", 8},
    {"octal_with_suffix", "v = 017L + -011;", 6},
    {"octal_zero", "v = 5 + 000;", 5},
    {"octal_bits", "v = 037777777776;", -2},
    {"octal_with_other_digits", "v = 089;", 89},
    {"command_result", "i = GT_Delay(1); v = 2;", 2},
    {"command_argument", "i = 1; GT_Delay(i * 2 - 1); v = 2;", 2},
    {"command_in_loop", "for (i = 0; i < 2; i++) GT_Delay(i + 1); v = i;", 2},
    {"command_missing", "GT_GetClock(&i); v = 2;", 2},
    {"command_address", "GT_GetClock(i, &j); v = 2;", 2},
    {"command_cast", "GT_GetClock((long*) &i, (unsigned long *) &j); v = 2;", 2},
    {"command_value", "i = 1; GT_Delay(&i); v = 2;", 2},
    {"command_extra", "GT_Delay(1, 2); v = 2;", 2},
    {"command_misspelt", "GT_Dealy(1); v = 2;", 2},
    {"whole_number", "GT_Delay(2.0); v = 2;", 2},
    {"truths", "bool on = false; bool off = !on; on = i < 3 && off; v = on * 10 + (off == true);",
     11},
    {"truth_loop", "bool more = true; while (more) { v++; more = v < 5; } v += TRUE - FALSE;", 6},
    {"truth_bits", "bool b = 0; b |= i == 0; b ^= true; b |= b; v = b + 4;", 4},
    {"truth_chosen", "bool b[2]; b[0] = (i ? 0 : j == 0); b[1] = b[0]; v = b[1] + 1;", 2},
    {"truth_beside_int", "{ int n = 7; v = n; } { bool n = !v; v += n; } v++;", 8},
    {"float_suffix", "x = 12.5f * 2; v = x; x = .5F; x = x + 1.e1L; v += x * 2;", 46},
    {"float_suffix_beside_int", "i = 3; v = i * 0.5f * 2 + 2.5e-1f * 4;", 4},
    {"characters", "v = 'b'; if (v == 'b') v = 'a' - '\\n'; v = -'\\'' + v;", 48},
    {"character_in_call", "GT_Delay('\\t' - 8); v = abs('!');", 33},
    {"character_cases", "i = 'q'; switch (i) { case 'p': v = 1; break; case 'q': v = 2; }", 2},
    {"sizes_of_sums", "int n[2 * 3], o['\\n' - 8]; n[5] = 4; o[1] = 3; v = n[5] + o[1];", 7},
    {"guarded_element", "i = -1; while (i >= 0 && a[i] > 0) i = i - 1; v = i;", -1},
    {"guarded_division", "i = 0; if (i != 0 && 10 / i > 2) v = 1; else v = 2;", 2},
    {"guarded_value", "i = 9; v = i < 4 && a[i] == 0; v = v + (i > 3 || a[i]) * 10;", 10},
    {"second_step_skipped", "i = 1; if (i++ > 2 && i++ > 3) v = 100; v += i;", 2},
    {"second_step_taken", "i = 3; if (i++ > 2 && i++ > 3) v = 100; v += i;", 105},
    {"or_skips", "i = 5; if (i > 3 || i++ > 0) v = 10; v += i;", 15},
    {"or_of_ands", "i = 1; if ((i > 3 && j++) || (i < 2 && ++k)) v = 1; v += j * 10 + k;", 2},
    {"not_of_or", "i = 1; while (!(i > 5 || i++ > 9)) v++; v = v * 10 + i;", 56},
    {"logic_to_goto", "i = 5; if (i > 3 && i < 7) goto done; v = 1; done: v += 5;", 5},
    {"logic_to_return", "i = 5; v = 1; if (i > 3 && v++) return; v = 9;", 2},
    {"logic_at_the_end", "v = 1; if (v && i) goto done; if (v) goto done; v = 2; done: ;", 1},
    {"logic_in_do", "do v++; while (v < 9 && v != 4);", 4},
    {"choice_of_logic", "i = 4; v = i > 3 && i < 9 ? 7 : 8;", 7},
    {"comma_condition", "if (i = 3, i > 2) v = i;", 3},
    {"double_logic", "x = 0.5; v = x && x < 1.0;", 1},
    {"values_in_order", "int n = 2; int m = n + 1, o = m * n; v = o * 10 + m; ", 63},
    {"rest_is_zero", "a[1] = 5; a[2] = 6; { int n[3] = {7}; n[1]++; v = n[0] + n[1] + n[2]; }", 8},
    {"big_rest_is_zero", "{ int n[40] = {7, 8}; for (i = 0; i < 40; i++) v += n[i]; }", 15},
    {"hidden_name", "i = 7; { int i = 2; v = i; } v = v * 10 + i;", 27},
    {"hidden_counter", "i = 7; for (int i = 0; i < 3; i++) v += i; v = v * 10 + i;", 37},
    {"hidden_twice",
     "for (int n = 0; n < 2; n++) { v += 100; for (int n = 0; n < 3; n++) v += n; }", 206},
    {"hides_a_global", "counter = 5; { int counter; counter = 1; } v = counter;", 5},
    {"counter_hides_a_global",
     "counter = 5; for (int counter = 0; counter < 3; counter++) i += counter; v = counter * 10 + "
     "i;",
     53},
    {"array_hides_a_global", "a[1] = 5; if (a[1]) { int a[4]; a[1] = 1; } v = a[1];", 5},
    {"values_hide_a_global", "a[1] = 5; { int a[2] = {2, 3}; i = a[1]; } v = a[1] + i;", 8},
    {"other_type_hides_a_global",
     "counter = 7; { double counter; counter = 1.5; x = counter; } v = counter / 2 * 3 + x * 2;",
     12},
    {"two_blocks_hide_a_global",
     "counter = 4; { int counter; counter = 1; i = counter; } { int counter; counter = 2; i += "
     "counter; } v = counter * 10 + i;",
     43},
    {"two_counters_hide_a_global",
     "counter = 9; for (int counter = 0; counter < 2; counter++) i++; for (int counter = 0; "
     "counter "
     "< 3; counter++) i++; v = counter * 10 + i;",
     95},
    {"block_in_block_hides_a_global",
     "counter = 3; { int counter = 4; { int counter = 5; i = counter; } i = i * 10 + counter; } v "
     "= "
     "i * 10 + counter;",
     543},
    {"loop_around_a_hidden_global",
     "do { int counter = 8; i += counter; } while (++counter < 3); v = i + counter;", 27},
    {"branch_hides_a_global",
     "counter = 2; if (counter == 2) { int counter = 6; v = counter; } else { int counter = 7; v = "
     "counter; } v = v * 10 + counter;",
     62},
    {"hidden_in_a_switch",
     "counter = 1; switch (counter) { case 1: { int counter = 5; v = counter; } case 2: v += "
     "counter; "
     "}",
     6},
    {"hidden_beside_a_value",
     "counter = 5; again: j++; int n = counter, counter = 2; if (j < 2) goto again; v = n + "
     "counter;",
     7},
    {"late_hides_a_global",
     "counter = 5; again: i = counter; j++; int counter = 2; if (j < 2) goto again; v = i + "
     "counter;",
     7},
    {"hidden_local_of_another_type", "i = 7; { double i; i = 1.5; x = i; } v = i / 2 * 3 + x * 2;",
     12},
    {"other_type", "{ int n = 7; v = n; } { double n = 0.5; x = n * 2; } v += (int) x;", 8},
    {"local_const", "const int n = 3; v = n * 2;", 6},
    {"case_expressions", "i = 5; switch (i) { case 2 + 3: v = 1; break; case -5: v = 2; }", 1},
    {"inner_case", "i = 2; switch (i) { case 1: if (j) { case 2: v = 3; } }", 3},
    {"unsigned_counter", "unsigned int n; for (n = 0; n < 4; n++) v += n;", 6},
    {"three_dimensions",
     "int m[2][3][4]; i = 1; m[i][2][i + 2] = 5; v = m[1][i * 2][3] + m[0][0][0];", 5},
    {"constant_dimensions", "int m[2][3]; m[1][2] = 5; i = 1; v = m[i][i + i];", 5},
    {"everything",
     "for (int n = 0; n < 5; n++) { if (n % 2 == 0) { v += n * 2; } else if (n == 3) { "
     "while (v > 1) v -= 2; } else { switch (n) { case 1: v++; break; } } }",
     9},
};

class RewriterTest : public testing::TestWithParam<Foreign> {};

TEST_P(RewriterTest, CorrectsTheProgramToWhatItMeansInC) {
  const std::string text = std::string(
                               "int v, counter;\nint a[4];\nint t0() {\n  int i, j, k;\n"
                               "  double x;\n  v = 0;\n  ") +
                           GetParam().body + "\n}\n";
  std::string trace;
  const std::string corrected = CorrectOneByOne(text, &trace);
  const Compilation compilation = CompileString(corrected);
  ASSERT_TRUE(compilation.ok()) << trace << compilation.diagnostics.front().message.en << '\n'
                                << corrected;
  const CatalogueShapes shapes;
  const Result<void> verified = vm::Verify(*compilation.object, shapes);
  ASSERT_TRUE(verified.ok()) << verified.error().message.en;
  EXPECT_EQ(RunAndRead(*compilation.object, "v"), GetParam().v) << trace << corrected;

  // In another order a type may remain that must be corrected first, but no fix-it is wrong.
  trace.clear();
  const std::string backwards = CorrectOneByOne(text, &trace, true);
  const Compilation from_last = CompileString(backwards);
  if (from_last.ok()) {
    EXPECT_EQ(RunAndRead(*from_last.object, "v"), GetParam().v) << trace << backwards;
  }

  const CorrectedProgram at_once = CorrectString(text);
  ASSERT_TRUE(at_once.compilation.ok()) << at_once.files.at("test.c");
  EXPECT_EQ(RunAndRead(*at_once.compilation.object, "v"), GetParam().v)
      << at_once.files.at("test.c");
}

INSTANTIATE_TEST_SUITE_P(Bodies, RewriterTest, testing::ValuesIn(kBodies),
                         [](const testing::TestParamInfo<Foreign>& body) {
                           return std::string(body.param.name);
                         });

struct Whole {
  const char* name;
  const char* text;
};

// Programs whose errors are outside statements.
const Whole kPrograms[] = {
    {"unsigned_long", "unsigned long v; float f; char c; static int s; int t0() { return v; }\n"},
    {"global_zero", "int v = 0; double d = 0.0; int a[3] = {0, 0}; int t0() { return v; }\n"},
    {"const_number",
     "const int N = 2 * 3; static const double K = 4; int a[N]; "
     "double t0() { return K; }\n"},
    {"plain_char", "char c; unsigned short m; int t0() { c = 'x'; m = 0xFFFF; return c + m; }\n"},
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
    {"misspelt_members",
     "TTrapPrm t; TJogPrm j; TPid p; double d; int t0() { t.Acc = 0.5; t.velstart = d * 2 + 1; "
     "j.smoth = t.smoothtime; d = p.integrallimit + p.kI; GT_SetPid(1, 1, &p); return 0; }\n"},
    {"truth_function", "bool ready(bool on, int n) { if (n) return on; return n > 3 && !on; }\n"},
    {"static_truth", "static bool on; bool const off = false; int t0() { on = off; return on; }\n"},
    {"const_truth", "const bool kOn = true; _Bool b; int t0() { b = kOn; return b; }\n"},
    {"truth_as_a_name", "int t0() { int bool; bool = 5; return bool; }\n"},
    {"header_of_c", "#include <stdbool.h>\nint t0() { return true; }\n"},
    {"full_width", "int v；\nint t0() { v ＝ 1； return v； }\n"},
    {"open_comment", "int t0() { return 0; }\n/* and so on"},
    {"missing_brace", "int t0() return 0; }\n"},
    {"missing_bracket", "int a 3]; int t0() { return a[0]; }\n"},
    {"windows_lines", "int v;\r\nint t0() {\r\n  v = 1 + 2 * 3;\r\n  while (v) v--;\r\n}\r\n"},
    {"no_declarations", "int v; int t0() {\n  v = v * v + 1;\n}\n"},
    {"one_line", "int v; int t0() { v = v * v + 1; while (v) v--; }"},
};

class ProgramTest : public testing::TestWithParam<Whole> {};

TEST_P(ProgramTest, CanBeCorrected) {
  std::string trace;
  const std::string corrected = CorrectOneByOne(GetParam().text, &trace);
  const Compilation compilation = CompileString(corrected);
  EXPECT_TRUE(compilation.ok()) << trace << compilation.diagnostics.front().message.en << '\n'
                                << corrected;
}

INSTANTIATE_TEST_SUITE_P(Programs, ProgramTest, testing::ValuesIn(kPrograms),
                         [](const testing::TestParamInfo<Whole>& program) {
                           return std::string(program.param.name);
                         });

struct MacroCase {
  const char* name;
  const char* body;
  const char* use;
  double value;  ///< of `v` after `v = USE;`, as in C
};

const MacroCase kMacros[] = {
    {"product", "(3*4)", "N - 1", 11},
    {"of_macros", "(M + 1)", "N * 2", 12},
    {"negative", "-(3)", "10 - N", 13},
    {"not", "!0", "N + N", 2},
    {"bits", "(1 << 4 | 2)", "N", 18},
    {"division", "(7 / 2)", "N * 10", 30},
    {"of_doubles", "(2.5 * 4)", "(int) N", 10},
    {"cast", "(int) 3.75", "N * 2", 6},
    {"character", "'x'", "N + 1", 121},
    {"choice", "(M > 3 ? 7 : 8)", "N", 7},
    {"truth", "true", "N + 1", 2},
    {"alone", "3 + 4", "N", 7},
    {"alone_in_parentheses", "3 + 4", "(N) * 2", 14},
    {"alone_in_an_index", "M - 4", "a[N]", 9},
};

class MacroTest : public testing::TestWithParam<MacroCase> {};

TEST_P(MacroTest, HasTheValueOfItsBody) {
  const std::string text = fmt::format(
      "#define M 5\n#define N {}\nint v, a[4];\nint t0() {{\n  a[1] = 9;\n  v = {};\n}}\n",
      GetParam().body, GetParam().use);
  const Compilation compilation = CompileString(text);
  ASSERT_FALSE(compilation.diagnostics.empty());
  EXPECT_EQ(compilation.diagnostics[0].info->code, 35);
  const CorrectedProgram corrected = CorrectString(text);
  ASSERT_TRUE(corrected.compilation.ok()) << corrected.files.at("test.c");
  EXPECT_EQ(RunAndRead(*corrected.compilation.object, "v"), GetParam().value)
      << corrected.files.at("test.c");
}

INSTANTIATE_TEST_SUITE_P(Macros, MacroTest, testing::ValuesIn(kMacros),
                         [](const testing::TestParamInfo<MacroCase>& macro) {
                           return std::string(macro.param.name);
                         });

struct Uncorrectable {
  const char* name;
  const char* text;
  std::vector<int> codes;  ///< the codes that remain
  const char* note;        ///< part of a note with advice
};

// No fix-it is possible in the language, or C gives no meaning: it remains an error.
const Uncorrectable kUncorrectable[] = {
    {"global_value", "int rate = 25; int t0() { return rate; }\n", {110}, "#define"},
    {"global_array", "int a[2] = {0, 1}; int t0() { return a[1]; }\n", {110}, "in a function"},
    {"const_table", "const int a[2] = {1, 2}; int t0() { return a[1]; }\n", {115, 110}, "#define"},
    {"changed_const",
     "const int n = 3; int t0() { n = 4; return n; }\n",
     {115, 110, 31},
     "changed"},
    {"stepped_const",
     "int t0() { const int n = 3; n++; return n; }\n",
     {115, 110, 31, 107},
     "changed"},
    {"nested_const",
     "int v; int t0() { const int n = 3; v = 1 + (n = 2); }\n",
     {115, 110, 100, 31},
     "changed"},
    {"const_output",
     "const int n = 3; int t0() { GT_GetSts(1, &n, 1, &n); }\n",
     {115, 110, 31, 31},
     "changed"},
    {"const_parameter", "int t0(const int n) { n = 4; return n; }\n", {115, 31}, "changed"},
    {"const_without_value", "const int n; int t0() { return n; }\n", {115}, "no value"},
    {"static_local", "int t0() { static int n = 5; n = n + 1; return n; }\n", {115, 110}, "global"},
    {"extern_local", "int t0() { extern int n; n = 1; return n; }\n", {115}, "global"},
    {"twice_the_case",
     "int v; int t0() { switch (v) { case 1: v = 2; break; case 1: v = 3; } }\n",
     {105, 13},
     "first"},
    {"twice_the_same_sum",
     "int v; int t0() { switch (v) { case 3: v = 2; break; case 1 + 2: v = 3; } }\n",
     {105, 13},
     "first"},
    {"twice_default",
     "int v; int t0() { switch (v) { default: v = 2; default: v = 3; } }\n",
     {105, 13},
     "first"},
    {"column_too_big",
     "int m[3][4]; int t0() { m[1][5] = 1; return m[2][3]; }\n",
     {111, 17},
     "declared"},
    {"row_negative", "int m[3][4]; int t0() { return m[-1][5]; }\n", {111, 17, 17}, "declared"},
    {"row_alone", "int m[3][4]; int t0() { return m[5]; }\n", {111, 28}, "each dimension"},
    {"into_a_loop",
     "int v; int t0() { goto in; while (v < 9) { v = v + 2; in: v = v + 1; } }\n",
     {101},
     "label"},
    {"into_a_for",
     "int i; int t0() { for (i = 0; i < 3; i++) { in: i++; } goto in; }\n",
     {102},
     "label"},
    {"code_read",
     "int t0() { int r; r = GT_Update(1); if (r) return 1; return 0; }\n",
     {49},
     "read"},
    {"code_global", "int r; int t0() { r = GT_Update(1); }\n", {49}, "host"},
    {"unsigned_wraps",
     "int v; int t0() { unsigned n; n = v - 1; if (n > 5) v = 1; }\n",
     {114},
     "sign"},
    {"char_wraps", "int v; int t0() { char c; c = v; v = c + 1; }\n", {114}, "sign"},
    {"no_wait", "int t0() { GT_Delay(0.5); }\n", {19}, "truncate 0.5 to 0"},
    {"macro_taken_apart",
     "#define N 3 + 4\nint v; int t0() { v = N * 2; }\n",
     {35},
     "C evaluates 'N' piece by piece here, because its body has no parentheses; add them if 7 is "
     "meant"},
    {"macro_in_a_macro",
     "#define N 3 + 4\n#define O (2 * N)\nint v; int t0() { v = O; }\n",
     {35, 35},
     "C evaluates 'N' piece by piece"},
    {"bool_from_bits", "int v; int t0() { bool b = v & 4; if (b == 1) v = 2; }\n", {114}, "!= 0"},
    {"bool_from_double", "double x; int t0() { bool b = x; return b; }\n", {114}, "!= 0"},
    {"bool_counts", "int t0() { bool b; b = 0; b++; b++; return b; }\n", {114}, "!= 0"},
    {"bool_returns_bits", "bool t0(int n) { return n & 4; }\n", {114}, "!= 0"},
    {"char_returns", "char t0(int n) { return n; }\n", {114}, "sign"},
    {"coarse_float", "double d; int t0() { d = 1000.1f; }\n", {3}, "1000.0999755859375"},
    {"long_long", "long long n; int t0() { return n; }\n", {114}, "32 bits"},
};

class UncorrectableTest : public testing::TestWithParam<Uncorrectable> {};

TEST_P(UncorrectableTest, StaysAnErrorThatSaysWhatToDo) {
  const CorrectedProgram corrected = CorrectString(GetParam().text);
  std::string all;
  std::string notes;
  for (const Diagnostic& diagnostic : corrected.compilation.diagnostics) {
    all += DiagnosticName(diagnostic.info->code) + ": " + diagnostic.message.en + '\n';
    for (const Note& note : diagnostic.notes) notes += note.message.en + '\n';
  }
  EXPECT_FALSE(corrected.compilation.ok());
  EXPECT_EQ(CodesOf(corrected.compilation), GetParam().codes) << all << notes;
  EXPECT_THAT(notes, HasSubstr(GetParam().note)) << all << notes;
}

INSTANTIATE_TEST_SUITE_P(Programs, UncorrectableTest, testing::ValuesIn(kUncorrectable),
                         [](const testing::TestParamInfo<Uncorrectable>& program) {
                           return std::string(program.param.name);
                         });

// Whether a variable can be an int depends on other types, so all types are corrected before the
// loops around them.
TEST(ApplyAllFixIts, CorrectsTypesFirst) {
  const CorrectedProgram corrected = CorrectString(
      "bool ready; int v;\nint t0() {\n  ready = v == 0;\n  while (v < 3) {\n    bool go = ready;\n"
      "    v += go + 1;\n  }\n  return v;\n}\n");
  ASSERT_TRUE(corrected.compilation.ok()) << corrected.files.at("test.c");
  EXPECT_EQ(RunAndRead(*corrected.compilation.object, "v"), 4) << corrected.files.at("test.c");
}

// A semicolon after the call does not end the statement in the macro's body.
TEST(ApplyAllFixIts, EndsWhereACorrectionDoesNotHelp) {
  Options options;
  options.structured = true;
  const CorrectedProgram corrected =
      ApplyAllFixIts("test.c", "#define CLEAR(n) do { for (i = 0; n\nvoid t0() {\n  CLEAR(3);\n}\n",
                     options, ReaderOf({}));
  EXPECT_FALSE(corrected.compilation.ok());
}

// Fix-its may be applied in any order, or one of them alone.
TEST(Rewriter, DeclaresInEachFixItWhatItNeeds) {
  const std::string text =
      "int v;\nint t0() {\n  for (int n = 0; n < 2; n++) v = n;\n"
      "  for (int n = 0; n < 3; n++) v = n;\n}\n";
  const Compilation compilation = CompileString(text);
  ASSERT_EQ(CodesOf(compilation), (std::vector<int>{102, 102}));
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    EXPECT_THAT(ApplyFixIts(text, diagnostic), HasSubstr("\n  int n;\n"));
  }
  const std::string corrected = CorrectString(text).files.at("test.c");
  EXPECT_EQ(corrected.find("int n;"), corrected.rfind("int n;")) << corrected;
}

TEST(Rewriter, KeepsTheCommentsOfABody) {
  const Compilation compilation =
      CompileString("int v;\nint t0() {\n  while (v < 3) {\n    v = v + 1;  // count\n  }\n}\n");
  ASSERT_EQ(CodesOf(compilation), std::vector<int>{101});
  const std::string corrected =
      ApplyFixIts(compilation.files[0].text(), compilation.diagnostics[0]);
  EXPECT_THAT(corrected, HasSubstr("v = v + 1;  // count\n"));
}

// A comment inside an edited range is kept, next to the code that it belonged to.
TEST(Rewriter, KeepsTheCommentsBetweenTheParts) {
  struct Case {
    const char* statement;
    const char* corrected;  ///< the statement's text, up to the end label
  };
  const Case cases[] = {
      {"if (v) /* why */ v = 1;", "cc = !v;\n  if (cc) goto lbl_end;\n  /* why */\n  v = 1;\n"},
      {"if (v) // why\n    v = 1;", "cc = !v;\n  if (cc) goto lbl_end;\n  // why\n  v = 1;\n"},
      {"if (v /* or so */) { v = 1; }", "cc = !v;\n  if (cc) goto lbl_end;\n  /* or so */ v = 1; "},
      {"if (v) // why\n  { v = 1; }", "cc = !v;\n  if (cc) goto lbl_end;\n  // why\n   v = 1; "},
      {"if (v) v = 1; /* or */ else /* not */ v = 2;",
       "cc = !v;\n  if (cc) goto lbl_else;\n  v = 1;\n  goto lbl_end;\n  lbl_else:\n  /* or */\n  "
       "/* not */\n  v = 2;\n"},
      {"while (v > 1) /* down */ v = 1;",
       "lbl_loop:\n  cc = v <= 1;\n  if (cc) goto lbl_end;\n  /* down */\n  v = 1;\n"},
      {"do v = 0; /* down */ while (v);",
       "lbl_loop:\n  v = 0;\n  /* down */\n  if (v) goto lbl_loop;"},
      {"v = v * 2 /* twice */ + 1; // more",
       "/* twice */\n  tmp = v * 2;\n  v = tmp + 1; // more\n"},
      {"v /* half */ /= 2 * \n // too\n 3;",
       "/* half */\n  // too\n  tmp = 2 * 3;\n  v = v / tmp;"},
  };
  for (const Case& test : cases) {
    const std::string text = fmt::format("int v;\nint t0() {{\n  {}\n}}\n", test.statement);
    const Compilation compilation = CompileString(text);
    ASSERT_FALSE(compilation.diagnostics.empty()) << text;
    const std::string corrected = ApplyFixIts(text, compilation.diagnostics[0]);
    EXPECT_THAT(corrected, HasSubstr(test.corrected)) << text << corrected;
    EXPECT_TRUE(CorrectString(text).compilation.ok()) << corrected;
  }
}

TEST(Rewriter, ShowsTheManualsFormOfALoop) {
  const Compilation compilation =
      CompileString("int v;\nint t0() {\n  int i;\n  while (i <= 10) v = i;\n}\n");
  ASSERT_EQ(compilation.diagnostics.size(), 1u);
  EXPECT_EQ(ApplyFixIts(compilation.files[0].text(), compilation.diagnostics[0]),
            "int v;\nint t0() {\n  int i;\n  int cc;\n  lbl_loop:\n  cc = i > 10;\n"
            "  if (cc) goto lbl_end;\n  v = i;\n  goto lbl_loop;\n  lbl_end:\n  return;\n}\n");
}

// What a fix-it writes is what a person would have written: constants keep their names, a jump that
// an `if` decides about stays its statement, and a global is read as often as in C.
TEST(Rewriter, WritesWhatAPersonWouldWrite) {
  struct Case {
    const char* statement;
    const char* corrected;
  };
  const Case cases[] = {
      {"v = LIMIT * 2 + 0x10;", "  tmp = LIMIT * 2;\n  v = tmp + 0x10;\n"},
      {"v = a[LIMIT] + 1 - v;", "  tmp = a[LIMIT] + 1;\n  v = tmp - v;\n"},
      {"x = x * LIMIT + 3;", "  tmp = x * LIMIT;\n  x = tmp + 3;\n"},
      {"v = -LIMIT + v * 2;", "  tmp = v * 2;\n  v = -LIMIT + tmp;\n"},
      {"if (v) { goto done; }", "  if (v) goto done;\n"},
      {"if (v > 3) { return LIMIT; }", "  cc = v > 3;\n  if (cc) return LIMIT;\n"},
      {"if (v > 3 || v < 1) return 0;",
       "  cc = v > 3;\n  if (cc) return 0;\n  cc = v < 1;\n  if (cc) return 0;\n"},
      {"if (v % 2 == 0 && !i) return v + 1;",
       "  tmp = v % 2;\n  cc = tmp != 0;\n  if (cc) goto lbl_end;\n  if (i) goto lbl_end;\n"
       "  tmp1 = v + 1;\n  return tmp1;\n  lbl_end:\n"},
      {"i = v > 3 ? v : 5;",
       "  cc = v <= 3;\n  if (cc) goto lbl_else;\n  i = v;\n  goto lbl_end;\n  lbl_else:\n"
       "  i = 5;\n  lbl_end:\n"},
      {"switch (v) { case LIMIT: i = 1; break; default: i = 2; }",
       "  tmp = v;\n  cc = tmp == LIMIT;\n  if (cc) goto lbl_case_2;\n  goto lbl_default; "
       "lbl_case_2: i = 1; goto lbl_end; lbl_default: i = 2; lbl_end:\n"},
  };
  for (const Case& test : cases) {
    const std::string text = fmt::format(
        "#define LIMIT 2\nint v, a[4];\nint t0() {{\n  int i;\n  double x;\n  i = 0;\n  x = 0;\n"
        "  {}\n  done:\n  return i;\n}}\n",
        test.statement);
    const Compilation compilation = CompileString(text);
    ASSERT_FALSE(compilation.diagnostics.empty()) << text;
    EXPECT_THAT(ApplyFixIts(text, compilation.diagnostics[0]), HasSubstr(test.corrected)) << text;
  }
}

// An initial value moves below the declarations, where a name may mean another variable.
TEST(Rewriter, RenamesBeforeItMovesInitialValues) {
  const CorrectedProgram corrected =
      CorrectString("int k;\nint t0() {\n  int n = k + 1, k = 4;\n  return n * k;\n}\n");
  EXPECT_TRUE(corrected.compilation.ok());
  EXPECT_THAT(corrected.files.at("test.c"), HasSubstr("n = k + 1;\n  k1 = 4;\n"));
}

TEST(Rewriter, TakesNamesThatAreFree) {
  const Compilation compilation =
      CompileString("int tmp, tmp1;\nint t0() {\n  tmp = tmp * 2 + tmp1;\n}\n");
  ASSERT_EQ(compilation.diagnostics.size(), 1u);
  EXPECT_THAT(compilation.diagnostics[0].fixits[0].text, HasSubstr("int tmp2;"));
}

}  // namespace
}  // namespace oncard::compiler
