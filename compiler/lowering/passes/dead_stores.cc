// Assignments to locals that no path reads, and of locals to themselves. What they read is not read
// any more, and a division or an index that would fault does not fault: C leaves both open.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

// The assignments whose values are needed, found from the statements that do something else than to
// assign a local, backwards: what they read is needed, then what those assignments read. Variables
// that a block has from the blocks before it are looked for in those, 64 of them at once.
class NeededStores {
 public:
  NeededStores(const Program& program, LoweredFunction& function)
      : program_(program), code_(function.code), needed_(code_.size()) {
    FindBlocks(LabelPositions(function));
    FindStores();
    FindPassing();
    for (size_t i = 0; i < code_.size(); ++i) {
      if (!StoresLocal(code_[i])) Need(i);
    }
    SearchOperands();
    // Most of what leads to a block stands before it.
    while (waiting_ > 0) {
      for (size_t block = blocks_.size(); block-- > 0;) {
        if (!blocks_[block].waits) continue;
        SearchBlock(block);
        SearchOperands();
      }
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
    std::vector<size_t> before;  // the blocks that lead to it
    bool waits = false;          // has passing variables that are to be looked for
  };
  // 64 passing variables of a block.
  struct Passing {
    uint64_t stored = 0;    // those that the block assigns
    uint64_t wanted = 0;    // those whose values at its end are needed
    uint64_t searched = 0;  // of those, the ones that have been looked for
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
    block_of_.reserve(code_.size());
    for (size_t i = 0; i < code_.size(); ++i) {
      const bool begins = i == 0 || code_[i].kind == Instruction::Kind::kLabel ||
                          code_[i - 1].Jumps() || !code_[i - 1].GoesOn();
      if (begins) {
        blocks_.emplace_back();
        blocks_.back().begin = i;
      }
      blocks_.back().end = i + 1;
      block_of_.push_back(blocks_.size() - 1);
    }
    for (size_t b = 0; b < blocks_.size(); ++b) {
      const Instruction& last = code_[blocks_[b].end - 1];
      if (last.GoesOn() && b + 1 < blocks_.size()) blocks_[b + 1].before.push_back(b);
      if (last.Jumps()) {
        const int position = positions[static_cast<size_t>(last.label)];
        blocks_[block_of_[static_cast<size_t>(position)]].before.push_back(b);
      }
    }
  }

  void FindStores() {
    const size_t variables = program_.variables.size();
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

  // Numbers the variables that a block reads without having assigned them, and finds the blocks
  // that assign these.
  void FindPassing() {
    number_of_.assign(program_.variables.size(), -1);
    std::vector<size_t> assigned_in(program_.variables.size(), blocks_.size());
    for (size_t i = 0; i < code_.size(); ++i) {
      ForEachRead(code_[i], [&](int variable) {
        const size_t v = static_cast<size_t>(variable);
        if (number_of_[v] >= 0 || assigned_in[v] == block_of_[i]) return;
        if (!IsLocalNumber(program_, variable)) return;
        number_of_[v] = static_cast<int>(variables_.size());
        variables_.push_back(v);
      });
      if (StoresLocal(code_[i])) assigned_in[Target(code_[i])] = block_of_[i];
    }
    words_ = (variables_.size() + 63) / 64;
    passing_.resize(words_ * blocks_.size());
    for (size_t number = 0; number < variables_.size(); ++number) {
      const size_t v = variables_[number];
      for (size_t s = first_store_[v]; s < first_store_[v + 1]; ++s) {
        PassingOf(block_of_[stores_[s]], number / 64).stored |= Bit(number);
      }
    }
  }

  static uint64_t Bit(size_t number) { return uint64_t{1} << (number % 64); }

  Passing& PassingOf(size_t block, size_t word) { return passing_[block * words_ + word]; }

  static size_t Target(const Instruction& instruction) {
    return static_cast<size_t>(instruction.target.variable);
  }

  void Need(size_t statement) {
    if (needed_[statement] != 0) return;
    needed_[statement] = 1;
    open_.push_back(statement);
  }

  void SearchOperands() {
    while (!open_.empty()) {
      const size_t next = open_.back();
      open_.pop_back();
      ForEachRead(code_[next], [&](int variable) { Search(variable, next); });
    }
  }

  // The last assignment of a variable in a block before a statement, -1 if there is none.
  std::ptrdiff_t LastStore(size_t variable, const Block& block, size_t statement) const {
    const auto first = stores_.begin() + static_cast<std::ptrdiff_t>(first_store_[variable]);
    const auto last = stores_.begin() + static_cast<std::ptrdiff_t>(first_store_[variable + 1]);
    const auto after = std::lower_bound(first, last, statement);
    if (after == first || *(after - 1) < block.begin) return -1;
    return static_cast<std::ptrdiff_t>(*(after - 1));
  }

  // Needs the assignments that give a variable its value before a statement.
  void Search(int variable, size_t statement) {
    if (!IsLocalNumber(program_, variable)) return;
    const size_t v = static_cast<size_t>(variable);
    const Block& block = blocks_[block_of_[statement]];
    const std::ptrdiff_t store = LastStore(v, block, statement);
    if (store >= 0) {
      Need(static_cast<size_t>(store));
      return;
    }
    const size_t number = static_cast<size_t>(number_of_[v]);
    for (const size_t before : block.before) Want(before, number / 64, Bit(number));
  }

  void Want(size_t block, size_t word, uint64_t variables) {
    Passing& passing = PassingOf(block, word);
    if ((variables & ~passing.wanted) == 0) return;
    passing.wanted |= variables;
    if (!std::exchange(blocks_[block].waits, true)) ++waiting_;
  }

  // Needs the assignments of a block that give its last values, and looks for the others before it.
  void SearchBlock(size_t b) {
    Block& block = blocks_[b];
    block.waits = false;
    --waiting_;
    for (size_t word = 0; word < words_; ++word) {
      Passing& passing = PassingOf(b, word);
      const uint64_t found = passing.wanted & ~passing.searched;
      if (found == 0) continue;
      passing.searched = passing.wanted;
      for (uint64_t rest = found & passing.stored; rest != 0; rest &= rest - 1) {
        const size_t number = word * 64 + static_cast<size_t>(std::countr_zero(rest));
        Need(static_cast<size_t>(LastStore(variables_[number], block, block.end)));
      }
      const uint64_t others = found & ~passing.stored;
      if (others == 0) continue;
      for (const size_t before : block.before) Want(before, word, others);
    }
  }

  const Program& program_;
  std::vector<Instruction>& code_;
  std::vector<char> needed_;  // statements
  std::vector<Block> blocks_;
  std::vector<size_t> block_of_;     // by statement
  std::vector<size_t> first_store_;  // among `stores_`, by variable
  std::vector<size_t> stores_;       // statements that assign each local, in their order
  std::vector<int> number_of_;       // of a passing variable, by variable; -1: it is none
  std::vector<size_t> variables_;    // the passing ones, by their numbers
  size_t words_ = 0;                 // of 64 passing variables
  std::vector<Passing> passing_;     // by block and word
  std::vector<size_t> open_;         // needed statements whose operands are to be looked for
  size_t waiting_ = 0;               // blocks
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
    const bool checks = program.variables[target].checks && instruction.target.index >= 0;
    return read[target] == 0 && !checks &&
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
