// C's conversions: between int and double by the card's own statements, to narrower integers by
// shifts and masks, to bool by a comparison.
#include "compiler/lowering/lowerer.h"
#include "vm/arithmetic.h"

namespace oncard::compiler::lowering {

Value Lowerer::Convert(Value value, BasicType type, SourceRange range) {
  if (IsVoid(value) || !IsArithmetic(type) || value.type == type) return value;
  const bool fits = Fits(value.range, type);
  const bool to_double = type == BasicType::kDouble;
  const bool from_double = value.type == BasicType::kDouble;
  if (value.operand.IsConstant()) {
    const int wrap_shift = vm::WrapShift(options_.double_format);
    int64_t number = value.operand.value;
    if (to_double) {
      number = vm::FixedFromInt(static_cast<int32_t>(number), wrap_shift);
    } else if (from_double && type == BasicType::kBool) {
      number = number != 0 ? 1 : 0;
    } else {
      if (from_double) number = vm::IntFromFixed(number);
      number = ConvertInteger(number, type);
    }
    Operand converted = ConstantOperand(DataTypeOf(type), number);
    // An int beside a double is written the same.
    if (to_double) converted.name = value.operand.name;
    return {converted, type, type};
  }
  Value result;
  if (to_double) {
    result = Compute(vm::UnaryOperator::kToDouble, value.operand, type, range);
  } else if (type == BasicType::kBool) {
    if (fits) return {value.operand, type, type};
    result = Compute(vm::BinaryOperator::kNotEqual, value.operand,
                     ConstantOperand(value.operand.type, 0), type, range);
  } else {
    if (from_double) {
      value = Compute(vm::UnaryOperator::kToInt, value.operand, BasicType::kInt, range);
    }
    if (fits || Fits(BasicType::kInt, type)) {
      return {value.operand, type, fits ? value.range : type};
    }
    const bool is_signed = type == BasicType::kChar || type == BasicType::kShort;
    const bool byte = SizeOf(type) == 1;
    if (is_signed) {
      const Operand count = IntOperand(byte ? 24 : 16);
      value = Compute(vm::BinaryOperator::kShiftLeft, value.operand, count, BasicType::kInt, range);
      result = Compute(vm::BinaryOperator::kShiftRight, value.operand, count, type, range);
    } else {
      const Operand mask = IntOperand(byte ? UINT8_MAX : UINT16_MAX);
      result = Compute(vm::BinaryOperator::kAnd, value.operand, mask, type, range);
    }
  }
  result.type = result.range = type;
  return result;
}

// A value that is used more than once must not be read more than once if it is shared.
Value Lowerer::Load(Value value, SourceRange range) {
  value.operand = Stable(value.operand, range);
  return value;
}

Operand Lowerer::Stable(const Operand& operand, SourceRange range) {
  if (operand.IsConstant() || operand.kind == Operand::Kind::kNone) return operand;
  if (operand.IsVariable() && !IsShared(operand)) return operand;
  const Operand temporary = NewTemporary(operand.type, range);
  EmitCopy(temporary, operand, range);
  return temporary;
}

}  // namespace oncard::compiler::lowering
