// Internal to gtcalls: common parts of the commands of axes and profiles: finding them, the
// refusals that all motion modes share, reading values of several axes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "gtcalls/card.h"
#include "gtcalls/gts/commands/commands.h"
#include "gtcalls/gts/limits.h"
#include "motion/motion_core.h"

namespace oncard::gtcalls::gts {

/// The axis, profile, encoder ... that argument `index` numbers, counted from 0.
inline size_t NumberOf(const Call& call, size_t index = 0) {
  return static_cast<size_t>(call.integer(index) - 1);
}
/// The profile and the axis, to read.
inline const motion::Profile& ProfileOf(const Call& call) {
  return call.card.motion.profile(NumberOf(call));
}
inline const motion::Axis& AxisOf(const Call& call) {
  return call.card.motion.axis(NumberOf(call));
}
/// The same to command it.
inline motion::ProfileHandle ProfileAt(const Call& call) {
  return call.card.motion.ProfileAt(NumberOf(call));
}
inline motion::AxisHandle AxisAt(const Call& call) {
  return call.card.motion.AxisAt(NumberOf(call));
}

/// 0, or 1 with the reason when the profile moves.
int16_t CheckAtRest(Call& call, size_t profile);
/// 0, or 1 with the reason when a profile that the axis maps moves.
int16_t CheckAxisAtRest(Call& call, size_t axis);
/// 0, or 1 with the reason when the profile is in another mode.
int16_t CheckMode(Call& call, size_t profile, motion::ProfileMode mode);
/// Both, for commands that set up a mode.
int16_t CheckModeAtRest(Call& call, size_t profile, motion::ProfileMode mode);
/// GT_PrfTrap and similar commands: selects a mode for a profile at rest that no coordinate system
/// uses.
int16_t ChooseMode(Call& call, size_t profile, motion::ProfileMode mode);

/// 0, or 1 with the reason when the axis is the slave of a gantry.
int16_t CheckNoGantrySlave(Call& call, size_t axis);
/// 0, or 1 with the reason while homing moves the axis.
int16_t CheckNotHoming(Call& call, size_t axis);

/// 0, or 1 with the reason when an axis of the profile may not start to move in `direction` (its
/// sign; 0: not known): a stop input or alarm is latched, or the limit in that direction is.
int16_t CheckMayStart(Call& call, size_t profile, double direction);

/// GT_PrfGear, GT_PrfFollow: 1 with the reason when the profile is in `mode` with another
/// direction.
int16_t CheckDirection(Call& call, motion::ProfileMode mode, int present, int wanted);

/// Arguments 1 to 3 of GT_SetGearMaster and GT_SetFollowMaster. Empty, with the reason recorded,
/// when the card has no such master or it is the slave itself: refuse with 7.
std::optional<motion::Master> ReadMasterArguments(Call& call);
/// The same as outputs of GT_GetGearMaster and GT_GetFollowMaster; index 0: none has been set.
void SetMasterOutputs(const Call& call, const motion::Master& master);

/// The profiles that argument 0, a mask, selects; those the card does not have are left out. Empty,
/// with the reason recorded, when none is selected: refuse with 1.
std::vector<size_t> SelectedProfiles(Call& call);

/// Writes `value(n)` for argument `count` consecutive numbers from argument 0 on to the cells of
/// argument 1, and the clock to argument 3: the form of GT_GetPrfPos and similar commands.
template <typename Value>
int16_t ReadEach(const Call& call, Value value) {
  for (int i = 0; i < call.integer(2); ++i) {
    const auto cell = static_cast<size_t>(i);
    call.Set(1, value(NumberOf(call) + cell), cell);
  }
  if (call.arguments.size() > 3) call.Set(3, UnsignedLong(call.card.motion.ClockMs()));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
