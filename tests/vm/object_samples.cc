#include "tests/vm/object_samples.h"

#include <utility>

namespace oncard::vm {

Instruction Malformed(Opcode opcode, uint16_t op, std::vector<Operand> operands) {
  return {opcode, op, DataType::kInt, std::move(operands), 0};
}

Instruction Unary(UnaryOperator op, DataType type, const Operand& src, const Operand& dst) {
  return {Opcode::kUnary, static_cast<uint16_t>(op), type, {src, dst}, 0};
}

Instruction Binary(BinaryOperator op, DataType type, const Operand& a, const Operand& b,
                   const Operand& dst) {
  return {Opcode::kBinary, static_cast<uint16_t>(op), type, {a, b, dst}, 0};
}

Instruction Jump(const Operand& condition, int16_t displacement) {
  return {Opcode::kJump, 0, DataType::kInt, {condition}, displacement};
}

Instruction Return(const Operand& condition, const Operand& value) {
  return Malformed(Opcode::kReturn, 0, {condition, value});
}

Instruction Command(uint16_t number, std::vector<Operand> arguments) {
  return Malformed(Opcode::kCommand, number, std::move(arguments));
}

const CommandShape* FakeCommands::Find(uint16_t number) const {
  static constexpr DataType kIntSlot[] = {DataType::kInt};
  static constexpr DataType kDoubleSlot[] = {DataType::kDouble};
  static constexpr DataType kTrapSlots[] = {DataType::kDouble, DataType::kDouble, DataType::kDouble,
                                            DataType::kInt};
  static constexpr DataType kPairSlots[] = {DataType::kInt, DataType::kDouble};
  static constexpr ParameterShape kValue = {"value", false, kIntSlot, -1};
  static constexpr ParameterShape kSetVelParameters[] = {kValue, {"vel", false, kDoubleSlot, -1}};
  static constexpr ParameterShape kGetPosParameters[] = {
      kValue, {"pos", true, kDoubleSlot, 2}, {"count", false, kIntSlot, -1}};
  static constexpr ParameterShape kSetTrapPrmParameters[] = {kValue,
                                                             {"trap", true, kTrapSlots, -1}};
  static constexpr ParameterShape kGetClockParameters[] = {{"clock", true, kIntSlot, -1}};
  static constexpr ParameterShape kLoadParameters[] = {{"file", true, {}, -1}};
  static constexpr ParameterShape kReadPairsParameters[] = {{"pairs", true, kPairSlots, 1},
                                                            {"count", false, kIntSlot, -1}};
  static constexpr ParameterShape kShorts[16] = {kValue, kValue, kValue, kValue, kValue, kValue,
                                                 kValue, kValue, kValue, kValue, kValue, kValue,
                                                 kValue, kValue, kValue, kValue};
  static constexpr std::span<const ParameterShape> kAll = kShorts;
  static constexpr CommandShape kCommands[] = {
      {kSetDo, "GT_SetDo", kAll.first(1), true},
      {kSetVel, "GT_SetVel", kSetVelParameters, true},
      {kGetPos, "GT_GetPos", kGetPosParameters, true},
      {kSetTrapPrm, "GT_SetTrapPrm", kSetTrapPrmParameters, true},
      {kGetClock, "GT_GetClock", kGetClockParameters, true},
      {kOpen, "GT_Open", kAll.first(1), false},
      {kFifteen, "GT_Fifteen", kAll.first(15), true},
      {kSixteen, "GT_Sixteen", kAll, true},
      {kLoad, "GT_Load", kLoadParameters, true},
      {kReadPairs, "GT_ReadPairs", kReadPairsParameters, true},
  };
  for (const CommandShape& command : kCommands) {
    if (command.number == number) return &command;
  }
  return nullptr;
}

int16_t FakeCommands::Execute(uint16_t, Machine&, int, std::span<CommandArgument>) { return 0; }

Object SumObject() {
  constexpr Variable kTotal = Global(0);
  constexpr Variable kBegin = Local(0);
  constexpr Variable kEnd = Local(1);
  constexpr Variable kCounter = Local(2);
  constexpr Variable kCc = Local(3);
  Function add;
  add.name = "add";
  add.file = "sum.c";
  add.return_type = DataType::kInt;
  add.instructions = {
      Unary(UnaryOperator::kCopy, DataType::kInt, kBegin, kCounter),
      Binary(BinaryOperator::kGreater, DataType::kInt, kCounter, kEnd, kCc),
      Jump(kCc, 4),
      Binary(BinaryOperator::kAdd, DataType::kInt, kTotal, kCounter, kTotal),
      Binary(BinaryOperator::kAdd, DataType::kInt, kCounter, ImmediateInt(1), kCounter),
      Jump(ImmediateInt(1), -4),
      Return(ImmediateInt(1), kTotal),
  };
  add.lines = {13, 15, 16, 17, 18, 19, 21};
  add.variables = {{"begin", 0, DataType::kInt, 0},
                   {"end", 1, DataType::kInt, 0},
                   {"i", 2, DataType::kInt, 0},
                   {"cc", 3, DataType::kInt, 0}};
  Object object;
  object.functions = {add};
  object.globals = {{"sum", 0, DataType::kInt, 0}};
  return object;
}

Object ArrayObject() {
  const Element local_by_local{Storage::kLocal, 1, 5, Local(0)};
  const Element local_by_global{Storage::kLocal, 1, 5, Global(0)};
  const Element global_by_local{Storage::kGlobal, 1, 8, Local(0)};
  const Element global_by_global{Storage::kGlobal, 1, 8, Global(0)};
  const Element position{Storage::kGlobal, 9, 4, Local(0)};
  Function work;
  work.name = "work";
  work.file = "array.c";
  work.return_type = DataType::kVoid;
  work.instructions = {
      Unary(UnaryOperator::kCopy, DataType::kInt, local_by_local, global_by_global),
      Binary(BinaryOperator::kXor, DataType::kInt, global_by_local, ImmediateInt(-2),
             local_by_global),
      Unary(UnaryOperator::kCopy, DataType::kInt, ImmediateInt(7), Local(3)),
      Command(kSetDo, {global_by_local}),
      Command(kGetPos, {ImmediateInt(1), Global(9), ImmediateInt(4)}),
      Command(kGetPos, {ImmediateInt(1), position, Local(0)}),
      Command(kGetClock, {Local(0)}),
      Jump(Global(0), -7),
      Return(ImmediateInt(1), ImmediateInt(0)),
  };
  work.lines = {5, 6, 7, 8, 9, 10, 11, 12, 13};
  work.variables = {{"i", 0, DataType::kInt, 0}, {"a", 1, DataType::kInt, 5}};
  Function nothing;
  nothing.name = "nothing";
  nothing.file = "array.c";
  nothing.return_type = DataType::kInt;
  Object object;
  object.functions = {work, nothing};
  object.globals = {{"n", 0, DataType::kInt, 0},
                    {"table", 1, DataType::kInt, 8},
                    {"pos", 9, DataType::kDouble, 4}};
  return object;
}

Object StructureObject() {
  Function move;
  move.name = "move";
  move.file = "move.c";
  move.return_type = DataType::kDouble;
  move.instructions = {
      Unary(UnaryOperator::kCopy, DataType::kDouble, Raw(0x4000), Local(0)),  // trap.acc = 0.25
      Unary(UnaryOperator::kCopy, DataType::kInt, ImmediateInt(25), Local(3)),
      Command(kSetTrapPrm, {ImmediateInt(1), Local(0)}),
      Command(kSetVel, {ImmediateInt(1), Global(0)}),
      Binary(BinaryOperator::kMultiply, DataType::kDouble, Global(0), Raw(-0x18000), Global(0)),
      Binary(BinaryOperator::kLess, DataType::kDouble, Global(0), Local(0), Local(4)),
      Unary(UnaryOperator::kToInt, DataType::kDouble, Global(0), Local(4)),
      Unary(UnaryOperator::kFabs, DataType::kDouble, Global(0), Local(1)),
      Return(Local(4), Local(1)),
  };
  move.lines = {4, 5, 6, 7, 8, 9, 10, 11, 12};
  move.variables = {{"trap.acc", 0, DataType::kDouble, 0},
                    {"trap.dec", 1, DataType::kDouble, 0},
                    {"trap.velStart", 2, DataType::kDouble, 0},
                    {"trap.smoothTime", 3, DataType::kInt, 0},
                    {"less", 4, DataType::kInt, 0}};
  Object object;
  object.functions = {move};
  object.globals = {{"vel", 0, DataType::kDouble, 0}};
  object.double_format = DoubleFormat::k16_16;
  return object;
}

}  // namespace oncard::vm
