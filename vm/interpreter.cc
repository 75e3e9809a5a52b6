// The interpreter: one handler per decoded op, each ending with a jump to the next handler. With
// clang the handlers are functions that tail-call each other (musttail), so that the state stays in
// registers; g++ cannot guarantee tail calls, so there they are labels of one function (computed
// goto). In WebAssembly they are labels, too: a tail call through a table takes five times as long
// there, and not every engine has it. The bodies are the same source text.
//
// Fuel is the number of statements still permitted, counted down by every dispatch, so that the
// count is exact for every quantum. The subtraction and the jump out when nothing is left are one
// operation of the processor.
//
// There are two tables of handlers. In the second one every op that can access globals or the card
// leads to a handler that stops. This lets the machine run a thread ahead as long as no other
// thread could notice it (run_ahead.cc).
// Tested by tests/vm/machine_test.cc, tests/vm/run_ahead_test.cc and the differential tests.
#include "vm/interpreter.h"

#include "vm/addresses.h"
#include "vm/arithmetic.h"
#include "vm/handlers.h"

namespace oncard::vm {
namespace {

Exit StopWithFault(Frame* frame, const Code* pc, int64_t fuel, Fault fault) {
  frame->pc = pc;
  frame->fault = fault;
  frame->left = fuel - 1;
  return Exit::kFault;
}

// What operators compute, as functions of their operands, for ops that execute two of them.
#define FUNCTION [[maybe_unused]] inline __attribute__((always_inline))
#define INT_BINARY(name, bad, value) \
  FUNCTION int32_t Int##name(int32_t a, int32_t b) { return static_cast<int32_t>(value); }
#define DOUBLE_BINARY(name, bad, value) \
  FUNCTION int64_t Double##name(int64_t a, int64_t b, int wrap_shift) { return value; }
#include "vm/handlers.def"
FUNCTION int32_t IntFrom(int32_t a, int32_t b) { return IntSubtract(b, a); }
FUNCTION int64_t DoubleFrom(int64_t a, int64_t b, int wrap_shift) {
  return DoubleSubtract(b, a, wrap_shift);
}
#undef FUNCTION

}  // namespace

int64_t* ElementAddress(Frame& frame, uint16_t operand) {
  return AddressOfElement(&frame, IndexOf(operand));
}

#if defined(__clang__) && __has_cpp_attribute(clang::musttail) && !defined(__wasm__)

namespace {

struct HandlerEntry;
using Handler = Exit (*)(const Code* pc, int64_t* locals, const int64_t* constants, Frame* frame,
                         int64_t fuel, const HandlerEntry* table);
struct HandlerEntry {
  Handler run;
};

#define HANDLER(name)                                                                 \
  Exit name([[maybe_unused]] const Code* pc, [[maybe_unused]] int64_t* locals,        \
            [[maybe_unused]] const int64_t* constants, [[maybe_unused]] Frame* frame, \
            [[maybe_unused]] int64_t fuel, [[maybe_unused]] const HandlerEntry* table)
#define DISPATCH() \
  [[clang::musttail]] return table[pc->op].run(pc, locals, constants, frame, fuel, table)
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

Exit Enter(Frame& frame, int64_t fuel, const HandlerEntry* first, const HandlerEntry* table) {
  return first[frame.pc->op].run(frame.pc, frame.locals(), frame.bases[kConstantBase], &frame, fuel,
                                 table);
}

}  // namespace

Exit Interpret(Frame& frame, int64_t statements, Reach reach) {
  frame.left = 0;
  if (statements == 0 && frame.pc->op != kEnd) return Exit::kBudget;
  return Enter(frame, statements, reach == Reach::kPrivateOnly ? kPrivateHandlers : kAllHandlers,
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
  int64_t fuel = statements;
  const void* const* const first = reach == Reach::kPrivateOnly ? kPrivateHandlers : kAllHandlers;
  const void* const* const table = reach == Reach::kAll ? kAllHandlers : kPrivateHandlers;
  goto* first[pc->op];

#include "vm/handlers.inc"
}

#endif

}  // namespace oncard::vm
