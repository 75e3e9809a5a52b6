// What the surroundings that a scenario describes are to the motion core of a card: their state at
// power-on, and the events that follow.
// Tested by tests/runtime/scenario_world_test.cc.
#pragma once

#include <cstdint>

#include "motion/motion_core.h"
#include "runtime/scenario/world/bus_setup.h"
#include "runtime/scenario/world/world_setup.h"

namespace oncard::runtime {

/// Puts the surroundings of a core that has just been switched on into their state at power-on.
void SetUpWorld(const World& world, const BusSetup& bus, motion::MotionCore& core);

/// The events that follow, in order of time; for a card with this profile cycle.
motion::WorldEvents EventsOf(const World& world, const BusSetup& bus, int64_t cycle_us);

}  // namespace oncard::runtime
