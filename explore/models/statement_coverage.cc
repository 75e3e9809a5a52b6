#include "explore/models/statement_coverage.h"

#include <variant>

namespace oncard::explore {

StatementCoverage::StatementCoverage(const vm::Object& object) {
  for (const vm::Function& function : object.functions) {
    noted_.emplace_back(function.instructions.size());
  }
}

void StatementCoverage::Include(const StatementCoverage& other) {
  if (empty() || other.empty()) {
    noted_.clear();
    return;
  }
  for (size_t function = 0; function < noted_.size(); ++function) {
    for (size_t position = 0; position < noted_[function].size(); ++position) {
      noted_[function][position] |= other.noted_[function][position];
    }
  }
}

bool HasTwoWays(const vm::Instruction& instruction) {
  const bool jumps = instruction.opcode == vm::Opcode::kJump && instruction.displacement != 1;
  return (jumps || instruction.opcode == vm::Opcode::kReturn) &&
         !std::holds_alternative<vm::Immediate>(instruction.operands[0]);
}

}  // namespace oncard::explore
