// Statements for asserts whose own ones have been removed.
#include <utility>
#include <vector>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {

void GiveStatementsToAsserts(LoweredFunction& function) {
  using Kind = Instruction::Kind;
  std::vector<Instruction> code;
  code.reserve(function.code.size());
  for (Instruction& instruction : function.code) {
    if (instruction.kind == Kind::kLabel && !code.empty() && code.back().kind == Kind::kAssert) {
      Instruction jump;
      jump.kind = Kind::kGoto;
      jump.label = instruction.label;
      jump.range = code.back().range;
      jump.statement = instruction.statement;
      code.push_back(std::move(jump));
    }
    code.push_back(std::move(instruction));
  }
  function.code = std::move(code);
}

}  // namespace oncard::compiler::lowering
