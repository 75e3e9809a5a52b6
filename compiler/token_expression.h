// An expression parsed from tokens that stand in no program: the condition of an #if, or the body
// of a #define. Tested by tests/compiler/preprocessor_test.cc and rewriter_test.cc.
#pragma once

#include <span>
#include <vector>

#include "compiler/dialect.h"
#include "compiler/syntax.h"

namespace oncard::compiler {

class TokenExpression {
 public:
  /// The texts of the tokens must outlive this object.
  TokenExpression(std::span<const Token> tokens, Dialect dialect);

  /// The expression, or nullptr if the tokens are not exactly one.
  const Expression* get() const { return expression_; }

 private:
  std::vector<Token> tokens_;
  Tree tree_;
  const Expression* expression_ = nullptr;
};

}  // namespace oncard::compiler
