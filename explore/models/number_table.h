// Tables of numbers for keys with several values: open addressing, without removal.
// Tested by tests/explore/thread_states_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/large_array.h"

namespace oncard::explore {

/// Numbers for pairs of a number and a value. Longer keys can be looked up in it value by value, if
/// each beginning of a key has a number.
class NumberTable {
 public:
  static constexpr uint32_t kNone = ~uint32_t{0};

  NumberTable() : slots_(size_t{1} << kFirstBits) {}

  /// The number that was added for a pair; kNone if there is none.
  uint32_t Find(uint32_t first, int64_t value) const {
    return slots_[SlotOf(first, value)].number();
  }

  /// Adds a pair that is not in the table; `number` is not kNone.
  void Add(uint32_t first, int64_t value, uint32_t number) {
    if (2 * ++size_ > slots_.size()) Grow();
    slots_[SlotOf(first, value)] = {value, first, ~number};
  }

  size_t size() const { return size_; }

 private:
  static constexpr int kFirstBits = 10;

  /// Zero bytes are a slot without a number.
  struct Slot {
    int64_t value;
    uint32_t first;
    uint32_t complement;  ///< of the number

    uint32_t number() const { return ~complement; }
  };

  size_t SlotOf(uint32_t first, int64_t value) const {
    const uint64_t mixed =
        (static_cast<uint64_t>(value) ^ uint64_t{first} << 32) * 0x9e3779b97f4a7c15ULL +
        first * 0xd1b54a32d192ed03ULL;
    size_t slot = static_cast<size_t>((mixed ^ mixed >> 29) >> shift_);
    while (slots_[slot].number() != kNone &&
           (slots_[slot].value != value || slots_[slot].first != first)) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }

  void Grow() {
    const LargeArray<Slot> old = std::exchange(slots_, LargeArray<Slot>(slots_.size() * 2));
    --shift_;
    for (const Slot& slot : old) {
      if (slot.number() != kNone) slots_[SlotOf(slot.first, slot.value)] = slot;
    }
  }

  LargeArray<Slot> slots_;
  int shift_ = 64 - kFirstBits;
  size_t size_ = 0;
};

/// Numbers different tuples in the order in which they are first looked up.
class TupleTable {
 public:
  static constexpr uint32_t kNone = ~uint32_t{0};

  /// Gives at most `most` numbers.
  explicit TupleTable(size_t most) : most_(most), slots_(kFirstSize, kNone) {}

  /// The number of a tuple; kNone for a new one when all numbers have been given. A tuple of
  /// another size than the one before is new, and tuples of the earlier size are forgotten.
  uint32_t NumberOf(const std::vector<int64_t>& tuple) {
    if (tuple.size() != width_) Restart(tuple.size());
    const size_t slot = SlotOf(tuple.data());
    if (slots_[slot] != kNone) return first_ + slots_[slot];
    if (first_ + size_ >= most_) return kNone;
    slots_[slot] = size_++;
    values_.insert(values_.end(), tuple.begin(), tuple.end());
    if (2 * size_t{size_} > slots_.size()) Grow();
    return first_ + size_ - 1;
  }

 private:
  static constexpr size_t kFirstSize = 1024;  // a power of two

  size_t SlotOf(const int64_t* tuple) const {
    uint64_t mixed = 0;
    for (size_t i = 0; i < width_; ++i) {
      mixed = (mixed ^ static_cast<uint64_t>(tuple[i])) * 0x9e3779b97f4a7c15ULL;
      mixed ^= mixed >> 32;
    }
    size_t slot = mixed & (slots_.size() - 1);
    while (slots_[slot] != kNone && !IsTuple(slots_[slot], tuple)) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  /// Tuples are short: a loop is faster than a call of a library.
  bool IsTuple(uint32_t number, const int64_t* tuple) const {
    const int64_t* const value = values_.data() + size_t{number} * width_;
    size_t i = 0;
    while (i < width_ && value[i] == tuple[i]) ++i;
    return i == width_;
  }
  void Grow() {
    slots_.assign(2 * slots_.size(), kNone);
    for (uint32_t i = 0; i < size_; ++i) slots_[SlotOf(values_.data() + i * width_)] = i;
  }
  void Restart(size_t width) {
    first_ += size_;
    size_ = 0;
    width_ = width;
    values_.clear();
    slots_.assign(kFirstSize, kNone);
  }

  size_t most_;
  size_t width_ = 0;
  uint32_t first_ = 0;  ///< number of the first tuple that is kept
  uint32_t size_ = 0;   ///< number of tuples that are kept
  std::vector<int64_t> values_;
  std::vector<uint32_t> slots_;
};

}  // namespace oncard::explore
