// What a statement accesses, widened by what the cycles of the card connect with it: two threads
// whose lasting accesses do not depend on each other never notice each other, whatever happens
// between their statements. Of what is not known to be apart, everything is accessed.
//
// An axis is its profile, encoder and servo controller. An input can be that of a switch which an
// axis operates; the other words of inputs and outputs belong to the axes. Paths, captures, compare
// outputs, analogue outputs and settings of the whole card connect everything. So does a command
// that begins to follow other axes (GT_GearStart, GT_FollowStart), as it reads all of them. Time
// connects nothing. A thread sets its data page, Resource::kThread, and its state,
// Resource::kProgram, by its number.
// Tested by tests/explore/lasting_access_test.cc.
#pragma once

#include "runtime/observe/quantity.h"
#include "runtime/observe/statement_access.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// Of the next statement of a running thread, for the current values of the variables.
StatementAccess NextLastingAccess(const Controller& controller, int thread);

/// What a value is read from.
StatementAccess LastingAccessOf(const Quantity& quantity, const Controller& controller);

/// True if a thread of the program may wait until another one has written a variable.
bool WaitsForVariables(const vm::Object& object, const gtcalls::Catalogue& catalogue);

}  // namespace oncard::runtime
