// The card of a scenario in its surroundings, for runs of scenarios and for host programs.
// Tested by tests/runtime/scenario_world_test.cc.
#pragma once

#include "runtime/scenario/file/scenario.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// The family of the card: that of its name, without one the first.
const gtcalls::Family& FamilyOf(const Scenario& scenario);

/// The card a scenario describes: its family, size, cycle and rate.
ControllerOptions CardOptions(const Scenario& scenario);

/// Puts a controller that was made with CardOptions() and has just been switched on into the
/// scenario's surroundings. Times count from power-on.
void ApplyWorld(const Scenario& scenario, Controller* controller);

/// True if time or the card matters: the program calls GT commands, a thread is periodic, the
/// scenario ends at an instant, or an expectation has an instant or a tolerance.
bool NeedsCard(const Scenario& scenario, const vm::Object& object);

}  // namespace oncard::runtime
