// Executes rounds of the one-statement round robin by changing the thread in every handler.
// Internal to the machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "vm/interpreter.h"

namespace oncard::vm {

/// Where a rotation ended: after `rounds` whole rounds and, in the round begun, after the
/// statements of the first `position` frames.
struct RotationEnd {
  int64_t rounds = 0;
  ptrdiff_t position = 0;
};

/// Executes up to `rounds` rounds. In each, every frame but the last executes one statement, in
/// their order; the last one is only room for the end of the round. Ends early, before it, at a
/// statement that returns, calls a command or would fault, and where a function has ended. Only the
/// frames' `pc` change, and their fault values where a statement would fault.
RotationEnd Rotate(std::span<Frame> frames, int64_t rounds);

}  // namespace oncard::vm
