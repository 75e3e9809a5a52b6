// Where the operands of decoded ops are. Internal to the interpreter: interpreter.cc and
// rotation.cc. Each function returns nullptr, with the fault recorded in the frame, when an
// element's index is out of bounds.
#pragma once

#include "vm/arithmetic.h"
#include "vm/handlers.h"
#include "vm/interpreter.h"

namespace oncard::vm {

/// Records in the frame that an element's index is out of bounds.
inline void RecordBadIndex(Frame& frame, const ElementReference& element, int32_t index) {
  frame.fault_value = index;
  frame.fault_limit = element.size;
}

/// The slot of an element, given the value of its index and the first slot of the storage that
/// holds its array.
inline __attribute__((always_inline)) int64_t* SlotOfElement(Frame* frame,
                                                             const ElementReference& element,
                                                             int64_t* storage, int32_t index) {
  if (__builtin_expect(ToUnsigned(index) >= element.size, 0)) {
    RecordBadIndex(*frame, element, index);
    return nullptr;
  }
  return storage + element.base + index;
}

/// The slot of any element.
inline __attribute__((always_inline)) int64_t* AddressOfElement(Frame* frame, uint16_t number) {
  const ElementReference& element = frame->elements[number];
  return SlotOfElement(frame, element, frame->bases[element.array_class],
                       IntOf(frame->bases[element.index_class][element.index]));
}

/// The slot of an element of a local array whose index is a local variable.
inline __attribute__((always_inline)) int64_t* AddressOfPrivateElement(Frame* frame,
                                                                       int64_t* locals,
                                                                       uint16_t number) {
  const ElementReference& element = frame->elements[number];
  return SlotOfElement(frame, element, locals, IntOf(locals[element.index]));
}

/// The slot of a packed operand.
inline __attribute__((always_inline)) int64_t* OperandAddress(Frame* frame, uint16_t operand) {
  if (ClassOf(operand) == OperandClass::kElement) return AddressOfElement(frame, IndexOf(operand));
  return frame->bases[operand >> kOperandIndexBits] + IndexOf(operand);
}

/// The slot of a packed operand that is private to the thread.
inline __attribute__((always_inline)) int64_t* PrivateAddress(Frame* frame, int64_t* locals,
                                                              uint16_t operand) {
  if (ClassOf(operand) == OperandClass::kElement) {
    return AddressOfPrivateElement(frame, locals, IndexOf(operand));
  }
  if (ClassOf(operand) == OperandClass::kLocal) return locals + operand;
  return frame->bases[kConstantBase] + IndexOf(operand);
}

}  // namespace oncard::vm
