// GT commands, which stay as they are: arguments become operands, and ints become doubles where the
// command takes doubles. Everything else about them is checked in the lowered text.
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {

// `&variable`, `&array[index]`, `&structure`, and an array's name for its first element.
std::optional<Operand> Lowerer::LowerAddress(const Expression& argument) {
  const Expression& inner = WithoutParens(argument);
  const bool address = inner.kind == Expression::Kind::kUnary && inner.op == "&";
  const Expression& target = address ? WithoutParens(*inner.operands[0]) : inner;
  Operand operand;
  if (IsArray(target)) {
    const std::optional<ArrayPlace> array = LowerArray(target);
    if (!array) return std::nullopt;
    operand.kind = Operand::Kind::kElement;
    operand.variable = array->variable;
    operand.type = program_.variables[static_cast<size_t>(array->variable)].type;
    if (array->offset.IsConstant()) {
      operand.value = array->offset.value;
    } else {
      operand.index = Stable(array->offset, target.range).variable;
    }
    if (array->element.is_const) Report(Code::kWriteToConst, target.range, Source(target.range));
  } else {
    const std::optional<Place> place = LowerPlace(target);
    if (!place || !CheckWritable(*place, target)) return std::nullopt;
    operand = place->operand;
  }
  operand.address = true;
  return operand;
}

void Lowerer::LowerCommand(const Expression& call, const gtcalls::Command& command) {
  Instruction instruction;
  instruction.kind = Instruction::Kind::kCall;
  instruction.command = &command;
  for (size_t i = 1; i < call.operands.size(); ++i) {
    const Expression& argument = *call.operands[i];
    const Expression& inner = WithoutParens(argument);
    const bool address = inner.kind == Expression::Kind::kUnary && inner.op == "&";
    const gtcalls::Parameter* parameter =
        i <= command.parameters.size() ? &command.parameters[i - 1] : nullptr;
    const bool by_value = parameter == nullptr || parameter->passing == gtcalls::Passing::kValue;
    if (address || (!by_value && IsArray(argument))) {
      const std::optional<Operand> operand = LowerAddress(argument);
      if (!operand) return;
      instruction.arguments.push_back(*operand);
      continue;
    }
    Value value = LowerValue(argument);
    if (!RequireNumber(value, argument)) return;
    if (parameter != nullptr && by_value) {
      const bool real = parameter->type == gtcalls::Scalar::kDouble;
      if (real != (value.type == BasicType::kDouble)) {
        value = Convert(value, real ? BasicType::kDouble : BasicType::kInt, argument.range);
      }
    }
    instruction.arguments.push_back(value.operand);
  }
  Emit(std::move(instruction), call.range);
}

}  // namespace oncard::compiler::lowering
