#include "compiler/token_expression.h"

#include "compiler/parser_driver.h"

namespace oncard::compiler {

TokenExpression::TokenExpression(std::span<const Token> tokens, Dialect dialect)
    : tokens_(tokens.begin(), tokens.end()) {
  // The parser reads programs: the expression becomes a statement of one.
  for (const int kind : {Parser::token::kSemicolon, Parser::token::kEnd}) {
    tokens_.emplace_back().kind = kind;
  }
  Reporter reporter;
  ParserDriver driver(tokens_, reporter, dialect);
  Parser parser(driver);
  const bool good = parser.parse() == 0 && !reporter.HasErrors();
  tree_ = std::move(driver.tree);
  if (!good || tree_.items.size() != 1) return;
  const Statement& statement = *tree_.items[0];
  if (statement.kind == Statement::Kind::kExpression) expression_ = statement.value.get();
}

}  // namespace oncard::compiler
