// Instructions, symbols and lines of the object, compared with the format's one public example and
// the encoding rules of vm/object.h.
#include <gtest/gtest.h>

#include "gtcalls/gts/catalogue.h"
#include "tests/compiler/compiler_support.h"
#include "vm/object_writer.h"
#include "vm/verifier.h"

namespace oncard::compiler {
namespace {

using vm::DataType;
using vm::Element;
using vm::Immediate;
using vm::ImmediateInt;
using vm::Instruction;
using vm::Opcode;
using vm::Storage;
using vm::Variable;

// Example 10-1 of the GTS manual with its statements on lines 13 15 16 17 18 19 21.
constexpr char kExample[] =
    "/*------------------------------------------------\n"
    "\n"
    "\n"
    "\n"
    "------------------------------------------------*/\n"
    "int sum;\n"
    "\n"
    "int add(int begin, int end)\n"
    "{\n"
    " int i;\n"
    " int cc;\n"
    "\n"
    " i=begin;\n"
    "lbl_loop:\n"
    " cc = i>end;\n"
    " if(cc) goto lbl_end;\n"
    " sum = sum + i;\n"
    " i = i + 1;\n"
    " goto lbl_loop;\n"
    "lbl_end:\n"
    " return sum;\n"
    "}\n";

TEST(Translation, GivesTheVendorsObjectForExample10_1) {
  Compilation compilation = CompileText("sum.c", kExample, {}, {});
  ASSERT_TRUE(compilation.ok());
  const vm::ObjectFiles files = vm::WriteObject(*compilation.object, true);
  const std::vector<uint16_t> words = {
      0x0001, 0x0001, 0x0007,                                                          //
      0x0005, 0x5041, 0x0001, 0x0000, 0x0001, 0x0002, 0x0003, 0x000A, 0x0001, 0x0001,  //
      0x0006, 0x5040, 0x000B, 0x0002, 0x0001, 0x0001, 0x0003, 0x0004, 0x0016, 0x0001, 0x0001,
      0x0001,                                                  //
      0x0003, 0x5080, 0x0003, 0x0004, 0x0002, 0x0001, 0x0001,  //
      0x0006, 0x5040, 0x0001, 0x0000, 0x0002, 0x0001, 0x0000, 0x0004, 0x0016, 0x0003, 0x0001,
      0x0003,  //
      0x0008, 0x5040, 0x0001, 0x0002, 0x0001, 0x0000, 0x0000, 0x0001, 0x0002, 0x0003, 0x0012,
      0x0001, 0x0001,                                  //
      0x0003, 0x5080, 0x0001, 0xFFFC, 0x0001, 0x0000,  //
      0x0003, 0x5081, 0x0001, 0x0000, 0x0002, 0x0002, 0x0003};
  ASSERT_EQ(files.bin.size(), 140u);
  ASSERT_EQ(words.size(), 70u);
  for (size_t i = 0; i < words.size(); ++i) {
    const auto low = static_cast<uint8_t>(files.bin[2 * i]);
    const auto high = static_cast<uint8_t>(files.bin[2 * i + 1]);
    EXPECT_EQ(low | high << 8, words[i]) << "word " << i;
  }
  EXPECT_EQ(files.ini.size(), 129u);
  EXPECT_EQ(compilation.object->functions[0].lines,
            (std::vector<uint16_t>{13, 15, 16, 17, 18, 19, 21}));
}

// The instructions of `int t0(int p) { BODY }` with the globals below.
std::vector<Instruction> Translate(const std::string& body) {
  const Compilation compilation = CompileString(
      "int g, a[4]; double d; TTrapPrm trap; long clock;\n"
      "int t0(int p) { int i; double x; int b[3];\n" +
      body + "\n}\n");
  EXPECT_TRUE(compilation.ok()) << (compilation.diagnostics.empty()
                                        ? ""
                                        : compilation.diagnostics[0].message.en);
  return compilation.ok() ? compilation.object->functions[0].instructions
                          : std::vector<Instruction>();
}

const Variable kG{Storage::kGlobal, 0};
const Variable kD{Storage::kGlobal, 5};
const Variable kP{Storage::kLocal, 0};
const Variable kI{Storage::kLocal, 1};
const Variable kX{Storage::kLocal, 2};

TEST(Translation, NumbersSlotsInOrderOfDeclaration) {
  const Compilation compilation = CompileString(
      "int a; int b[3]; TTrapPrm t; double c;\nint f(int p, double q) { int l; int m[2]; int n; "
      "}\n");
  ASSERT_TRUE(compilation.ok());
  const std::vector<vm::Symbol> globals = {{"a", 0, DataType::kInt, 0},
                                           {"b", 1, DataType::kInt, 3},
                                           {"t.acc", 4, DataType::kDouble, 0},
                                           {"t.dec", 5, DataType::kDouble, 0},
                                           {"t.velStart", 6, DataType::kDouble, 0},
                                           {"t.smoothTime", 7, DataType::kInt, 0},
                                           {"c", 8, DataType::kDouble, 0}};
  EXPECT_EQ(compilation.object->globals, globals);
  const std::vector<vm::Symbol> locals = {{"p", 0, DataType::kInt, 0},
                                          {"q", 1, DataType::kDouble, 0},
                                          {"l", 2, DataType::kInt, 0},
                                          {"m", 3, DataType::kInt, 2},
                                          {"n", 5, DataType::kInt, 0}};
  EXPECT_EQ(compilation.object->functions[0].variables, locals);
}

TEST(Translation, CopiesWithTheTypeOfTheTarget) {
  const Instruction int_copy{Opcode::kUnary, 1, DataType::kInt, {ImmediateInt(7), kG}};
  EXPECT_EQ(Translate("g = 7;"), std::vector{int_copy});
  const Instruction double_copy{Opcode::kUnary, 1, DataType::kDouble, {ImmediateInt(7), kD}};
  EXPECT_EQ(Translate("d = 7;"), std::vector{double_copy});
  const Instruction half{Opcode::kUnary, 1, DataType::kDouble, {Immediate{32768}, kD}};
  EXPECT_EQ(Translate("d = 0.5;"), std::vector{half});
}

TEST(Translation, ConvertsWithTheTypeOfTheOperand) {
  const Instruction to_int{Opcode::kUnary, 6, DataType::kDouble, {kX, kI}};
  EXPECT_EQ(Translate("i = (int) x;"), std::vector{to_int});
  const Instruction to_double{Opcode::kUnary, 7, DataType::kInt, {kI, kX}};
  EXPECT_EQ(Translate("x = (double) i;"), std::vector{to_double});
  const Instruction copy{Opcode::kUnary, 1, DataType::kInt, {kP, kI}};
  EXPECT_EQ(Translate("i = (int) p;"), std::vector{copy});
}

TEST(Translation, ComparesWithTheTypeOfTheOperands) {
  const Instruction compare{Opcode::kBinary, 0x0B, DataType::kDouble, {kX, ImmediateInt(1), kI}};
  EXPECT_EQ(Translate("i = x > 1;"), std::vector{compare});
}

TEST(Translation, TellsElementsByVariableFromThoseByConstant) {
  const Instruction by_constant{
      Opcode::kUnary, 1, DataType::kInt, {Variable{Storage::kGlobal, 3}, kI}};
  EXPECT_EQ(Translate("i = a[2];"), std::vector{by_constant});
  const Instruction by_variable{
      Opcode::kUnary, 1, DataType::kInt, {Element{Storage::kGlobal, 1, 4, kI}, kG}};
  EXPECT_EQ(Translate("g = a[i];"), std::vector{by_variable});
  const Instruction local{
      Opcode::kUnary, 1, DataType::kInt, {kG, Element{Storage::kLocal, 3, 3, kG}}};
  EXPECT_EQ(Translate("b[g] = g;"), std::vector{local});
}

TEST(Translation, JumpsRelativeToTheJump) {
  const std::vector<Instruction> code =
      Translate("again: g = 1; if (g) goto done; goto again; done: if (i) return g; return;");
  ASSERT_EQ(code.size(), 5u);
  EXPECT_EQ(code[1], (Instruction{Opcode::kJump, 0, DataType::kInt, {kG}, 2}));
  EXPECT_EQ(code[2], (Instruction{Opcode::kJump, 0, DataType::kInt, {ImmediateInt(1)}, -2}));
  EXPECT_EQ(code[3], (Instruction{Opcode::kReturn, 0, DataType::kInt, {kI, kG}}));
  EXPECT_EQ(code[4],
            (Instruction{Opcode::kReturn, 0, DataType::kInt, {ImmediateInt(1), ImmediateInt(0)}}));
}

TEST(Translation, PassesAddressesAsVariables) {
  const gtcalls::Command* command = gtcalls::GtsCatalogue().Find("GT_SetTrapPrm");
  ASSERT_NE(command, nullptr);
  const Instruction call{Opcode::kCommand,
                         command->number,
                         DataType::kInt,
                         {ImmediateInt(1), Variable{Storage::kGlobal, 6}}};
  EXPECT_EQ(Translate("GT_SetTrapPrm(1, &trap);"), std::vector{call});
}

TEST(Translation, WritesAnUnknownLineBeyondTheWordOfTheFormat) {
  const Compilation compilation =
      CompileString("int v;\nint t0() {\n v = 1;" + std::string(65535, '\n') + " v = 2;\n}\n");
  ASSERT_TRUE(compilation.ok());
  EXPECT_EQ(compilation.object->functions[0].lines, (std::vector<uint16_t>{3, 0}));
}

TEST(Translation, NamesTheFileOfEachFunction) {
  Options options;
  const Compilation compilation = CompileString("#include \"other.h\"\nint t1() { return 0; }\n",
                                                options, {{"other.h", "int t0() { return 0; }\n"}});
  ASSERT_TRUE(compilation.ok());
  EXPECT_EQ(compilation.object->functions[0].file, "other.h");
  EXPECT_EQ(compilation.object->functions[1].file, "test.c");
}

TEST(Translation, IsTheSameEveryTime) {
  const Compilation first = CompileText("sum.c", kExample, {}, {});
  const Compilation second = CompileText("sum.c", kExample, {}, {});
  EXPECT_EQ(*first.object, *second.object);
}

TEST(Translation, PassesTheVerifier) {
  const Compilation compilation = CompileString(
      "long sts[8], clock; double pos; TPid pid;\n"
      "int t0(int axis) {\n"
      "  GT_GetSts(1, &sts[0], 8, &clock);\n"
      "  GT_GetSts(axis, &sts[axis], axis, &clock);\n"
      "  GT_GetPid(1, 1, &pid);\n"
      "  GT_GetEncPos(axis, &pos, 1, &clock);\n"
      "}\n");
  ASSERT_TRUE(compilation.ok()) << compilation.diagnostics[0].message.en;
  const CatalogueShapes shapes;
  const Result<void> verified = vm::Verify(*compilation.object, shapes);
  EXPECT_TRUE(verified.ok()) << verified.error().message.en;
}

}  // namespace
}  // namespace oncard::compiler
