// The arithmetic of motion programs: what the operators of opcodes.def compute. The values are the
// rows of handlers.def, which the interpreter executes too.
// Tested by tests/vm/arithmetic_test.cc.
#pragma once

#include <cstdint>
#include <optional>

#include "vm/fixed_point.h"
#include "vm/opcodes.h"

namespace oncard::vm {

constexpr uint32_t ToUnsigned(int32_t value) { return static_cast<uint32_t>(value); }
constexpr int32_t ToInt(uint32_t value) { return static_cast<int32_t>(value); }
/// The int in a slot: its low half. On a page that another function used for doubles, the upper
/// half may be set.
constexpr int32_t IntOf(int64_t slot) { return static_cast<int32_t>(slot); }

/// a/b, truncated toward zero and wrapped; b must not be 0. Programs mostly divide by powers of
/// two, and a division instruction takes as long as several statements.
inline __attribute__((always_inline)) int32_t DivideInt(int32_t a, int32_t b) {
  if (b > 0 && (b & (b - 1)) == 0) [[likely]] {
    const int32_t toward_zero = (a >> 31) & (b - 1);
    return ToInt(ToUnsigned(a) + ToUnsigned(toward_zero)) >> __builtin_ctz(ToUnsigned(b));
  }
  return b == -1 ? ToInt(0u - ToUnsigned(a)) : a / b;
}

/// The remainder of that division, with the sign of a; b must not be 0.
inline __attribute__((always_inline)) int32_t RemainderInt(int32_t a, int32_t b) {
  if (b > 0 && (b & (b - 1)) == 0) [[likely]] {
    const int32_t toward_zero = (a >> 31) & (b - 1);
    return (ToInt(ToUnsigned(a) + ToUnsigned(toward_zero)) & (b - 1)) - toward_zero;
  }
  return b == -1 ? 0 : a % b;
}

/// The slot that a binary operator yields for two slots of one type; empty for a division by zero.
/// The operator must take this type. `wrap_shift` is WrapShift() of the program's doubles.
inline std::optional<int64_t> EvaluateBinary(BinaryOperator op, DataType type, int64_t left,
                                             int64_t right, [[maybe_unused]] int wrap_shift) {
  if (type == DataType::kInt) {
    const int32_t a = IntOf(left);
    const int32_t b = IntOf(right);
    switch (op) {
#define INT_BINARY(name, bad, value) \
  case BinaryOperator::k##name:      \
    if (bad) return std::nullopt;    \
    return static_cast<int32_t>(value);
#define COMPARE(name, value) INT_BINARY(name, false, value)
#include "vm/handlers.def"
    }
    return std::nullopt;
  }
  const int64_t a = left;
  const int64_t b = right;
  switch (op) {
#define DOUBLE_BINARY(name, bad, value) \
  case BinaryOperator::k##name:         \
    if (bad) return std::nullopt;       \
    return value;
#define COMPARE(name, value) DOUBLE_BINARY(name, false, value)
#include "vm/handlers.def"
    default:
      return std::nullopt;
  }
}

/// The slot that a unary operator yields for a slot of this type, which the operator must take.
inline int64_t EvaluateUnary(UnaryOperator op, DataType type, int64_t source,
                             [[maybe_unused]] int wrap_shift) {
  if (type == DataType::kInt) {
    const int32_t a = IntOf(source);
    switch (op) {
#define UNARY_Int(name, value) \
  case UnaryOperator::k##name: \
    return value;
#define UNARY_Double(name, value)
#define UNARY(name, type, value) UNARY_##type(name, value)
#include "vm/handlers.def"
#undef UNARY_Int
#undef UNARY_Double
      default:
        return source;
    }
  }
  const int64_t a = source;
  switch (op) {
#define UNARY_Int(name, value)
#define UNARY_Double(name, value) \
  case UnaryOperator::k##name:    \
    return value;
#define UNARY(name, type, value) UNARY_##type(name, value)
#include "vm/handlers.def"
#undef UNARY_Int
#undef UNARY_Double
    default:
      return source;
  }
}

/// True when a division by zero stops the operator.
inline bool Divides(BinaryOperator op) {
  return !EvaluateBinary(op, DataType::kInt, 1, 0, 0).has_value();
}

}  // namespace oncard::vm
