#include "compiler/macro_body.h"

#include <algorithm>

#include "compiler/parser_driver.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;

bool IsClosed(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::kBinary:
    case Expression::Kind::kConditional:
      return false;
    default:
      return true;
  }
}

bool IsOneOf(int kind, std::initializer_list<int> kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace

std::optional<MacroNumber> FoldMacroBody(std::span<const Token> body, const MacroLookup& lookup) {
  std::vector<Token> tokens(body.begin(), body.end());
  Token mark;
  mark.kind = Kind::kSemicolon;
  tokens.push_back(mark);
  mark.kind = Kind::kEnd;
  tokens.push_back(mark);
  Reporter reporter;
  ParserDriver driver(tokens, reporter);
  Parser parser(driver);
  if (parser.parse() != 0 || reporter.HasErrors() || driver.tree.items.size() != 1) {
    return std::nullopt;
  }
  const Statement& statement = *driver.tree.items[0];
  if (statement.kind != Statement::Kind::kExpression) return std::nullopt;
  const std::optional<Constant> value = Fold(*statement.value, lookup);
  if (!value) return std::nullopt;
  return MacroNumber{*value, IsClosed(*statement.value)};
}

bool StandsAlone(const Token& before, const Token& after) {
  return IsOneOf(before.kind, {Kind::kOpenParen, Kind::kOpenBracket, Kind::kOpenBrace, Kind::kComma,
                               Kind::kAssign, Kind::kCompoundAssign, Kind::kReturn, Kind::kCase}) &&
         IsOneOf(after.kind, {Kind::kCloseParen, Kind::kCloseBracket, Kind::kCloseBrace,
                              Kind::kComma, Kind::kSemicolon, Kind::kColon});
}

}  // namespace oncard::compiler
