// One line of a scenario's `expect`: a comparison, at the end of the run or at an instant.
//
//   sum == 5050
//   thread0.result == sum
//   x == 1.5 +- 0.001
//   gpo[1] == 1 @ 12.5ms
//
// Names are those of quantity.h. Operators: == != < <= > >=. A tolerance goes with == and != only.
// An instant is in ms or s and sees everything that happened up to it; it falls on the end of the
// first profile cycle that is not before it.
// Tested by tests/runtime/scenario_expectation_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "base/result.h"
#include "runtime/observe/quantity.h"

namespace oncard::runtime {

enum class Comparison : uint8_t {
  kEqual,
  kNotEqual,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
};

/// An expectation as written.
struct Expectation {
  std::string text;
  std::string left;
  Comparison comparison = Comparison::kEqual;
  std::variant<double, std::string> right = 0.0;  ///< a number, or a name
  double tolerance = 0;
  std::optional<int64_t> at_us;  ///< empty: at the end of the run
};

/// Reads one. The error names what is wrong and shows a right form.
Result<Expectation> ParseExpectation(std::string_view text);

/// An expectation bound to a program.
struct BoundExpectation {
  Expectation expectation;
  Quantity left;
  std::optional<Quantity> right;
};

/// Finds the names. Fails when one is unknown or an array's.
Result<BoundExpectation> BindExpectation(Expectation expectation, const Controller& controller);

/// What came of an expectation.
struct ExpectationResult {
  bool holds = false;
  std::string actual;    ///< value of the left side
  std::string expected;  ///< value of the right side
};

/// Evaluates it now.
ExpectationResult Evaluate(const BoundExpectation& bound, const Controller& controller);

/// The values of an expectation that does not hold, in words: `sum is 5, last is 6`.
Message DescribeFailure(const BoundExpectation& bound, const ExpectationResult& outcome);

}  // namespace oncard::runtime
