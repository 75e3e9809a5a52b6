// What the surroundings that a scenario describes are to the motion core of a card: their state at
// power-on, and the events that follow.
// Tested by tests/runtime/scenario_world_test.cc.
#pragma once

#include <vector>

#include "motion/motion_core.h"
#include "runtime/scenario/world/bus_setup.h"
#include "runtime/scenario/world/world_setup.h"
#include "runtime/sim/card_clock.h"
#include "runtime/sim/reactions.h"

namespace oncard::runtime {

/// Puts the surroundings of a core that has just been switched on into their state at power-on.
void SetUpWorld(const World& world, const BusSetup& bus, const CardClock& clock,
                motion::MotionCore& core);

/// The events that follow, in order of time, in the time of the core.
motion::WorldEvents EventsOf(const World& world, const BusSetup& bus, const CardClock& clock);

/// What the surroundings do when the card does something.
std::vector<Reactions::Reaction> ReactionsOf(const World& world);

/// Lets the surroundings go on when the clock has been changed: their velocities and times outside
/// are others in the time of the core. A motor that is turned by hand meanwhile turns on for as
/// long as before, but comes to another place.
void FollowClock(const World& world, const BusSetup& bus, const CardClock& clock,
                 motion::MotionCore& core);

}  // namespace oncard::runtime
