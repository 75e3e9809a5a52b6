// The program of a scenario on a card: loaded, bound, its variables set, its threads started.
// Tested by tests/runtime/scenario_run_test.cc.
#pragma once

#include "base/result.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/scenario.h"
#include "runtime/sim/controller.h"
#include "vm/object.h"

namespace oncard::runtime {

/// Puts a controller that was made with CardOptions() and has just been switched on into the state
/// before the scenario's first statement: the world applied, every thread bound, then all values
/// set, then the threads started in the order of the scenario. Fails when the scenario does not fit
/// the program.
Result<void> StartScenario(const Scenario& scenario, vm::Object object, Controller* controller);

/// Writes the values to the variable `name`, an array's to its first elements. Gives all the
/// variables that the name stands for; fails when it stands for something else, for fewer than
/// there are values, or a value does not fit.
Result<std::vector<Quantity>> SetVariable(const InitialValue& initial, const std::string& name,
                                          Controller* controller);

/// The boundary of profile cycles at which something of an instant happens: the first that is not
/// before it.
int64_t CycleOf(const Scenario& scenario, int64_t microseconds);

}  // namespace oncard::runtime
