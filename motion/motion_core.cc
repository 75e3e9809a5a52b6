// The order of a cycle, and what commands do to axes and profiles.
// Tested by tests/motion/motion_core_test.cc and axis_test.cc.
#include "motion/motion_core.h"

#include <bit>
#include <cmath>
#include <utility>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<MotionState> && kFieldsComplete<Profile> && kFieldsComplete<Plant> &&
              kFieldsComplete<WorldEvent> && kFieldsComplete<WorldProgress>);

/// Calls `function` with the number of every bit of `map` below `count`.
template <typename Function>
void ForEachBit(uint32_t map, size_t count, Function function) {
  for (map &= (uint32_t{1} << count) - 1; map != 0; map &= map - 1) {
    function(static_cast<size_t>(std::countr_zero(map)));
  }
}

}  // namespace

MotionCore::MotionCore(const MotionConfig& config) : config_(config) { Reset(); }

void MotionCore::Tick() {
  ApplyWorldEvents();
  state_.io.SampleInputs();
  for (Adc& adc : state_.adcs) adc.Sample();
  state_.io.AdvanceOutputs(config_.cycle_us);
  ++state_.cycle;
  ++state_.clock_cycle;
  AdvanceProfiles();
  MapProfiles();
  for (size_t i = 0; i < axis_count(); ++i) GuardAxis(i);
  if (state_.compensates) AdvanceCompensations();
  if (Observed()) {
    AdvanceObserved();
  } else {
    AdvanceMachine();
  }
  for (size_t i = 0; i < axis_count(); ++i) JudgeControl(state_.controls[i]);
  if (state_.gantry.on) JudgeGantry();
  for (size_t i = 0; i < axis_count(); ++i) JudgeAxis(i);
  if (state_.homing_runs) AdvanceHomings();
}

void MotionCore::Reset() {
  state_.clock_cycle = 0;
  state_.io.Reset(config_.defaults.filter_ticks);
  state_.pvt_tables.fill(nullptr);
  state_.crds = {};
  for (Crd& crd : state_.crds) {
    crd.smooth_stop = config_.defaults.smooth_stop;
    crd.abrupt_stop = config_.defaults.abrupt_stop;
  }
  ResetAxes();
  for (size_t i = 0; i < state_.enable_axes.size(); ++i) {
    state_.enable_axes[i] = static_cast<int8_t>(i);
  }
  state_.compensations.fill({});
  state_.compensates = false;
  ResetMachine();
  state_.capture.Reset();
  state_.compare.Reset();
  state_.gantry = {};
  state_.homing.fill({});
  state_.homing_runs = false;
  state_.reached.clear();
  LatchCauses();
}

void MotionCore::ResetAxes() {
  const CardDefaults& defaults = config_.defaults;
  for (size_t i = 0; i < kAxisMax; ++i) {
    Profile& profile = state_.profiles[i];
    profile = {};
    profile.smooth_stop = defaults.smooth_stop;
    profile.abrupt_stop = defaults.abrupt_stop;
    Axis& axis = state_.axes[i];
    axis = DefaultAxis(static_cast<int>(i));
    axis.alarm_on = defaults.alarm_on;
    axis.positive_limit_on = defaults.limits_on;
    axis.negative_limit_on = defaults.limits_on;
  }
}

int64_t MotionCore::ClockMs() const { return ClockUs() / 1000; }

// --- Steps of a tick ---------------------------------------------------------------------------

void MotionCore::AdvanceProfiles() {
  bool crd_slaves = false;
  for (size_t i = 0; i < axis_count(); ++i) {
    const Profile& profile = state_.profiles[i];
    if (!profile.now.moving || profile.driven) continue;
    if (FollowsCrd(profile)) {
      crd_slaves = true;
    } else {
      AdvanceProfile(i);
    }
  }
  for (Crd& crd : state_.crds) {
    if (crd.run.running) AdvanceCrd(crd);
  }
  if (!crd_slaves) return;
  for (size_t i = 0; i < axis_count(); ++i) {
    if (FollowsCrd(state_.profiles[i])) AdvanceProfile(i);
  }
}

void MotionCore::AdvanceProfile(size_t index) {
  if (state_.profiles[index].now.velocity == 0) return BeginProfile(index);
  SampleProfile(index);
}

