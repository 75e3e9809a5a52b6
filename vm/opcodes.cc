#include "vm/opcodes.h"

#include <array>

namespace oncard::vm {
namespace {

enum class Basis : uint8_t { O, A };

constexpr OperatorInfo kUnaryOperators[] = {
#define UNARY_OPERATOR(name, number, basis, spelling, types, result, effect) \
  {number, spelling, OperandTypes::types, ResultType::result, effect, Basis::basis == Basis::O},
#include "vm/opcodes.def"
};

constexpr OperatorInfo kBinaryOperators[] = {
#define BINARY_OPERATOR(name, number, basis, spelling, types, result, effect) \
  {number, spelling, OperandTypes::types, ResultType::result, effect, Basis::basis == Basis::O},
#include "vm/opcodes.def"
};

// True if the rows are in the order of their numbers, from 1 without gaps.
template <size_t size>
constexpr bool NumberedFromOne(const OperatorInfo (&rows)[size]) {
  for (size_t i = 0; i < size; ++i) {
    if (rows[i].number != i + 1) return false;
  }
  return true;
}
static_assert(NumberedFromOne(kUnaryOperators));
static_assert(NumberedFromOne(kBinaryOperators));

template <size_t size>
const OperatorInfo* FindRow(const OperatorInfo (&rows)[size], uint16_t number) {
  return number >= 1 && number <= size ? &rows[number - 1] : nullptr;
}

}  // namespace

const OperatorInfo* FindUnaryOperator(uint16_t number) { return FindRow(kUnaryOperators, number); }

const OperatorInfo* FindBinaryOperator(uint16_t number) {
  return FindRow(kBinaryOperators, number);
}

}  // namespace oncard::vm
