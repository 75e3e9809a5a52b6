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
  if (literal.kind != Literal::Kind::kInteger) return std::nullopt;
  const std::optional<IntegerOfC> integer = ReadIntegerOfC(expression.text);
  if (!integer) {  // a character, or the value of `defined`
    if (literal.invalid) return std::nullopt;
    return Value{literal.negative ? 0 - literal.magnitude : literal.magnitude, false};
  }
  if (!integer->bits) return std::nullopt;
  const bool fits = *integer->bits <= static_cast<uint64_t>(INT64_MAX);
  // As in C, only digits that stand for bits become unsigned by themselves.
  if (!fits && integer->decimal && !integer->is_unsigned) return std::nullopt;
  return Value{*integer->bits, integer->is_unsigned || !fits};
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

std::optional<Value> Evaluate(const Expression& expression, bool live);

std::optional<Value> EvaluateBinary(const Expression& expression, bool live) {
  const std::optional<Value> left = Evaluate(*expression.operands[0], live);
  if (!left) return std::nullopt;
  const bool is_and = expression.op == "&&";
  const bool logical = is_and || expression.op == "||";
  const bool known = logical && (left->bits != 0) != is_and;
  const std::optional<Value> right = Evaluate(*expression.operands[1], live && !known);
  if (!right) return std::nullopt;
  if (known) return OfInt(is_and ? 0 : 1);
  if (logical) return OfInt(right->bits != 0 ? 1 : 0);
  const std::optional<Value> value = Apply(expression.op, *left, *right);
  // What is not evaluated has a type all the same; it may divide by zero.
  if (!value && !live) return Value{0, left->is_unsigned || right->is_unsigned};
  return value;
}

std::optional<Value> EvaluateUnary(const Expression& expression, bool live) {
  const std::optional<Value> value = Evaluate(*expression.operands[0], live);
  if (!value) return std::nullopt;
  if (expression.op == "-") return Value{0 - value->bits, value->is_unsigned};
  if (expression.op == "+") return value;
  if (expression.op == "~") return Value{~value->bits, value->is_unsigned};
  if (expression.op == "!") return OfInt(value->bits == 0 ? 1 : 0);
  return std::nullopt;
}

// Both branches have one type: unsigned, if one of them is.
std::optional<Value> EvaluateConditional(const Expression& expression, bool live) {
  const std::optional<Value> condition = Evaluate(*expression.operands[0], live);
  if (!condition) return std::nullopt;
  const bool holds = condition->bits != 0;
  const std::optional<Value> yes = Evaluate(*expression.operands[1], live && holds);
  const std::optional<Value> no = Evaluate(*expression.operands[2], live && !holds);
  if (!yes || !no) return std::nullopt;
  return Value{holds ? yes->bits : no->bits, yes->is_unsigned || no->is_unsigned};
}

// The value of an expression; if it is not `live`, C does not evaluate it, and only its type
// counts.
std::optional<Value> Evaluate(const Expression& expression, bool live) {
  switch (expression.kind) {
    case EKind::kLiteral:
      return OfLiteral(expression);
    case EKind::kName:
      return OfInt(expression.text == "true" ? 1 : 0);
    case EKind::kParen:
      return Evaluate(*expression.operands[0], live);
    case EKind::kUnary:
      return EvaluateUnary(expression, live);
    case EKind::kBinary:
      return EvaluateBinary(expression, live);
    case EKind::kConditional:
      return EvaluateConditional(expression, live);
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<bool> EvaluateCondition(std::span<const Token> condition) {
  const TokenExpression expression(condition, Dialect::kStructured);
  if (expression.get() == nullptr) return std::nullopt;
  const std::optional<Value> value = Evaluate(*expression.get(), true);
  if (!value) return std::nullopt;
  return value->bits != 0;
}

}  // namespace oncard::compiler
