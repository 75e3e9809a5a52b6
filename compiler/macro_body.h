// Computes the body of a #define that is more than one number, so that a fix-it can put the number
// there. Tested by tests/compiler/rewriter_test.cc.
#pragma once

#include <optional>
#include <span>

#include "compiler/constant_folding.h"

namespace oncard::compiler {

struct MacroNumber {
  Constant value;
  /// The body stays one operand wherever it is put, as `(3 * 4)` and `-3` do, and `3 + 4` does not.
  bool closed = false;
};

/// The value of a macro's body, which C puts in place of the name. Nothing when it is no expression
/// of numbers and of names that `lookup` knows.
std::optional<MacroNumber> FoldMacroBody(std::span<const Token> body, const MacroLookup& lookup);

/// Whether a name is a whole expression where it stands between two tokens, so that the number for
/// it and its body for it give the same.
bool StandsAlone(const Token& before, const Token& after);

}  // namespace oncard::compiler