void MotionCore::SampleProfile(size_t index) {
  Profile& profile = state_.profiles[index];
  if (const Master* master = profile.FollowedMaster(); master != nullptr) {
    profile.AdvanceSlave(ReadMaster(*master));
  } else {
    profile.Advance(now());
  }
}

void MotionCore::BeginProfile(size_t index) {
  Profile& profile = state_.profiles[index];
  const double begin = profile.now.position;
  SampleProfile(index);
  if (profile.now.position == begin) return;
  if (!LimitForbids(index, profile.now.position - begin)) return;
  // A motion that a latched limit would stop does not start.
  profile.now = {begin, 0, 0, true};
  Tell(HappeningKind::kHeldAtLimit, index, begin);
  StopProfile(index, true);
}

bool MotionCore::LimitForbids(size_t profile, double direction) const {
  for (size_t i = 0; i < axis_count(); ++i) {
    const Axis& axis = state_.axes[i];
    if (!axis.active || (axis.profile_map >> profile & 1) == 0) continue;
    const double along = axis.profile_scale.reverses() ? -direction : direction;
    if ((along > 0 && (axis.latched & kPositiveLimitBit) != 0) ||
        (along < 0 && (axis.latched & kNegativeLimitBit) != 0)) {
      return true;
    }
  }
  return false;
}

bool MotionCore::FollowsCrd(const Profile& profile) const {
  const Master* master = profile.FollowedMaster();
  if (master == nullptr || master->type == MasterType::kEncoder) return false;
  if (master->type == MasterType::kAxis && master->encoder_side) return false;
  const uint32_t profiles = master->type == MasterType::kProfile
                                ? uint32_t{1} << master->index
                                : state_.axes[master->index].profile_map;
  bool found = false;
  ForEachBit(profiles, axis_count(),
             [&](size_t i) { found = found || state_.profiles[i].mode == ProfileMode::kCrd; });
  return found;
}

MasterValue MotionCore::ReadMaster(const Master& master) const {
  switch (master.type) {
    case MasterType::kEncoder: {
      const Encoder& encoder = state_.encoders[master.index];
      return {encoder.position, encoder.velocity, encoder.acceleration};
    }
    case MasterType::kProfile: {
      const Sample& sample = state_.profiles[master.index].now;
      return {sample.position, sample.velocity, sample.acceleration};
    }
    case MasterType::kAxis:
      break;
  }
  const Axis& axis = state_.axes[master.index];
  if (!master.encoder_side) return PlannedAxis(axis);
  return {axis.encoder.position, axis.encoder.velocity, axis.encoder.acceleration};
}

MasterValue MotionCore::PlannedAxis(const Axis& axis) const {
  MasterValue sum;
  ForEachBit(axis.profile_map, axis_count(), [&](size_t profile) {
    const Sample& sample = state_.profiles[profile].now;
    sum.position += sample.position;
    sum.velocity += sample.velocity;
    sum.acceleration += sample.acceleration;
  });
  return {axis.profile_scale.Apply(sum.position) + axis.profile.offset,
          axis.profile_scale.Apply(sum.velocity), axis.profile_scale.Apply(sum.acceleration)};
}

void MotionCore::MapProfiles() {
  for (size_t i = 0; i < axis_count(); ++i) {
    Axis& axis = state_.axes[i];
    if (!axis.active) continue;
    const MasterValue planned = PlannedAxis(axis);
    axis.profile.position = planned.position;
    axis.profile.velocity = planned.velocity;
    axis.profile.acceleration = planned.acceleration;
    axis.profile.filter.Add(axis.profile.velocity);
  }
}

void MotionCore::GuardAxis(size_t index) {
  Axis& axis = state_.axes[index];
  if (!axis.active) return;
  const uint32_t causes = ActiveCauses(axis);
  const uint32_t before = axis.latched;
  axis.latched |= causes;
  if (axis.latched == 0) return;
  if (axis.latched != before) TellCauses(index, causes & ~before);
  // A latched alarm that is no longer active prevents the axis from moving, but not from being
  // enabled.
  if ((causes & kAlarmBit) != 0 && axis.servo_on) ServoOff(index);
  if (!AxisMoving(axis)) return;
  const double velocity = axis.profile.velocity;
  const bool into_limit = (velocity > 0 && (axis.latched & kPositiveLimitBit) != 0) ||
                          (velocity < 0 && (axis.latched & kNegativeLimitBit) != 0);
  if (into_limit || (axis.latched & (kAlarmBit | kAbruptStopBit)) != 0) {
    StopAxis(axis, true);
  } else if ((axis.latched & kSmoothStopBit) != 0) {
    StopAxis(axis, false);
  }
}

