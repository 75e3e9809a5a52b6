// Copies of constants and locals: their readers read the source instead. Copies of globals stay:
// reading the global later, or twice, would be another program when other threads write it.
#include <algorithm>
#include <utility>

#include "compiler/lowering/passes/passes.h"
#include "vm/arithmetic.h"

namespace oncard::compiler::lowering {
namespace {

// Follows a function once from its begin. A condition that becomes constant on the way decides at
// once which statements are reached, so that what is known outlives all branches that are decided.
class Copies {
 public:
  Copies(const Program& program, LoweredFunction& function, vm::DoubleFormat format)
      : program_(program),
        function_(function),
        wrap_shift_(vm::WrapShift(format)),
        known_(program.variables.size()),
        ways_(function.labels.size()) {}

  bool Run() {
    FindWaysBack();
    for (Instruction& instruction : function_.code) {
      if (instruction.kind == Instruction::Kind::kLabel) {
        Arrive(instruction.label);
        continue;
      }
      if (!reached_) continue;  // RemoveUnreachable() removes it
      Replace(instruction);
      changed_ |= FoldConstants(instruction, wrap_shift_);
      ForEachOperand(instruction, [this](const Operand& operand, bool written) {
        if (written && operand.IsVariable()) ++known_[At(operand)].version;
      });
      Remember(instruction);
      Leave(instruction);
    }
    return changed_;
  }

 private:
  // What a variable is a copy of, as long as neither is written.
  struct Known {
    int block = -1;
    int own_version = 0;
    int source_version = 0;
    Operand source;
    int version = 0;  // counts the writes of the variable itself
  };

  // The jumps to a label.
  struct Ways {
    bool back = false;  // from statements after it, which are not known where it is passed
    int jumps = 0;      // from those before it that are reached
  };

  static size_t At(const Operand& operand) { return static_cast<size_t>(operand.variable); }

  Ways& WaysTo(int label) { return ways_[static_cast<size_t>(label)]; }

  void FindWaysBack() {
    std::vector<char> passed(ways_.size());
    for (const Instruction& instruction : function_.code) {
      if (instruction.kind == Instruction::Kind::kLabel) {
        passed[static_cast<size_t>(instruction.label)] = 1;
      } else if (instruction.Jumps()) {
        WaysTo(instruction.label).back |= passed[static_cast<size_t>(instruction.label)] != 0;
      }
    }
  }

  // What is known stays known where one way alone leads to a label: from the statement before it,
  // or from the last jump, when nothing has been reached since.
  void Arrive(int label) {
    const int left_to = std::exchange(left_to_, -1);
    const Ways& ways = WaysTo(label);
    const bool only_way = reached_ ? ways.jumps == 0 : ways.jumps == 1 && left_to == label;
    reached_ = reached_ || ways.jumps > 0 || ways.back;
    if (reached_ && (!only_way || ways.back)) ++block_;
    if (!reached_) left_to_ = left_to;
  }

  void Leave(const Instruction& instruction) {
    if (instruction.kind == Instruction::Kind::kReturn) reached_ = false;
    if (!instruction.Jumps()) return;
    // ThreadJumps() decides the constant ones.
    const bool decided = instruction.a.IsConstant();
    if (decided && instruction.a.value == 0) return;
    ++WaysTo(instruction.label).jumps;
    reached_ = instruction.kind == Instruction::Kind::kIf && !decided;
    if (!reached_) left_to_ = instruction.label;
  }

  const Operand* Find(int variable) const {
    const Known& known = known_[static_cast<size_t>(variable)];
    if (known.block != block_ || known.own_version != known.version) return nullptr;
    if (known.source.IsVariable() && known_[At(known.source)].version != known.source_version) {
      return nullptr;
    }
    return &known.source;
  }

