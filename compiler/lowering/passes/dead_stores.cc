// Assignments to locals that no path reads. What they read is not read any more, and a division or
// an index that would fault does not fault: C leaves both open.
#include <algorithm>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

// Sets of variables as bits. Only those that a block reads before it writes them have one: all
// others live in one block.
class Liveness {
 public:
  Liveness(const Program& program, LoweredFunction& function)
      : program_(program), code_(function.code) {
    FindBlocks(LabelPositions(function));
    FindCrossing();
    Solve();
  }

  bool RemoveDead() {
    std::vector<char> dead(code_.size());
    std::vector<char> live(program_.variables.size());
    for (size_t b = 0; b < blocks_.size(); ++b) {
      const Block& block = blocks_[b];
      std::vector<int> touched;
      const auto set = [&live, &touched](int variable, char value) {
        live[static_cast<size_t>(variable)] = value;
        touched.push_back(variable);
      };
      for (size_t bit = 0; bit < crossing_.size(); ++bit) {
        if (Test(block.out, bit)) set(crossing_[bit], 1);
      }
      for (size_t i = block.end; i-- > block.begin;) {
        const Instruction& instruction = code_[i];
        const Operand& target = instruction.target;
        if (instruction.Writes() && target.IsVariable() &&
            IsLocalNumber(program_, target.variable)) {
          if (live[static_cast<size_t>(target.variable)] == 0) {
            dead[i] = 1;
            continue;
          }
          set(target.variable, 0);
        }
        ForEachRead(instruction, [&set](int variable) { set(variable, 1); });
      }
      for (const int variable : touched) live[static_cast<size_t>(variable)] = 0;
    }
    size_t kept = 0;
    for (size_t i = 0; i < code_.size(); ++i) {
      if (dead[i] != 0) continue;
      if (kept != i) code_[kept] = std::move(code_[i]);
      ++kept;
    }
    const bool changed = kept != code_.size();
    code_.resize(kept);
    return changed;
  }

 private:
  using Bits = std::vector<uint64_t>;
  struct Block {
    size_t begin = 0;
    size_t end = 0;
    int next[2] = {-1, -1};
    Bits used;  // read before they are written
    Bits written;
    Bits in;
    Bits out;
  };

  static bool Test(const Bits& bits, size_t bit) { return (bits[bit / 64] >> (bit % 64) & 1) != 0; }
  static void Set(Bits& bits, size_t bit) { bits[bit / 64] |= uint64_t{1} << (bit % 64); }

  template <typename Visitor>
  static void ForEachRead(const Instruction& instruction, const Visitor& visit) {
    ForEachOperand(instruction, [&visit](const Operand& operand, bool written) {
      if (operand.index >= 0) visit(operand.index);
      if (operand.IsVariable() && (!written || operand.address)) visit(operand.variable);
    });
  }

  void FindBlocks(const std::vector<int>& positions) {
    std::vector<int> block_of(code_.size(), -1);
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
      block_of[i] = static_cast<int>(blocks_.size()) - 1;
    }
    for (size_t b = 0; b < blocks_.size(); ++b) {
      const Instruction& last = code_[blocks_[b].end - 1];
      const bool falls =
          last.kind != Instruction::Kind::kGoto && last.kind != Instruction::Kind::kReturn;
      if (falls && b + 1 < blocks_.size()) blocks_[b].next[0] = static_cast<int>(b) + 1;
      if (last.kind == Instruction::Kind::kGoto || last.kind == Instruction::Kind::kIf) {
        const int position = positions[static_cast<size_t>(last.label)];
        blocks_[b].next[1] = block_of[static_cast<size_t>(position)];
      }
    }
  }

  void FindCrossing() {
    bit_of_.assign(program_.variables.size(), -1);
    std::vector<int> written_in(program_.variables.size(), -1);
    for (size_t b = 0; b < blocks_.size(); ++b) {
      const int number = static_cast<int>(b);
      for (size_t i = blocks_[b].begin; i < blocks_[b].end; ++i) {
        ForEachRead(code_[i], [&](int variable) {
          const size_t v = static_cast<size_t>(variable);
          if (written_in[v] == number || bit_of_[v] >= 0 || !IsLocalNumber(program_, variable)) {
            return;
          }
          bit_of_[v] = static_cast<int>(crossing_.size());
          crossing_.push_back(variable);
        });
        if (code_[i].Writes() && code_[i].target.IsVariable()) {
          written_in[static_cast<size_t>(code_[i].target.variable)] = number;
        }
      }
    }
    for (Block& block : blocks_) {
      const Bits none((crossing_.size() + 63) / 64);
      block.used = block.written = block.in = block.out = none;
      for (size_t i = block.begin; i < block.end; ++i) {
        ForEachRead(code_[i], [&](int variable) {
          const int bit = bit_of_[static_cast<size_t>(variable)];
          if (bit >= 0 && !Test(block.written, static_cast<size_t>(bit))) {
            Set(block.used, static_cast<size_t>(bit));
          }
        });
        if (!code_[i].Writes() || !code_[i].target.IsVariable()) continue;
        const int bit = bit_of_[static_cast<size_t>(code_[i].target.variable)];
        if (bit >= 0) Set(block.written, static_cast<size_t>(bit));
      }
    }
  }

  void Solve() {
    for (bool changed = true; changed;) {
      changed = false;
      for (size_t b = blocks_.size(); b-- > 0;) {
        Block& block = blocks_[b];
        for (size_t word = 0; word < block.in.size(); ++word) {
          uint64_t out = 0;
          for (const int next : block.next) {
            if (next >= 0) out |= blocks_[static_cast<size_t>(next)].in[word];
          }
          block.out[word] = out;
          const uint64_t in = block.used[word] | (out & ~block.written[word]);
          changed |= in != block.in[word];
          block.in[word] = in;
        }
      }
    }
  }

  const Program& program_;
  std::vector<Instruction>& code_;
  std::vector<Block> blocks_;
  std::vector<int> crossing_;  // variables, by bit
  std::vector<int> bit_of_;
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
    return read[target] == 0 && program.variables[target].role != Variable::Role::kGlobal &&
           !IsLocalNumber(program, instruction.target.variable);
  });
  return erased > 0;
}

}  // namespace

bool RemoveDeadStores(const Program& program, LoweredFunction& function) {
  bool removed = RemoveUnreadAggregates(program, function);
  // What only removed statements read is dead then.
  while (Liveness(program, function).RemoveDead()) removed = true;
  return removed;
}

}  // namespace oncard::compiler::lowering
