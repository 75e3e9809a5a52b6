// The card's ferroelectric memory: a buffer that the host reads and writes in small pieces, and the
// memory itself, with transfers in both directions that take time. GT_Reset clears the buffer and
// ends a transfer; the memory keeps its contents. Source: GTS manual 11.8. Tested by
// tests/gtcalls/mram_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "motion/common/sizes.h"

namespace oncard::gtcalls::gts {

inline constexpr int kMramWords = 4096;
/// Maximum number of words of one transfer between host and buffer.
inline constexpr int kMramTransferMax = 24;
/// Assumption: the time the card needs for one word.
inline constexpr motion::Micros kMramWordUs = 10;

enum class MramAccess : uint8_t { kRead = 0, kWrite = 1 };

class Mram {
 public:
  /// Words of the buffer; addresses below kMramWords.
  int16_t Word(int address) const { return At(buffer_, address); }
  void SetWord(int address, int16_t value) { Put(address, value, &buffer_); }
  /// Words of the memory itself, which survive that the power goes off.
  int16_t Kept(int address) const { return At(memory_, address); }
  void Keep(int address, int16_t value) { Put(address, value, &memory_); }
  /// Begins to copy words from `address` on; they arrive at the end of the transfer time.
  void Start(motion::Micros now, int address, int count, MramAccess access);
  /// Aborts a transfer; words that have not arrived are not copied.
  void Stop() { busy_ = false; }
  bool busy() const { return busy_; }
  /// Completes the transfer when its time is over.
  void Advance(motion::Micros now) {
    if (busy_ && now >= end_) Finish();
  }
  /// How many cycles pass before the one that completes it; for a transfer that runs.
  int64_t CyclesBeforeEnd(motion::Micros now, motion::Micros cycle_us) const {
    return end_ <= now ? 0 : (end_ - now - 1) / cycle_us;
  }
  void Reset();

  auto Fields(auto visit) const {
    return visit(buffer_, memory_, busy_, access_, address_, count_, end_);
  }

 private:
  static int16_t At(const std::vector<int16_t>& words, int address) {
    return words.empty() ? int16_t{0} : words[static_cast<size_t>(address)];
  }
  static void Put(int address, int16_t value, std::vector<int16_t>* words);
  void Finish();

  // Either is empty as long as all its words are 0.
  std::vector<int16_t> buffer_;
  std::vector<int16_t> memory_;
  bool busy_ = false;
  MramAccess access_ = MramAccess::kRead;
  int32_t address_ = 0;
  int32_t count_ = 0;
  motion::Micros end_ = 0;
};

}  // namespace oncard::gtcalls::gts
