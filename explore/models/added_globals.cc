#include "explore/models/added_globals.h"

#include <algorithm>
#include <optional>

#include "vm/operand_slots.h"

namespace oncard::explore {
namespace {

/// The global of `g = g + x`, `g = x + g` or `g = g - x`.
std::optional<uint16_t> TargetOfSum(const vm::Instruction& instruction) {
  if (instruction.opcode != vm::Opcode::kBinary || instruction.type != vm::DataType::kInt) {
    return std::nullopt;
  }
  const auto* target = std::get_if<vm::Variable>(&instruction.operands[2]);
  if (target == nullptr || target->storage != vm::Storage::kGlobal) return std::nullopt;
  const bool first = instruction.operands[0] == instruction.operands[2];
  const bool second = instruction.operands[1] == instruction.operands[2];
  const auto op = static_cast<vm::BinaryOperator>(instruction.op);
  const bool adds = op == vm::BinaryOperator::kAdd && first != second;
  const bool subtracts = op == vm::BinaryOperator::kSubtract && first && !second;
  return adds || subtracts ? std::optional(target->id) : std::nullopt;
}

bool AddsTo(const vm::Function& function, uint16_t global) {
  return std::ranges::any_of(function.instructions, [&](const vm::Instruction& instruction) {
    return TargetOfSum(instruction) == global;
  });
}

}  // namespace

std::vector<uint16_t> GlobalsOnlyAddedTo(const vm::Object& object,
                                         const std::vector<ThreadSetup>& threads) {
  std::vector<uint16_t> added;
  for (const vm::Symbol& symbol : object.globals) {
    // A command that is given one member of a structure accesses the others, too.
    const bool alone = symbol.array_size == 0 && symbol.name.find('.') == std::string::npos;
    if (alone && symbol.type == vm::DataType::kInt) added.push_back(symbol.id);
  }
  std::ranges::sort(added);
  for (const vm::Function& function : object.functions) {
    for (const vm::Instruction& instruction : function.instructions) {
      // Where it stands on both sides of `g = g + x`, it is named twice.
      int own = TargetOfSum(instruction) ? 2 : 0;
      for (const vm::Operand& operand : instruction.operands) {
        vm::ForEachNamedSlot(operand, vm::Storage::kGlobal, [&](uint32_t slot) {
          if (own > 0 && slot == *TargetOfSum(instruction)) {
            --own;
          } else {
            std::erase(added, slot);
          }
        });
      }
    }
  }
  std::erase_if(added, [&](uint16_t global) {
    return std::ranges::count_if(threads, [&](const ThreadSetup& thread) {
             return AddsTo(object.functions[static_cast<size_t>(thread.function)], global);
           }) < 2;
  });
  return added;
}

runtime::StatementAccess WithoutGlobals(const std::vector<uint16_t>& globals,
                                        runtime::StatementAccess accesses) {
  std::erase_if(accesses, [&](const runtime::Touched& touched) {
    return touched.resource == gtcalls::Resource::kVariable &&
           std::ranges::binary_search(globals, touched.number);
  });
  return accesses;
}

}  // namespace oncard::explore
