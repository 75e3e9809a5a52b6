// How GT_GetPrfMode numbers the modes of a profile. Source: GTS manual, GT_GetPrfMode.
// Tested by tests/gtcalls/position_command_test.cc.
#pragma once

#include <algorithm>
#include <array>

#include "motion/profiles/modes.h"

namespace oncard::gtcalls::gts {

/// The modes in the order of their numbers, which count from 0.
inline constexpr std::array kModes = {motion::ProfileMode::kTrap,   motion::ProfileMode::kJog,
                                      motion::ProfileMode::kPt,     motion::ProfileMode::kGear,
                                      motion::ProfileMode::kFollow, motion::ProfileMode::kCrd,
                                      motion::ProfileMode::kPvt};

/// The number of one of them.
constexpr int ModeNumber(motion::ProfileMode mode) {
  return static_cast<int>(std::ranges::find(kModes, mode) - kModes.begin());
}

}  // namespace oncard::gtcalls::gts
