// One line of a scenario's `expect`: a comparison, at the end of the run or at an instant.
//
//   sum == 5050
//   thread0.result == sum
//   x == 1.5 +- 0.001
//   gpo[1] == 1 @ 12.5ms
//
// Names are those of quantity.h. Operators: == != < <= > >=. A tolerance goes with == and != only.
// An instant is in ms or s and includes everything that happens up to it; it is rounded up to the
// end of a profile cycle. Tested by tests/runtime/scenario_expectation_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "base/result.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/placed_errors.h"

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
  TextPlace place = {};
};

/// Parses an expectation. The error explains the mistake and shows a correct example.
Result<Expectation> ParseExpectation(std::string_view text);

/// An expectation bound to a program.
struct BoundExpectation {
  Expectation expectation;
  Quantity left;
  std::optional<Quantity> right;
};

/// Resolves the names. Fails if one is unknown or names an array.
Result<BoundExpectation> BindExpectation(Expectation expectation, const Controller& controller);

/// The result of an expectation.
struct ExpectationResult {
  bool holds = false;
  std::string actual;    ///< value of the left side
  std::string expected;  ///< value of the right side
};

/// Evaluates it now.
ExpectationResult Evaluate(const BoundExpectation& bound, const Controller& controller);

/// The values of an expectation that does not hold, as text: `sum is 5, last is 6`.
Message DescribeFailure(const BoundExpectation& bound, const ExpectationResult& outcome);

}  // namespace oncard::runtime
