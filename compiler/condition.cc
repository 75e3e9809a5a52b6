#include "compiler/condition.h"

#include <cstdint>
#include <string_view>

#include "compiler/token_expression.h"

namespace oncard::compiler {
namespace {

using EKind = Expression::Kind;

// A value of C's preprocessor: the bits of an integer with or without a sign.
struct Value {
  uint64_t bits = 0;
  bool is_unsigned = false;

  int64_t AsSigned() const { return static_cast<int64_t>(bits); }
};

Value OfInt(int64_t value) { return {static_cast<uint64_t>(value), false}; }

std::optional<Value> OfLiteral(const Expression& expression) {
  const Literal& literal = expression.literal;
  if (literal.kind != Literal::Kind::kInteger || literal.invalid) return std::nullopt;
  if (literal.magnitude >= kHuge) return std::nullopt;
  const bool character = expression.text.starts_with('\'');
  const bool suffix = !character && expression.text.find_first_of("uU") != std::string_view::npos;
  return Value{literal.negative ? 0 - literal.magnitude : literal.magnitude, suffix};
}

std::optional<Value> Divide(std::string_view op, Value a, Value b, bool is_unsigned) {
  if (b.bits == 0) return std::nullopt;
  if (is_unsigned) return Value{op == "/" ? a.bits / b.bits : a.bits % b.bits, true};
  // The smallest number divided by -1 does not fit.
  if (b.AsSigned() == -1) return Value{op == "/" ? 0 - a.bits : 0, false};
  return OfInt(op == "/" ? a.AsSigned() / b.AsSigned() : a.AsSigned() % b.AsSigned());
}

std::optional<Value> Shift(std::string_view op, Value a, Value b) {
  if (b.bits > 63) return std::nullopt;
  if (op == "<<") return Value{a.bits << b.bits, a.is_unsigned};
  if (a.is_unsigned) return Value{a.bits >> b.bits, true};
  return OfInt(a.AsSigned() >> b.bits);
}

std::optional<Value> Apply(std::string_view op, Value a, Value b) {
  if (op == "<<" || op == ">>") return Shift(op, a, b);
  const bool is_unsigned = a.is_unsigned || b.is_unsigned;
  if (op == "/" || op == "%") return Divide(op, a, b, is_unsigned);
  const bool less = is_unsigned ? a.bits < b.bits : a.AsSigned() < b.AsSigned();
  const bool equal = a.bits == b.bits;
  if (op == "==") return OfInt(equal ? 1 : 0);
  if (op == "!=") return OfInt(equal ? 0 : 1);
  if (op == "<") return OfInt(less ? 1 : 0);
  if (op == "<=") return OfInt(less || equal ? 1 : 0);
  if (op == ">") return OfInt(less || equal ? 0 : 1);
  if (op == ">=") return OfInt(less ? 0 : 1);
  if (op == "+") return Value{a.bits + b.bits, is_unsigned};
  if (op == "-") return Value{a.bits - b.bits, is_unsigned};
  if (op == "*") return Value{a.bits * b.bits, is_unsigned};
  if (op == "&") return Value{a.bits & b.bits, is_unsigned};
  if (op == "|") return Value{a.bits | b.bits, is_unsigned};
  if (op == "^") return Value{a.bits ^ b.bits, is_unsigned};
  return std::nullopt;
}

std::optional<Value> Evaluate(const Expression& expression);

std::optional<Value> EvaluateBinary(const Expression& expression) {
  const std::optional<Value> left = Evaluate(*expression.operands[0]);
  if (!left) return std::nullopt;
  const bool is_and = expression.op == "&&";
  if (is_and || expression.op == "||") {
    if ((left->bits != 0) != is_and) return OfInt(is_and ? 0 : 1);
    const std::optional<Value> right = Evaluate(*expression.operands[1]);
    if (!right) return std::nullopt;
    return OfInt(right->bits != 0 ? 1 : 0);
  }
  const std::optional<Value> right = Evaluate(*expression.operands[1]);
  return right ? Apply(expression.op, *left, *right) : std::nullopt;
}

std::optional<Value> EvaluateUnary(const Expression& expression) {
  const std::optional<Value> value = Evaluate(*expression.operands[0]);
  if (!value) return std::nullopt;
  if (expression.op == "-") return Value{0 - value->bits, value->is_unsigned};
  if (expression.op == "+") return value;
  if (expression.op == "~") return Value{~value->bits, value->is_unsigned};
  if (expression.op == "!") return OfInt(value->bits == 0 ? 1 : 0);
  return std::nullopt;
}

std::optional<Value> Evaluate(const Expression& expression) {
  switch (expression.kind) {
    case EKind::kLiteral:
      return OfLiteral(expression);
    case EKind::kName:
      return OfInt(expression.text == "true" ? 1 : 0);
    case EKind::kParen:
      return Evaluate(*expression.operands[0]);
    case EKind::kUnary:
      return EvaluateUnary(expression);
    case EKind::kBinary:
      return EvaluateBinary(expression);
    case EKind::kConditional: {
      const std::optional<Value> condition = Evaluate(*expression.operands[0]);
      if (!condition) return std::nullopt;
      return Evaluate(*expression.operands[condition->bits != 0 ? 1 : 2]);
    }
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<bool> EvaluateCondition(std::span<const Token> condition) {
  const TokenExpression expression(condition, Dialect::kStructured);
  if (expression.get() == nullptr) return std::nullopt;
  const std::optional<Value> value = Evaluate(*expression.get());
  if (!value) return std::nullopt;
  return value->bits != 0;
}

}  // namespace oncard::compiler
