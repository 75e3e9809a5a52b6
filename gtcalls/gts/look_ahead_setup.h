// What a GTS card keeps for the multi-axis look-ahead of a coordinate system beside its planners
// (motion/paths/path_planner.h): the settings that the next initialisation uses, and the rules for
// the order of commands. Units as the commands have them: mm, mm/s, mm/s^2. Source: manual of the
// multi-axis look-ahead module, chapter 2. Tested by tests/gtcalls/look_ahead_command_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/paths/crd.h"

namespace oncard::gtcalls::gts {

/// LA_AXIS_NUM: the axes of the planner, and the profiles that can follow.
inline constexpr size_t kLookAheadAxes = 8;

/// EMachineMode.
enum class MachineMode : uint8_t { kThreeAxes, kMultiAxes, kFiveAxes, kFiveAxesWork };

/// A profile that may follow segments (GT_SetFollowAxisParaLa).
struct FollowSettings {
  bool follows = false;
  double velocity = 0;
  double acceleration = 0;
  double jump = 0;  ///< mm/s^2, times the time constant

  auto Fields(auto visit) const { return visit(follows, velocity, acceleration, jump); }
};

/// One buffer, while it has a planner.
struct LookAheadBuffer {
  bool in_pulses = false;     ///< GT_InitLookAheadPara: the commands are those in pulses
  double scale = 1;           ///< pulse/mm
  bool awaits_start = false;  ///< after GT_CrdDataEx: the next command only makes a start point
  bool has_start = false;     ///< a segment has made the start point where the next one begins
  int16_t auxiliaries = 0;    ///< commands without motion in a row
  bool numbered = false;      ///< GT_SetUserSegNumEx has been called
  int32_t number = 0;

  auto Fields(auto visit) const {
    return visit(in_pulses, scale, awaits_start, has_start, auxiliaries, numbered, number);
  }
};

struct LookAheadSetup {
  bool established = false;
  MachineMode mode = MachineMode::kThreeAxes;
  std::array<uint8_t, kLookAheadAxes> axis_limits{};  ///< AXIS_LIMIT_... of each axis
  uint32_t length_axes = 0xFF;                        ///< GT_SetAxisVelValidModeLa
  bool geometric = true;                              ///< GT_SetWorkLimitModeLa
  std::array<FollowSettings, kLookAheadAxes> followers;
  std::array<LookAheadBuffer, motion::kCrdFifoCount> buffers;

  bool five_axes() const { return mode >= MachineMode::kFiveAxes; }
  bool in_use() const { return established; }
  auto Fields(auto visit) const {
    return visit(established, mode, axis_limits, length_axes, geometric, followers, buffers);
  }
};

}  // namespace oncard::gtcalls::gts
