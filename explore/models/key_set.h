// A set of keys, numbered in the order in which they were added: open addressing, without removal.
//
// The table is an array of cache lines, and a key with its number is in one of them, so that a
// look-up waits for memory once. The place of a key grows with its value: a table becomes larger
// where it is, from back to front, and its size need not be a power of two. It takes 28 to 43 bytes
// per key.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/large_array.h"
#include "explore/models/state_key.h"

namespace oncard::explore {

class KeySet {
 public:
  KeySet() : lines_(kFirstSize) {}

  /// The number of a key; the next free one, from 0, when it is new.
  uint32_t FindOrAdd(const StateKey& key, bool* added) {
    if (size_ >= most_) Grow();
    const Place place = PlaceOf(key);
    *added = place.line->numbers[place.slot] == kEmpty;
    if (*added) place.line->Put(place.slot, {key, ++size_});
    return place.line->numbers[place.slot] - 1;
  }
  /// True when the key is new.
  bool Insert(StateKey key) {
    bool added = false;
    FindOrAdd(key, &added);
    return added;
  }
  /// To be called some time before a key is looked up, which is then faster.
  void Prefetch(StateKey key) const { __builtin_prefetch(&lines_[LineOf(key)], 1); }
  uint32_t size() const { return size_; }
  /// In the order of their numbers.
  std::vector<StateKey> Keys() const {
    std::vector<StateKey> keys(size_);
    for (const Line& line : lines_) {
      for (size_t slot = 0; slot < line.used(); ++slot) {
        keys[line.numbers[slot] - 1] = line.keys[slot];
      }
    }
    return keys;
  }

 private:
  static constexpr size_t kFirstSize = 64;
  static constexpr size_t kSmall = size_t{1} << 14;
  static constexpr size_t kPerLine = 3;
  static constexpr uint32_t kEmpty = 0;

  struct Entry {
    StateKey key;
    uint32_t number;  ///< from 1
  };
  /// The keys in a line are its first ones. A line of zero bytes is empty.
  struct alignas(64) Line {
    std::array<StateKey, kPerLine> keys;
    std::array<uint32_t, kPerLine> numbers;

    size_t used() const {
      size_t slot = 0;
      while (slot < kPerLine && numbers[slot] != kEmpty) ++slot;
      return slot;
    }
    void Put(size_t slot, const Entry& entry) {
      keys[slot] = entry.key;
      numbers[slot] = entry.number;
    }
  };
  struct Place {
    Line* line;
    size_t slot;
  };

  /// At most three quarters of the slots are in use.
  uint32_t MostNow() const { return static_cast<uint32_t>(lines_.size() * kPerLine / 4 * 3); }
  size_t LineOf(StateKey key) const {
    return static_cast<size_t>((key.low >> 32) * lines_.size() >> 32);
  }
  /// Where the key is, or the free slot in which it belongs.
  Place PlaceOf(StateKey key) {
    size_t index = LineOf(key);
    for (;;) {
      Line& line = lines_[index];
      for (size_t slot = 0; slot < kPerLine; ++slot) {
        if (line.keys[slot] == key || line.numbers[slot] == kEmpty) return {&line, slot};
      }
      index = index + 1 < lines_.size() ? index + 1 : 0;
    }
  }
  void Grow() {
    // While the table is small, growing costs more than room that is not used.
    const size_t before = lines_.size();
    lines_.Grow(before < kSmall ? 4 * before : before + before / 2);
    most_ = MostNow();
    // A key moves backwards, into lines that have been emptied, unless it was not in its own line.
    std::vector<Entry> others;
    for (size_t index = before; index-- > 0;) {
      const Line line = std::exchange(lines_[index], Line{});
      for (size_t slot = 0; slot < line.used(); ++slot) {
        const Entry entry = {line.keys[slot], line.numbers[slot]};
        if (!PutBehind(index, entry)) others.push_back(entry);
      }
    }
    for (const Entry& entry : others) {
      const Place place = PlaceOf(entry.key);
      place.line->Put(place.slot, entry);
    }
  }
  /// Puts a key where it belongs if that is in this line or behind it, and does not begin at the
  /// front again.
  bool PutBehind(size_t first, const Entry& entry) {
    size_t index = LineOf(entry.key);
    if (index < first) return false;
    while (index < lines_.size() && lines_[index].used() == kPerLine) ++index;
    if (index == lines_.size()) return false;
    lines_[index].Put(lines_[index].used(), entry);
    return true;
  }

  LargeArray<Line> lines_;
  uint32_t size_ = 0;
  uint32_t most_ = MostNow();  ///< keys that are added before the table grows
};

}  // namespace oncard::explore
