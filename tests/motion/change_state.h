// The state of a motion core, to arrange what only the surroundings or the past of a card would
// bring about.
#pragma once

#include "motion/motion_core.h"

namespace oncard::motion {

/// Takes the card out of its lanes. The reference lasts until the card advances.
inline MotionState& ChangeState(MotionCore& core) {
  core.Restore(core.state());
  // The core is not const.
  return const_cast<MotionState&>(core.state());
}

}  // namespace oncard::motion
