// Jumps to jumps, to the next statement, over another jump, to where the next jump goes, and on
// constants.
#include "compiler/lowering/passes/passes.h"
#include "compiler/operators.h"

namespace oncard::compiler::lowering {
namespace {

class Jumps {
 public:
  Jumps(const Program& program, LoweredFunction& function)
      : program_(program), code_(function.code), positions_(LabelPositions(function)) {}

  bool Run() {
    Decide();
    for (Instruction& instruction : code_) {
      if (!instruction.Jumps()) continue;
      const int label = Final(instruction.label);
      changed_ |= label != instruction.label;
      instruction.label = label;
    }
    CountReads();
    for (size_t i = 0; i < code_.size(); ++i) Shorten(i);
    std::erase_if(code_, [](const Instruction& instruction) { return IsRemoved(instruction); });
    return changed_;
  }

 private:
  static bool IsRemoved(const Instruction& instruction) {
    return instruction.kind == Instruction::Kind::kLabel && instruction.label < 0;
  }

  void Remove(Instruction& instruction) {
    instruction = Instruction();
    instruction.kind = Instruction::Kind::kLabel;
    instruction.label = -1;
    changed_ = true;
  }

  // Conditions that copies have made constant.
  void Decide() {
    for (Instruction& instruction : code_) {
      if (instruction.kind != Instruction::Kind::kIf || !instruction.a.IsConstant()) continue;
      if (instruction.a.value == 0) {
        Remove(instruction);
        continue;
      }
      instruction.kind = Instruction::Kind::kGoto;
      instruction.a = Operand();
      changed_ = true;
    }
  }

  // Index of the first statement at or after `i` that is not a label.
  size_t Statement(size_t i) const {
    while (i < code_.size() && code_[i].kind == Instruction::Kind::kLabel) ++i;
    return i;
  }

  int Final(int label) const {
    for (size_t steps = 0; steps <= code_.size(); ++steps) {
      const size_t next = Statement(static_cast<size_t>(positions_[static_cast<size_t>(label)]));
      if (next >= code_.size() || code_[next].kind != Instruction::Kind::kGoto) return label;
      if (code_[next].label == label) return label;
      label = code_[next].label;
    }
    return label;  // jumps in a circle: an endless loop of the program
  }

  bool LeadsToNext(size_t i, int label) const {
    const int position = positions_[static_cast<size_t>(label)];
    return position > static_cast<int>(i) && Statement(i + 1) >= static_cast<size_t>(position);
  }

  void CountReads() {
    reads_.assign(program_.variables.size(), 0);
    for (const Instruction& instruction : code_) {
      ForEachOperand(instruction, [this](const Operand& operand, bool written) {
        if (operand.index >= 0) ++reads_[static_cast<size_t>(operand.index)];
        if (operand.variable >= 0 && (!written || operand.address)) {
          ++reads_[static_cast<size_t>(operand.variable)];
        }
      });
    }
  }

  void Shorten(size_t i) {
    Instruction& jump = code_[i];
    if (!jump.Jumps()) return;
    if (LeadsToNext(i, jump.label)) {
      Remove(jump);
      return;
    }
    if (jump.kind != Instruction::Kind::kIf) return;
    const bool decides_nothing = i + 1 < code_.size() &&
                                 code_[i + 1].kind == Instruction::Kind::kGoto &&
                                 code_[i + 1].label == jump.label;
    if (decides_nothing) {
      Remove(jump);
    } else {
      JumpOver(i);
    }
  }

  // `t = a < b; if (t) goto x; goto y; x:` becomes `t = a >= b; if (t) goto y; x:`
  void JumpOver(size_t i) {
    if (i == 0 || i + 1 >= code_.size()) return;
    Instruction& test = code_[i - 1];
    Instruction& jump = code_[i];
    Instruction& other = code_[i + 1];
    if (other.kind != Instruction::Kind::kGoto || !LeadsToNext(i + 1, jump.label)) return;
    const bool only_here = test.Writes() && jump.a.IsVariable() && test.target == jump.a &&
                           IsLocalNumber(program_, jump.a.variable) &&
                           reads_[static_cast<size_t>(jump.a.variable)] == 1;
    if (!only_here) return;
    if (test.kind == Instruction::Kind::kBinary) {
      const vm::OperatorInfo& info = *vm::FindBinaryOperator(static_cast<uint16_t>(test.binary));
      const vm::OperatorInfo* opposite = vm::IsComparison(info) ? OppositeOf(info) : nullptr;
      if (opposite == nullptr) return;
      test.binary = static_cast<vm::BinaryOperator>(opposite->number);
    } else if (test.unary == vm::UnaryOperator::kNot) {
      test.unary = vm::UnaryOperator::kCopy;
    } else if (test.unary == vm::UnaryOperator::kCopy && test.a.type == vm::DataType::kInt) {
      test.unary = vm::UnaryOperator::kNot;
    } else {
      return;
    }
    jump.label = other.label;
    Remove(other);
  }

  const Program& program_;
  std::vector<Instruction>& code_;
  std::vector<int> positions_;
  std::vector<int> reads_;
  bool changed_ = false;
};

}  // namespace

std::vector<int> LabelPositions(const LoweredFunction& function) {
  std::vector<int> positions(function.labels.size(), -1);
  for (size_t i = 0; i < function.code.size(); ++i) {
    const Instruction& instruction = function.code[i];
    if (instruction.kind != Instruction::Kind::kLabel) continue;
    positions[static_cast<size_t>(instruction.label)] = static_cast<int>(i);
  }
  return positions;
}

bool ThreadJumps(const Program& program, LoweredFunction& function) {
  return Jumps(program, function).Run();
}

}  // namespace oncard::compiler::lowering
