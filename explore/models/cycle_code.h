// What a thread can still execute in the present cycle, from its code alone: it goes on until it
// delays or returns.
//
// What is found can be too much, never too little. A plain value. Tested by
// tests/explore/cycle_code_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gtcalls/catalogue.h"
#include "vm/object.h"

namespace oncard::explore {

class CycleCode {
 public:
  /// No number of statements is too many: a loop does not delay.
  static constexpr int64_t kUnlimited = INT64_MAX;

  CycleCode(const vm::Function& function, const gtcalls::Catalogue& catalogue);

  /// The most statements that a thread can execute from a position on. 0 behind the last one.
  int64_t MostFrom(size_t position) const { return most_[position]; }
  /// The positions of the statements that it can execute, with the first one, in order.
  std::vector<size_t> ReachedFrom(size_t position) const;

 private:
  /// Of each statement those that can follow in the same cycle.
  std::vector<std::vector<size_t>> next_;
  std::vector<int64_t> most_;  ///< one more than there are statements
};

/// The positions of the statements that can follow one, in this cycle or a later one.
std::vector<size_t> FollowersOf(const vm::Function& function, size_t position);

/// True if a statement ends its thread's part of the cycle: the thread sleeps until a later one.
bool Delays(const vm::Instruction& instruction, const gtcalls::Catalogue& catalogue);

}  // namespace oncard::explore
