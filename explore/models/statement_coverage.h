// Which statements of a program a search has executed, and which ways it has gone where a jump or a
// return has a condition. Every statement that is noted here is executed under some schedule; of a
// search that has looked at every schedule, every other one is executed under none.
//
// A plain value; not thread-safe: one per search. Tested by
// tests/explore/statement_coverage_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vm/object.h"

namespace oncard::explore {

class StatementCoverage {
 public:
  // What is noted of a statement, as bits.
  static constexpr uint8_t kExecuted = 1;
  static constexpr uint8_t kHeld = 2;     ///< its condition did
  static constexpr uint8_t kNotHeld = 4;  ///< it did not

  /// Nothing is known: the search does not note what it executes.
  StatementCoverage() = default;
  /// Nothing was executed.
  explicit StatementCoverage(const vm::Object& object);

  /// True if nothing is known.
  bool empty() const { return noted_.empty(); }
  void Note(size_t function, size_t position, uint8_t bits) { noted_[function][position] |= bits; }
  /// The bits of each instruction of a function, to be set where that has to be fast; valid as long
  /// as this, or what it is moved to.
  uint8_t* BitsOf(size_t function) { return noted_[function].data(); }
  uint8_t At(size_t function, size_t position) const { return noted_[function][position]; }
  /// Adds what another search of the same program has executed; if nothing is known of one of both,
  /// nothing is known of them together.
  void Include(const StatementCoverage& other);

  bool operator==(const StatementCoverage&) const = default;

 private:
  std::vector<std::vector<uint8_t>> noted_;  ///< for each function, for each of its instructions
};

/// True if an instruction goes one of two ways: a jump or a return with a condition. A jump to the
/// next instruction has only one.
bool HasTwoWays(const vm::Instruction& instruction);

}  // namespace oncard::explore
