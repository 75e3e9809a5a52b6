// Temporaries whose lifetimes do not overlap become one. A lifetime is the part of the text from
// the first to the last use; a loop that is entered within it belongs to it as a whole. What is in
// use at a call by a jump must outlive a body that stands elsewhere in the text, so the temporaries
// of a shared body are its own.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

struct Lifetime {
  int variable = -1;
  int begin = -1;
  int end = -1;
};

struct Loop {
  int begin;
  int end;
};

std::vector<Loop> LoopsOf(const LoweredFunction& function) {
  const std::vector<int> positions = LabelPositions(function);
  std::vector<Loop> loops;
  for (size_t i = 0; i < function.code.size(); ++i) {
    const Instruction& instruction = function.code[i];
    if (!instruction.Jumps()) continue;
    const int position = positions[static_cast<size_t>(instruction.label)];
    if (position <= static_cast<int>(i)) loops.push_back({position, static_cast<int>(i)});
  }
  std::sort(loops.begin(), loops.end(),
            [](const Loop& a, const Loop& b) { return a.begin < b.begin; });
  return loops;
}

void Extend(Lifetime& lifetime, const std::vector<Loop>& loops) {
  for (bool changed = true; changed;) {
    changed = false;
    auto loop = std::upper_bound(loops.begin(), loops.end(), lifetime.begin,
                                 [](int begin, const Loop& other) { return begin < other.begin; });
    for (; loop != loops.end() && loop->begin <= lifetime.end; ++loop) {
      if (loop->end <= lifetime.end) continue;
      lifetime.end = loop->end;
      changed = true;
    }
  }
}

}  // namespace

std::unordered_set<std::string_view> SharedNames(const Program& program) {
  std::unordered_set<std::string_view> names;
  for (const int global : program.globals) {
    names.insert(program.variables[static_cast<size_t>(global)].name);
  }
  for (const LoweredFunction& function : program.functions) names.insert(function.name);
  return names;
}

void ShareTemporaries(const std::unordered_set<std::string_view>& taken, Program& program,
                      LoweredFunction& function) {
  std::map<int, Lifetime> by_variable;
  std::unordered_set<std::string> names;
  for (const int parameter : function.parameters) {
    names.insert(program.variables[static_cast<size_t>(parameter)].name);
  }
  const auto use = [&](int variable, int position) {
    const Variable& info = program.variables[static_cast<size_t>(variable)];
    if (info.role != Variable::Role::kTemporary) {
      names.insert(info.name);
      return;
    }
    Lifetime& lifetime = by_variable[variable];
    lifetime.variable = variable;
    if (lifetime.begin < 0) lifetime.begin = position;
    lifetime.end = position;
  };
  for (size_t i = 0; i < function.code.size(); ++i) {
    const int position = static_cast<int>(i);
    ForEachOperand(function.code[i], [&use, position](const Operand& operand, bool /*written*/) {
      if (operand.variable >= 0) use(operand.variable, position);
      if (operand.index >= 0) use(operand.index, position);
    });
  }
  const std::vector<Loop> loops = LoopsOf(function);
  std::vector<Lifetime> lifetimes;
  for (auto& [variable, lifetime] : by_variable) {
    Extend(lifetime, loops);
    lifetimes.push_back(lifetime);
  }
  std::stable_sort(lifetimes.begin(), lifetimes.end(),
                   [](const Lifetime& a, const Lifetime& b) { return a.begin < b.begin; });

  // Of each type, those that are free, the oldest first, and those in use by the end of their use.
  // A statement reads its operands before it writes, so one may end where the next begins.
  struct Pool {
    std::set<int> free;
    std::multimap<int, int> busy;
  };
  std::map<std::pair<vm::DataType, int>, Pool> pools;  // by type and shared body
  std::map<vm::DataType, int> counts;
  std::unordered_map<int, int> shared;
  for (const Lifetime& lifetime : lifetimes) {
    const Variable& variable = program.variables[static_cast<size_t>(lifetime.variable)];
    const vm::DataType type = variable.type;
    Pool& pool = pools[{type, variable.body}];
    while (!pool.busy.empty() && pool.busy.begin()->first <= lifetime.begin) {
      pool.free.insert(pool.busy.begin()->second);
      pool.busy.erase(pool.busy.begin());
    }
    int owner = lifetime.variable;
    if (!pool.free.empty()) {
      owner = *pool.free.begin();
      pool.free.erase(pool.free.begin());
    } else {
      const std::string_view prefix = type == vm::DataType::kDouble ? "real" : "tmp";
      std::string name;
      do {
        name = fmt::format("{}{}", prefix, ++counts[type]);
      } while (taken.contains(name) || !names.insert(name).second);
      program.variables[static_cast<size_t>(owner)].name = name;
    }
    shared[lifetime.variable] = owner;
    pool.busy.emplace(lifetime.end, owner);
  }
  const auto replace = [&shared](int& variable) {
    const auto owner = shared.find(variable);
    if (owner != shared.end()) variable = owner->second;
  };
  for (Instruction& instruction : function.code) {
    ForEachOperand(instruction, [&replace](Operand& operand, bool /*written*/) {
      replace(operand.variable);
      replace(operand.index);
    });
  }
}

}  // namespace oncard::compiler::lowering
