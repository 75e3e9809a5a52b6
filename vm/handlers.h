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

/// Everything one dispatch can do. Fields of Code by op:
///   binary LL, LK, KL   a, b: indices within their class; d: index of the target's local slot
///   binary P, S         a, b, d: packed operands
///   unary L, K          a: index; d: index of the target's local slot
///   unary P, S          a, d: packed operands
///   kGoto               d: displacement
///   kIfLocal            a: index of the condition's local slot; d: displacement
///   kIfGlobal           a: index of the condition's global slot; d: displacement
///   kReturnP, kReturnS  a: packed condition; b: packed result value
///   kCommand            a: index of the call site
///   kEnd                falls off the end; takes no statement
///   kTest...            as the comparison; the next instruction is kIfLocal on its target
///   kLoop...            as kGoto; the target is the corresponding kTest
///   kIncrementLoop...   as kIntAddLK; the next instruction is the corresponding kLoop
enum DecodedOp : uint16_t {
#define INT_BINARY(name, bad, value) \
  kInt##name##LL, kInt##name##LK, kInt##name##KL, kInt##name##P, kInt##name##S,
#include "vm/handlers.def"
#define DOUBLE_BINARY(name, bad, value) \
  kDouble##name##LL, kDouble##name##LK, kDouble##name##KL, kDouble##name##P, kDouble##name##S,
#define DOUBLE_COMPARE(name, value) \
  kDouble##name##LL, kDouble##name##LK, kDouble##name##KL, kDouble##name##P, kDouble##name##S,
#include "vm/handlers.def"
#define UNARY(name, type, value) k##name##L, k##name##K, k##name##P, k##name##S,
#include "vm/handlers.def"
  kGoto,
  kIfLocal,
  kIfGlobal,
  kReturnP,
  kReturnS,
  kCommand,
  kEnd,
#define INT_COMPARE(name, value) kTest##name##LL, kTest##name##LK,
#include "vm/handlers.def"
#define INT_COMPARE(name, value) kLoop##name##LL, kLoop##name##LK,
#include "vm/handlers.def"
#define INT_COMPARE(name, value) kIncrementLoop##name##LL, kIncrementLoop##name##LK,
#include "vm/handlers.def"
  kDecodedOpCount
};

/// Variants of a binary op, counted from its LL.
inline constexpr uint16_t kVariantLL = 0;
inline constexpr uint16_t kVariantLK = 1;
inline constexpr uint16_t kVariantKL = 2;
inline constexpr uint16_t kVariantP = 3;
inline constexpr uint16_t kVariantS = 4;
/// Variants of a unary op, counted from its L.
inline constexpr uint16_t kUnaryVariantL = 0;
inline constexpr uint16_t kUnaryVariantK = 1;
inline constexpr uint16_t kUnaryVariantP = 2;
inline constexpr uint16_t kUnaryVariantS = 3;

}  // namespace oncard::vm
