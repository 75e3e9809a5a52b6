// The senses of inputs and encoders as words of bits, which several families write in the same way.
// Tested by tests/gtcalls/digital_io_command_test.cc, encoder_command_test.cc; axis_command_test.cc
// and capture_command_test.cc of tests/gtcalls/ge and tests/gtcalls/gt400.
#pragma once

#include <cstddef>
#include <cstdint>

#include "motion/motion_core.h"

namespace oncard::gtcalls {

/// Bits 2n and 2n + 1: the positive and the negative limit switch of axis n, from 0, act at the low
/// level.
void InvertLimits(uint32_t sense, motion::MotionCore& core);

/// Bit n reverses encoder `first` + n, for `count` encoders, as far as the card has them.
void ReverseEncoders(uint32_t sense, size_t first, size_t count, motion::MotionCore& core);

/// Bit n: the capture of axis n, from 0, takes the rising edge of its home switch, else the falling
/// one.
void ChooseHomeEdges(uint32_t sense, motion::MotionCore& core);

}  // namespace oncard::gtcalls
