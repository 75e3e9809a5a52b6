#include "motion/origins.h"

#include <bit>

namespace oncard::motion {

void Origins::ShiftSlaves(const Master& master, double shift) {
  for (Profile& profile : state_.profiles) {
    if (const Master* followed = profile.FollowedMaster();
        followed == nullptr || !(*followed == master)) {
      continue;
    }
    profile.ShiftMaster(shift);
  }
}

void Origins::SetProfilePosition(size_t profile, double position) {
  ShiftSlaves({true, MasterType::kProfile, static_cast<uint8_t>(profile), false},
              position - state_.profiles[profile].now.position);
  state_.profiles[profile].SetPosition(position);
  for (Axis& axis : state_.axes) {
    if ((axis.profile_map >> profile & 1) == 0) continue;
    axis.profile.offset = axis.profile.position - readings_.MappedProfiles(axis);
  }
}

void Origins::SetEncoderPosition(size_t encoder, double position) {
  ShiftSlaves({true, MasterType::kEncoder, static_cast<uint8_t>(encoder), false},
              position - state_.encoders[encoder].position);
  state_.encoders[encoder].position = position;
  for (Axis& axis : state_.axes) {
    if ((axis.encoder_map >> encoder & 1) == 0) continue;
    axis.encoder.offset = axis.encoder.position - readings_.MappedEncoders(axis);
  }
}

void Origins::SynchAxis(size_t index) {
  Axis& axis = state_.axes[index];
  const double before = axis.profile.position;
  axis.encoder.offset = 0;
  const double measured = readings_.MappedEncoders(axis);
  if (readings_.IsGantrySlave(index)) {
    // It uses the profiles of its master: its planned position changes by as much as its measured
    // one, so that the beam does not move.
    MoveAxis(index, axis.profile.position + (measured - axis.encoder.position));
  } else {
    axis.profile.offset = 0;
    MovePlanned(index, readings_.MappedProfiles(axis));
  }
  state_.compensations[index].MoveOrigin(before, axis.profile.position);
  RenameShaped(index);
  MoveMeasured(index, measured);
}

void Origins::ZeroAxis(size_t axis) {
  EndShaping(axis);
  SetProfilePosition(axis, 0);
  SetEncoderPosition(axis, 0);
  SynchAxis(axis);
  Compensation& compensation = state_.compensations[axis];
  if (readings_.IsGantrySlave(axis)) {
    compensation.MoveOrigin(state_.axes[axis].profile.position, 0);
    MoveAxis(axis, 0);
  }
  // The position that is set to 0 includes the current compensation.
  const double amount = compensation.Amount();
  compensation.origin += amount;
  drives_.Keep(axis, amount);
  RenameShaped(axis);
}

void Origins::SetProfileScale(size_t axis, Scale scale) {
  const double before = state_.axes[axis].profile.position;
  state_.axes[axis].profile_scale = scale;
  state_.axes[axis].profile.offset = 0;
  MovePlanned(axis, readings_.MappedProfiles(state_.axes[axis]));
  state_.compensations[axis].MoveOrigin(before, state_.axes[axis].profile.position);
  RenameShaped(axis);
  if (!state_.gantry.on || state_.gantry.master != axis) return;
  Axis& follower = state_.axes[state_.gantry.slave];
  follower.profile_scale = scale;
  follower.profile.offset = follower.profile.position - readings_.MappedProfiles(follower);
}

void Origins::SetEncoderScale(size_t axis, Scale scale) {
  state_.axes[axis].encoder_scale = scale;
  state_.axes[axis].encoder.offset = 0;
  MoveMeasured(axis, readings_.MappedEncoders(state_.axes[axis]));
}

void Origins::MoveMeasured(size_t index, double position) {
  AxisValue& value = state_.axes[index].encoder;
  const double shift = position - value.position;
  ShiftSlaves({true, MasterType::kAxis, static_cast<uint8_t>(index), true}, shift);
  // Only position values change, not the mechanics, so the skew must not change.
  Gantry& gantry = state_.gantry;
  if (gantry.on && gantry.slave == index) gantry.skew_origin += shift;
  if (gantry.on && gantry.master == index) gantry.skew_origin -= shift;
  value.position = position;
}

void Origins::MovePlanned(size_t index, double position) {
  ShiftSlaves({true, MasterType::kAxis, static_cast<uint8_t>(index), false},
              position - state_.axes[index].profile.position);
  AxisValue& value = state_.axes[index].profile;
  drives_.Keep(index, value.position - position);
  value.position = position;
}

void Origins::MoveAxis(size_t index, double position) {
  Axis& axis = state_.axes[index];
  MovePlanned(index, position);
  axis.profile.offset = position - readings_.MappedProfiles(axis);
}

void Origins::RenameShaped(size_t index) {
  if (!state_.shapers) return;
  InputShaper& shaper = (*state_.shapers)[index];
  if (shaper.on()) shaper.Rename(readings_.Unshaped(index).position);
}

void Origins::EndShaping(size_t index) {
  if (readings_.ShaperSettled(index)) return;
  InputShaper& shaper = (*state_.shapers)[index];
  drives_.Keep(index, shaper.addition.position);
  shaper.Restart(readings_.Unshaped(index));
}

void Origins::KeepPlanned(size_t index) {
  Axis& axis = state_.axes[index];
  axis.profile.offset = axis.profile.position - readings_.MappedProfiles(axis);
}

void Origins::AlignWithEncoder(size_t index) {
  EndShaping(index);
  Axis& axis = state_.axes[index];
  // The measured position includes the compensation.
  const double measured = axis.encoder.position - state_.compensations[index].Amount();
  const uint32_t map = axis.profile_map & ((uint32_t{1} << axis_count_) - 1);
  if (std::has_single_bit(map) && !readings_.IsGantrySlave(index)) {
    // The position of the axis' own profile is set too, so that both agree as after
    // GT_SynchAxisPos.
    const auto profile = static_cast<size_t>(std::countr_zero(map));
    const Scale& scale = axis.profile_scale;
    SetProfilePosition(profile, measured * scale.alpha / scale.beta);
  }
  MoveAxis(index, measured);
  RenameShaped(index);
}

}  // namespace oncard::motion
