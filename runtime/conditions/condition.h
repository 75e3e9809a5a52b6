// The language of all conditions on a program and its card: `expect`, `always`, `never`, `final`,
// `eventually`, and both sides of `leads` and `within`.
//
//   x == 6 && ret0 + ret1 >= 1
//   axis1.prfPos == 50000 +- 0.01
//   gpo[1] == 1 @ 12.5ms              with an instant, if the caller allows one
//
// Operators have the precedence of C: || && == != < <= > >= + - * and, before an operand, ! - +;
// there are parentheses. `a == b +- t` holds if a and b differ by at most t, `a != b +- t` if they
// differ by more. Numbers are those of base/number.h; a word that begins with a letter is a name,
// even `inf`. The binding defines the names: `v`, `a[3]`, `s.member`, `a[2].member`, `m[1][2]`,
// `page0.v`, `ret0`, `axis1.prfPos`.
//
// Every value is a double: it represents an int, an unsigned word and a fixed-point number exactly,
// and sums and products do not wrap as they do on the card. True is 1 and false is 0; every value
// except 0 is true. Both sides of || and && are evaluated, which has no observable effect.
//
// A condition is independent of the names: card_condition.h binds it to a card, the explorer's
// property.h to a program without one. Plain values, safe to read from several threads.
// Tested by tests/runtime/condition_test.cc.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"

namespace oncard::runtime {

class Condition {
 public:
  /// Names, numbers and operators of one condition.
  static constexpr size_t kElementMax = 128;
  /// Maximum nesting of parentheses and prefix operators.
  static constexpr int kNestingMax = 100;

  enum class Kind : uint8_t {
    kNumber,
    kName,
    kOr,
    kAnd,
    kEqual,
    kNotEqual,
    kLess,
    kLessEqual,
    kGreater,
    kGreaterEqual,
    kAdd,
    kSubtract,
    kMultiply,
    kNot,
    kNegate
  };

  /// A comparison of a name with a number or another name, and nothing else.
  struct Comparison {
    size_t left = 0;  ///< among names()
    Kind comparison = Kind::kEqual;
    std::variant<double, size_t> right = 0.0;  ///< the number, or which of names()
    double tolerance = 0;
  };

  /// The text from which it was read.
  const std::string& text() const { return text_; }
  /// The names in it without blanks, as `a[3]`, each once, in the order of their first occurrence.
  const std::vector<std::string>& names() const { return names_; }
  /// True if a comparison in it has a tolerance.
  bool HasTolerance() const;
  /// Empty for a condition that is more than a comparison.
  std::optional<Comparison> AsComparison() const;

  /// Evaluates it with `value(i)` for names()[i].
  template <typename Value>
  bool Holds(Value value) const;

 private:
  friend class ConditionReader;

  /// One element in postfix order.
  struct Element {
    Kind kind = Kind::kNumber;
    uint8_t name = 0;   ///< kName: which
    double number = 0;  ///< kNumber: the value; kEqual, kNotEqual: the tolerance
  };
  static_assert(kElementMax <= UINT8_MAX);

  std::string text_;
  std::vector<std::string> names_;
  std::vector<Element> elements_;
};

/// Reads a condition. Fails for a text that is not a condition, exceeds the limits above, or has an
/// instant.
Result<Condition> ParseCondition(std::string_view text);

struct TimedCondition {
  Condition condition;
  std::optional<int64_t> at_us;  ///< the instant, if there is one
};

/// Reads a condition with or without an instant: `@` and a time in ms or s, of at most 1e9 ms.
Result<TimedCondition> ParseTimedCondition(std::string_view text);

/// A time from 0 to 1e9 ms, as in `10ms`, `12.5 ms`, `1s`, in microseconds; empty for another text.
std::optional<int64_t> ParseTime(std::string_view text);

template <typename Value>
bool Condition::Holds(Value value) const {
  const auto truth = [](bool holds) { return holds ? 1.0 : 0.0; };
  const auto equal = [](double left, double right, double tolerance) {
    return left == right || std::abs(left - right) <= tolerance;
  };
  std::array<double, kElementMax> stack;
  size_t top = 0;
  for (const Element& element : elements_) {
    switch (element.kind) {
      case Kind::kNumber:
        stack[top++] = element.number;
        continue;
      case Kind::kName:
        stack[top++] = value(element.name);
        continue;
      case Kind::kNot:
        stack[top - 1] = truth(stack[top - 1] == 0);
        continue;
      case Kind::kNegate:
        stack[top - 1] = -stack[top - 1];
        continue;
      default:
        break;
    }
    const double right = stack[--top];
    double& left = stack[top - 1];
    switch (element.kind) {
      case Kind::kOr:
        left = truth(left != 0 || right != 0);
        break;
      case Kind::kAnd:
        left = truth(left != 0 && right != 0);
        break;
      case Kind::kEqual:
        left = truth(equal(left, right, element.number));
        break;
      case Kind::kNotEqual:
        left = truth(!equal(left, right, element.number));
        break;
      case Kind::kLess:
        left = truth(left < right);
        break;
      case Kind::kLessEqual:
        left = truth(left <= right);
        break;
      case Kind::kGreater:
        left = truth(left > right);
        break;
      case Kind::kGreaterEqual:
        left = truth(left >= right);
        break;
      case Kind::kAdd:
        left += right;
        break;
      case Kind::kSubtract:
        left -= right;
        break;
      default:
        left *= right;
        break;
    }
  }
  return stack[0] != 0;
}

}  // namespace oncard::runtime
