// Statements whose operands are constants, and operations that change nothing, such as x + 0.
#include "compiler/lowering/passes/passes.h"
#include "vm/arithmetic.h"

namespace oncard::compiler::lowering {
namespace {

bool IsInt(const Operand& operand, int64_t value) {
  return operand.IsConstant() && operand.type == vm::DataType::kInt && operand.value == value;
}

// The operand that an operation yields unchanged, or nullptr.
const Operand* Neutral(const Instruction& instruction) {
  const Operand& a = instruction.a;
  const Operand& b = instruction.b;
  switch (instruction.binary) {
    case vm::BinaryOperator::kAdd:
    case vm::BinaryOperator::kOr:
    case vm::BinaryOperator::kXor:
      if (IsInt(a, 0)) return &b;
      return IsInt(b, 0) ? &a : nullptr;
    case vm::BinaryOperator::kMultiply:
      if (IsInt(a, 1)) return &b;
      return IsInt(b, 1) ? &a : nullptr;
    case vm::BinaryOperator::kDivide:
      return IsInt(b, 1) ? &a : nullptr;
    case vm::BinaryOperator::kSubtract:
    case vm::BinaryOperator::kShiftLeft:
    case vm::BinaryOperator::kShiftRight:
      return IsInt(b, 0) ? &a : nullptr;
    default:
      return nullptr;
  }
}

}  // namespace

bool FoldConstants(Instruction& instruction, int wrap_shift) {
  const Operand& a = instruction.a;
  const Operand& b = instruction.b;
  if (instruction.kind == Instruction::Kind::kBinary) {
    std::optional<int64_t> value;
    if (a.IsConstant() && b.IsConstant()) {
      value = vm::EvaluateBinary(instruction.binary, a.type, a.value, b.value, wrap_shift);
    }
    if (value) {
      MakeCopy(instruction, ConstantOperand(instruction.target.type, *value));
      return true;
    }
    const Operand* same = Neutral(instruction);
    if (same != nullptr) MakeCopy(instruction, Operand(*same));
    return same != nullptr;
  }
  const bool computes = instruction.kind == Instruction::Kind::kUnary &&
                        instruction.unary != vm::UnaryOperator::kCopy && a.IsConstant();
  if (!computes) return false;
  const int64_t value = vm::EvaluateUnary(instruction.unary, a.type, a.value, wrap_shift);
  MakeCopy(instruction, ConstantOperand(instruction.target.type, value));
  return true;
}

}  // namespace oncard::compiler::lowering
