// A property of a state: an expression over the program's variables, or over everything that can be
// observed of a card, for example
//
//   x == 6 && ret0 + ret1 >= 1
//
// Names: globals `v`, `a[3]`, `s.member`; locals `pageN.v`; `retN` or `threadN.result`, what thread
// N returned; with a card, also those of runtime/observe/quantity.h; numbers. Operators as in C:
// `||` `&&` `==` `!=` `<` `<=` `>` `>=` `+` `-` `*` `!`, and parentheses. Every value is a number,
// including doubles of motion programs, and true is 1. Tested by tests/explore/property_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/models/model.h"
#include "runtime/observe/quantity.h"

namespace oncard::explore {

class Property {
 public:
  /// Fails with the error and its place if the text is not an expression, is longer or deeper than
  /// the limits below, or a name is unknown. A global hides anything else of the same name.
  static Result<Property> Parse(std::string_view text, const Model& model);
  /// The same for the values of a card with its program.
  static Result<Property> Parse(std::string_view text, const runtime::Controller& controller);

  /// Maximum number of names, numbers and operators of one property.
  static constexpr size_t kElementMax = 128;
  /// Maximum nesting of parentheses and prefix operators.
  static constexpr int kNestingMax = 100;

  const std::string& text() const { return text_; }
  /// True if it names a local variable.
  bool SeesLocals() const;
  /// Evaluates it in the current state of the model or card that it was parsed for.
  bool Holds(const Model& model) const;
  bool Holds(const runtime::Controller& controller) const;
  /// The names and their values, as in `x is 3, a[1] is 0`, each name once; empty for an expression
  /// of numbers.
  Message DescribeValues(const runtime::Controller& controller) const;

 private:
  template <typename Names>
  friend class PropertyParser;
  friend class ModelNames;
  friend class CardNames;
  enum class Kind : uint8_t {
    kNumber,
    kSlot,
    kReturn,
    kQuantity,
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
  /// One element of the expression in postfix order.
  struct Element {
    Kind kind = Kind::kNumber;
    double number = 0;
    vm::SlotAddress slot = {};
    int thread = 0;                          ///< kReturn
    size_t quantity = 0;                     ///< kQuantity: index
    vm::DataType type = vm::DataType::kInt;  ///< of a slot or returned value
  };

  /// Evaluates the expression with `value(element)` for each name.
  template <typename Value>
  bool Evaluate(Value value) const;

  std::string text_;
  std::vector<Element> elements_;
  std::vector<runtime::Quantity> quantities_;  ///< of a card
};

}  // namespace oncard::explore
