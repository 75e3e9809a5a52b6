// Evaluates the condition of #if, with the integers of 64 bits that C has there.
// Tested by tests/compiler/preprocessor_test.cc.
#pragma once

#include <optional>
#include <span>

#include "compiler/syntax.h"

namespace oncard::compiler {

/// Whether a condition is true: an expression of integers, in which macros and `defined` have been
/// replaced; any name that is left is 0, except `true`. Empty if it is none, or divides by zero.
std::optional<bool> EvaluateCondition(std::span<const Token> condition);

}  // namespace oncard::compiler