void MotionCore::AdvanceMachine() {
  for (size_t i = 0; i < axis_count(); ++i) AdvancePlant(i);
  for (size_t i = 0; i < axis_count(); ++i) {
    if (state_.encoder_faults[i].any()) AdvanceEncoderFault(i);
    CountEncoder(i);
  }
  if (has_auxiliary()) AdvanceAuxiliary();
  for (size_t i = 0; i < axis_count(); ++i) {
    Axis& axis = state_.axes[i];
    if (!axis.active) continue;
    double velocity = 0;
    double acceleration = 0;
    ForEachBit(axis.encoder_map, axis_count(), [&](size_t encoder) {
      velocity += state_.encoders[encoder].velocity;
      acceleration += state_.encoders[encoder].acceleration;
    });
    axis.encoder.position = MappedEncoders(axis) + axis.encoder.offset;
    axis.encoder.velocity = axis.encoder_scale.Apply(velocity);
    axis.encoder.acceleration = axis.encoder_scale.Apply(acceleration);
    axis.encoder.filter.Add(axis.encoder.velocity);
  }
}

void MotionCore::AdvanceAuxiliary() {
  for (size_t i = kAuxiliaryFirst; i < kAuxiliaryFirst + kAuxiliaryCount; ++i) {
    Plant& plant = state_.plants[i];
    const bool faulty = state_.encoder_faults[i].any();
    // They only count if they are turned by hand or have a fault.
    if (plant.hand == 0 && !faulty && state_.encoders[i].resting()) continue;
    if (plant.hand != 0) TurnByHand(plant);
    if (faulty) AdvanceEncoderFault(i);
    CountEncoder(i);
  }
}

void MotionCore::JudgeAxis(size_t index) {
  Axis& axis = state_.axes[index];
  if (!axis.band_set || !axis.active) return;
  const double error = std::fabs(CommandedPosition(index) - axis.encoder.position);
  const bool inside = error < axis.band && !AxisMoving(axis);
  if (inside && !axis.in_band) axis.in_band_since = now();
  axis.in_band = inside;
  axis.in_position = inside && now() - axis.in_band_since >= axis.band_time;
}

// --- Axes and profiles -------------------------------------------------------------------------

void MotionCore::StartProfile(size_t index) {
  Profile& profile = state_.profiles[index];
  if (const Master* master = profile.SelectedMaster(); master != nullptr) {
    profile.StartSlave(ReadMaster(*master));
  } else {
    profile.Start(now());
  }
}

void MotionCore::ServoOn(size_t axis) {
  state_.axes[axis].servo_on = true;
  EnableMachine(axis);
  state_.io.Write(DoType::kEnable, EnableOutputs(axis), ~uint32_t{0});
}

void MotionCore::ServoOff(size_t axis) {
  state_.axes[axis].servo_on = false;
  DisableMachine(axis);
  state_.io.Write(DoType::kEnable, EnableOutputs(axis), 0);
  StopAxis(state_.axes[axis], true);
}

uint32_t MotionCore::EnableOutputs(size_t axis) const {
  uint32_t outputs = 0;
  for (size_t i = 0; i < state_.enable_axes.size(); ++i) {
    if (state_.enable_axes[i] == static_cast<int8_t>(axis)) outputs |= uint32_t{1} << i;
  }
  return outputs;
}

bool MotionCore::AxisMoving(const Axis& axis) const {
  bool moving = false;
  ForEachBit(axis.profile_map, axis_count(),
             [&](size_t profile) { moving = moving || state_.profiles[profile].now.moving; });
  return moving;
}

uint32_t MotionCore::Conditions(size_t index) const {
  const Axis& axis = state_.axes[index];
  uint32_t conditions = axis.latched;
  if (axis.servo_on) conditions |= kServoOnBit;
  if (AxisMoving(axis)) {
    conditions |= kMovingBit;
  } else if (axis.in_position) {
    conditions |= kInPositionBit;
  }
  return conditions;
}

