// A set of keys, numbered in the order in which they were added: open addressing, without removal.
//
// The table is an array of cache lines, and a key with its number is in one of them, so that a
// look-up waits for memory once. The place of a key grows with its value: a table is moved to a
// larger one from front to back, and its size need not be a power of two. It takes 28 to 43 bytes
// per key.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/large_pages.h"
#include "explore/models/state_key.h"

namespace oncard::explore {

class KeySet {
 public:
  KeySet() : lines_(kFirstSize) {}

  /// The number of a key; the next free one, from 0, when it is new.
  uint32_t FindOrAdd(const StateKey& key, bool* added) {
    if (size_ >= most_) Grow();
    const Place place = PlaceOf(lines_, key);
    *added = place.line->numbers[place.slot] == kEmpty;
    if (*added) place.line->Put(place.slot, key, size_++);
    return place.line->numbers[place.slot];
  }
  /// True when the key is new.
  bool Insert(StateKey key) {
    bool added = false;
    FindOrAdd(key, &added);
    return added;
  }
  /// To be called some time before a key is looked up, which is then faster.
  void Prefetch(StateKey key) const { __builtin_prefetch(&lines_[LineOf(lines_, key)], 1); }
  uint32_t size() const { return size_; }
  /// In the order of their numbers.
  std::vector<StateKey> Keys() const {
    std::vector<StateKey> keys(size_);
    ForEach(lines_, [&](StateKey key, uint32_t number) { keys[number] = key; });
    return keys;
  }

 private:
  static constexpr size_t kFirstSize = 64;
  static constexpr size_t kSmall = size_t{1} << 14;
  static constexpr size_t kPerLine = 3;
  static constexpr uint32_t kEmpty = ~uint32_t{0};

  /// The keys in a line are its first ones.
  struct alignas(64) Line {
    std::array<StateKey, kPerLine> keys;
    std::array<uint32_t, kPerLine> numbers = {kEmpty, kEmpty, kEmpty};

    void Put(size_t slot, StateKey key, uint32_t number) {
      keys[slot] = key;
      numbers[slot] = number;
    }
  };
  using Lines = LargeVector<Line>;
  struct Place {
    Line* line;
    size_t slot;
  };

  /// At most three quarters of the slots are in use.
  static uint32_t MostOf(const Lines& lines) {
    return static_cast<uint32_t>(lines.size() * kPerLine / 4 * 3);
  }
  static size_t LineOf(const Lines& lines, StateKey key) {
    return static_cast<size_t>((key.low >> 32) * lines.size() >> 32);
  }
  /// Where the key is, or the free slot in which it belongs.
  static Place PlaceOf(Lines& lines, StateKey key) {
    size_t index = LineOf(lines, key);
    for (;;) {
      Line& line = lines[index];
      for (size_t slot = 0; slot < kPerLine; ++slot) {
        if (line.keys[slot] == key || line.numbers[slot] == kEmpty) return {&line, slot};
      }
      index = index + 1 < lines.size() ? index + 1 : 0;
    }
  }
  template <typename Visit>
  static void ForEach(const Lines& lines, const Visit& visit) {
    for (const Line& line : lines) {
      for (size_t slot = 0; slot < kPerLine && line.numbers[slot] != kEmpty; ++slot) {
        visit(line.keys[slot], line.numbers[slot]);
      }
    }
  }
  void Grow() {
    // While the table is small, moving it costs more than room that is not used.
    Lines larger(lines_.size() < kSmall ? 4 * lines_.size() : lines_.size() + lines_.size() / 2);
    ForEach(lines_, [&](StateKey key, uint32_t number) {
      const Place place = PlaceOf(larger, key);
      place.line->Put(place.slot, key, number);
    });
    lines_.swap(larger);
    most_ = MostOf(lines_);
  }

  Lines lines_;
  uint32_t size_ = 0;
  uint32_t most_ = MostOf(lines_);  ///< keys that are added before the table grows
};

}  // namespace oncard::explore
