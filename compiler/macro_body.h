// Evaluates the body of a #define that is more than one number, so that a fix-it can replace it by
// its value. Tested by tests/compiler/rewriter_test.cc.
#pragma once

#include <optional>
#include <span>

#include "compiler/constant_folding.h"

namespace oncard::compiler {

struct MacroNumber {
  Constant value;
  /// The body is a single operand in every context, as `(3 * 4)` and `-3` are, and `3 + 4` is not.
  bool closed = false;
};

/// The value of a macro's body, which C substitutes for the name. Empty if it is not an expression
/// of numbers and of names that `lookup` knows.
std::optional<MacroNumber> FoldMacroBody(std::span<const Token> body, const MacroLookup& lookup);

/// Whether a name between two tokens is a whole expression, so that its value and its body are
/// equivalent there.
bool StandsAlone(const Token& before, const Token& after);

}  // namespace oncard::compiler
