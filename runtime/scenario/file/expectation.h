// One line of a scenario's `expect`: a condition (runtime/conditions/condition.h) on the card with
// its program, checked at the end of the run or at an instant.
//
//   sum == 5050
//   thread0.result == sum && x == 1.5 +- 0.001
//   gpo[1] == 1 @ 12.5ms
//
// An instant sees everything that happened up to it; it falls on the end of the first profile cycle
// that is not before it.
// Tested by tests/runtime/scenario_expectation_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "runtime/conditions/condition.h"
#include "runtime/scenario/file/placed_errors.h"

namespace oncard::runtime {

struct Expectation {
  Condition condition;
  std::optional<int64_t> at_us;  ///< empty: at the end of the run
  TextPlace place = {};

  /// As written, the instant included.
  const std::string& text() const { return condition.text(); }
};

/// Reads one. The error names what is wrong.
Result<Expectation> ParseExpectation(std::string_view text);

}  // namespace oncard::runtime
