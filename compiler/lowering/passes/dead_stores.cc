// Assignments to locals that no path reads, and of locals to themselves. What they read is not read
// any more, and a division or an index that would fault does not fault: C leaves both open.
#include <algorithm>
#include <utility>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

// The assignments whose values are needed, found from the statements that do something else than to
// assign a local, backwards: what they read is needed, then what those assignments read. A variable
// is looked for in a block once, so the work is that of the places where variables live.
class NeededStores {
 public:
  NeededStores(const Program& program, LoweredFunction& function)
      : program_(program), code_(function.code), needed_(code_.size()) {
    FindBlocks(LabelPositions(function));
    FindStores();
    for (size_t i = 0; i < code_.size(); ++i) {
      if (!StoresLocal(code_[i])) Need(i);
    }
    while (!open_.empty()) {
      const size_t next = open_.back();
      open_.pop_back();
      ForEachRead(code_[next], [&](int variable) { Search(variable, next); });
    }
  }

  bool RemoveOthers() {
    size_t kept = 0;
    for (size_t i = 0; i < code_.size(); ++i) {
      if (needed_[i] == 0) continue;
      if (kept != i) code_[kept] = std::move(code_[i]);
      ++kept;
    }
    const bool changed = kept != code_.size();
    code_.resize(kept);
    return changed;
  }

 private:
  struct Block {
    size_t begin = 0;
    size_t end = 0;
    std::vector<int> before;  // the blocks that lead to it
  };

  bool StoresLocal(const Instruction& instruction) const {
    return instruction.Writes() && instruction.target.IsVariable() &&
           IsLocalNumber(program_, instruction.target.variable);
  }

  template <typename Visitor>
  static void ForEachRead(const Instruction& instruction, const Visitor& visit) {
    ForEachOperand(instruction, [&visit](const Operand& operand, bool written) {
      if (operand.index >= 0) visit(operand.index);
      if (operand.IsVariable() && (!written || operand.address)) visit(operand.variable);
    });
  }

  void FindBlocks(const std::vector<int>& positions) {
    block_of_.assign(code_.size(), -1);
    for (size_t i = 0; i < code_.size(); ++i) {
      const bool begins = i == 0 || code_[i].kind == Instruction::Kind::kLabel ||
                          code_[i - 1].kind == Instruction::Kind::kGoto ||
                          code_[i - 1].kind == Instruction::Kind::kIf ||
                          code_[i - 1].kind == Instruction::Kind::kReturn;
      if (begins) {
        blocks_.emplace_back();
        blocks_.back().begin = i;
      }
      blocks_.back().end = i + 1;
      block_of_[i] = static_cast<int>(blocks_.size()) - 1;
    }
    for (size_t b = 0; b < blocks_.size(); ++b) {
      const Instruction& last = code_[blocks_[b].end - 1];
      const bool falls =
          last.kind != Instruction::Kind::kGoto && last.kind != Instruction::Kind::kReturn;
      if (falls && b + 1 < blocks_.size()) blocks_[b + 1].before.push_back(static_cast<int>(b));
      if (last.kind == Instruction::Kind::kGoto || last.kind == Instruction::Kind::kIf) {
        const int position = positions[static_cast<size_t>(last.label)];
        const int target = block_of_[static_cast<size_t>(position)];
        blocks_[static_cast<size_t>(target)].before.push_back(static_cast<int>(b));
      }
    }
  }

  void FindStores() {
    const size_t variables = program_.variables.size();
    searched_.resize(variables);
    first_store_.assign(variables + 1, 0);
    for (const Instruction& instruction : code_) {
      if (StoresLocal(instruction)) ++first_store_[Target(instruction) + 1];
    }
    for (size_t v = 0; v < variables; ++v) first_store_[v + 1] += first_store_[v];
    stores_.resize(first_store_[variables]);
    std::vector<size_t> next(first_store_.begin(), first_store_.end() - 1);
    for (size_t i = 0; i < code_.size(); ++i) {
      if (StoresLocal(code_[i])) stores_[next[Target(code_[i])]++] = i;
    }
  }

