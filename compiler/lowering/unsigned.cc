// Unsigned ints, whose bits are kept in the card's signed ones. Sums, products and bit operations
// are the same; comparisons, divisions and the shift to the right take a few statements.
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {
// Moving both operands by half the range keeps their order as signed ints.
Value Lowerer::CompareUnsigned(vm::BinaryOperator op, const Value& a, const Value& b,
                               SourceRange range) {
  const auto move = [this, range](const Operand& operand) {
    if (operand.IsConstant()) return IntOperand(static_cast<int32_t>(operand.value ^ INT32_MIN));
    return Compute(vm::BinaryOperator::kXor, operand, IntOperand(INT32_MIN), BasicType::kInt, range)
        .operand;
  };
  const Operand left = move(a.operand);
  const Operand right = move(b.operand);
  return Compute(op, left, right, BasicType::kInt, range);
}

// (a >> n) with the copies of the sign removed.
Value Lowerer::ShiftUnsignedRight(const Value& a, const Value& count, SourceRange range) {
  const Operand number = Stable(a.operand, range);
  const Operand n = Stable(count.operand, range);
  const auto compute = [this, range](vm::BinaryOperator op, const Operand& x, const Operand& y) {
    return Compute(op, x, y, BasicType::kUnsigned, range).operand;
  };
  if (n.IsConstant()) {
    if ((n.value & 31) == 0) return {number, BasicType::kUnsigned, BasicType::kUnsigned};
    const Operand shifted = compute(vm::BinaryOperator::kShiftRight, number, n);
    const int64_t mask = UINT32_MAX >> (n.value & 31);
    return Compute(vm::BinaryOperator::kAnd, shifted, IntOperand(mask), BasicType::kUnsigned,
                   range);
  }
  const Operand signs = compute(vm::BinaryOperator::kShiftRight, IntOperand(INT32_MIN), n);
  const Operand above = compute(vm::BinaryOperator::kShiftLeft, signs, IntOperand(1));
  const Operand shifted = compute(vm::BinaryOperator::kShiftRight, number, n);
  const Operand below =
      Compute(vm::UnaryOperator::kInvert, above, BasicType::kUnsigned, range).operand;
  return Compute(vm::BinaryOperator::kAnd, shifted, below, BasicType::kUnsigned, range);
}

// With a divisor of at least 2^31 the quotient is 0 or 1. Otherwise half of the dividend is divided
// as a signed int, and the quotient, doubled, may be too small by one.
Value Lowerer::DivideUnsigned(const Value& a, const Value& b, bool remainder, SourceRange range) {
  const Value dividend = Load(a, range);
  const Value divisor = Load(b, range);
  const Operand quotient = NewTemporary(vm::DataType::kInt, range);
  const int end = NewLabel("divided", range);
  const auto compute = [this, range](vm::BinaryOperator op, const Operand& x, const Operand& y) {
    return Compute(op, x, y, BasicType::kUnsigned, range);
  };
  const auto at_least_divisor = [&](const Value& value) {
    return CompareUnsigned(vm::BinaryOperator::kGreaterEqual, value, divisor, range).operand;
  };
  const bool known_small = divisor.operand.IsConstant() && divisor.operand.value >= 0;
  if (!known_small) {
    EmitCopy(quotient, at_least_divisor(dividend), range);
    const Value large = compute(vm::BinaryOperator::kLess, divisor.operand, IntOperand(0));
    EmitIf(large.operand, end, range);
  }
  Value half;
  half.operand = IntOperand(1);
  half = ShiftUnsignedRight(dividend, half, range);
  const Value part = compute(vm::BinaryOperator::kDivide, half.operand, divisor.operand);
  const Value doubled = compute(vm::BinaryOperator::kShiftLeft, part.operand, IntOperand(1));
  const Value product = compute(vm::BinaryOperator::kMultiply, doubled.operand, divisor.operand);
  const Value rest = compute(vm::BinaryOperator::kSubtract, dividend.operand, product.operand);
  const Operand one_more = at_least_divisor(rest);
  EmitCopy(quotient, compute(vm::BinaryOperator::kAdd, doubled.operand, one_more).operand, range);
  EmitLabel(end, range);
  const Value result = {quotient, BasicType::kUnsigned, BasicType::kUnsigned};
  if (!remainder) return result;
  const Value whole = compute(vm::BinaryOperator::kMultiply, quotient, divisor.operand);
  return compute(vm::BinaryOperator::kSubtract, dividend.operand, whole.operand);
}

}  // namespace oncard::compiler::lowering
