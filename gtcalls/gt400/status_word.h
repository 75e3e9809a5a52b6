// The status word of an axis (GT_GetSts), whose bits 0 to 7 are events (events.h), and its mode
// register (GT_GetMode). The only place that knows their other bits. Source: GT manual tables 4-14
// and 4-15. Tested by tests/gtcalls/gt400/axis_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "motion/profiles/modes.h"

namespace oncard::gtcalls::gt400 {

/// The axis counts from 0.
uint32_t StatusWord(const CardView& card, size_t axis);
uint16_t ModeRegister(const CardView& card, size_t axis);
/// The modes as the mode register numbers them: 0 T, 1 velocity, 2 S, 3 gear, 5 coordinated.
int ModeNumber(motion::ProfileMode mode);

}  // namespace oncard::gtcalls::gt400
