// The one-statement round robin where nearly every statement accesses shared data: each handler
// goes on with the next thread's statement instead of its own thread's. What is rare is left to the
// caller: returns, commands, ends, faults.
// Tested by tests/vm/run_ahead_test.cc.
#include "vm/rotation.h"

#include "vm/addresses.h"
#include "vm/arithmetic.h"
#include "vm/handlers.h"

namespace oncard::vm {
namespace {

// The op of the code that the frame after the last one executes.
constexpr uint16_t kRoundEnd = kDecodedOpCount;
constexpr Code kRoundEndCode{kRoundEnd, 0, 0, 0};

}  // namespace

#define HANDLER(name) \
  name:
#define ENTRY(name) &&name,
#define LOCALS frame->bases[kLocalBase]
#define CONSTANTS frame->bases[kConstantBase]
// The next thread's statement. The pc of a thread is written when its turn is over.
#define CONTINUE()          \
  do {                      \
    frame->pc = pc;         \
    ++frame;                \
    pc = frame->pc;         \
    goto* handlers[pc->op]; \
  } while (false)
#define NEXT()  \
  do {          \
    ++pc;       \
    CONTINUE(); \
  } while (false)
#define JUMP(from, displacement) pc = (from) + static_cast<int16_t>(displacement)
#define FAULT(fault) goto Leave

RotationEnd Rotate(std::span<Frame> frames, int64_t rounds) {
#define ROTATION
  static const void* const handlers[] = {
#include "vm/handler_table.inc"
      &&RoundEnd};
#undef ROTATION
  Frame& after_last = frames.back();
  after_last.pc = &kRoundEndCode;
  if (rounds == 0) return {0, 0};
  int64_t remaining = rounds;
  Frame* frame = frames.data();
  const Code* pc = frame->pc;
  goto* handlers[pc->op];

#include "vm/operations.inc"

  HANDLER(RoundEnd) {
    if (--remaining == 0) return {rounds, 0};
    frame = frames.data();
    pc = frame->pc;
    goto* handlers[pc->op];
  }

  HANDLER(Leave) { return {rounds - remaining, frame - frames.data()}; }
}

}  // namespace oncard::vm
