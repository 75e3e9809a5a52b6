// Statements that no path reaches, and labels that no jump names.
#include <algorithm>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {

void RemoveUnusedLabels(LoweredFunction& function) {
  std::vector<char> named(function.labels.size());
  for (const Instruction& instruction : function.code) {
    if (instruction.Jumps()) named[static_cast<size_t>(instruction.label)] = 1;
  }
  std::erase_if(function.code, [&named](const Instruction& instruction) {
    return instruction.kind == Instruction::Kind::kLabel &&
           named[static_cast<size_t>(instruction.label)] == 0;
  });
}

bool RemoveUnreachable(LoweredFunction& function) {
  std::vector<Instruction>& code = function.code;
  const std::vector<int> positions = LabelPositions(function);
  std::vector<char> reached(code.size());
  std::vector<size_t> open = {0};
  while (!open.empty()) {
    size_t i = open.back();
    open.pop_back();
    while (i < code.size() && reached[i] == 0) {
      reached[i] = 1;
      const Instruction& instruction = code[i];
      if (instruction.Jumps()) {
        open.push_back(static_cast<size_t>(positions[static_cast<size_t>(instruction.label)]));
      }
      if (!instruction.GoesOn()) break;
      ++i;
    }
  }
  const size_t before = code.size();
  size_t kept = 0;
  for (size_t i = 0; i < before; ++i) {
    if (reached[i] == 0) continue;
    if (kept != i) code[kept] = std::move(code[i]);
    ++kept;
  }
  code.resize(kept);
  RemoveUnusedLabels(function);
  return code.size() != before;
}

}  // namespace oncard::compiler::lowering
