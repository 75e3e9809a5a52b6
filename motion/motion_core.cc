// The order of a cycle, and what commands do to axes and profiles.
// Tested by tests/motion/motion_core_test.cc and axis_test.cc.
#include "motion/motion_core.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/common/state_hash.h"
#include "motion/crossings.h"
#include "motion/world.h"

namespace oncard::motion {
namespace {

/// What an axis may exceed its limits by, relative to them.
constexpr double kLimitTolerance = 1e-6;

static_assert(kFieldsComplete<MotionState> && kFieldsComplete<Profile> && kFieldsComplete<Plant> &&
              kFieldsComplete<WorldEvent> && kFieldsComplete<WorldProgress>);

}  // namespace

MotionCore::MotionCore(const MotionConfig& config)
    : config_(config), block_(state_, config_, LaneKernels().front().run) {
  Reset();
}

MotionCore::MotionCore(const MotionCore& other)
    : config_(other.config_),
      state_(other.state()),
      observer_(other.observer_),
      block_(state_, config_, other.block_.kernel()) {}

void MotionCore::Restore(const MotionState& copy) {
  block_.Leave();
  state_ = copy;
}

void MotionCore::Tick() {
  block_.Leave();
  BeginTick();
  AdvanceProfiles();
  FinishTick();
}

int64_t MotionCore::Advance(int64_t cycles) {
  if (cycles >= CycleBlock::kWorthwhile) block_.Retry();
  int64_t done = 0;
  while (done < cycles && state_.reached.empty()) {
    const int64_t block = AdvanceBlock(cycles - done);
    if (block == 0) Tick();
    done += std::max(block, int64_t{1});
  }
  return done;
}

int64_t MotionCore::AdvanceBlock(int64_t cycles) {
  if (!block_.Enter(cycles)) return 0;
  const int64_t ahead = std::min(cycles, block_.CyclesAhead());
  if (!block_.plans()) return AdvanceBesideProfiles(ahead);
  const int64_t done = ahead > 0 ? block_.Run(ahead) : 0;
  state_.cycle += done;
  state_.clock_cycle += done;
  for (int64_t i = 0; i < done && state_.io.HasTimedOutputs(); ++i) {
    state_.io.AdvanceOutputs(config_.cycle_us);
  }
  return done;
}

int64_t MotionCore::AdvanceBesideProfiles(int64_t cycles) {
  const bool encoders_are_read = EncodersAreRead();
  int64_t done = 0;
  bool goes_on = true;
  while (goes_on && done < cycles) {
    if (state_.io.HasTimedOutputs()) state_.io.AdvanceOutputs(config_.cycle_us);
    ++state_.cycle;
    ++state_.clock_cycle;
    AdvanceProfiles();
    block_.TakeProfiles();
    goes_on = block_.loaded() && block_.Run(1) == 1;
    if (goes_on && encoders_are_read) block_.ShowEncoders();
    ++done;
  }
  block_.Leave();
  if (!goes_on) FinishTick();
  return done;
}

bool MotionCore::EncodersAreRead() const {
  const auto reads = [](const Profile& profile) {
    const Master* master = profile.FollowedMaster();
    return master != nullptr && (master->type == MasterType::kEncoder || master->encoder_side);
  };
  return std::ranges::any_of(state_.profiles, reads);
}

void MotionCore::BeginTick() {
  World(state_, config_).ApplyEvents();
  state_.io.SampleInputs();
  for (Adc& adc : state_.adcs) adc.Sample();
  state_.io.AdvanceOutputs(config_.cycle_us);
  ++state_.cycle;
  ++state_.clock_cycle;
}

void MotionCore::FinishTick() {
  MapProfiles();
  const Readings present = readings();
  const bool inputs = state_.io.AnyActive() || state_.bus;
  for (size_t i = 0; i < axis_count(); ++i) {
    const Axis& axis = state_.axes[i];
    // Most axes have no latched condition and no cause to latch one.
    const bool cause = inputs ? present.ActiveCauses(axis) != 0 : present.BeyondSoftLimit(axis);
    if (axis.latched != 0 || cause) GuardAxis(i);
  }
  if (state_.compensates) AdvanceCompensations();
  if (state_.shapers) AdvanceShapers();
  AdvanceDrives();
  for (size_t i = 0; i < axis_count(); ++i) JudgeControl(state_.controls[i]);
  if (state_.gantry.on) JudgeGantry();
  for (size_t i = 0; i < axis_count(); ++i) JudgeAxis(i);
  if (state_.homing_runs) AdvanceHomings();
}

void MotionCore::Reset() {
  block_.Leave();
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
  state_.shapers.Reset();
  drives().Reset();
  if (config_.defaults.spindle) state_.spindle.Emplace();
  for (Adc& adc : state_.adcs) adc = {.volts = adc.volts, .filtered = adc.volts};
  for (ExtensionModule& module : state_.modules) {
    module.outputs = 0;
    module.output_volts.fill(0);
  }
  state_.capture.Reset();
  state_.compare.Reset();
  state_.lasers = {};
  state_.gantry = {};
  state_.homing.fill({});
  state_.homing_runs = false;
  state_.reached.clear();
  if (state_.bus) bus_axes().Reset();
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
  const Readings present = unlaned();
  const auto comes_last = [&](const Profile& profile) {
    // Most profiles have no master.
    return profile.FollowedMaster() != nullptr &&
           (config_.defaults.slaves_last || present.FollowsCrd(profile));
  };
  bool any_last = false;
  for (size_t i = 0; i < axis_count(); ++i) {
    const Profile& profile = state_.profiles[i];
    if (!profile.now.moving || profile.driven) continue;
    if (comes_last(profile)) {
      any_last = true;
    } else {
      AdvanceProfile(i);
    }
  }
  for (size_t i = 0; i < kCrdCount; ++i) {
    if (state_.crds[i].run.running) CrdAt(i).Advance();
  }
  if (!any_last) return;
  for (size_t i = 0; i < axis_count(); ++i) {
    if (comes_last(state_.profiles[i])) AdvanceProfile(i);
  }
}

void MotionCore::AdvanceProfile(size_t index) {
  if (state_.profiles[index].now.velocity == 0) return BeginProfile(index);
  SampleProfile(index);
}

void MotionCore::SampleProfile(size_t index) {
  Profile& profile = state_.profiles[index];
  if (const Master* master = profile.FollowedMaster(); master != nullptr) {
    // Beside lanes the encoders have been copied to the state.
    profile.AdvanceSlave(Readings(state_, config_).ValueOf(*master));
  } else {
    profile.Advance(now());
  }
}

void MotionCore::BeginProfile(size_t index) {
  Profile& profile = state_.profiles[index];
  const double begin = profile.now.position;
  const bool held = profile.gear.direct.held;
  SampleProfile(index);
  if (profile.now.position == begin) return;
  if (!unlaned().LimitForbids(index, profile.now.position - begin)) return;
  // A motion that a latched limit would stop does not start.
  profile.now = {begin, 0, 0, true};
  if (!held) Tell(CardEventKind::kHeldAtLimit, index, begin);
  if (!profile.HoldAtLimit()) ProfileAt(index).Stop(true);
}

void MotionCore::MapProfiles() {
  const Readings present = readings();
  for (size_t i = 0; i < axis_count(); ++i) {
    Axis& axis = state_.axes[i];
    if (!axis.active) continue;
    const MasterValue planned = present.PlannedAxis(axis);
    if (config_.drive_limits[i].any()) JudgeLimits(i, planned);
    axis.profile.position = planned.position;
    axis.profile.velocity = planned.velocity;
    axis.profile.acceleration = planned.acceleration;
    axis.profile.filter.Add(axis.profile.velocity);
  }
}

void MotionCore::JudgeLimits(size_t index, const MasterValue& planned) const {
  const auto begins = [](double last, double now, double limit) {
    // A motion at the limit itself is rounded.
    const double most = limit * (1 + kLimitTolerance);
    return std::abs(now) > most && std::abs(last) <= most;
  };
  const DriveLimits& limits = config_.drive_limits[index];
  const auto& before = state_.axes[index].profile;
  if (begins(before.velocity, planned.velocity, limits.velocity)) {
    Tell(CardEventKind::kTooFast, index, planned.velocity, limits.velocity);
  }
  // At a corner a path changes the velocity at once, with no acceleration that is planned; a ramp
  // that begins within the cycle has changed it little.
  const double mean = (planned.velocity - before.velocity) / MsBetween(0, config_.cycle_us);
  const double steepest =
      std::abs(mean) > std::abs(planned.acceleration) ? mean : planned.acceleration;
  if (begins(before.acceleration, steepest, limits.acceleration)) {
    Tell(CardEventKind::kTooSteep, index, steepest, limits.acceleration);
  }
}

void MotionCore::GuardAxis(size_t index) {
  Axis& axis = state_.axes[index];
  if (!axis.active) return;
  const uint32_t causes = readings().ActiveCauses(axis);
  const uint32_t before = axis.latched;
  axis.latched |= causes;
  if (axis.latched == 0) return;
  if (axis.latched != before) TellCauses(index, causes & ~before);
  // A latched alarm that is no longer active prevents the axis from moving, but not from being
  // enabled.
  if ((causes & kAlarmBit) != 0 && axis.servo_on) AxisAt(index).ServoOff();
  if (!AxisMoving(axis)) return;
  const double velocity = axis.profile.velocity;
  const bool into_limit = (velocity > 0 && (axis.latched & kPositiveLimitBit) != 0) ||
                          (velocity < 0 && (axis.latched & kNegativeLimitBit) != 0);
  if ((axis.latched & (kAlarmBit | kAbruptStopBit)) != 0) {
    AxisAt(index).StopProfiles(true);
  } else if (into_limit) {
    AxisAt(index).StopProfilesAtLimit();
  } else if ((axis.latched & kSmoothStopBit) != 0) {
    AxisAt(index).StopProfiles(false);
  }
}

void MotionCore::AdvanceCompensations() {
  state_.compensates = false;
  for (size_t i = 0; i < axis_count(); ++i) {
    Compensation& compensation = state_.compensations[i];
    if (!compensation.InUse()) continue;
    const AxisValue& planned = state_.axes[i].profile;
    compensation.Advance(now() - config_.cycle_us, now(), planned.position, planned.velocity);
    state_.compensates = state_.compensates || compensation.InUse();
  }
}

void MotionCore::AdvanceShapers() {
  const Readings present = readings();
  for (size_t i = 0; i < axis_count(); ++i) {
    InputShaper& shaper = (*state_.shapers)[i];
    if (!shaper.on()) continue;
    const CommandedMotion command = present.Unshaped(i);
    if (state_.axes[i].servo_on && present.FollowsPlan(i)) {
      shaper.Advance(state_.cycle, command);
    } else {
      shaper.Restart(command);
    }
  }
}

void MotionCore::AdvanceDrives() {
  if (state_.bus) return AdvanceDrivesWithBus();
  if (!Crossings::Wanted(state_)) return drives().Advance();
  Crossings crossings(state_, config_);
  drives().Advance();
  crossings.Finish();
}

void MotionCore::AdvanceDrivesWithBus() {
  Crossings crossings(state_, config_);
  bus_axes().Exchange();
  drives().Advance();
  if (Crossings::Wanted(state_)) crossings.Finish();
  ForEachBit(bus_axes().Follow(), axis_count(), [&](size_t axis) {
    drives().Disable(axis);
    AxisAt(axis).StopProfiles(true);
  });
}

void MotionCore::JudgeControl(Control& control) {
  if (!control.active || control.axis < 0) return;
  const auto index = static_cast<size_t>(control.axis);
  const Axis& axis = state_.axes[index];
  if (!axis.servo_on) return;
  const double error = std::fabs(readings().CommandedPosition(index) - axis.encoder.position);
  if (error <= static_cast<double>(control.error_limit) && !drives().EncoderSilent(control)) return;
  FailControl(control, error);
}

void MotionCore::FailControl(const Control& control, double error) {
  const auto index = static_cast<size_t>(control.axis);
  // A drive on a bus that moves by itself does not follow the plan.
  if (!readings().FollowsPlan(index)) return;
  Axis& axis = state_.axes[index];
  const auto limit = static_cast<double>(control.error_limit);
  if (error > limit && !config_.defaults.following_error_stops) {
    // The error may last as long as the axis moves.
    const bool known = (axis.latched & kFollowingErrorBit) != 0;
    if (!known) Tell(CardEventKind::kBeyondErrorLimit, index, error, limit);
  } else if (error > limit) {
    Tell(CardEventKind::kFollowingError, index, error, limit);
  } else {
    Tell(CardEventKind::kEncoderSilent, index, axis.encoder.velocity, control.check.min_velocity);
  }
  axis.latched |= kFollowingErrorBit;
  if (config_.defaults.following_error_stops) AxisAt(index).ServoOff();
}

void MotionCore::JudgeGantry() {
  const Gantry& gantry = state_.gantry;
  if (!gantry.Exceeded(state_.axes)) return;
  Tell(CardEventKind::kGantrySkew, gantry.master, GantrySkew(), gantry.error_limit);
  for (const size_t axis : {size_t{gantry.master}, size_t{gantry.slave}}) {
    state_.axes[axis].latched |= kFollowingErrorBit;
    if (config_.defaults.following_error_stops) AxisAt(axis).ServoOff();
  }
}

void MotionCore::JudgeAxis(size_t index) {
  Axis& axis = state_.axes[index];
  if (!axis.band_set || !axis.active) return;
  const double error = std::fabs(readings().CommandedPosition(index) - axis.encoder.position);
  const bool inside = error < axis.band && !AxisMoving(axis) && ShaperSettled(index);
  if (inside && !axis.in_band) axis.in_band_since = now();
  axis.in_band = inside;
  axis.in_position = inside && now() - axis.in_band_since >= axis.band_time;
}

void MotionCore::AdvanceHomings() {
  state_.homing_runs = false;
  for (size_t i = 0; i < axis_count(); ++i) {
    if (!state_.homing[i].running) continue;
    HomingAt(i).Advance();
    state_.homing_runs |= state_.homing[i].running;
  }
}

uint32_t MotionCore::Conditions(size_t index) const {
  const Axis& axis = state_.axes[index];  // lanes hold none of its conditions
  uint32_t conditions = axis.latched;
  if (axis.servo_on) conditions |= kServoOnBit;
  if (AxisMoving(axis)) {
    conditions |= kMovingBit;
  } else if (axis.in_position) {
    conditions |= kInPositionBit;
  }
  return conditions;
}

void MotionCore::RestartDrives() {
  drives().Wire();
  drives().KeepPulses();
  for (size_t i = 0; i < kAxisMax; ++i) {
    if (state_.axes[i].servo_on && !OnBus(i)) AxisAt(i).RestartDrive();
  }
}

// --- Gantry ------------------------------------------------------------------------------------

void MotionCore::EnableGantry(size_t master, size_t slave, double master_kp, double slave_kp) {
  parts().Changed().gantry.Begin(master, slave, master_kp, slave_kp, state_.axes);
  origins().KeepPlanned(slave);
}

void MotionCore::DisableGantry() {
  if (!state_.gantry.on) return;
  parts().Changed().gantry.End(state_.axes);
  origins().KeepPlanned(state_.gantry.slave);
}

// --- Axes on a bus -----------------------------------------------------------------------------

void MotionCore::ConnectBus(bus::SlavesPointer configured, bus::SlavesPointer connected) {
  parts().Changed().bus.Emplace().line = bus::Bus(std::move(configured), std::move(connected));
  bus_axes().NumberAxes();
}

void MotionCore::TerminateBus() {
  for (size_t i = 0; i < axis_count(); ++i) {
    if (OnBus(i)) AxisAt(i).ServoOff();
  }
  parts().Changed().bus->line.Terminate();
}

// --- Outside the card --------------------------------------------------------------------------

void MotionCore::PowerOn(std::shared_ptr<const WorldEvents> events) {
  if (state_.bus) bus_axes().PowerOn();
  World(parts().Changed(), config_).PowerOn(std::move(events));
  LatchCauses();
}

void MotionCore::Happen(const WorldEvent& event) {
  World(parts().Changed(), config_).Happen(event);
}

void MotionCore::SetEvents(std::shared_ptr<const WorldEvents> events) {
  World(parts().Changed(), config_).Replace(std::move(events));
}

void MotionCore::PlaceMotor(size_t motor, double position) {
  Plant& plant = parts().Changed().plants[motor];
  plant.lead += position - plant.position;
  plant.position = position;
  EncoderAt(motor).Rebase();
}

// --- Stops and reports -------------------------------------------------------------------------

void MotionCore::Tell(CardEventKind kind, size_t item, double value, double bound) const {
  if (observer_) observer_({kind, item, value, bound});
}

void MotionCore::TellCauses(size_t index, uint32_t causes) const {
  const Axis& axis = state_.axes[index];
  const double position = axis.profile.position;
  const auto tell = [&](CardEventKind kind, double bound = 0) {
    Tell(kind, index, position, bound);
  };
  if ((causes & kAlarmBit) != 0) tell(CardEventKind::kAlarm);
  if ((causes & kSmoothStopBit) != 0) tell(CardEventKind::kSmoothStopInput);
  if ((causes & kAbruptStopBit) != 0) tell(CardEventKind::kAbruptStopInput);
  if ((causes & kPositiveLimitBit) != 0) {
    if (axis.positive_limit_on && InputActive(axis.positive_limit)) {
      tell(CardEventKind::kPositiveLimitSwitch);
    } else {
      tell(CardEventKind::kPositiveSoftLimit, axis.soft_positive);
    }
  }
  if ((causes & kNegativeLimitBit) != 0) {
    if (axis.negative_limit_on && InputActive(axis.negative_limit)) {
      tell(CardEventKind::kNegativeLimitSwitch);
    } else {
      tell(CardEventKind::kNegativeSoftLimit, axis.soft_negative);
    }
  }
}

void MotionCore::LatchCauses() {
  for (size_t i = 0; i < axis_count(); ++i) {
    const uint32_t causes = readings().ActiveCauses(state_.axes[i]) & ~state_.axes[i].latched;
    TellCauses(i, causes);
    state_.axes[i].latched |= causes;
  }
}

uint64_t MotionCore::Hash() const { return StateHash().Add(state()).value(); }

}  // namespace oncard::motion
