#include "explore/models/live_locals.h"

#include "vm/operand_slots.h"

namespace oncard::explore {

std::vector<LocalSlots> LiveLocals(const std::vector<LocalUse>& statements) {
  std::vector<std::vector<size_t>> before(statements.size());
  std::vector<LocalSlots> live;
  std::vector<size_t> open;
  live.reserve(statements.size());
  for (size_t position = 0; position < statements.size(); ++position) {
    live.push_back(statements[position].read);
    for (const size_t next : statements[position].next) before[next].push_back(position);
    open.push_back(position);
  }
  while (!open.empty()) {
    const size_t position = open.back();
    open.pop_back();
    for (const size_t previous : before[position]) {
      const LocalSlots more = live[previous] | (live[position] & ~statements[previous].written);
      if (more == live[previous]) continue;
      live[previous] = more;
      open.push_back(previous);
    }
  }
  return live;
}

void AddNamedLocals(const vm::Operand& operand, LocalSlots* slots) {
  vm::ForEachNamedSlot(operand, vm::Storage::kLocal, [&](uint32_t slot) { slots->set(slot); });
}

void AddOwnLocals(const vm::Operand& operand, LocalSlots* slots) {
  vm::ForEachSlot(operand, vm::Storage::kLocal, [&](uint32_t slot) { slots->set(slot); });
}

}  // namespace oncard::explore
