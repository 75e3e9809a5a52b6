// Globals to which threads only add, such as the counter of `done = done + 1`. Whatever the order
// of the threads, such a global has in the end the sum of what each of them has added. Tested by
// tests/explore/added_globals_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "explore/models/model.h"
#include "runtime/observe/statement_access.h"
#include "vm/object.h"

namespace oncard::explore {

/// By their slots, in order: ints, each a variable of its own, to which at least two of the threads
/// add, and that no statement of the program names but `g = g + x`, `g = x + g` and `g = g - x`,
/// where x does not depend on any of them.
std::vector<uint16_t> GlobalsOnlyAddedTo(const vm::Object& object,
                                         const std::vector<ThreadSetup>& threads);

/// The accesses without those of the globals.
runtime::StatementAccess WithoutGlobals(const std::vector<uint16_t>& globals,
                                        runtime::StatementAccess accesses);

}  // namespace oncard::explore
