// Constant expressions: what C computes while compiling, with C's types. Doubles are computed as
// real numbers, and only the result is rounded to the card's fixed point.
#include <fmt/core.h>

#include <cmath>

#include "base/number.h"
#include "compiler/lowering/lowerer.h"
#include "vm/arithmetic.h"

namespace oncard::compiler::lowering {
namespace {

TypedConstant OfInteger(int64_t value, BasicType type) {
  TypedConstant constant;
  constant.type = type;
  constant.value.integer = ConvertInteger(value, type);
  return constant;
}

// Unsigned ints wrap in C, so nothing is left open but a division by zero and shifts that are too
// far.
std::optional<int64_t> FoldUnsigned(std::string_view op, uint32_t a, uint32_t b) {
  if (op == "/" || op == "%") {
    if (b == 0) return std::nullopt;
    return op == "/" ? a / b : a % b;
  }
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  if (op == ">") return a > b;
  if (op == ">=") return a >= b;
  if (op == "<<" || op == ">>") {
    if (b >= 32) return std::nullopt;
    return op == "<<" ? a << b : a >> b;
  }
  const vm::OperatorInfo* info = vm::FindBinaryOperator(op);
  return vm::EvaluateBinary(static_cast<vm::BinaryOperator>(info->number), vm::DataType::kInt,
                            static_cast<int32_t>(a), static_cast<int32_t>(b), 0);
}

}  // namespace

std::optional<TypedConstant> Lowerer::LiteralConstant(const Expression& expression) const {
  const Literal& literal = expression.literal;
  TypedConstant constant;
  if (literal.kind == Literal::Kind::kFixed) {
    constant.type = BasicType::kDouble;
    constant.value.is_double = true;
    constant.value.real = ReadLeadingNumber(expression.text);
    return constant;
  }
  const bool is_unsigned = literal.is_unsigned;
  if (is_unsigned) {
    if (literal.magnitude > UINT32_MAX) return std::nullopt;
    const int64_t value = static_cast<int64_t>(literal.magnitude);
    return OfInteger(literal.negative ? -value : value, BasicType::kUnsigned);
  }
  const std::optional<int32_t> value = IntValue(literal);
  if (!value) return std::nullopt;
  return OfInteger(*value, BasicType::kInt);
}

std::optional<TypedConstant> Lowerer::ConvertConstant(const TypedConstant& constant,
                                                      BasicType type) {
  if (constant.type == type) return constant;
  TypedConstant result;
  result.type = type;
  if (type == BasicType::kDouble) {
    result.value.is_double = true;
    result.value.real = constant.type == BasicType::kUnsigned
                            ? static_cast<double>(static_cast<uint32_t>(constant.value.integer))
                            : constant.value.AsDouble();
    return result;
  }
  if (!constant.value.is_double) return OfInteger(constant.value.integer, type);
  if (type == BasicType::kBool) return OfInteger(constant.value.real != 0 ? 1 : 0, type);
  const double whole = std::trunc(constant.value.real);
  const double maximum = type == BasicType::kUnsigned ? UINT32_MAX : INT32_MAX;
  if (!(whole >= INT32_MIN && whole <= maximum)) return std::nullopt;
  return OfInteger(static_cast<int64_t>(whole), type);
}

std::optional<TypedConstant> Lowerer::EvaluateBinary(const Expression& expression) {
  std::optional<TypedConstant> left = Evaluate(*expression.operands[0]);
  if (!left) return std::nullopt;
  std::optional<TypedConstant> right = Evaluate(*expression.operands[1]);
  if (!right) return std::nullopt;
  const vm::OperatorInfo* info = vm::FindBinaryOperator(expression.op);
  if (info == nullptr) return std::nullopt;
  const bool shift = info->precedence == vm::Precedence::kShift;
  const BasicType type = shift ? Promoted(left->type) : Common(left->type, right->type);
  const bool truth = vm::IsLogical(*info) || vm::IsComparison(*info);
  if (!vm::IsLogical(*info)) {
    left = ConvertConstant(*left, type);
    if (!shift) right = ConvertConstant(*right, type);
    if (!left || !right) return std::nullopt;
  }
  TypedConstant result;
  result.type = truth ? BasicType::kInt : type;
  if (type == BasicType::kUnsigned && !vm::IsLogical(*info)) {
    const std::optional<int64_t> value =
        FoldUnsigned(expression.op, static_cast<uint32_t>(left->value.integer),
                     static_cast<uint32_t>(right->value.integer));
    if (!value) return std::nullopt;
    return OfInteger(*value, result.type);
  }
  const std::optional<Constant> value = FoldBinary(expression.op, left->value, right->value);
  if (!value) return std::nullopt;
  result.value = *value;
  return result;
}

std::optional<TypedConstant> Lowerer::Evaluate(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::kLiteral:
      return LiteralConstant(expression);
    case Expression::Kind::kName: {
      const Symbol* symbol = Lookup(expression.text);
      const bool known = symbol != nullptr && symbol->kind == Symbol::Kind::kConstant;
      return known ? std::optional(symbol->constant) : std::nullopt;
    }
    case Expression::Kind::kParen:
      return Evaluate(*expression.operands[0]);
    case Expression::Kind::kUnary: {
      const Expression& literal = *expression.operands[0];
      if (expression.op == "-" && literal.kind == Expression::Kind::kLiteral &&
          !literal.literal.negative && !literal.literal.is_unsigned &&
          literal.literal.kind == Literal::Kind::kInteger) {
        // The smallest int has no positive counterpart.
        Literal negative = literal.literal;
        negative.negative = true;
        const std::optional<int32_t> value = IntValue(negative);
        return value ? std::optional(OfInteger(*value, BasicType::kInt)) : std::nullopt;
      }
      const std::optional<TypedConstant> operand = Evaluate(*expression.operands[0]);
      if (!operand) return std::nullopt;
      if (expression.op == "!") {
        const std::optional<Constant> value = FoldUnary("!", operand->value);
        return value ? std::optional(OfInteger(value->integer, BasicType::kInt)) : std::nullopt;
      }
      const BasicType type = Promoted(operand->type);
      if (type == BasicType::kUnsigned) {
        const int64_t value = operand->value.integer;
        if (expression.op == "+") return OfInteger(value, type);
        if (expression.op == "-") return OfInteger(-value, type);
        if (expression.op == "~") return OfInteger(~value, type);
        return std::nullopt;
      }
      const std::optional<Constant> value = FoldUnary(expression.op, operand->value);
      if (!value) return std::nullopt;
      return TypedConstant{type, *value};
    }
    case Expression::Kind::kBinary:
      return EvaluateBinary(expression);
    case Expression::Kind::kCast: {
      const std::optional<BasicType> type = CastType(expression);
      const std::optional<TypedConstant> operand = Evaluate(*expression.operands[0]);
      if (!type || !operand || !IsArithmetic(*type)) return std::nullopt;
      return ConvertConstant(*operand, *type);
    }
    case Expression::Kind::kSizeof: {
      const std::optional<int64_t> size = SizeOfOperand(expression);
      return size ? std::optional(OfInteger(*size, BasicType::kUnsigned)) : std::nullopt;
    }
    case Expression::Kind::kConditional: {
      const std::optional<TypedConstant> condition = Evaluate(*expression.operands[0]);
      if (!condition) return std::nullopt;
      const std::optional<TypedConstant> yes = Evaluate(*expression.operands[1]);
      const std::optional<TypedConstant> no = Evaluate(*expression.operands[2]);
      if (!yes || !no) return std::nullopt;
      return ConvertConstant(condition->value.AsDouble() != 0 ? *yes : *no,
                             Common(yes->type, no->type));
    }
    default:
      return std::nullopt;
  }
}

