#include "compiler/lowering/costs.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "vm/limits.h"

namespace oncard::compiler::lowering {
namespace {

constexpr size_t kNamedMax = 3;

// The variables of a page, in the order of their numbers.
std::set<int> PageOf(const Program& program, const LoweredFunction& function) {
  std::set<int> page(function.parameters.begin(), function.parameters.end());
  for (const Instruction& instruction : function.code) {
    ForEachOperand(instruction, [&](const Operand& operand, bool /*written*/) {
      for (const int number : {operand.variable, operand.index}) {
        if (number < 0) continue;
        const Variable& variable = program.variables[static_cast<size_t>(number)];
        if (variable.role != Variable::Role::kGlobal) page.insert(number);
      }
    });
  }
  return page;
}

// `buffer (600), table (500)`: those that take most.
template <typename Numbers>
std::string Largest(const Program& program, const Numbers& numbers) {
  std::vector<const Variable*> variables;
  variables.reserve(numbers.size());
  for (const int number : numbers) {
    variables.push_back(&program.variables[static_cast<size_t>(number)]);
  }
  std::stable_sort(variables.begin(), variables.end(),
                   [](const Variable* a, const Variable* b) { return SlotsOf(*a) > SlotsOf(*b); });
  std::string text;
  for (size_t i = 0; i < std::min(variables.size(), kNamedMax); ++i) {
    if (i > 0) text += ", ";
    text += fmt::format("{} ({})", variables[i]->name, SlotsOf(*variables[i]));
  }
  return text;
}

// How deep recursive functions may be if all else in the page stays as it is.
Message FittingDepth(const FramesCost& frames, int page_slots) {
  const int left = vm::kSlotCount - (page_slots - frames.count * frames.slots);
  const int depth = left / frames.slots + 1;
  if (depth < 2) {
    return MakeMessage("each call of '{0}' that waits takes {1} slots; no depth fits",
                       "'{0}' 每次等待中的调用占用 {1} 个存储单元；任何深度都放不下", frames.name,
                       frames.slots);
  }
  return MakeMessage("each call of '{0}' that waits takes {1} slots; '//@ depth: {2}' fits",
                     "'{0}' 每次等待中的调用占用 {1} 个存储单元；'//@ depth: {2}' 可以放下",
                     frames.name, frames.slots, depth);
}

}  // namespace

int SlotsOf(const Variable& variable) {
  if (variable.structure != nullptr) return static_cast<int>(variable.structure->members.size());
  return std::max(variable.size, 1);
}

FunctionCost CostOf(const Program& program, const LoweredFunction& function) {
  FunctionCost cost;
  cost.name = function.name;
  for (const Instruction& instruction : function.code) {
    if (instruction.kind == Instruction::Kind::kLabel) ++cost.labels;
    if (instruction.IsStatement()) ++cost.statements;
  }
  const std::set<int> page = PageOf(program, function);
  for (const int number : page) {
    const Variable& variable = program.variables[static_cast<size_t>(number)];
    if (variable.role == Variable::Role::kTemporary) ++cost.temporaries;
    cost.page_slots += SlotsOf(variable);
  }
  for (const SharedCalls& shared : function.calls) {
    const auto calls = std::count_if(
        function.code.begin(), function.code.end(), [&shared](const Instruction& instruction) {
          return instruction.target.variable == shared.number && instruction.a.IsConstant();
        });
    if (calls > 0) cost.jumps.push_back({shared.name, static_cast<int>(calls)});
  }
  for (const SharedSlots& shared : function.shared_slots) {
    SharedSlotsCost& one = cost.shared_slots.emplace_back();
    one.name = program.variables[static_cast<size_t>(shared.owner)].name;
    for (const int other : shared.others) {
      one.others.push_back(program.variables[static_cast<size_t>(other)].name);
    }
  }
  for (const int table : function.tables) {
    cost.tables.push_back(program.variables[static_cast<size_t>(table)].name);
  }
  for (const KeptFrames& frames : function.frames) {
    if (page.contains(frames.array)) {
      cost.frames.push_back({frames.name, frames.count, frames.slots});
    }
  }
  return cost;
}

int GlobalSlots(const Program& program) {
  int slots = 0;
  for (const int global : program.globals) {
    slots += SlotsOf(program.variables[static_cast<size_t>(global)]);
  }
  return slots;
}

void CheckLimits(const Program& program, const std::vector<FunctionCost>& costs,
                 Reporter& reporter) {
  const int global_slots = GlobalSlots(program);
  if (global_slots > vm::kSlotCount) {
    const SourceRange last = program.variables[static_cast<size_t>(program.globals.back())].range;
    reporter.Report(Code::kLoweredTooLarge, last, MakeMessage("the globals", "全局变量"),
                    int64_t{global_slots}, int64_t{vm::kSlotCount},
                    Largest(program, program.globals));
  }
  for (size_t i = 0; i < program.functions.size(); ++i) {
    const LoweredFunction& function = program.functions[i];
    if (costs[i].page_slots > vm::kSlotCount) {
      Diagnostic& diagnostic =
          reporter.Report(Code::kLoweredTooLarge, function.header,
                          MakeMessage("the function '{0}'", "函数 '{0}'", function.name),
                          int64_t{costs[i].page_slots}, int64_t{vm::kSlotCount},
                          Largest(program, PageOf(program, function)));
      for (const FramesCost& frames : costs[i].frames) {
        AddNote(diagnostic, FittingDepth(frames, costs[i].page_slots));
      }
    }
    if (costs[i].labels > vm::kLabelMax) {
      reporter.Report(Code::kLoweredLabels, function.header, function.name,
                      int64_t{costs[i].labels}, int64_t{vm::kLabelMax});
    }
  }
}

}  // namespace oncard::compiler::lowering
