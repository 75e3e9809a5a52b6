#include "vm/packed_state.h"

#include <algorithm>
#include <bit>

namespace oncard::vm {

PackedState::PackedState(const MachineState& state)
    : slots_(state.globals.begin(), state.globals.end()),
      used_pages_(state.pages.used()),
      threads_(state.threads),
      scheduler_(state.scheduler),
      executed_(state.executed),
      faults_(state.faults),
      cycle_(state.cycle) {
  slots_.reserve(slots_.size() * (1 + static_cast<size_t>(std::popcount(used_pages_))));
  for (uint32_t pages = used_pages_; pages != 0; pages &= pages - 1) {
    const auto& page = state.pages[static_cast<size_t>(std::countr_zero(pages))];
    slots_.insert(slots_.end(), page.begin(), page.end());
  }
}

void PackedState::Unpack(MachineState* state) const {
  auto from = slots_.begin();
  const auto take = [&from](auto& slots) {
    const auto end = from + static_cast<std::ptrdiff_t>(slots.size());
    std::copy(from, end, slots.begin());
    from = end;
  };
  take(state->globals);
  for (uint32_t pages = used_pages_ | state->pages.used(); pages != 0; pages &= pages - 1) {
    const auto number = static_cast<size_t>(std::countr_zero(pages));
    DataPages::Page& page = state->pages.Use(number);
    if ((used_pages_ >> number & 1) != 0) {
      take(page);
    } else {
      page.fill(0);
    }
  }
  state->threads = threads_;
  state->scheduler = scheduler_;
  state->executed = executed_;
  state->faults = faults_;
  state->cycle = cycle_;
}

}  // namespace oncard::vm