void MotionCore::ClearStatus(size_t axis) {
  uint32_t& latched = state_.axes[axis].latched;
  const uint32_t error = FollowingErrorExceeded(axis) ? latched & kFollowingErrorBit : 0;
  latched = ActiveCauses(state_.axes[axis]) | error;
}

void MotionCore::StopProfile(size_t profile, bool abrupt) {
  for (size_t i = 0; i < kCrdCount && state_.profiles[profile].driven; ++i) {
    if (state_.crds[i].Drives(profile)) StopCrd(i, abrupt);
  }
  if (state_.profiles[profile].driven) return;
  Profile& stopped = state_.profiles[profile];
  stopped.Stop(now(), abrupt ? stopped.abrupt_stop : stopped.smooth_stop);
}

void MotionCore::ShiftSlaves(const Master& master, double shift) {
  for (Profile& profile : state_.profiles) {
    if (const Master* followed = profile.FollowedMaster();
        followed == nullptr || !(*followed == master)) {
      continue;
    }
    profile.ShiftMaster(shift);
  }
}

void MotionCore::SetProfilePosition(size_t profile, double position) {
  ShiftSlaves({true, MasterType::kProfile, static_cast<uint8_t>(profile), false},
              position - state_.profiles[profile].now.position);
  state_.profiles[profile].SetPosition(position);
  for (Axis& axis : state_.axes) {
    if ((axis.profile_map >> profile & 1) == 0) continue;
    axis.profile.offset = axis.profile.position - MappedProfiles(axis);
  }
}

void MotionCore::SetEncoderPosition(size_t encoder, double position) {
  ShiftSlaves({true, MasterType::kEncoder, static_cast<uint8_t>(encoder), false},
              position - state_.encoders[encoder].position);
  state_.encoders[encoder].position = position;
  for (Axis& axis : state_.axes) {
    if ((axis.encoder_map >> encoder & 1) == 0) continue;
    axis.encoder.offset = axis.encoder.position - MappedEncoders(axis);
  }
}

void MotionCore::SynchAxis(size_t index) {
  Axis& axis = state_.axes[index];
  const double before = axis.profile.position;
  axis.encoder.offset = 0;
  const double measured = MappedEncoders(axis);
  if (IsGantrySlave(index)) {
    // It uses the profiles of its master: its planned position changes by as much as its measured
    // one, so that the beam does not move.
    RenamePlanned(index, axis.profile.position + (measured - axis.encoder.position));
  } else {
    axis.profile.offset = 0;
    MoveAxisOrigin(index, MappedProfiles(axis));
  }
  state_.compensations[index].MoveOrigin(before, axis.profile.position);
  MoveEncoderOrigin(index, measured);
}

void MotionCore::ZeroAxis(size_t axis) {
  SetProfilePosition(axis, 0);
  SetEncoderPosition(axis, 0);
  SynchAxis(axis);
  Compensation& compensation = state_.compensations[axis];
  if (IsGantrySlave(axis)) {
    compensation.MoveOrigin(state_.axes[axis].profile.position, 0);
    RenamePlanned(axis, 0);
  }
  // The position that is set to 0 includes the current compensation.
  const double amount = compensation.Amount();
  compensation.origin += amount;
  KeepMachine(axis, amount);
}

void MotionCore::SetProfileScale(size_t axis, Scale scale) {
  const double before = state_.axes[axis].profile.position;
  state_.axes[axis].profile_scale = scale;
  state_.axes[axis].profile.offset = 0;
  MoveAxisOrigin(axis, MappedProfiles(state_.axes[axis]));
  state_.compensations[axis].MoveOrigin(before, state_.axes[axis].profile.position);
  if (!state_.gantry.on || state_.gantry.master != axis) return;
  Axis& follower = state_.axes[state_.gantry.slave];
  follower.profile_scale = scale;
  follower.profile.offset = follower.profile.position - MappedProfiles(follower);
}

void MotionCore::SetEncoderScale(size_t axis, Scale scale) {
  state_.axes[axis].encoder_scale = scale;
  state_.axes[axis].encoder.offset = 0;
  MoveEncoderOrigin(axis, MappedEncoders(state_.axes[axis]));
}

