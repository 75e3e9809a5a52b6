// The decoded instruction set: what the linker writes into Code and the interpreter executes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace oncard::vm {

/// A packed operand: two bits of class, fourteen of index.
enum class OperandClass : uint16_t { kLocal = 0, kGlobal = 1, kConstant = 2, kElement = 3 };
inline constexpr int kOperandIndexBits = 14;
inline constexpr uint16_t kOperandIndexMask = (1u << kOperandIndexBits) - 1;
/// Distinct literals, and distinct elements, that one function can have.
inline constexpr int kPackedIndexCount = 1 << kOperandIndexBits;

/// Maximum number of statements of one op. The same number of end markers follows a function's
/// code, so that an op can check its fuel without computing an address outside the code.
inline constexpr size_t kLookAhead = 5;

constexpr uint16_t PackOperand(OperandClass operand_class, size_t index) {
  return static_cast<uint16_t>(static_cast<size_t>(operand_class) << kOperandIndexBits | index);
}
constexpr OperandClass ClassOf(uint16_t operand) {
  return static_cast<OperandClass>(operand >> kOperandIndexBits);
}
constexpr uint16_t IndexOf(uint16_t operand) { return operand & kOperandIndexMask; }

// Operands in the names of decoded ops: L a local slot, G a global slot, K a constant, E an element
// private to the thread, P any operands private to the thread, S operands of which one is shared.
// The letters are those of a and b; the target d is a local slot unless the first letter is G. In a
// unary op they are those of a and, unless it is a local slot, d.
//
// Some ops execute several statements that are adjacent in loops: an operation with the kIfLocal
// after it (...If), a comparison with the kIfLocal on its target (kTest), a goto to a kTest
// (kLoop), an increment before a kLoop (kIncrementLoop), and the operations that are usually the
// last ones before the increment: accumulate or store (kAccumulate..., kStore...). Measurements
// showed that they are slower if the relation is data instead of part of the op.
// clang-format off
#define ONCARD_INT_BINARY_OPS(X, SHARED, name)                               \
  X(name##LL) X(name##LK) X(name##KL) X(name##LE) X(name##P) SHARED(name##S) \
  SHARED(name##GL) SHARED(name##GK) X(name##LLIf) X(name##LKIf)
#define ONCARD_DOUBLE_BINARY_OPS(X, SHARED, name) \
  X(name##LL) X(name##LK) X(name##KL) X(name##LE) X(name##P) SHARED(name##S)
#define ONCARD_UNARY_OPS(X, SHARED, name) \
  X(name##L) X(name##K) X(name##LE) X(name##P) SHARED(name##S)
#define ONCARD_COMPARE_OPS(X, SHARED, name)                                               \
  X(Test##name##LL) X(Test##name##LK) X(Loop##name##LL) X(Loop##name##LK)                 \
  X(IncrementLoop##name##LL) X(IncrementLoop##name##LK)                                   \
  X(AccumulateIntLoop##name##LL) X(AccumulateIntLoop##name##LK)                           \
  SHARED(AccumulateGlobalLoop##name##LL) SHARED(AccumulateGlobalLoop##name##LK)           \
  X(AccumulateDoubleLoop##name##LL) X(AccumulateDoubleLoop##name##LK)                     \
  X(StoreIntLoop##name##LL) X(StoreIntLoop##name##LK)
#define ONCARD_OTHER_OPS(X, SHARED) \
  X(Goto) X(IfLocal) SHARED(IfGlobal) X(ReturnP) SHARED(ReturnS) SHARED(Command) X(End)
// clang-format on

/// All operations of one dispatch. Fields of Code by op:
///   P, S                packed operands
///   all other operands  indices within their class
///   kGoto               d: displacement
///   kIfLocal, kIfGlobal a: index of the condition; d: displacement
///   kReturnP, kReturnS  a: packed condition; b: packed result value
///   kCommand            a: index of the call site
///   kEnd                end of the function; takes no statement
///   ...If               as without If; the next instruction is kIfLocal
///   kTest...            as the comparison; the next instruction is kIfLocal on its target
///   kLoop...            as kGoto; the target is the kTest of the same name
///   kIncrementLoop...   as kIntAddLK with a = d; the next instruction is the kLoop of the same
///                       name, whose comparison is of d
///   kAccumulateIntLoop..., kAccumulateGlobalLoop..., kAccumulateDoubleLoop..., kStoreIntLoop...
///                       as kIntAddLL, kIntAddGL, kDoubleAddLL (with a = d), kCopyIntLE; the next
///                       instruction is the kIncrementLoop of the same name
enum DecodedOp : uint16_t {
#define ONCARD_ENUMERATOR(op) k##op,
#define INT_BINARY(name, bad, value) \
  ONCARD_INT_BINARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, Int##name)
#define COMPARE(name, value) ONCARD_INT_BINARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, Int##name)
#include "vm/handlers.def"
#define DOUBLE_BINARY(name, bad, value) \
  ONCARD_DOUBLE_BINARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, Double##name)
#define COMPARE(name, value) \
  ONCARD_DOUBLE_BINARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, Double##name)
#include "vm/handlers.def"
#define UNARY(name, type, value) ONCARD_UNARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, name##type)
#include "vm/handlers.def"
#define COMPARE(name, value) ONCARD_COMPARE_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, name)
#include "vm/handlers.def"
  ONCARD_OTHER_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR)
#undef ONCARD_ENUMERATOR
      kDecodedOpCount
};

/// Variants of a binary op, counted from its LL; doubles have those up to kVariantS.
enum BinaryVariant : uint16_t {
  kVariantLL,
  kVariantLK,
  kVariantKL,
  kVariantLE,
  kVariantP,
  kVariantS,
  kVariantGL,
  kVariantGK,
  kVariantLLIf,
  kVariantLKIf,
  kIntVariantCount
};
/// Variants of a unary op, counted from its L.
enum UnaryVariant : uint16_t {
  kUnaryVariantL,
  kUnaryVariantK,
  kUnaryVariantLE,
  kUnaryVariantP,
  kUnaryVariantS
};

/// The binary ops on ints come first.
inline constexpr uint16_t kIntOpEnd = kIntVariantCount * (0
#define INT_BINARY(name, bad, value) +1
#define COMPARE(name, value) +1
#include "vm/handlers.def"
                                                         );

}  // namespace oncard::vm
