#include "vm/opcodes.h"

#include <algorithm>

namespace oncard::vm {
namespace {

enum class Basis : uint8_t { O, A };

constexpr OperatorInfo kUnaryOperators[] = {
#define UNARY_OPERATOR(name, number, basis, spelling, types, result, effect) \
  {number,                                                                   \
   spelling,                                                                 \
   Precedence::kUnary,                                                       \
   OperandTypes::types,                                                      \
   ResultType::result,                                                       \
   effect,                                                                   \
   Basis::basis == Basis::O},
#include "vm/opcodes.def"
};

constexpr OperatorInfo kBinaryOperators[] = {
#define BINARY_OPERATOR(name, number, basis, spelling, precedence, types, result, effect) \
  {number,                                                                                \
   spelling,                                                                              \
   Precedence::precedence,                                                                \
   OperandTypes::types,                                                                   \
   ResultType::result,                                                                    \
   effect,                                                                                \
   Basis::basis == Basis::O},
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

// Each spelling means one operator.
template <size_t size>
constexpr bool SpelledApart(const OperatorInfo (&rows)[size]) {
  for (size_t i = 0; i < size; ++i) {
    for (size_t j = 0; j < i; ++j) {
      if (rows[i].spelling == rows[j].spelling) return false;
    }
  }
  return true;
}
static_assert(SpelledApart(kUnaryOperators));
static_assert(SpelledApart(kBinaryOperators));

// handlers.def has a row with ints for every binary operator.
constexpr bool AllTakeInts() {
  return std::all_of(std::begin(kBinaryOperators), std::end(kBinaryOperators),
                     [](const OperatorInfo& info) { return Accepts(info, DataType::kInt); });
}
static_assert(AllTakeInts());

const OperatorInfo* FindRow(std::span<const OperatorInfo> rows, uint16_t number) {
  return number >= 1 && number <= rows.size() ? &rows[number - 1u] : nullptr;
}

const OperatorInfo* FindRow(std::span<const OperatorInfo> rows, std::string_view spelling) {
  const auto found = std::find_if(rows.begin(), rows.end(), [spelling](const OperatorInfo& info) {
    return info.spelling == spelling;
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::span<const OperatorInfo> UnaryOperators() { return kUnaryOperators; }
std::span<const OperatorInfo> BinaryOperators() { return kBinaryOperators; }

const OperatorInfo* FindUnaryOperator(uint16_t number) { return FindRow(kUnaryOperators, number); }

const OperatorInfo* FindBinaryOperator(uint16_t number) {
  return FindRow(kBinaryOperators, number);
}

const OperatorInfo* FindUnaryOperator(std::string_view spelling) {
  return FindRow(kUnaryOperators, spelling);
}

const OperatorInfo* FindBinaryOperator(std::string_view spelling) {
  return FindRow(kBinaryOperators, spelling);
}

}  // namespace oncard::vm
