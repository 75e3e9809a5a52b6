// Loops in which a thread waits for others: a pass reads globals, writes none, and leaves the
// thread as it was. Another pass does the same until another thread writes what it reads.
//
// A pass has one statement that accesses globals; a loop with several is not recognised.
// Deterministic; not thread-safe. Tested by tests/explore/waiting_loop_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "explore/models/model.h"

namespace oncard::explore {

/// True if a thread that runs, and is about to execute a statement that accesses globals, waits in
/// such a loop as long as nobody writes what it reads. The model is left as it was.
bool WaitsInLoop(Model* model, int thread);

/// The statements of one pass of each thread that runs, if all of them wait in such loops: they do
/// so for ever. Empty if one does not, or if no thread runs.
std::vector<uint8_t> EndlessWait(Model model);

}  // namespace oncard::explore
