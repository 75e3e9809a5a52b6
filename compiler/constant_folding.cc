#include "compiler/constant_folding.h"

#include <fmt/format.h>

#include <cmath>

#include "base/number.h"

namespace oncard::compiler {
namespace {

std::optional<Constant> Int(int64_t value) {
  if (value < INT32_MIN || value > INT32_MAX) return std::nullopt;
  Constant result;
  result.integer = value;
  return result;
}

Constant Double(double value) {
  Constant result;
  result.is_double = true;
  result.real = value;
  return result;
}

std::optional<Constant> OfLiteral(const Literal& literal) {
  if (literal.invalid) return std::nullopt;
  if (literal.kind == Literal::Kind::kInteger) {
    const std::optional<int32_t> value = IntValue(literal);
    return value ? Int(*value) : std::nullopt;
  }
  const double magnitude =
      static_cast<double>(literal.magnitude) / static_cast<double>(1 << vm::kFractionBits);
  return Double(literal.negative ? -magnitude : magnitude);
}

std::optional<Constant> FoldInts(int64_t a, std::string_view op, int64_t b) {
  if (op == "+") return Int(a + b);
  if (op == "-") return Int(a - b);
  if (op == "*") return Int(a * b);
  if (op == "/") return b == 0 ? std::nullopt : Int(a / b);
  if (op == "%") return b == 0 ? std::nullopt : Int(a % b);
  if (op == "&") return Int(a & b);
  if (op == "|") return Int(a | b);
  if (op == "^") return Int(a ^ b);
  const bool shifts = a >= 0 && b >= 0 && b < 31;
  if (op == "<<") return shifts ? Int(a * (int64_t{1} << b)) : std::nullopt;
  if (op == ">>") return shifts ? Int(a >> b) : std::nullopt;
  return std::nullopt;
}

std::optional<Constant> Finite(double value) {
  return std::isfinite(value) ? std::optional(Double(value)) : std::nullopt;
}

std::optional<Constant> FoldDoubles(double a, std::string_view op, double b) {
  if (op == "+") return Finite(a + b);
  if (op == "-") return Finite(a - b);
  if (op == "*") return Finite(a * b);
  if (op == "/" && b != 0) return Finite(a / b);
  return std::nullopt;
}

std::optional<Constant> Compare(double a, std::string_view op, double b) {
  if (op == "<") return Int(a < b);
  if (op == ">") return Int(a > b);
  if (op == "<=") return Int(a <= b);
  if (op == ">=") return Int(a >= b);
  if (op == "==") return Int(a == b);
  if (op == "!=") return Int(a != b);
  if (op == "&&") return Int(a != 0 && b != 0);
  if (op == "||") return Int(a != 0 || b != 0);
  return std::nullopt;
}

std::optional<Constant> FoldUnary(std::string_view op, const Constant& value) {
  if (op == "!") return Int(value.AsDouble() == 0);
  if (op == "+") return value;
  if (op == "-") return value.is_double ? Double(-value.real) : Int(-value.integer);
  if (op == "~" && !value.is_double) return Int(~value.integer);
  return std::nullopt;
}

std::optional<Constant> FoldCast(std::string_view type, const Constant& value) {
  if (type == "double") return Double(value.AsDouble());
  if (type != "int" && type != "long") return std::nullopt;
  if (!value.is_double) return value;
  if (value.real <= -2147483649.0 || value.real >= 2147483648.0) return std::nullopt;
  return Int(static_cast<int64_t>(value.real));
}

}  // namespace

std::string Constant::Text() const {
  if (!is_double) return std::to_string(integer);
  std::string text = fmt::format("{}", real);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

Literal Constant::AsLiteral() const {
  Literal literal;
  if (is_double) {
    literal = ParseFixed(fmt::format("{}", std::abs(real)));
    literal.negative = real < 0;
  } else {
    literal.magnitude = static_cast<uint64_t>(std::abs(integer));
    literal.negative = integer < 0;
  }
  return literal;
}

std::optional<Literal> TruthValue(std::string_view name) {
  const bool yes = name == "true" || name == "TRUE";
  if (!yes && name != "false" && name != "FALSE") return std::nullopt;
  Literal literal;
  literal.magnitude = yes ? 1 : 0;
  return literal;
}

std::optional<Constant> Fold(const Expression& expression, const MacroLookup& lookup) {
  switch (expression.kind) {
    case Expression::Kind::kLiteral: {
      if (expression.literal.kind == Literal::Kind::kInteger) return OfLiteral(expression.literal);
      // The number is not rounded to a multiple of 2^-16 here; only the result is.
      return Double(ReadLeadingNumber(expression.text));
    }
    case Expression::Kind::kString: {
      const std::optional<int> character = CharacterValue(expression.text);
      return character ? Int(*character) : std::nullopt;
    }
    case Expression::Kind::kName: {
      const std::optional<Literal> literal = lookup(expression.text);
      return literal ? OfLiteral(*literal) : std::nullopt;
    }
    case Expression::Kind::kParen:
      return Fold(*expression.operands[0], lookup);
    case Expression::Kind::kUnary:
    case Expression::Kind::kCast: {
      const std::optional<Constant> value = Fold(*expression.operands[0], lookup);
      if (!value) return std::nullopt;
      return expression.kind == Expression::Kind::kCast ? FoldCast(expression.text, *value)
                                                        : FoldUnary(expression.op, *value);
    }
    case Expression::Kind::kBinary: {
      const std::optional<Constant> left = Fold(*expression.operands[0], lookup);
      const std::optional<Constant> right = Fold(*expression.operands[1], lookup);
      if (!left || !right) return std::nullopt;
      // A double represents every int exactly.
      if (auto truth = Compare(left->AsDouble(), expression.op, right->AsDouble())) return truth;
      if (left->is_double || right->is_double) {
        return FoldDoubles(left->AsDouble(), expression.op, right->AsDouble());
      }
      return FoldInts(left->integer, expression.op, right->integer);
    }
    case Expression::Kind::kConditional: {
      const std::optional<Constant> condition = Fold(*expression.operands[0], lookup);
      if (!condition) return std::nullopt;
      return Fold(*expression.operands[condition->AsDouble() != 0 ? 1 : 2], lookup);
    }
    default:
      return std::nullopt;
  }
}

}  // namespace oncard::compiler
