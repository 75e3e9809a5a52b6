#include "compiler/macro_body.h"

#include <algorithm>

#include "compiler/parser.hh"
#include "compiler/token_expression.h"

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
  const TokenExpression expression(body, Dialect::kCard);
  if (expression.get() == nullptr) return std::nullopt;
  const std::optional<Constant> value = Fold(*expression.get(), lookup);
  if (!value) return std::nullopt;
  return MacroNumber{*value, IsClosed(*expression.get())};
}

bool StandsAlone(const Token& before, const Token& after) {
  return IsOneOf(before.kind, {Kind::kOpenParen, Kind::kOpenBracket, Kind::kOpenBrace, Kind::kComma,
                               Kind::kAssign, Kind::kCompoundAssign, Kind::kReturn, Kind::kCase}) &&
         IsOneOf(after.kind, {Kind::kCloseParen, Kind::kCloseBracket, Kind::kCloseBrace,
                              Kind::kComma, Kind::kSemicolon, Kind::kColon});
}

}  // namespace oncard::compiler
