// Locals whose lives do not overlap share slots, in a thread function that has too many: those that
// fit keep theirs, and their names. Only variables of one type and size share, so that every index
// is checked against the size of its own array.
//
// A variable lives from where it may have been written to where it may still be read. Writing an
// element does not end the life of the values before, so arrays also end with their blocks: in
//
//     while (1) { int a[600]; ... }
//
// nothing of `a` is left when the loop goes on. What copies have moved are numbers, never arrays,
// so these are used in the instances of their blocks only.
//
// A number that is read before it is written, or an array that is never written, has its value from
// the host, and lives from the beginning.
#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/lowering/costs.h"
#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

// A set of candidates.
class Variables {
 public:
  explicit Variables(size_t count) : words_((count + 63) / 64) {}
  void Add(size_t i) { words_[i / 64] |= uint64_t{1} << (i % 64); }
  bool Contains(size_t i) const { return (words_[i / 64] >> (i % 64) & 1) != 0; }
  void Remove(const Variables& other) {
    for (size_t w = 0; w < words_.size(); ++w) words_[w] &= ~other.words_[w];
  }
  void Keep(const Variables& other) {
    for (size_t w = 0; w < words_.size(); ++w) words_[w] &= other.words_[w];
  }
  // True if the set becomes larger.
  bool Add(const Variables& other) {
    bool grown = false;
    for (size_t w = 0; w < words_.size(); ++w) {
      grown |= (other.words_[w] & ~words_[w]) != 0;
      words_[w] |= other.words_[w];
    }
    return grown;
  }

 private:
  std::vector<uint64_t> words_;
};

class SlotSharing {
 public:
  SlotSharing(Program& program, LoweredFunction& function)
      : program_(program), function_(function), code_(function.code) {}

  void Run(int surplus) {
    FindCandidates();
    FindBlocks();
    FindNext();
    FindLives();
    FindOverlaps();
    Share(surplus);
  }

 private:
  const Variable& At(int number) const { return program_.variables[static_cast<size_t>(number)]; }

  bool IsNumber(size_t candidate) const { return IsLocalNumber(program_, candidates_[candidate]); }

  template <typename Visitor>
  void ForEachUse(const Instruction& instruction, const Visitor& visit) const {
    ForEachOperand(instruction, [&](const Operand& operand, bool written) {
      const auto use = [&](int number, bool read, bool writes) {
        if (number < 0) return;
        const int candidate = candidate_of_[static_cast<size_t>(number)];
        if (candidate >= 0) visit(static_cast<size_t>(candidate), read, writes);
      };
      use(operand.index, true, false);
      use(operand.variable, !written || operand.address, written);
    });
  }

  void FindCandidates() {
    std::set<int> numbers;
    for (const Instruction& instruction : code_) {
      ForEachOperand(instruction, [&](const Operand& operand, bool /*written*/) {
        for (const int number : {operand.variable, operand.index}) {
          // The size of an array that is checked has a meaning of its own.
          if (number < 0 || At(number).checks) continue;
          if (At(number).role == Variable::Role::kLocal) numbers.insert(number);
        }
      });
    }
    candidates_.assign(numbers.begin(), numbers.end());
    candidate_of_.assign(program_.variables.size(), -1);
    for (size_t i = 0; i < candidates_.size(); ++i) {
      candidate_of_[static_cast<size_t>(candidates_[i])] = static_cast<int>(i);
    }
  }

  // The blocks that have instances in each body.
  void FindBlocks() {
    for (const BlockInstance& instance : function_.instances) {
      if (instance.block != 0) blocks_[instance.body].insert(instance.block);
    }
  }

  void FindNext() {
    const std::vector<int> positions = LabelPositions(function_);
    next_.resize(code_.size());
    for (size_t i = 0; i < code_.size(); ++i) {
      if (code_[i].Jumps()) {
        next_[i].push_back(static_cast<size_t>(positions[static_cast<size_t>(code_[i].label)]));
      }
      if (code_[i].GoesOn() && i + 1 < code_.size()) next_[i].push_back(i + 1);
    }
  }

  // The innermost instance that two instances belong to, of one body.
  int Common(int a, int b) const {
    while (a != b)
      (a > b ? a : b) = function_.instances[static_cast<size_t>(std::max(a, b))].parent;
    return a;
  }

  // The arrays that lose their values on the way from one statement to the next one; nullptr: none.
  const Variables* LostBetween(size_t from, size_t to) {
    const int a = code_[from].instance, b = code_[to].instance;
    if (a == b || a < 0 || b < 0) return nullptr;
    const int body = function_.instances[static_cast<size_t>(a)].body;
    // A call, or the way back from one: what is outside of the body keeps its values.
    if (body != function_.instances[static_cast<size_t>(b)].body) return nullptr;
    const int common = Common(a, b);
    const auto known = lost_.find(common);
    if (known != lost_.end()) return &known->second;
    std::set<int> left = blocks_[body];
    for (int i = common; i >= 0; i = function_.instances[static_cast<size_t>(i)].parent) {
      left.erase(function_.instances[static_cast<size_t>(i)].block);
    }
    Variables lost(candidates_.size());
    for (size_t i = 0; i < candidates_.size(); ++i) {
      if (!IsNumber(i) && left.contains(At(candidates_[i]).block)) lost.Add(i);
    }
    return &lost_.emplace(common, std::move(lost)).first->second;
  }

