// What must hold of a state: an expression over the program's variables, as in
//
//   x == 6 && ret0 + ret1 >= 1
//
// Names: globals `v`, `a[3]`, `s.member`; locals `pageN.v`; `retN` or `threadN.result`, what thread
// N returned; numbers. Operators as in C: || && == != < <= > >= + - * ! and parentheses; every
// value is a number, doubles of motion programs included, and true is 1. Tested by
// tests/explore/property_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/model.h"

namespace oncard::explore {

class Property {
 public:
  /// Fails with what is wrong and where when the text is no expression or a name is unknown.
  static Result<Property> Parse(std::string_view text, const Model& model);

  /// Names, numbers and operators of one property.
  static constexpr size_t kElementMax = 128;

  const std::string& text() const { return text_; }
  /// Evaluates it in the model's present state.
  bool Holds(const Model& model) const;

 private:
  friend class PropertyParser;
  enum class Kind : uint8_t {
    kNumber,
    kSlot,
    kReturn,
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
    int thread = 0;
    vm::DataType type = vm::DataType::kInt;  ///< of a slot or returned value
  };

  std::string text_;
  std::vector<Element> elements_;
};

}  // namespace oncard::explore
