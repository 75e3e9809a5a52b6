#include "vm/packed_state.h"

#include <algorithm>
#include <bit>

namespace oncard::vm {

void PackedVariables::Pack(const MachineState& state) {
  used_pages = 0;
  slots.assign(state.globals.begin(), state.globals.end());
  for (uint32_t pages = state.pages.used(); pages != 0; pages &= pages - 1) {
    const auto number = static_cast<size_t>(std::countr_zero(pages));
    const DataPages::Page& page = state.pages[number];
    if (std::ranges::all_of(page, [](int64_t slot) { return slot == 0; })) continue;
    used_pages |= uint32_t{1} << number;
    slots.insert(slots.end(), page.begin(), page.end());
  }
}

void PackedVariables::Unpack(MachineState* state) const {
  std::copy_n(slots.begin(), kSlotCount, state->globals.begin());
  auto from = slots.begin() + kSlotCount;
  for (uint32_t pages = state->pages.used() | used_pages; pages != 0; pages &= pages - 1) {
    const auto number = static_cast<size_t>(std::countr_zero(pages));
    DataPages::Page& page = state->pages.Use(number);
    if ((used_pages >> number & 1) == 0) {
      page.fill(0);
      continue;
    }
    std::copy_n(from, kSlotCount, page.begin());
    from += kSlotCount;
  }
}

PackedState::PackedState(const MachineState& state)
    : threads_(state.threads),
      scheduler_(state.scheduler),
      executed_(state.executed),
      faults_(state.faults),
      cycle_(state.cycle) {
  variables_.Pack(state);
}

void PackedState::Unpack(MachineState* state) const {
  variables_.Unpack(state);
  state->threads = threads_;
  state->scheduler = scheduler_;
  state->executed = executed_;
  state->faults = faults_;
  state->cycle = cycle_;
}

}  // namespace oncard::vm
