// Numbers for different values, which are told apart by their keys. Tested by
// tests/explore/card_rows_test.cc.
#pragma once

#include <cstdint>
#include <deque>

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
    if (added) values_.push_back(make());
    return number;
  }
  /// The value itself, which stays where it is.
  template <typename Make>
  const Value& Of(StateKey key, const Make& make) {
    return values_[NumberOf(key, make)];
  }
  const Value& operator[](uint32_t number) const { return values_[number]; }

 private:
  KeySet keys_;
  std::deque<Value> values_;
};

}  // namespace oncard::explore
