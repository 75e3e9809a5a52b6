#include "vm/disassembler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/vm/object_samples.h"

namespace oncard::vm {
namespace {

using testing::HasSubstr;

TEST(DisassemblerTest, SumIsListedWithTheVendorsWords) {
  EXPECT_EQ(Disassemble(SumObject(), FakeCommands()), R"(double 32.16
globals
      0  int     sum

function 1 'add' of sum.c returns int
variables
      0  int     begin
      1  int     end
      2  int     i
      3  int     cc
instructions
      0  line 13     i := begin      ; 0005 5041 0001 0000 0001 0002  0003 000A 0001 0001
      1  line 15     cc := i > end   ; 0006 5040 000B 0002 0001 0001 0003  0004 0016 0001 0001 0001
      2  line 16     if cc goto 6    ; 0003 5080 0003 0004  0002 0001 0001
      3  line 17     sum := sum + i  ; 0006 5040 0001 0000 0002 0001 0000  0004 0016 0003 0001 0003
      4  line 18     i := i + 1      ; 0008 5040 0001 0002 0001 0000 0000 0001 0002  0003 0012 0001 0001
      5  line 19     goto 1          ; 0003 5080 0001 FFFC  0001 0000
      6  line 21     return sum      ; 0003 5081 0001 0000  0002 0002 0003
)");
}

TEST(DisassemblerTest, ArraysAndCommandsAreListed) {
  EXPECT_EQ(Disassemble(ArrayObject(), FakeCommands()), R"(double 32.16
globals
      0  int     n
      1  int     table[8]
      9  double  pos[4]

function 1 'work' of array.c returns void
variables
      0  int     i
      1  int     a[5]
instructions
      0  line 5      table[n] := a[i]          ; 0005 5041 0001 0001 0001 0001  0007 000A 0011 0005 0000 0033 0008 0000
      1  line 6      a[n] := table[i] ^ -2     ; 0008 5040 0010 0001 FFFE FFFF 0000 0001 0001  0007 0012 0013 0008 0000 0031 0005 0000
      2  line 7      a[2] := 7                 ; 0007 5041 0001 0007 0000 0000 0001 0003  0002 0008 0001
      3  line 8      GT_SetDo(table[i])        ; 0003 5090 0001 0001  0004 0002 0013 0008 0000
      4  line 9      GT_GetPos(1, &pos[0], 4)  ; 0009 5090 0003 0001 0000 0000 0009 0004 0000 0000  0002 0004 0003
      5  line 10     GT_GetPos(1, &pos[i], i)  ; 0007 5090 0003 0001 0000 0000 0009 0000  0005 000C 0013 0004 0000 0001
      6  line 11     GT_GetClock(&i)           ; 0003 5090 0005 0000  0002 0002 0001
      7  line 12     if n goto 0               ; 0003 5080 0000 FFF9  0002 0001 0003
      8  line 13     return                    ; 0005 5081 0001 0000 0000 0000  0001 0000

function 2 'nothing' of array.c returns int
)");
}

TEST(DisassemblerTest, JsonHoldsTheSameFacts) {
  Object object = StructureObject();
  object.functions[0].instructions.resize(1);
  object.functions[0].lines.resize(1);
  object.functions[0].variables.resize(1);
  object.globals = {{"g", 0, DataType::kInt, 3}};
  EXPECT_EQ(DisassembleJson(object, FakeCommands()), R"({
  "double": "16.16",
  "globals": [
    {
      "name": "g",
      "id": 0,
      "type": "int",
      "size": 3
    }
  ],
  "functions": [
    {
      "id": 1,
      "name": "move",
      "file": "move.c",
      "returns": "double",
      "variables": [
        {
          "name": "trap.acc",
          "id": 0,
          "type": "double"
        }
      ],
      "instructions": [
        {
          "index": 0,
          "line": 4,
          "statement": "trap.acc := 0.25",
          "words": "0007 5041 0001 0000 0000 4000 0002 0000  0002 0008 0001"
        }
      ]
    }
  ]
}
)");
}

TEST(DisassemblerTest, JsonSurvivesFileNamesThatAreNotUtf8) {
  Object object = SumObject();
  object.functions[0].file = "\xCE.c";
  EXPECT_THAT(DisassembleJson(object, FakeCommands()), HasSubstr("\"\xEF\xBF\xBD.c\""));
}

struct Statement {
  Instruction instruction;
  std::string text;
};

// In the function of StructureObject(): locals trap.acc, trap.dec, trap.velStart, trap.smoothTime
// and less, and a global vel.
TEST(DisassemblerTest, EveryFormOfStatement) {
  const DataType kInt = DataType::kInt;
  const DataType kDouble = DataType::kDouble;
  const std::vector<Statement> statements = {
      {Unary(UnaryOperator::kCopy, kInt, ImmediateInt(-5), Local(4)), "less := -5"},
      {Unary(UnaryOperator::kNot, kInt, Local(4), Local(4)), "less := ! less"},
      {Unary(UnaryOperator::kInvert, kInt, Local(4), Local(4)), "less := ~ less"},
      {Unary(UnaryOperator::kAbs, kInt, Local(4), Local(4)), "less := abs(less)"},
      {Unary(UnaryOperator::kFabs, kDouble, Global(0), Global(0)), "vel := fabs(vel)"},
      {Unary(UnaryOperator::kToInt, kDouble, Global(0), Local(4)), "less := (int) vel"},
      {Unary(UnaryOperator::kToDouble, kInt, Local(4), Global(0)), "vel := (double) less"},
      {Unary(UnaryOperator::kCopy, kDouble, ImmediateInt(3), Global(0)), "vel := 3.0"},
      {Unary(static_cast<UnaryOperator>(99), kInt, Local(4), Local(4)),
       "less := operator 99(less)"},
      {Binary(BinaryOperator::kAdd, kDouble, Global(0), Raw(0x8000), Global(0)),
       "vel := vel + 0.5"},
      {Binary(BinaryOperator::kShiftLeft, kInt, ImmediateInt(1), Local(4), Local(4)),
       "less := 1 << less"},
      {Binary(static_cast<BinaryOperator>(99), kInt, Local(4), ImmediateInt(1), Local(4)),
       "less := operator 99(less, 1)"},
      {Jump(ImmediateInt(1), 2), "goto 2"},
      {Jump(Local(3), -1), "if trap.smoothTime goto -1"},
      {Jump(ImmediateInt(7), 0), "if 7 goto 0"},
      {Return(ImmediateInt(1), ImmediateInt(0)), "return 0.0"},
      {Return(Local(4), Global(0)), "if less return vel"},
      {Command(kSetDo, {ImmediateInt(12)}), "GT_SetDo(12)"},
      {Command(kSetVel, {ImmediateInt(1), ImmediateInt(12)}), "GT_SetVel(1, 12.0)"},
      {Command(kSetTrapPrm, {ImmediateInt(1), Local(0)}), "GT_SetTrapPrm(1, &trap)"},
      {Command(kGetPos, {ImmediateInt(1), Local(1), ImmediateInt(1)}),
       "GT_GetPos(1, &trap.dec, 1)"},
      {Command(77, {ImmediateInt(1), Raw(0x8000), Local(4)}), "command 77(1, 0.5, less)"},
      {Unary(UnaryOperator::kCopy, kInt, Local(5), Global(1023)), "global:1023 := local:5"},
      {Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 5, 2, Global(9)}, Local(4)),
       "less := local:5[global:9]"},
  };
  Object object = StructureObject();
  for (const Statement& statement : statements) {
    object.functions[0].instructions = {statement.instruction};
    EXPECT_EQ(DescribeInstruction(object, object.functions[0], 0, FakeCommands()), statement.text);
  }
}

TEST(DisassemblerTest, VoidFunctionReturnsNothing) {
  Object object = StructureObject();
  object.functions[0].return_type = DataType::kVoid;
  object.functions[0].instructions = {Return(Local(4), ImmediateInt(0))};
  EXPECT_EQ(DescribeInstruction(object, object.functions[0], 0, FakeCommands()), "if less return");
}

TEST(DisassemblerTest, LongStatementsDoNotWidenTheColumn) {
  Object object = SumObject();
  object.functions[0].instructions = {
      Jump(ImmediateInt(1), 0), Command(kFifteen, std::vector<Operand>(15, ImmediateInt(12345)))};
  object.functions[0].lines = {1, 2};
  EXPECT_THAT(Disassemble(object, FakeCommands()), HasSubstr("line 1      goto 0  ; 0003 5080"));
}

}  // namespace
}  // namespace oncard::vm
