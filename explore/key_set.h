// Keys, each with the number under which it was added: open addressing, never forgets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "explore/state_key.h"

namespace oncard::explore {

class KeySet {
 public:
  KeySet() : keys_(kFirstSize), numbers_(kFirstSize, kEmpty) {}

  /// The number of a key; the next free one, from 0, when it is new.
  uint32_t FindOrAdd(StateKey key, bool* added) {
    if (2 * size_t{size_} >= keys_.size()) Grow();
    const size_t slot = SlotOf(key);
    *added = numbers_[slot] == kEmpty;
    if (*added) {
      keys_[slot] = key;
      numbers_[slot] = size_++;
    }
    return numbers_[slot];
  }
  /// True when the key is new.
  bool Insert(StateKey key) {
    bool added = false;
    FindOrAdd(key, &added);
    return added;
  }
  uint32_t size() const { return size_; }

 private:
  static constexpr size_t kFirstSize = 1024;  // a power of two
  static constexpr uint32_t kEmpty = ~uint32_t{0};

  size_t SlotOf(StateKey key) const {
    size_t slot = key.low & (keys_.size() - 1);
    while (numbers_[slot] != kEmpty && !(keys_[slot] == key)) {
      slot = (slot + 1) & (keys_.size() - 1);
    }
    return slot;
  }
  void Grow() {
    std::vector<StateKey> old_keys(keys_.size() * 2);
    std::vector<uint32_t> old_numbers(keys_.size() * 2, kEmpty);
    old_keys.swap(keys_);
    old_numbers.swap(numbers_);
    for (size_t i = 0; i < old_keys.size(); ++i) {
      if (old_numbers[i] == kEmpty) continue;
      const size_t slot = SlotOf(old_keys[i]);
      keys_[slot] = old_keys[i];
      numbers_[slot] = old_numbers[i];
    }
  }

  std::vector<StateKey> keys_;
  std::vector<uint32_t> numbers_;
  uint32_t size_ = 0;
};

}  // namespace oncard::explore
