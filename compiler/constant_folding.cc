#include "compiler/constant_folding.h"

#include <fmt/core.h>

#include <cmath>
#include <type_traits>

#include "vm/arithmetic.h"

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

// The int or double that a value is, unless it is out of range.
template <typename Value>
std::optional<Constant> Number(Value value) {
  if constexpr (std::is_floating_point_v<Value>) {
    return std::isfinite(value) ? std::optional(Double(value)) : std::nullopt;
  } else {
    return Int(value);
  }
}

// The arithmetic of C's compile time for the rows of handlers.def: ints so wide that nothing wraps,
// and real numbers instead of fixed-point ones.
namespace exact {

constexpr int64_t ToUnsigned(int64_t value) { return value; }
constexpr int64_t ToInt(int64_t value) { return value; }
constexpr int64_t DivideInt(int64_t a, int64_t b) { return a / b; }
constexpr int64_t RemainderInt(int64_t a, int64_t b) { return a % b; }
constexpr double AddFixed(double a, double b, int /*wrap_shift*/) { return a + b; }
constexpr double SubtractFixed(double a, double b, int /*wrap_shift*/) { return a - b; }
constexpr double MultiplyFixed(double a, double b, int /*wrap_shift*/) { return a * b; }
constexpr double DivideFixed(double a, double b, int /*wrap_shift*/) { return a / b; }
constexpr double FixedFromInt(int64_t value, int /*wrap_shift*/) {
  return static_cast<double>(value);
}

constexpr int wrap_shift = 0;

std::optional<Constant> BinaryOfInts(vm::BinaryOperator op, int64_t a, int64_t b) {
  switch (op) {
#define INT_BINARY(name, bad, value) \
  case vm::BinaryOperator::k##name:  \
    if (bad) return std::nullopt;    \
    return Number(value);
#define COMPARE(name, value) INT_BINARY(name, false, value)
#include "vm/handlers.def"
  }
  return std::nullopt;
}

std::optional<Constant> BinaryOfDoubles(vm::BinaryOperator op, double a, double b) {
  switch (op) {
#define DOUBLE_BINARY(name, bad, value) \
  case vm::BinaryOperator::k##name:     \
    if (bad) return std::nullopt;       \
    return Number(value);
#define COMPARE(name, value) DOUBLE_BINARY(name, false, value)
#include "vm/handlers.def"
    default:
      return std::nullopt;
  }
}

std::optional<Constant> UnaryOfInt(vm::UnaryOperator op, int64_t a) {
  switch (op) {
#define UNARY_Int(name, value)     \
  case vm::UnaryOperator::k##name: \
    return Number(value);
#define UNARY_Double(name, value)
#define UNARY(name, type, value) UNARY_##type(name, value)
#include "vm/handlers.def"
#undef UNARY_Int
#undef UNARY_Double
    default:
      return std::nullopt;
  }
}

}  // namespace exact

// C leaves open what the shifts of negative numbers and those out of the number yield.
bool IsOpenShift(const vm::OperatorInfo& info, int64_t a, int64_t b) {
  return info.precedence == vm::Precedence::kShift && (a < 0 || b < 0 || b >= 31);
}

// What C leaves open because it overflows, the machine wraps.
std::optional<Constant> FoldInts(const vm::OperatorInfo& info, int64_t a, int64_t b) {
  const auto op = static_cast<vm::BinaryOperator>(info.number);
  if (IsOpenShift(info, a, b)) return std::nullopt;
  const std::optional<Constant> value = exact::BinaryOfInts(op, a, b);
  const std::optional<int64_t> wrapped = vm::EvaluateBinary(op, vm::DataType::kInt, a, b, 0);
  return value && wrapped == value->integer ? value : std::nullopt;
}

std::optional<Constant> FoldCast(std::string_view type, const Constant& value) {
  if (type == "double") return Double(value.AsDouble());
  if (type != "int" && type != "long") return std::nullopt;
  if (!value.is_double) return value;
  if (value.real <= -2147483649.0 || value.real >= 2147483648.0) return std::nullopt;
  return Int(static_cast<int64_t>(value.real));
}

}  // namespace

std::optional<Constant> FoldBinary(std::string_view spelling, const Constant& left,
                                   const Constant& right) {
  const vm::OperatorInfo& info = *vm::FindBinaryOperator(spelling);
  if (vm::IsLogical(info)) return FoldInts(info, left.AsDouble() != 0, right.AsDouble() != 0);
  if (!left.is_double && !right.is_double) return FoldInts(info, left.integer, right.integer);
  // A double represents every int exactly.
  return exact::BinaryOfDoubles(static_cast<vm::BinaryOperator>(info.number), left.AsDouble(),
                                right.AsDouble());
}

std::optional<Constant> FoldUnary(std::string_view spelling, const Constant& value) {
  if (spelling == "+") return value;
  if (spelling == "-") return value.is_double ? Double(-value.real) : Int(-value.integer);
  if (spelling == "!") return Int(value.AsDouble() == 0);
  const vm::OperatorInfo* info = vm::FindUnaryOperator(spelling);
  if (info == nullptr || value.is_double) return std::nullopt;
  return exact::UnaryOfInt(static_cast<vm::UnaryOperator>(info->number), value.integer);
}

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
      return FoldBinary(expression.op, *left, *right);
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
