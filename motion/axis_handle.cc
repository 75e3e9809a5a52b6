#include "motion/axis_handle.h"

#include <algorithm>
#include <utility>

#include "motion/bus_axes.h"
#include "motion/drive_train.h"
#include "motion/origins.h"
#include "motion/profile_handle.h"

namespace oncard::motion {

// --- Drive, stops, conditions ------------------------------------------------------------------

void AxisHandle::ServoOn() const {
  MotionState& state = core_.Changed();
  if (OnBus()) {
    BusAxes(state, core_.config).Enable(index_, true);
  } else {
    axis().servo_on = true;
    RestartDrive();
  }
  state.io.Write(DoType::kEnable, EnableOutputs(), ~uint32_t{0});
}

void AxisHandle::ServoOff() const {
  MotionState& state = core_.Changed();
  axis().servo_on = false;
  if (OnBus()) BusAxes(state, core_.config).Enable(index_, false);
  DriveTrain(state, core_.config).Disable(index_);
  if (state.shapers) (*state.shapers)[index_].Restart(core_.readings().Unshaped(index_));
  state.io.Write(DoType::kEnable, EnableOutputs(), 0);
  StopProfiles(true);
}

void AxisHandle::RestartDrive() const {
  MotionState& state = core_.Changed();
  // A controller begins at rest, where the axis is.
  if (core_.config.defaults.enabling_aligns && core_.readings().InClosedLoop(index_)) {
    Origins(state, core_.config).AlignWithEncoder(index_);
  }
  DriveTrain(state, core_.config).Enable(index_);
}

void AxisHandle::SetClosedLoop(bool closed) const {
  DriveTrain(core_.Changed(), core_.config).SetClosedLoop(index_, closed);
}

void AxisHandle::ClearStatus() const {
  MotionState& state = core_.Changed();
  if (OnBus()) BusAxes(state, core_.config).ResetFault(index_);
  const Readings present = core_.readings();
  uint32_t& latched = axis().latched;
  const uint32_t error = present.FollowingErrorExceeded(index_) ? latched & kFollowingErrorBit : 0;
  latched = present.ActiveCauses(axis()) | error;
}

void AxisHandle::ClearConditions(uint32_t conditions) const {
  Axis& cleared = core_.Changed().axes[index_];
  cleared.latched &= ~conditions | core_.readings().ActiveCauses(cleared);
}

void AxisHandle::LatchConditions(uint32_t conditions) const {
  Axis& latching = core_.Changed().axes[index_];
  latching.latched = conditions | core_.readings().ActiveCauses(latching);
}

void AxisHandle::Stop(bool abrupt) const {
  ProfileHandle(core_, index_).Stop(abrupt);
  if (core_.readings().IsGantrySlave(index_)) StopProfiles(abrupt);
}

void AxisHandle::StopProfiles(bool abrupt) const {
  ForEachBit(axis().profile_map, core_.axis_count(),
             [&](size_t profile) { ProfileHandle(core_, profile).Stop(abrupt); });
}

void AxisHandle::StopProfilesAtLimit() const {
  ForEachBit(axis().profile_map, core_.axis_count(), [&](size_t profile) {
    const bool smooth = std::ranges::any_of(core_.state.crds, [&](const Crd& crd) {
      return crd.limit_stop.smooth && crd.Drives(profile);
    });
    if (!core_.state.profiles[profile].HoldAtLimit()) ProfileHandle(core_, profile).Stop(!smooth);
  });
}

uint32_t AxisHandle::EnableOutputs() const {
  const auto& followed = core_.state.enable_axes;
  uint32_t outputs = 0;
  for (size_t i = 0; i < followed.size(); ++i) {
    if (followed[i] == static_cast<int8_t>(index_)) outputs |= uint32_t{1} << i;
  }
  return outputs;
}

// --- Positions ---------------------------------------------------------------------------------

void AxisHandle::SynchPosition() const { Origins(core_.Changed(), core_.config).SynchAxis(index_); }

void AxisHandle::ZeroPosition() const { Origins(core_.Changed(), core_.config).ZeroAxis(index_); }

void AxisHandle::SetProfileScale(Scale scale) const {
  Origins(core_.Changed(), core_.config).SetProfileScale(index_, scale);
}

void AxisHandle::SetEncoderScale(Scale scale) const {
  Origins(core_.Changed(), core_.config).SetEncoderScale(index_, scale);
}

void AxisHandle::SetProfileVelocityFilter(int16_t exponent) const {
  AxisValue& planned = core_.Changed().axes[index_].profile;
  planned.filter.Set(exponent, planned.velocity);
}

void AxisHandle::SetEncoderVelocityFilter(int16_t exponent) const {
  AxisValue& measured = core_.Changed().axes[index_].encoder;
  measured.filter.Set(exponent, measured.velocity);
}

// --- Inputs, limits, in-position band ----------------------------------------------------------

void AxisHandle::SetSoftLimits(int32_t positive, int32_t negative) const {
  Axis& limited = core_.Changed().axes[index_];
  limited.soft_positive = positive;
  limited.soft_negative = negative;
}

void AxisHandle::SetBand(int32_t band, Micros time) const {
  Axis& judged = core_.Changed().axes[index_];
  judged.band = band;
  judged.band_time = time;
  judged.band_set = true;
}

// --- Configuration -----------------------------------------------------------------------------

void AxisHandle::SetInputs(const AxisInputs& inputs) const {
  Axis& listening = core_.Changed().axes[index_];
  listening.alarm = inputs.alarm;
  listening.positive_limit = inputs.positive_limit;
  listening.negative_limit = inputs.negative_limit;
  listening.smooth_stop = inputs.smooth_stop;
  listening.abrupt_stop = inputs.abrupt_stop;
}

void AxisHandle::SetMaps(const AxisMaps& maps) const {
  Axis& mapping = core_.Changed().axes[index_];
  const bool same = maps.profiles == mapping.profile_map && maps.encoders == mapping.encoder_map &&
                    maps.profile_scale == mapping.profile_scale &&
                    maps.encoder_scale == mapping.encoder_scale;
  if (same) return;
  mapping.profile_map = maps.profiles;
  mapping.encoder_map = maps.encoders;
  mapping.profile_scale = maps.profile_scale;
  mapping.encoder_scale = maps.encoder_scale;
  SynchPosition();
}

// --- What is added to the command --------------------------------------------------------------

void AxisHandle::SetBacklash(const Backlash& backlash) const {
  MotionState& state = core_.Changed();
  state.compensations[index_].SetBacklash(backlash);
  state.compensates = true;
}

void AxisHandle::SetPitchTable(PitchTablePointer table) const {
  core_.Changed().compensations[index_].pitch_table = std::move(table);
}

void AxisHandle::EnablePitchCompensation(bool on) const {
  MotionState& state = core_.Changed();
  state.compensations[index_].pitch_on = on;
  state.compensates = true;
}

void AxisHandle::SetInputShaper(size_t count, double k) const {
  auto& shapers = core_.Changed().shapers;
  if (!shapers) {
    if (count == 0) return;
    shapers.Emplace();
  }
  (*shapers)[index_].Set(count, k, core_.readings().Unshaped(index_));
  if (std::ranges::none_of(*shapers, &InputShaper::on)) shapers.Reset();
}

}  // namespace oncard::motion
