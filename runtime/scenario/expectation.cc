#include "runtime/scenario/expectation.h"

#include <array>
#include <cmath>

#include "base/number.h"
#include "base/trim.h"

namespace oncard::runtime {
namespace {

struct OperatorName {
  std::string_view spelling;
  Comparison comparison;
};

// Longer spellings first, so that `<=` is not read as `<`.
constexpr std::array kOperators = {
    OperatorName{"==", Comparison::kEqual},     OperatorName{"!=", Comparison::kNotEqual},
    OperatorName{"<=", Comparison::kLessEqual}, OperatorName{">=", Comparison::kGreaterEqual},
    OperatorName{"<", Comparison::kLess},       OperatorName{">", Comparison::kGreater},
};

constexpr std::string_view kTolerance = "+-";
// An hour of virtual time and more fits; the microseconds stay exact in a double.
constexpr double kInstantMaxMs = 1e9;

bool IsName(std::string_view text) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  if (text.empty() || !letter(text.front())) return false;
  for (const char c : text) {
    const bool digit = c >= '0' && c <= '9';
    if (!letter(c) && !digit && c != '.' && c != '[' && c != ']') return false;
  }
  return true;
}

Error Malformed(std::string_view text, std::string_view en, std::string_view zh) {
  return MakeError(1, "in the expectation '{0}': {1}; it should look like 'sum == 5050 @ 10ms'",
                   "期望“{0}”有误：{2}；正确形式如“sum == 5050 @ 10ms”", text, en, zh);
}

// `10ms`, `12.5 ms`, `1s` as microseconds.
std::optional<int64_t> ParseInstant(std::string_view text) {
  double scale = 1;
  if (text.ends_with("ms")) {
    text.remove_suffix(2);
  } else if (text.ends_with('s')) {
    text.remove_suffix(1);
    scale = 1000;
  } else {
    return std::nullopt;
  }
  const auto value = ReadNumber(Trim(text));
  if (!value || *value < 0 || *value * scale > kInstantMaxMs) return std::nullopt;
  return std::llround(*value * scale * 1000);
}

bool Holds(double left, Comparison comparison, double right, double tolerance) {
  switch (comparison) {
    case Comparison::kEqual:
      return std::abs(left - right) <= tolerance;
    case Comparison::kNotEqual:
      return std::abs(left - right) > tolerance;
    case Comparison::kLess:
      return left < right;
    case Comparison::kLessEqual:
      return left <= right;
    case Comparison::kGreater:
      return left > right;
    case Comparison::kGreaterEqual:
      return left >= right;
  }
  return false;
}

Result<Quantity> ResolveOne(const std::string& name, const Controller& controller) {
  auto found = ResolveQuantity(name, controller);
  if (!found.ok()) return found.error();
  if (found.value().size() != 1) {
    return MakeError(1, "'{0}' is an array; write one element, such as '{0}[0]'",
                     "“{0}”是数组；应写其中一个元素，如“{0}[0]”", name);
  }
  return std::move(found).value().front();
}

}  // namespace

Result<Expectation> ParseExpectation(std::string_view text) {
  Expectation expectation;
  expectation.text = Trim(text);
  std::string_view rest = expectation.text;

  if (const size_t at = rest.find('@'); at != std::string_view::npos) {
    const auto instant = ParseInstant(Trim(rest.substr(at + 1)));
    if (!instant) {
      return Malformed(text, "'@' must be followed by a time in ms or s",
                       "“@”后应为以 ms 或 s 计的时间");
    }
    expectation.at_us = *instant;
    rest = Trim(rest.substr(0, at));
  }

  const OperatorName* found = nullptr;
  size_t place = std::string_view::npos;
  for (const OperatorName& row : kOperators) {
    const size_t here = rest.find(row.spelling);
    if (here < place) {
      place = here;
      found = &row;
    }
  }
  if (found == nullptr) {
    return Malformed(text, "the comparison operator is missing", "缺少比较运算符");
  }
  expectation.comparison = found->comparison;
  expectation.left = Trim(rest.substr(0, place));
  std::string_view right = Trim(rest.substr(place + found->spelling.size()));

  if (const size_t sign = right.find(kTolerance); sign != std::string_view::npos) {
    const auto tolerance = ReadNumber(Trim(right.substr(sign + kTolerance.size())));
    const bool equality = expectation.comparison == Comparison::kEqual ||
                          expectation.comparison == Comparison::kNotEqual;
    if (!tolerance || *tolerance < 0 || !equality) {
      return Malformed(text, "a tolerance must be a positive number, with == or !=",
                       "容差应为正数，且只用于 == 或 !=");
    }
    expectation.tolerance = *tolerance;
    right = Trim(right.substr(0, sign));
  }
  if (!IsName(expectation.left)) {
    return Malformed(text, "the left side must be a name", "左边应为名称");
  }
  if (const auto number = ReadNumber(right)) {
    expectation.right = *number;
  } else if (IsName(right)) {
    expectation.right = std::string(right);
  } else {
    return Malformed(text, "the right side must be a number or a name", "右边应为数字或名称");
  }
  return expectation;
}

Result<BoundExpectation> BindExpectation(Expectation expectation, const Controller& controller) {
  BoundExpectation bound;
  auto left = ResolveOne(expectation.left, controller);
  if (!left.ok()) return left.error();
  bound.left = std::move(left).value();
  if (const std::string* name = std::get_if<std::string>(&expectation.right)) {
    auto right = ResolveOne(*name, controller);
    if (!right.ok()) return right.error();
    bound.right = std::move(right).value();
  }
  bound.expectation = std::move(expectation);
  return bound;
}

ExpectationResult Evaluate(const BoundExpectation& bound, const Controller& controller) {
  const Expectation& expectation = bound.expectation;
  const double left = ReadQuantity(bound.left, controller);
  ExpectationResult result;
  result.actual = FormatNumber(left, FormOfQuantity(bound.left, controller));
  double right = 0;
  if (bound.right) {
    right = ReadQuantity(*bound.right, controller);
    result.expected = FormatNumber(right, FormOfQuantity(*bound.right, controller));
  } else {
    right = std::get<double>(expectation.right);
    result.expected = fmt::format("{}", right);
  }
  result.holds = Holds(left, expectation.comparison, right, expectation.tolerance);
  return result;
}

Message DescribeFailure(const BoundExpectation& bound, const ExpectationResult& outcome) {
  if (bound.right) {
    return MakeMessage("{0} is {1}, {2} is {3}", "{0} 为 {1}，{2} 为 {3}", bound.left.name,
                       outcome.actual, bound.right->name, outcome.expected);
  }
  return MakeMessage("{0} is {1}", "{0} 为 {1}", bound.left.name, outcome.actual);
}

}  // namespace oncard::runtime
