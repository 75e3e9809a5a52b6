// What the handles of a motion core work on (axis_handle.h, profile_handle.h ...): its state, and
// the lanes that may hold newer values of it.
//
// lane_uses.h decides how a handle writes. What lanes neither hold nor read is written to `state`,
// and the card stays in its lanes; everything else is written to Changed(). A handle may be kept as
// long as its core, since it holds no values.
#pragma once

#include "motion/card_event.h"
#include "motion/common/sizes.h"
#include "motion/cycle_block.h"
#include "motion/motion_state.h"
#include "motion/readings.h"

namespace oncard::motion {

struct CoreParts {
  MotionState& state;
  const MotionConfig& config;
  const CardEventObserver& observer;
  CycleBlock& block;

  /// The state without lanes, to change any of it.
  MotionState& Changed() const {
    block.Leave();
    return state;
  }
  /// What follows from the state. Lanes may hold newer values, so they must be left before, unless
  /// they hold none of what is read.
  Readings readings() const { return {state, config}; }
  Micros now() const { return state.cycle * config.cycle_us; }
  size_t axis_count() const { return static_cast<size_t>(config.axis_count); }
};

}  // namespace oncard::motion
