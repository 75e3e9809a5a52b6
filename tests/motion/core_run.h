// Runs a motion core by hand: for tests of its mechanics.
#pragma once

#include <memory>
#include <utility>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

namespace oncard::motion {

/// The profile of axis 1 jogs from now on.
inline void Jog(MotionCore& core, double velocity) {
  Profile& profile = ChangeState(core).profiles[0];
  profile.mode = ProfileMode::kJog;
  profile.jog.velocity = velocity;
  profile.Start(core.now());
}

inline void Ticks(MotionCore& core, int count) {
  for (int i = 0; i < count; ++i) core.Tick();
}

/// The events of the world, which begin with the power-on.
inline void Happen(MotionCore& core, WorldEvents events) {
  core.PowerOn(std::make_shared<const WorldEvents>(std::move(events)));
}

}  // namespace oncard::motion
