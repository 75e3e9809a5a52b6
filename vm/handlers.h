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

constexpr uint16_t PackOperand(OperandClass operand_class, size_t index) {
  return static_cast<uint16_t>(static_cast<size_t>(operand_class) << kOperandIndexBits | index);
}
constexpr OperandClass ClassOf(uint16_t operand) {
  return static_cast<OperandClass>(operand >> kOperandIndexBits);
}
constexpr uint16_t IndexOf(uint16_t operand) { return operand & kOperandIndexMask; }

// Operands in the names of decoded ops: L a local slot, G a global slot, K a constant, E an element
// private to the thread (a local array, indexed by a local variable), P any operands private to the
// thread, S operands of which one is shared. The letters are those of a and b; the target d is a
// local slot unless the first letter is G, or a `To` names it. In a unary op they are those of a
// and, unless it is a local slot, d.
//
// Some ops execute several statements that are often adjacent: an operation with the kIfLocal after
// it (...If), a comparison with the kIfLocal on its target (kTest), a goto to a kTest (kLoop), an
// increment before a kTest or a kLoop (kIncrementTest, kIncrementLoop, kStepLoop), the operations
// that are usually the last ones before the increment: accumulate or store (kAccumulate...,
// kStore...), two copies, and two operations of one expression, the second of which takes the
// result of the first (...Then...). Measurements showed that they are slower if the relation is
// data instead of part of the op.
//
// The lists below name an op by X(op), or SHARED(op) if it can access data shared by threads; an op
// of several statements by FUSED(op, first) or SHARED_FUSED(op, first), where `first` is the op
// that executes its first statement alone.
// clang-format off
#define ONCARD_INT_BINARY_OPS(X, SHARED, FUSED, SHARED_FUSED, name)                          \
  X(name##LL) X(name##LK) X(name##KL) X(name##LE) X(name##EK) X(name##P) SHARED(name##S)     \
  SHARED(name##GL) SHARED(name##GK) SHARED(name##GLToL) SHARED(name##GKToL)                  \
  SHARED(name##LKToG) FUSED(name##LLIf, name##LL) FUSED(name##LKIf, name##LK)                \
  FUSED(name##EKIf, name##EK) SHARED_FUSED(name##GKToLIf, name##GKToL)
#define ONCARD_DOUBLE_BINARY_OPS(X, SHARED, name) \
  X(name##LL) X(name##LK) X(name##KL) X(name##LE) X(name##P) SHARED(name##S)
#define ONCARD_UNARY_OPS(X, SHARED, name)                                      \
  X(name##L) X(name##K) X(name##E) X(name##LE) X(name##KE) X(name##P)          \
  SHARED(name##S) SHARED(name##G) SHARED(name##LG) SHARED(name##KG)
#define ONCARD_COMPARE_OPS(FUSED, SHARED_FUSED, name)                                     \
  ONCARD_COMPARE_OPS_OF(FUSED, SHARED_FUSED, name##LL)                                    \
  ONCARD_COMPARE_OPS_OF(FUSED, SHARED_FUSED, name##LK)
#define ONCARD_COMPARE_OPS_OF(FUSED, SHARED_FUSED, test)                                  \
  FUSED(Test##test, Int##test) FUSED(Loop##test, Goto)                                    \
  FUSED(IncrementTest##test, IntAddLK) FUSED(IncrementLoop##test, IntAddLK)               \
  FUSED(StepLoop##test, IntAddLL) FUSED(AccumulateIntLoop##test, IntAddLL)                \
  SHARED_FUSED(AccumulateGlobalLoop##test, IntAddGL)                                      \
  FUSED(AccumulateDoubleLoop##test, DoubleAddLL) FUSED(StoreIntLoop##test, CopyIntLE)
#define ONCARD_OTHER_OPS(X, SHARED) \
  X(Goto) X(IfLocal) SHARED(IfGlobal) X(ReturnP) SHARED(ReturnS) SHARED(Command) X(End)

// The pairs of an expression. ONCARD_INT_PAIRS(PAIR) and ONCARD_DOUBLE_PAIRS(PAIR) call
// PAIR(type, first, form, second, operand) for `first` with the operands `form` (LL or LK), then
// `second` with the first one's target as its operand a and `operand` (L or K) as b. From with R is
// a subtraction whose operand b is the first one's target and a is a local slot. Neither can fault.
#define ONCARD_INT_PAIRS(PAIR)                                                         \
  ONCARD_INT_SECONDS(PAIR, Add) ONCARD_INT_SECONDS(PAIR, Subtract)                     \
  ONCARD_INT_SECONDS(PAIR, Multiply) ONCARD_INT_SECONDS(PAIR, And)                     \
  ONCARD_INT_SECONDS(PAIR, Or) ONCARD_INT_SECONDS(PAIR, Xor)                           \
  ONCARD_INT_SECONDS(PAIR, ShiftLeft) ONCARD_INT_SECONDS(PAIR, ShiftRight)
#define ONCARD_INT_SECONDS(PAIR, first)                                                \
  ONCARD_INT_SECONDS_OF(PAIR, first, LL) ONCARD_INT_SECONDS_OF(PAIR, first, LK)
#define ONCARD_INT_SECONDS_OF(PAIR, first, form)                                       \
  PAIR(Int, first, form, Add, L) PAIR(Int, first, form, Add, K)                        \
  PAIR(Int, first, form, Subtract, L) PAIR(Int, first, form, Subtract, K)              \
  PAIR(Int, first, form, From, R)                                                      \
  PAIR(Int, first, form, Multiply, L) PAIR(Int, first, form, Multiply, K)              \
  PAIR(Int, first, form, And, L) PAIR(Int, first, form, And, K)                        \
  PAIR(Int, first, form, Or, L) PAIR(Int, first, form, Xor, L)                         \
  PAIR(Int, first, form, ShiftLeft, K) PAIR(Int, first, form, ShiftRight, K)
#define ONCARD_DOUBLE_PAIRS(PAIR)                                                      \
  ONCARD_DOUBLE_SECONDS_OF(PAIR, Add, LL) ONCARD_DOUBLE_SECONDS_OF(PAIR, Add, LK)      \
  ONCARD_DOUBLE_SECONDS_OF(PAIR, Subtract, LL)                                         \
  ONCARD_DOUBLE_SECONDS_OF(PAIR, Subtract, LK)                                         \
  ONCARD_DOUBLE_SECONDS_OF(PAIR, Multiply, LL) ONCARD_DOUBLE_SECONDS_OF(PAIR, Multiply, LK)
#define ONCARD_DOUBLE_SECONDS_OF(PAIR, first, form)                                    \
  PAIR(Double, first, form, Add, L) PAIR(Double, first, form, Add, K)                  \
  PAIR(Double, first, form, Subtract, L) PAIR(Double, first, form, From, R)            \
  PAIR(Double, first, form, Multiply, L) PAIR(Double, first, form, Multiply, K)
// Not in WebAssembly: the module is downloaded, and engines compile all handlers as one function.
#ifdef __wasm__
#define ONCARD_PAIRS(PAIR)
#else
#define ONCARD_PAIRS(PAIR) ONCARD_INT_PAIRS(PAIR) ONCARD_DOUBLE_PAIRS(PAIR)
#endif
#define ONCARD_COPIES(FUSED) FUSED(CopyIntTwice, CopyIntL) FUSED(CopyDoubleTwice, CopyDoubleL)
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
///   kIncrementTest...   as kIntAddLK with a = d; the next instruction is the kTest of the same
///                       name, whose comparison is of d
///   kIncrementLoop...   as kIntAddLK with a = d; the next instruction is the kLoop of the same
///                       name, whose comparison is of d
///   kStepLoop...        the same with kIntAddLL
///   kAccumulateIntLoop..., kAccumulateGlobalLoop..., kAccumulateDoubleLoop..., kStoreIntLoop...
///                       as kIntAddLL, kIntAddGL, kDoubleAddLL (with a = d), kCopyIntLE; the next
///                       instruction is the kIncrementLoop of the same name
///   k...Then...         as the first op; the next instruction is the second one, whose operands b
///                       and d are indices as in kIntAddLL, kIntAddLK
///   k...Twice           as the op; the next instruction is the same one
enum DecodedOp : uint16_t {
#define ONCARD_ENUMERATOR(op) k##op,
#define ONCARD_FUSED_ENUMERATOR(op, first) k##op,
#define ONCARD_PAIR_ENUMERATOR(type, first, form, second, operand) \
  k##type##first##form##Then##second##operand,
#define INT_BINARY(name, bad, value)                                                   \
  ONCARD_INT_BINARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, ONCARD_FUSED_ENUMERATOR, \
                        ONCARD_FUSED_ENUMERATOR, Int##name)
#define COMPARE(name, value) INT_BINARY(name, false, value)
#include "vm/handlers.def"
#define DOUBLE_BINARY(name, bad, value) \
  ONCARD_DOUBLE_BINARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, Double##name)
#define COMPARE(name, value) \
  ONCARD_DOUBLE_BINARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, Double##name)
#include "vm/handlers.def"
#define UNARY(name, type, value) ONCARD_UNARY_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR, name##type)
#include "vm/handlers.def"
#define COMPARE(name, value) \
  ONCARD_COMPARE_OPS(ONCARD_FUSED_ENUMERATOR, ONCARD_FUSED_ENUMERATOR, name)
#include "vm/handlers.def"
  ONCARD_PAIRS(ONCARD_PAIR_ENUMERATOR) ONCARD_COPIES(ONCARD_FUSED_ENUMERATOR)
      ONCARD_OTHER_OPS(ONCARD_ENUMERATOR, ONCARD_ENUMERATOR)
#undef ONCARD_ENUMERATOR
#undef ONCARD_FUSED_ENUMERATOR
#undef ONCARD_PAIR_ENUMERATOR
          kDecodedOpCount
};

/// Variants of a binary op, on ints, counted from its LL.
enum BinaryVariant : uint16_t {
  kVariantLL,
  kVariantLK,
  kVariantKL,
  kVariantLE,
  kVariantEK,
  kVariantP,
  kVariantS,
  kVariantGL,
  kVariantGK,
  kVariantGLToL,
  kVariantGKToL,
  kVariantLKToG,
  kVariantLLIf,
  kVariantLKIf,
  kVariantEKIf,
  kVariantGKToLIf,
  kIntVariantCount
};
/// Variants of a binary op on doubles, counted from its LL.
enum DoubleVariant : uint16_t {
  kDoubleVariantLL,
  kDoubleVariantLK,
  kDoubleVariantKL,
  kDoubleVariantLE,
  kDoubleVariantP,
  kDoubleVariantS
};
/// Variants of a unary op, counted from its L.
enum UnaryVariant : uint16_t {
  kUnaryVariantL,
  kUnaryVariantK,
  kUnaryVariantE,
  kUnaryVariantLE,
  kUnaryVariantKE,
  kUnaryVariantP,
  kUnaryVariantS,
  kUnaryVariantG,
  kUnaryVariantLG,
  kUnaryVariantKG
};

/// The binary ops on ints come first.
inline constexpr uint16_t kIntOpEnd = kIntVariantCount * (0
#define INT_BINARY(name, bad, value) +1
#define COMPARE(name, value) +1
#include "vm/handlers.def"
                                                         );

}  // namespace oncard::vm
