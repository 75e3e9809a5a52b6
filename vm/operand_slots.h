// The variables that an operand of a statement names. Tested by tests/vm/operand_slots_test.cc.
#pragma once

#include <cstdint>
#include <variant>

#include "vm/object.h"

namespace oncard::vm {

/// The variable that chooses the element of an array; nullptr for any other operand. The statement
/// reads it.
inline const Variable* IndexVariableOf(const Operand& operand) {
  const auto* element = std::get_if<Element>(&operand);
  return element == nullptr ? nullptr : &element->index;
}

/// Calls `visit` with each slot of a storage that an operand can stand for: of an element those of
/// the whole array.
template <typename Visit>
void ForEachSlot(const Operand& operand, Storage storage, const Visit& visit) {
  if (const auto* variable = std::get_if<Variable>(&operand)) {
    if (variable->storage == storage) visit(uint32_t{variable->id});
  } else if (const auto* element = std::get_if<Element>(&operand)) {
    for (uint32_t i = 0; i < element->size && element->storage == storage; ++i) {
      visit(element->base + i);
    }
  }
}

/// The same with its index: all slots that it can name.
template <typename Visit>
void ForEachNamedSlot(const Operand& operand, Storage storage, const Visit& visit) {
  const Variable* index = IndexVariableOf(operand);
  if (index != nullptr && index->storage == storage) visit(uint32_t{index->id});
  ForEachSlot(operand, storage, visit);
}

}  // namespace oncard::vm
