// Operators as the lexer, the checker and the rewriter ask about them. Which ones there are and how
// tightly they bind is in vm/opcodes.def, what they compute in vm/handlers.def; only what C has
// beyond motion programs is listed here.
// Tested by tests/compiler/operators_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "vm/opcodes.h"

namespace oncard::compiler {

/// The token of an operator.
struct OperatorToken {
  std::string spelling;
  int kind = 0;  ///< Parser::token; the binary operators of one precedence have the same
};

/// The longest operator that the text begins with, or nullptr.
const OperatorToken* LeadingOperator(std::string_view text);

/// The comparison that is true exactly when this one is not, or nullptr.
const vm::OperatorInfo* OppositeOf(const vm::OperatorInfo& comparison);

/// True when `+`, `+=` and the like compute the same bits, or the same truth, from unsigned
/// operands.
bool IgnoresSign(std::string_view spelling);

}  // namespace oncard::compiler
