// Evaluates constant expressions as C does at compile time, so that a fix-it can replace them by
// their value. Tested by tests/compiler/rewriter_test.cc.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/syntax.h"

namespace oncard::compiler {

/// The literal to which a macro's name refers; empty for any other name.
using MacroLookup = std::function<std::optional<Literal>(std::string_view name)>;

/// A number of C: an int of 32 bits, or a double.
struct Constant {
  bool is_double = false;
  int64_t integer = 0;
  double real = 0;

  double AsDouble() const { return is_double ? real : static_cast<double>(integer); }
  /// As a literal of the language.
  std::string Text() const;
  /// The value of that literal for the compiler.
  Literal AsLiteral() const;
};

/// `true` and `false`, which C's headers define, and `TRUE` and `FALSE`, which Windows' do.
std::optional<Literal> TruthValue(std::string_view name);

/// The value of an expression of literals and macros. Empty if it contains anything else, divides
/// by zero, or overflows an int, which C leaves undefined.
std::optional<Constant> Fold(const Expression& expression, const MacroLookup& lookup);

/// The values of a binary operator and of a unary one, under the same conditions.
std::optional<Constant> FoldBinary(std::string_view spelling, const Constant& left,
                                   const Constant& right);
std::optional<Constant> FoldUnary(std::string_view spelling, const Constant& value);

}  // namespace oncard::compiler