void MotionCore::MoveEncoderOrigin(size_t index, double position) {
  AxisValue& value = state_.axes[index].encoder;
  const double shift = position - value.position;
  ShiftSlaves({true, MasterType::kAxis, static_cast<uint8_t>(index), true}, shift);
  // Only position values change, not the mechanics, so the skew must not change.
  Gantry& gantry = state_.gantry;
  if (gantry.on && gantry.slave == index) gantry.skew_origin += shift;
  if (gantry.on && gantry.master == index) gantry.skew_origin -= shift;
  value.position = position;
}

double MotionCore::MappedProfiles(const Axis& axis) const {
  double sum = 0;
  ForEachBit(axis.profile_map, axis_count(),
             [&](size_t profile) { sum += state_.profiles[profile].now.position; });
  return axis.profile_scale.Apply(sum);
}

double MotionCore::MappedEncoders(const Axis& axis) const {
  double sum = 0;
  ForEachBit(axis.encoder_map, axis_count(),
             [&](size_t encoder) { sum += state_.encoders[encoder].position; });
  return axis.encoder_scale.Apply(sum);
}

uint32_t MotionCore::ActiveCauses(const Axis& axis) const {
  uint32_t causes = 0;
  if (axis.alarm_on && InputActive(axis.alarm)) causes |= kAlarmBit;
  if (InputActive(axis.smooth_stop)) causes |= kSmoothStopBit;
  if (InputActive(axis.abrupt_stop)) causes |= kAbruptStopBit;
  const double position = axis.profile.position;
  if ((axis.positive_limit_on && InputActive(axis.positive_limit)) ||
      (axis.soft_positive != kNoPositiveLimit && position > axis.soft_positive)) {
    causes |= kPositiveLimitBit;
  }
  if ((axis.negative_limit_on && InputActive(axis.negative_limit)) ||
      (axis.soft_negative != kNoNegativeLimit && position < axis.soft_negative)) {
    causes |= kNegativeLimitBit;
  }
  return causes;
}

void MotionCore::Tell(HappeningKind kind, size_t item, double value, double bound) const {
  if (observer_) observer_({kind, item, value, bound});
}

void MotionCore::TellCauses(size_t index, uint32_t causes) const {
  const Axis& axis = state_.axes[index];
  const double position = axis.profile.position;
  const auto tell = [&](HappeningKind kind, double bound = 0) {
    Tell(kind, index, position, bound);
  };
  if ((causes & kAlarmBit) != 0) tell(HappeningKind::kAlarm);
  if ((causes & kSmoothStopBit) != 0) tell(HappeningKind::kSmoothStopInput);
  if ((causes & kAbruptStopBit) != 0) tell(HappeningKind::kAbruptStopInput);
  if ((causes & kPositiveLimitBit) != 0) {
    if (axis.positive_limit_on && InputActive(axis.positive_limit)) {
      tell(HappeningKind::kPositiveLimitSwitch);
    } else {
      tell(HappeningKind::kPositiveSoftLimit, axis.soft_positive);
    }
  }
  if ((causes & kNegativeLimitBit) != 0) {
    if (axis.negative_limit_on && InputActive(axis.negative_limit)) {
      tell(HappeningKind::kNegativeLimitSwitch);
    } else {
      tell(HappeningKind::kNegativeSoftLimit, axis.soft_negative);
    }
  }
}

void MotionCore::LatchCauses() {
  for (size_t i = 0; i < axis_count(); ++i) {
    const uint32_t causes = ActiveCauses(state_.axes[i]) & ~state_.axes[i].latched;
    TellCauses(i, causes);
    state_.axes[i].latched |= causes;
  }
}

void MotionCore::MoveAxisOrigin(size_t index, double position) {
  ShiftSlaves({true, MasterType::kAxis, static_cast<uint8_t>(index), false},
              position - state_.axes[index].profile.position);
  AxisValue& value = state_.axes[index].profile;
  KeepMachine(index, value.position - position);
  value.position = position;
}

void MotionCore::RenamePlanned(size_t index, double position) {
  Axis& axis = state_.axes[index];
  MoveAxisOrigin(index, position);
  axis.profile.offset = position - MappedProfiles(axis);
}

void MotionCore::StopAxis(const Axis& axis, bool abrupt) {
  ForEachBit(axis.profile_map, axis_count(), [&](size_t profile) { StopProfile(profile, abrupt); });
}

uint64_t MotionCore::Hash() const { return StateHash().Add(state_).value(); }

}  // namespace oncard::motion
