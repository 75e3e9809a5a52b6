// The status word of an axis (GT_GetSts) and its mode register (GT_GetMode). The only place that
// knows their bits. Source: GT manual tables 4-14 and 4-15. Tested by
// tests/gtcalls/gt400/axis_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "motion/profiles/modes.h"

namespace oncard::gtcalls::gt400 {

/// The events of a status word: they stay until they are cleared.
enum EventBit : uint8_t {
  kCompleteBit = 1u << 0,    ///< a motion has ended
  kAlarmEventBit = 1u << 1,  ///< the alarm input has become active
  kBreakpointBit = 1u << 2,
  kCapturedBit = 1u << 3,
  kMotionErrorBit = 1u << 4,  ///< the position error has exceeded its limit
  kPositiveLimitEventBit = 1u << 5,
  kNegativeLimitEventBit = 1u << 6,
  kRefusedBit = 1u << 7,  ///< a command has been refused
};

/// The axis counts from 0.
uint32_t StatusWord(const CardView& card, size_t axis);
uint16_t ModeRegister(const CardView& card, size_t axis);
/// The modes as the mode register numbers them: 0 T, 1 velocity, 2 S, 3 gear, 5 coordinated.
int ModeNumber(motion::ProfileMode mode);

}  // namespace oncard::gtcalls::gt400
