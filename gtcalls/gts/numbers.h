// The numbers by which GTS commands name words of inputs and outputs (MC_...), and modes, stages
// and errors of homing (HOME_...), for what the motion core names. Source: the public header's
// constants. Tested by tests/gtcalls/numbers_test.cc.
#pragma once

#include <cstdint>
#include <optional>

#include "motion/homing.h"
#include "motion/io/digital_io.h"

namespace oncard::gtcalls {

/// MC_MPG, the last input word, from 0; and MC_ENABLE and MC_GPO, the first and the last output
/// word.
inline constexpr int kInputWordLast = 6;
inline constexpr int kOutputWordFirst = 10;
inline constexpr int kOutputWordLast = 12;

/// The input word of MC_LIMIT_POSITIVE ... MC_MPG; empty for other numbers.
std::optional<motion::DiType> DiTypeOf(int number);
/// The output word of MC_ENABLE, MC_CLEAR, MC_GPO; empty for other numbers.
std::optional<motion::DoType> DoTypeOf(int number);

/// The homing of HOME_MODE_...; kNone for other numbers.
motion::HomeMode HomeModeOf(int number);
/// HOME_MODE_..., HOME_STAGE_..., HOME_ERROR_...; 0 for a mode kNone.
int HomeNumber(motion::HomeMode mode);
int HomeNumber(motion::HomeStage stage);
int HomeNumber(motion::HomeError error);

}  // namespace oncard::gtcalls
