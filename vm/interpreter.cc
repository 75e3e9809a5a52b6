// The interpreter: one handler per decoded op, each ending with a jump to the next handler. With
// clang the handlers are functions that tail-call each other (musttail), so that the state stays in
// registers; g++ cannot guarantee tail calls, so there they are labels of one function (computed
// goto). In WebAssembly they are labels, too: a tail call through a table takes five times as long
// there, and not every engine has it. The bodies are the same source text.
//
// Fuel is counted with the program counter: `limit` is where the permitted statements end if no
// jump is taken, and a jump moves it along. A straight-line statement then costs one comparison and
// no bookkeeping, and the count is exact for every quantum.
//
// There are two tables of handlers. In the second one every op that can access globals or the card
// leads to a handler that stops. This lets the machine run a thread ahead as long as no other
// thread could notice it (run_ahead.cc).
// Tested by tests/vm/machine_test.cc, tests/vm/run_ahead_test.cc and the differential tests.
#include "vm/interpreter.h"

#include "vm/arithmetic.h"
#include "vm/handlers.h"

namespace oncard::vm {
namespace {

/// Where the permitted statements end if no jump is taken. It has 64 bits also where addresses have
/// 32: the statements may be more than memory holds.
uint64_t LimitFrom(const Code* pc, int64_t statements) {
  return uint64_t{reinterpret_cast<uintptr_t>(pc)} +
         static_cast<uint64_t>(statements) * sizeof(Code);
}

Exit StopWithFault(Frame* frame, const Code* pc, uint64_t limit, Fault fault) {
  frame->pc = pc;
  frame->fault = fault;
  frame->left =
      (static_cast<int64_t>(limit) - static_cast<int64_t>(reinterpret_cast<uintptr_t>(pc))) /
          static_cast<int64_t>(sizeof(Code)) -
      1;
  return Exit::kFault;
}

inline __attribute__((always_inline)) int64_t* AddressOfElement(Frame& frame, uint16_t number) {
  const ElementReference& element = frame.elements[number];
  const int32_t index = IntOf(frame.bases[element.index_class][element.index]);
  if (__builtin_expect(ToUnsigned(index) >= element.size, 0)) {
    frame.fault_value = index;
    frame.fault_limit = element.size;
    return nullptr;
  }
  return frame.bases[element.array_class] + element.base + index;
}

// The address of a packed operand, or nullptr when an element's index is out of bounds.
inline __attribute__((always_inline)) int64_t* OperandAddress(Frame* frame, uint16_t operand) {
  if (ClassOf(operand) == OperandClass::kElement) {
    return AddressOfElement(*frame, IndexOf(operand));
  }
  return frame->bases[operand >> kOperandIndexBits] + IndexOf(operand);
}

}  // namespace

int64_t* ElementAddress(Frame& frame, uint16_t operand) {
  return AddressOfElement(frame, IndexOf(operand));
}

#if defined(__clang__) && __has_cpp_attribute(clang::musttail) && !defined(__wasm__)

namespace {

struct HandlerEntry;
using Handler = Exit (*)(const Code* pc, int64_t* locals, const int64_t* constants, Frame* frame,
                         uint64_t limit, const HandlerEntry* table);
struct HandlerEntry {
  Handler run;
};

#define HANDLER(name)                                                                 \
  Exit name([[maybe_unused]] const Code* pc, [[maybe_unused]] int64_t* locals,        \
            [[maybe_unused]] const int64_t* constants, [[maybe_unused]] Frame* frame, \
            [[maybe_unused]] uintptr_t limit, [[maybe_unused]] const HandlerEntry* table)
#define DISPATCH() \
  [[clang::musttail]] return table[pc->op].run(pc, locals, constants, frame, limit, table)
#define ENTRY(name) {name},

#include "vm/handlers.inc"

constexpr HandlerEntry kAllHandlers[] = {
#include "vm/handler_table.inc"
};
#define PRIVATE_ONLY
constexpr HandlerEntry kPrivateHandlers[] = {
#include "vm/handler_table.inc"
};
#undef PRIVATE_ONLY

Exit Enter(Frame& frame, uint64_t limit, const HandlerEntry* first, const HandlerEntry* table) {
  return first[frame.pc->op].run(frame.pc, frame.locals(), frame.bases[kConstantBase], &frame,
                                 limit, table);
}

}  // namespace

Exit Interpret(Frame& frame, int64_t statements, Reach reach) {
  frame.left = 0;
  if (statements == 0 && frame.pc->op != kEnd) return Exit::kBudget;
  const uint64_t limit = LimitFrom(frame.pc, statements);
  return Enter(frame, limit, reach == Reach::kPrivateOnly ? kPrivateHandlers : kAllHandlers,
               reach == Reach::kAll ? kAllHandlers : kPrivateHandlers);
}

#else

#define HANDLER(name) \
  name:
#define DISPATCH() goto* table[pc->op]
#define ENTRY(name) &&name,

Exit Interpret(Frame& entry_frame, int64_t statements, Reach reach) {
  static const void* const kAllHandlers[] = {
#include "vm/handler_table.inc"
  };
#define PRIVATE_ONLY
  static const void* const kPrivateHandlers[] = {
#include "vm/handler_table.inc"
  };
#undef PRIVATE_ONLY

  Frame* const frame = &entry_frame;
  const Code* pc = frame->pc;
  frame->left = 0;
  if (statements == 0 && pc->op != kEnd) return Exit::kBudget;
  int64_t* locals = frame->locals();
  const int64_t* const constants = frame->bases[kConstantBase];
  uint64_t limit = LimitFrom(pc, statements);
  const void* const* const first = reach == Reach::kPrivateOnly ? kPrivateHandlers : kAllHandlers;
  const void* const* const table = reach == Reach::kAll ? kAllHandlers : kPrivateHandlers;
  goto* first[pc->op];

#include "vm/handlers.inc"
}

#endif

}  // namespace oncard::vm
