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

bool FoldConstants(LoweredFunction& function, vm::DoubleFormat format) {
  const int wrap_shift = vm::WrapShift(format);
  bool changed = false;
  for (Instruction& instruction : function.code) {
    if (instruction.kind == Instruction::Kind::kBinary) {
      std::optional<int64_t> value;
      if (instruction.a.IsConstant() && instruction.b.IsConstant()) {
        value = vm::EvaluateBinary(instruction.binary, instruction.a.type, instruction.a.value,
                                   instruction.b.value, wrap_shift);
      }
      if (value) {
        MakeCopy(instruction, ConstantOperand(instruction.target.type, *value));
        changed = true;
      } else if (const Operand* same = Neutral(instruction)) {
        MakeCopy(instruction, Operand(*same));
        changed = true;
      }
    } else if (instruction.kind == Instruction::Kind::kUnary &&
               instruction.unary != vm::UnaryOperator::kCopy && instruction.a.IsConstant()) {
      const int64_t value =
          vm::EvaluateUnary(instruction.unary, instruction.a.type, instruction.a.value, wrap_shift);
      MakeCopy(instruction, ConstantOperand(instruction.target.type, value));
      changed = true;
    }
  }
  return changed;
}

}  // namespace oncard::compiler::lowering