  static size_t Target(const Instruction& instruction) {
    return static_cast<size_t>(instruction.target.variable);
  }

  void Need(size_t statement) {
    if (needed_[statement] != 0) return;
    needed_[statement] = 1;
    open_.push_back(statement);
  }

  // Needs the assignments that give a variable its value before a statement.
  void Search(int variable, size_t statement) {
    if (!IsLocalNumber(program_, variable)) return;
    const size_t v = static_cast<size_t>(variable);
    ends_.assign(1, {block_of_[statement], statement});
    while (!ends_.empty()) {
      const auto [b, end] = ends_.back();
      ends_.pop_back();
      const Block& block = blocks_[static_cast<size_t>(b)];
      const auto first = stores_.begin() + static_cast<std::ptrdiff_t>(first_store_[v]);
      const auto last = stores_.begin() + static_cast<std::ptrdiff_t>(first_store_[v + 1]);
      const auto after = std::lower_bound(first, last, end);
      if (after != first && *(after - 1) >= block.begin) {
        Need(*(after - 1));
      } else if (BeginSearch(v, static_cast<size_t>(b))) {
        for (const int before : block.before) {
          ends_.emplace_back(before, blocks_[static_cast<size_t>(before)].end);
        }
      }
    }
  }

  // False if the variable has been looked for before this block.
  bool BeginSearch(size_t variable, size_t block) {
    std::vector<uint64_t>& searched = searched_[variable];
    searched.resize((blocks_.size() + 63) / 64);
    const uint64_t bit = uint64_t{1} << (block % 64);
    if ((searched[block / 64] & bit) != 0) return false;
    searched[block / 64] |= bit;
    return true;
  }

  const Program& program_;
  std::vector<Instruction>& code_;
  std::vector<char> needed_;  // statements
  std::vector<Block> blocks_;
  std::vector<int> block_of_;        // by statement
  std::vector<size_t> first_store_;  // among `stores_`, by variable
  std::vector<size_t> stores_;       // statements that assign each local, in their order
  std::vector<size_t> open_;         // needed statements whose operands are to be looked for
  std::vector<std::pair<int, size_t>> ends_;     // blocks to be searched, and up to where
  std::vector<std::vector<uint64_t>> searched_;  // blocks, by variable
};

// Arrays and structures that are only written.
bool RemoveUnreadAggregates(const Program& program, LoweredFunction& function) {
  std::vector<char> read(program.variables.size());
  for (const Instruction& instruction : function.code) {
    ForEachOperand(instruction, [&read](const Operand& operand, bool written) {
      if (operand.variable >= 0 && (!written || operand.address)) {
        read[static_cast<size_t>(operand.variable)] = 1;
      }
    });
  }
  const size_t erased = std::erase_if(function.code, [&](const Instruction& instruction) {
    if (!instruction.Writes()) return false;
    const size_t target = static_cast<size_t>(instruction.target.variable);
    return read[target] == 0 && !program.variables[target].checks &&
           program.variables[target].role != Variable::Role::kGlobal &&
           !IsLocalNumber(program, instruction.target.variable);
  });
  return erased > 0;
}

bool RemoveCopiesToItself(const Program& program, LoweredFunction& function) {
  const size_t erased = std::erase_if(function.code, [&](const Instruction& instruction) {
    return instruction.kind == Instruction::Kind::kUnary &&
           instruction.unary == vm::UnaryOperator::kCopy && instruction.target.IsVariable() &&
           instruction.target == instruction.a && IsLocalNumber(program, instruction.a.variable);
  });
  return erased > 0;
}

}  // namespace

bool RemoveDeadStores(const Program& program, LoweredFunction& function) {
  bool removed = RemoveUnreadAggregates(program, function);
  removed |= RemoveCopiesToItself(program, function);
  return NeededStores(program, function).RemoveOthers() || removed;
}

}  // namespace oncard::compiler::lowering
