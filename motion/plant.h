// The machine: motors and what they drive, one for each drive connector of the card. Part of the
// world around the card: GT_Reset leaves it alone.
//
// An ideal drive follows an enabled axis exactly, whether it is commanded by pulses or, in closed
// loop, through the servo controller. A velocity drive turns the voltage of its analogue output
// into a speed with a first-order lag; pulses do not reach it.
// Tested by tests/motion/plant_test.cc.
#pragma once

#include <cstdint>
#include <tuple>

#include "motion/sizes.h"

namespace oncard::motion {

/// Servo sub-steps have this length; every profile cycle is a whole number of them.
inline constexpr int64_t kServoUs = 125;
inline constexpr double kServoMs = static_cast<double>(kServoUs) / 1000;

/// The motor's state.
struct Plant {
  double position = 0;  ///< pulses since power-on
  double velocity = 0;  ///< pulse/ms
  /// Distance to the planned axis position while the drive follows it.
  double lead = 0;
  bool stalled = false;  ///< held by force: does not move, whatever the drive does

  auto Fields() const { return std::tie(position, velocity, lead, stalled); }
};

}  // namespace oncard::motion
