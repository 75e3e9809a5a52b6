// What an axis and its drive have to do with each other on cards that put out voltages or pulses,
// as the host chooses for each axis. Tested by axis_command_test.cc and servo_command_test.cc of
// tests/gtcalls/ge and tests/gtcalls/gt400.
#pragma once

#include <cstddef>
#include <cstdint>

#include "motion/motion_core.h"

namespace oncard::gtcalls {

/// True if the card can put out voltages.
bool HasVoltages(const motion::MotionCore& core);

/// The drive of an axis takes a voltage, which is that of a servo controller unless the loop is
/// open, or pulses.
void SwitchOutput(size_t axis, bool analogue, bool open_loop, motion::MotionCore& core);

/// The following error counts in closed loop only: to be called when the limit or the loop changes.
void LimitFollowingError(size_t axis, uint16_t limit, motion::MotionCore& core);

/// Sets the planned and the actual position of an axis at rest; the machine stays.
void PlaceAxisAt(size_t axis, int32_t position, motion::MotionCore& core);

}  // namespace oncard::gtcalls
