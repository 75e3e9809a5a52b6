// The card's sizes for motion programs. Source: GTS manual 10.2, 10.3.5 and 10.4.1, unless noted.
#pragma once

#include <cstdint>

namespace oncard::vm {

inline constexpr int kThreadCount = 32;
inline constexpr int kPageCount = 32;
/// Slots of one data page, and of the globals; one slot holds one int or one double.
inline constexpr int kSlotCount = 1024;
/// GT_Download refuses more (manual chapter 13, GT_Download, return value 7).
inline constexpr int kFunctionMax = 32;
/// TVarInfo.name holds 32 characters with the terminating NUL.
inline constexpr int kNameLengthMax = 31;
/// A jump's displacement is a signed 16-bit word of the object file.
inline constexpr int kInstructionMax = 32767;
/// Assumption: the manual gives no limit.
inline constexpr int kParameterMax = 32;
/// Assumption: the manual gives no limit.
inline constexpr int kLabelMax = 1024;
/// Assumption: the manual gives no limit.
inline constexpr int kMacroMax = 1024;
/// Operand flags of a record are bits of one word, and the command number is operand 0.
inline constexpr int kCommandArgumentMax = 15;

}  // namespace oncard::vm
