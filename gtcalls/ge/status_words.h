// The status word of an axis (GT_GetSts) and its mode register (GT_GetMode). The only place that
// knows their bits. Source: GE manual tables 4-2 to 4-4. Tested by
// tests/gtcalls/ge/axis_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "motion/profiles/modes.h"

namespace oncard::gtcalls::ge {

/// The events of a status word: they stay until they are cleared.
inline constexpr uint32_t kEventBits = 0xFF;
inline constexpr uint32_t kCapturedBit = 1u << 3;
inline constexpr uint32_t kRefusedBit = 1u << 7;

/// The conditions that the motion core latches for these bits.
uint32_t ConditionsOf(uint32_t bits);

}  // namespace oncard::gtcalls::ge

namespace oncard::gtcalls::gep {

/// The status word of a point-to-point card; the axis counts from 0.
uint32_t StatusWord(const CardView& card, size_t axis);
/// The mode register.
uint16_t ModeRegister(const CardView& card, size_t axis);
/// The modes as the mode register numbers them: 0 T, 1 velocity, 2 S.
int ModeNumber(motion::ProfileMode mode);

}  // namespace oncard::gtcalls::gep

namespace oncard::gtcalls::ges {

/// The status word of an axis of a path card.
uint32_t StatusWord(const CardView& card, size_t axis);
/// The status word of the path (GT_GetCrdSts).
uint16_t PathStatusWord(const CardView& card);

}  // namespace oncard::gtcalls::ges
