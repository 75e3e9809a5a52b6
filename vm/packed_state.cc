#include "vm/packed_state.h"

#include <algorithm>
#include <bit>

namespace oncard::vm {
namespace {

using Slots = std::array<int64_t, kSlotCount>;

/// How many slots are packed: up to the last that is not 0, in groups.
size_t PackedCount(const Slots& slots) {
  constexpr size_t kGroup = 8;
  static_assert(kSlotCount % kGroup == 0);
  size_t count = kSlotCount;
  for (; count > 0; count -= kGroup) {
    int64_t any = 0;
    for (size_t i = count - kGroup; i < count; ++i) any |= slots[i];
    if (any != 0) break;
  }
  return count;
}

void Append(const Slots& from, size_t count, std::vector<int64_t>* slots) {
  slots->push_back(static_cast<int64_t>(count));
  slots->insert(slots->end(), from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Returns the place behind what was read.
const int64_t* Read(const int64_t* from, Slots* slots) {
  const auto count = static_cast<size_t>(*from++);
  const auto rest = std::copy_n(from, count, slots->begin());
  std::fill(rest, slots->end(), 0);
  return from + count;
}

}  // namespace

void PackedVariables::Pack(const MachineState& state) {
  used_pages = 0;
  slots.clear();
  Append(state.globals, PackedCount(state.globals), &slots);
  for (uint32_t pages = state.pages.used(); pages != 0; pages &= pages - 1) {
    const auto number = static_cast<size_t>(std::countr_zero(pages));
    const DataPages::Page& page = state.pages[number];
    const size_t count = PackedCount(page);
    if (count == 0) continue;
    used_pages |= uint32_t{1} << number;
    Append(page, count, &slots);
  }
}

void PackedVariables::Unpack(MachineState* state) const {
  const int64_t* from = Read(slots.data(), &state->globals);
  for (uint32_t pages = state->pages.used() | used_pages; pages != 0; pages &= pages - 1) {
    const auto number = static_cast<size_t>(std::countr_zero(pages));
    DataPages::Page& page = state->pages.Use(number);
    if ((used_pages >> number & 1) == 0) {
      page.fill(0);
    } else {
      from = Read(from, &page);
    }
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
