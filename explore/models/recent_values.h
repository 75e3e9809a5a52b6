// What has been looked up last, found by a few numbers without a key (state_key.h): a small table
// in front of a large one (value_table.h). A search asks for the same things again within a few
// states. Tested by tests/explore/recent_values_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace oncard::explore {

/// Values that stay where they are as long as they are found here.
template <typename Value>
class RecentValues {
 public:
  /// All that a value depends on.
  using Numbers = std::array<uint32_t, 4>;

  RecentValues() : entries_(kSize) {}

  /// The value for these numbers; `find` returns it if it is not one of the last ones. It may not
  /// use the table.
  template <typename Find>
  const Value& Of(const Numbers& numbers, const Find& find) {
    Entry& entry = entries_[PlaceOf(numbers)];
    if (entry.value == nullptr || entry.numbers != numbers) entry = {numbers, &find()};
    return *entry.value;
  }

 private:
  static constexpr int kBits = 12;  ///< a table that stays in the processor's cache
  static constexpr size_t kSize = size_t{1} << kBits;

  struct Entry {
    Numbers numbers{};
    const Value* value = nullptr;
  };

  static size_t PlaceOf(const Numbers& numbers) {
    uint64_t mixed = 0;
    for (const uint32_t number : numbers) mixed = (mixed ^ number) * 0x9e3779b97f4a7c15ULL;
    return static_cast<size_t>(mixed >> (64 - kBits));
  }

  std::vector<Entry> entries_;
};

}  // namespace oncard::explore
