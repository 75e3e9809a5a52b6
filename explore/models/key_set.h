// A set of keys, numbered in the order in which they were added: open addressing, without removal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/large_pages.h"
#include "explore/models/state_key.h"

namespace oncard::explore {

class KeySet {
 public:
  KeySet() : slots_(kFirstSize) {}

  /// The number of a key; the next free one, from 0, when it is new.
  uint32_t FindOrAdd(StateKey key, bool* added) {
    if (2 * size_t{size_} >= slots_.size()) Grow();
    Slot& slot = slots_[SlotOf(key)];
    *added = slot.number == kEmpty;
    if (*added) slot = {key, size_++};
    return slot.number;
  }
  /// True when the key is new.
  bool Insert(StateKey key) {
    bool added = false;
    FindOrAdd(key, &added);
    return added;
  }
  uint32_t size() const { return size_; }
  /// In the order of their numbers.
  std::vector<StateKey> Keys() const {
    std::vector<StateKey> keys(size_);
    for (const Slot& slot : slots_) {
      if (slot.number != kEmpty) keys[slot.number] = slot.key;
    }
    return keys;
  }

 private:
  static constexpr size_t kFirstSize = 1024;  // a power of two
  static constexpr uint32_t kEmpty = ~uint32_t{0};

  struct Slot {
    StateKey key;
    uint32_t number = kEmpty;
  };

  size_t SlotOf(StateKey key) const {
    size_t slot = key.low & (slots_.size() - 1);
    while (slots_[slot].number != kEmpty && !(slots_[slot].key == key)) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  void Grow() {
    decltype(slots_) old(slots_.size() * 2);
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.number != kEmpty) slots_[SlotOf(slot.key)] = slot;
    }
  }

  std::vector<Slot, LargePageAllocator<Slot>> slots_;
  uint32_t size_ = 0;
};

}  // namespace oncard::explore
