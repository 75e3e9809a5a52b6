// Numbers for different values, which are told apart by their keys. Tested by
// tests/explore/card_rows_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "explore/models/key_set.h"
#include "explore/models/state_key.h"

namespace oncard::explore {

template <typename Value>
class ValueTable {
 public:
  /// The number of the value with a key. `make` returns it if it is new; it may not use the table.
  template <typename Make>
  uint32_t NumberOf(StateKey key, const Make& make) {
    bool added = false;
    const uint32_t number = keys_.FindOrAdd(key, &added);
    if (added) Add(make());
    return number;
  }
  /// The value itself, which stays where it is.
  template <typename Make>
  const Value& Of(StateKey key, const Make& make) {
    return (*this)[NumberOf(key, make)];
  }
  uint32_t size() const { return keys_.size(); }
  const Value& operator[](uint32_t number) const {
    return blocks_[number / kBlock][number % kBlock];
  }

 private:
  /// A power of two, so that a value is found without a division, as in a std::deque.
  static constexpr size_t kBlock = 64;

  void Add(Value value) {
    if (blocks_.empty() || blocks_.back().size() == kBlock) blocks_.emplace_back().reserve(kBlock);
    blocks_.back().push_back(std::move(value));
  }

  KeySet keys_;
  std::vector<std::vector<Value>> blocks_;
};

}  // namespace oncard::explore