std::optional<int64_t> Lowerer::EvaluateInteger(const Expression& expression) {
  const std::optional<TypedConstant> value = Evaluate(expression);
  if (!value || !IsInteger(value->type)) return std::nullopt;
  return value->value.integer;
}

// A constant that an expression is, or is converted to.
Value Lowerer::ConstantValue(const TypedConstant& constant, const Expression& expression) {
  const SourceRange range = expression.range;
  Value result;
  result.type = result.range = constant.type;
  if (constant.type != BasicType::kDouble) {
    result.operand = IntOperand(constant.value.integer);
    const bool truth = constant.value.integer == 0 || constant.value.integer == 1;
    if (truth) result.range = BasicType::kBool;
    KeepSpelling(expression, result.operand);
    return result;
  }
  const std::optional<int64_t> raw = FixedValue(constant.value.AsLiteral(), options_.double_format);
  if (!raw) {
    const vm::DoubleFormat format = options_.double_format;
    Report(Code::kLiteralTooLarge, range, Source(range), vm::TypeName(vm::DataType::kDouble),
           fmt::format("{}", vm::DoubleFromFixed(vm::FixedMin(format))),
           fmt::format("{}", vm::DoubleFromFixed(vm::FixedMax(format))));
  }
  result.operand = ConstantOperand(vm::DataType::kDouble, raw.value_or(0));
  KeepSpelling(expression, result.operand);
  return result;
}

}  // namespace oncard::compiler::lowering