  void Remember(const Instruction& instruction) {
    if (instruction.kind != Instruction::Kind::kUnary ||
        instruction.unary != vm::UnaryOperator::kCopy || !instruction.target.IsVariable() ||
        !IsLocalNumber(program_, instruction.target.variable)) {
      return;
    }
    const Operand& source = instruction.a;
    const bool local = source.IsVariable() && IsLocalNumber(program_, source.variable) &&
                       source.variable != instruction.target.variable;
    if (!source.IsConstant() && !local) return;
    Known& known = known_[At(instruction.target)];
    known.block = block_;
    known.own_version = known.version;
    known.source = source;
    if (local) known.source_version = known_[At(source)].version;
  }

  void ReplaceIndex(Operand& operand) {
    if (operand.kind != Operand::Kind::kElement || operand.index < 0) return;
    const Operand* source = Find(operand.index);
    if (source == nullptr) return;
    if (source->IsVariable()) {
      operand.index = source->variable;
      changed_ = true;
      return;
    }
    // An index that is out of bounds faults at run time, if it is ever reached.
    const int size = program_.variables[At(operand)].size;
    if (source->value < 0 || source->value >= size) return;
    operand.index = -1;
    operand.value = source->value;
    changed_ = true;
  }

  // An assert names the variables of its source, so their values must be kept.
  void Replace(Instruction& instruction) {
    if (instruction.kind == Instruction::Kind::kAssert) return;
    ForEachOperand(instruction, [this](Operand& operand, bool written) {
      ReplaceIndex(operand);
      if (written || !operand.IsVariable()) return;
      const Operand* source = Find(operand.variable);
      if (source == nullptr) return;
      operand = *source;
      changed_ = true;
    });
  }

  const Program& program_;
  LoweredFunction& function_;
  const int wrap_shift_;
  std::vector<Known> known_;
  std::vector<Ways> ways_;  // by label
  bool reached_ = true;     // the statement that is looked at
  int left_to_ = -1;        // the label of the last jump, while nothing is reached; -1: none
  int block_ = 0;
  bool changed_ = false;
};

// How often each variable occurs.
struct Counts {
  std::vector<int> reads;
  std::vector<int> writes;
};

Counts CountUses(const Program& program, const LoweredFunction& function) {
  Counts counts = {std::vector<int>(program.variables.size()),
                   std::vector<int>(program.variables.size())};
  for (const Instruction& instruction : function.code) {
    ForEachOperand(instruction, [&counts](const Operand& operand, bool written) {
      if (operand.index >= 0) ++counts.reads[static_cast<size_t>(operand.index)];
      if (operand.variable < 0) return;
      ++(written ? counts.writes : counts.reads)[static_cast<size_t>(operand.variable)];
      if (operand.address) ++counts.reads[static_cast<size_t>(operand.variable)];
    });
  }
  return counts;
}

// `t = a + b; x = t;` where t is used nowhere else: `x = a + b;`
bool JoinCopies(const Program& program, LoweredFunction& function) {
  const Counts counts = CountUses(program, function);
  std::vector<Instruction> code;
  code.reserve(function.code.size());
  for (Instruction& instruction : function.code) {
    const bool copy = instruction.kind == Instruction::Kind::kUnary &&
                      instruction.unary == vm::UnaryOperator::kCopy && instruction.a.IsVariable() &&
                      IsLocalNumber(program, instruction.a.variable);
    if (copy && !code.empty() && code.back().Writes() && code.back().target == instruction.a) {
      const size_t variable = static_cast<size_t>(instruction.a.variable);
      const bool parameter = program.variables[variable].role == Variable::Role::kParameter;
      if (!parameter && counts.reads[variable] == 1 && counts.writes[variable] == 1) {
        code.back().target = instruction.target;
        continue;
      }
    }
    code.push_back(std::move(instruction));
  }
  const bool changed = code.size() != function.code.size();
  function.code = std::move(code);
  return changed;
}

}  // namespace

bool IsLocalNumber(const Program& program, int variable) {
  const Variable& info = program.variables[static_cast<size_t>(variable)];
  return info.role != Variable::Role::kGlobal && info.size == 0 && info.structure == nullptr;
}

bool PropagateCopies(const Program& program, LoweredFunction& function, vm::DoubleFormat format) {
  const bool replaced = Copies(program, function, format).Run();
  return JoinCopies(program, function) || replaced;
}

}  // namespace oncard::compiler::lowering
