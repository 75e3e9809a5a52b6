// Names and properties of the instructions and operators listed in opcodes.def.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace oncard::vm {

/// Data types as object files number them; kVoid is only a function's return type.
enum class DataType : uint16_t { kVoid = 0, kInt = 1, kDouble = 2 };

/// As motion programs spell it; `?` for a number that no type has.
constexpr std::string_view TypeName(DataType type) {
  switch (type) {
    case DataType::kVoid:
      return "void";
    case DataType::kInt:
      return "int";
    case DataType::kDouble:
      return "double";
  }
  return "?";
}

enum class Opcode : uint16_t {
#define INSTRUCTION(name, number, basis, operands, effect) name = number,
#include "vm/opcodes.def"
};

enum class UnaryOperator : uint16_t {
#define UNARY_OPERATOR(name, number, basis, spelling, types, result, effect) name = number,
#include "vm/opcodes.def"
};

enum class BinaryOperator : uint16_t {
#define BINARY_OPERATOR(name, number, basis, spelling, precedence, types, result, effect) \
  name = number,
#include "vm/opcodes.def"
};

/// Which operands an operator takes.
enum class OperandTypes : uint8_t { kInt, kDouble, kBoth };
/// The type of its result.
enum class ResultType : uint8_t { kInt, kDouble, kSame };

/// How tightly an operator binds, as in C, from the loosest.
enum class Precedence : uint8_t {
  kLogicalOr,
  kLogicalAnd,
  kBitOr,
  kBitXor,
  kBitAnd,
  kEquality,
  kRelation,
  kShift,
  kSum,
  kProduct,
  kUnary,
};

/// One row of opcodes.def.
struct OperatorInfo {
  uint16_t number;
  std::string_view spelling;
  Precedence precedence;
  OperandTypes types;
  ResultType result;
  std::string_view effect;
  bool observed;
};

/// All rows, in the order of their numbers.
std::span<const OperatorInfo> UnaryOperators();
std::span<const OperatorInfo> BinaryOperators();

/// The row of an operator, or nullptr when no operator has this number.
const OperatorInfo* FindUnaryOperator(uint16_t number);
const OperatorInfo* FindBinaryOperator(uint16_t number);
/// The row of an operator, or nullptr when no operator is spelled so.
const OperatorInfo* FindUnaryOperator(std::string_view spelling);
const OperatorInfo* FindBinaryOperator(std::string_view spelling);

/// `&&` and `||`: their operands count as 0 or not 0.
constexpr bool IsLogical(const OperatorInfo& info) {
  return info.precedence == Precedence::kLogicalOr || info.precedence == Precedence::kLogicalAnd;
}
/// A comparison, such as `==` and `<`.
constexpr bool IsComparison(const OperatorInfo& info) {
  return info.precedence == Precedence::kEquality || info.precedence == Precedence::kRelation;
}

/// True when the operator takes operands of this type.
constexpr bool Accepts(const OperatorInfo& info, DataType type) {
  return info.types == OperandTypes::kBoth ||
         (info.types == OperandTypes::kInt) == (type == DataType::kInt);
}

/// The type an operator yields for operands of this type.
constexpr DataType ResultOf(const OperatorInfo& info, DataType operand) {
  switch (info.result) {
    case ResultType::kInt:
      return DataType::kInt;
    case ResultType::kDouble:
      return DataType::kDouble;
    case ResultType::kSame:
      break;
  }
  return operand;
}

}  // namespace oncard::vm
