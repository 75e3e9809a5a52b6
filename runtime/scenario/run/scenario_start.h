// Prepares the program of a scenario on a card: loads and binds it, sets its variables, and starts
// its threads. Tested by tests/runtime/scenario_run_test.cc.
#pragma once

#include <memory>

#include "base/result.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/scenario_errors.h"
#include "runtime/sim/controller.h"
#include "vm/object.h"
#include "vm/schedule.h"
#include "vm/scheduler.h"

namespace oncard::runtime {

/// Puts a controller that was made with CardOptions() and has just been switched on into the state
/// before the scenario's first statement: applies the world's initial state, binds every thread,
/// sets all values, then starts the threads in the order of the scenario. Anything that does not
/// fit the program is added to `errors` and skipped. Fails if the program cannot be loaded or has
/// no function.
Result<void> StartScenario(const Scenario& scenario, vm::Object object, Controller* controller,
                           ScenarioErrors* errors);

/// The same for a caller without checks of its own: also fails if anything does not fit.
Result<void> StartScenario(const Scenario& scenario, vm::Object object, Controller* controller);

/// Which of the program's functions has this name, from 0. Fails with the names that there are.
Result<int> FunctionIndex(const std::string& name, const vm::Image& image);

/// The policy that replays a schedule. Fails if it was recorded with another program.
Result<vm::Policy> FollowSchedule(std::shared_ptr<const vm::Schedule> schedule,
                                  const vm::Image& image);

/// Writes the values to the variable `name`, or to the first elements of an array. Returns all
/// quantities to which the name refers; fails if it is not a variable, has fewer elements than
/// there are values, or a value does not fit. Of a choice it writes the smallest value; the largest
/// one must fit, too, and an array has no choice.
Result<std::vector<Quantity>> SetVariable(const InitialValue& initial, const std::string& name,
                                          Controller* controller);

}  // namespace oncard::runtime
