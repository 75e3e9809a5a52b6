// Internal to gtcalls: common parts of the commands of the multi-axis look-ahead, which have codes
// of their own. Their rows name no ranges, as a value out of range gives 107 and not 7.
// Tested by tests/gtcalls/look_ahead_command_test.cc.
#pragma once

#include <cstdint>
#include <string_view>

#include "gtcalls/gts/commands/crd_support.h"
#include "gtcalls/gts/gts_state.h"

namespace oncard::gtcalls::gts {

/// Codes of the module (manual of the multi-axis look-ahead, chapter 2). 101 and 106 cannot happen:
/// no library has to be loaded, and 105 comes before 106.
inline constexpr int16_t kSamePoint = 102;
inline constexpr int16_t kNotEstablished = 103;
inline constexpr int16_t kNotInitialised = 104;
inline constexpr int16_t kNoFiveAxisLibrary = 105;
inline constexpr int16_t kLookAheadParameter = 107;
inline constexpr int16_t kPlatformRefuses = 110;

/// Assumption: the largest window, segments. The manual recommends 200.
inline constexpr int kWindowMax = 32766;
/// Auxiliary commands in a row (manual, chapter 1).
inline constexpr int16_t kAuxiliaryMax = 16;

/// The settings of the coordinate system that argument 0 numbers, which must be in range.
LookAheadSetup& SetupOf(const Call& call);
/// The state of the command's buffer.
LookAheadBuffer& BufferOf(const Call& call);

/// 107 with the reason: an argument or a member is out of range.
int16_t RefuseParameter(Call& call, std::string_view name, double value, std::string_view range);
/// 0, or 107 with the reason unless the value is a whole number in the range.
int16_t CheckWhole(Call& call, std::string_view name, double value, double first, double last);
/// 0, or 107 with the reason unless low <= value < high.
int16_t CheckSize(Call& call, std::string_view name, double value, double low, double high);

/// 0, or 107 with the reason when argument 0 is no coordinate system, or the command's `fifo` no
/// FIFO.
int16_t CheckNumbers(Call& call);
/// The same, 103 before GT_SetupLookAheadCrd, and 110 without a coordinate system.
int16_t CheckEstablished(Call& call);
/// The same, 104 before GT_InitLookAheadEx, and 107 if the buffer takes commands in pulses.
int16_t CheckInitialised(Call& call);
/// 0, or 107 with the reason when there have been too many auxiliary commands in a row.
int16_t CheckAuxiliaries(Call& call);
/// 0, or 110 with the reason while a look-ahead of the command's buffer holds segments.
int16_t CheckDrained(Call& call);

}  // namespace oncard::gtcalls::gts