  // Which variables may be read after each statement, and which may have been written.
  void FindLives() {
    const Variables none(candidates_.size());
    std::vector<Variables> before(code_.size(), none);  // needed before the statement
    needed_.assign(code_.size(), none);
    written_.assign(code_.size(), none);
    for (bool changed = true; changed;) {
      changed = false;
      for (size_t i = code_.size(); i-- > 0;) {
        for (const size_t next : next_[i]) {
          Variables needed = before[next];
          if (const Variables* lost = LostBetween(i, next)) needed.Remove(*lost);
          needed_[i].Add(needed);
        }
        Variables needed = needed_[i];
        const Operand& target = code_[i].target;
        if (target.IsVariable() && candidate_of_[static_cast<size_t>(target.variable)] >= 0) {
          Variables assigned = none;
          assigned.Add(static_cast<size_t>(candidate_of_[static_cast<size_t>(target.variable)]));
          needed.Remove(assigned);
        }
        ForEachUse(code_[i], [&needed](size_t candidate, bool read, bool /*written*/) {
          if (read) needed.Add(candidate);
        });
        changed |= before[i].Add(needed);
      }
    }
    Variables ever_written = none;
    for (size_t i = 0; i < code_.size(); ++i) {
      ForEachUse(code_[i], [&](size_t candidate, bool /*read*/, bool written) {
        if (!written) return;
        written_[i].Add(candidate);
        ever_written.Add(candidate);
      });
    }
    for (size_t i = 0; i < candidates_.size(); ++i) {
      const bool set_by_host = IsNumber(i) || !ever_written.Contains(i);
      if (set_by_host && before[0].Contains(i)) written_[0].Add(i);
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (size_t i = 0; i < code_.size(); ++i) {
        for (const size_t next : next_[i]) {
          Variables written = written_[i];
          if (const Variables* lost = LostBetween(i, next)) written.Remove(*lost);
          changed |= written_[next].Add(written);
        }
      }
    }
  }

  // Two lives overlap where one of them is written while the other one lasts.
  void FindOverlaps() {
    overlaps_.assign(candidates_.size(), Variables(candidates_.size()));
    for (size_t i = 0; i < code_.size(); ++i) {
      std::vector<size_t> assigned;
      ForEachUse(code_[i], [&assigned](size_t candidate, bool /*read*/, bool written) {
        if (written) assigned.push_back(candidate);
      });
      if (assigned.empty()) continue;
      Variables living = needed_[i];
      living.Keep(written_[i]);
      for (const size_t candidate : assigned) living.Add(candidate);
      for (const size_t candidate : assigned) {
        for (size_t other = 0; other < candidates_.size(); ++other) {
          if (other == candidate || !living.Contains(other)) continue;
          overlaps_[candidate].Add(other);
          overlaps_[other].Add(candidate);
        }
      }
    }
  }

  // The largest first, until enough slots are free.
  void Share(int surplus) {
    std::vector<size_t> order(candidates_.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto slots = [this](size_t candidate) { return SlotsOf(At(candidates_[candidate])); };
    std::stable_sort(order.begin(), order.end(),
                     [&slots](size_t a, size_t b) { return slots(a) > slots(b); });
    using Kind = std::tuple<vm::DataType, int, const gtcalls::Structure*>;
    std::map<Kind, std::vector<size_t>> owners;
    std::map<int, std::vector<int>> others;  // by owner
    std::vector<int> owner_of(candidates_.size(), -1);
    for (const size_t candidate : order) {
      if (surplus <= 0) break;
      const Variable& variable = At(candidates_[candidate]);
      auto& known = owners[{variable.type, variable.size, variable.structure}];
      const auto owner = std::find_if(known.begin(), known.end(), [&](size_t one) {
        return !overlaps_[one].Contains(candidate);
      });
      if (owner == known.end()) {
        known.push_back(candidate);
        continue;
      }
      overlaps_[*owner].Add(overlaps_[candidate]);
      owner_of[candidate] = candidates_[*owner];
      others[candidates_[*owner]].push_back(candidates_[candidate]);
      surplus -= slots(candidate);
    }
    Replace(owner_of);
    for (auto& [owner, numbers] : others) {
      std::sort(numbers.begin(), numbers.end());
      function_.shared_slots.push_back({owner, std::move(numbers)});
    }
  }

  void Replace(const std::vector<int>& owner_of) {
    const auto replace = [this, &owner_of](int& number) {
      if (number < 0) return;
      const int candidate = candidate_of_[static_cast<size_t>(number)];
      if (candidate < 0) return;
      const int owner = owner_of[static_cast<size_t>(candidate)];
      if (owner >= 0) number = owner;
    };
    for (Instruction& instruction : code_) {
      ForEachOperand(instruction, [&replace](Operand& operand, bool /*written*/) {
        replace(operand.variable);
        replace(operand.index);
      });
    }
  }

  Program& program_;
  LoweredFunction& function_;
  std::vector<Instruction>& code_;
  std::vector<int> candidates_;          // numbers of variables
  std::vector<int> candidate_of_;        // by variable; -1: none
  std::map<int, std::set<int>> blocks_;  // by body
  std::vector<std::vector<size_t>> next_;
  std::map<int, Variables> lost_;   // by the instance that is not left
  std::vector<Variables> needed_;   // after each statement
  std::vector<Variables> written_;  // after each statement
  std::vector<Variables> overlaps_;
};

}  // namespace

void ShareSlots(int surplus, Program& program, LoweredFunction& function) {
  if (surplus > 0) SlotSharing(program, function).Run(surplus);
}

}  // namespace oncard::compiler::lowering
