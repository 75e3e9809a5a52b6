// Which locals of a thread can still be read from a statement on, wherever its jumps lead.
//
// Plain functions of values. Tested by tests/explore/thread_future_test.cc and dead_locals_test.cc.
#pragma once

#include <bitset>
#include <cstddef>
#include <vector>

#include "vm/limits.h"
#include "vm/object.h"

namespace oncard::explore {

/// Bit n: the local with the slot n.
using LocalSlots = std::bitset<vm::kSlotCount>;

/// What a statement does with locals.
struct LocalUse {
  LocalSlots read;
  LocalSlots written;        ///< always
  std::vector<size_t> next;  ///< the statements that can follow
};

/// Of each statement the locals whose values can be read, in it or later, before they are written.
std::vector<LocalSlots> LiveLocals(const std::vector<LocalUse>& statements);

/// Adds all locals that an operand can name, and those that it stands for itself.
void AddNamedLocals(const vm::Operand& operand, LocalSlots* slots);
void AddOwnLocals(const vm::Operand& operand, LocalSlots* slots);

}  // namespace oncard::explore
