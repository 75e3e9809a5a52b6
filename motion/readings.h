// What follows from the state of a card at one instant: sums over maps, levels of chosen inputs,
// counts of encoders, masters. Changes nothing. Tested by tests/motion/axis_test.cc and
// encoder_test.cc.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/common/rounding.h"
#include "motion/motion_state.h"

namespace oncard::motion {

/// Calls `function` with the number of every bit of `map` below `count`.
template <typename Function>
void ForEachBit(uint32_t map, size_t count, Function function) {
  for (map &= (uint32_t{1} << count) - 1; map != 0; map &= map - 1) {
    function(static_cast<size_t>(std::countr_zero(map)));
  }
}

class Readings {
 public:
  Readings(const MotionState& state, const MotionConfig& config)
      : state_(state), axis_count_(static_cast<size_t>(config.axis_count)) {}

  /// Level of an input as GT_GetDi reads it; false if there is none.
  bool InputActive(const InputChoice& input) const {
    return input.bit >= 0 && (state_.io.Read(input.type) >> input.bit & 1) != 0;
  }

  /// True if a profile that the axis maps is moving.
  bool AxisMoving(const Axis& axis) const {
    bool moving = false;
    ForEachBit(axis.profile_map, axis_count_,
               [&](size_t profile) { moving = moving || state_.profiles[profile].now.moving; });
    return moving;
  }
  /// The axis that a profile moves although the drive is off; nullopt if it moves none, or one
  /// whose drive is on.
  std::optional<size_t> AxisWithDriveOff(size_t profile) const;
  /// The mapped sum of an axis' profiles or encoders, without the offset.
  double MappedProfiles(const Axis& axis) const {
    double sum = 0;
    ForEachBit(axis.profile_map, axis_count_,
               [&](size_t profile) { sum += state_.profiles[profile].now.position; });
    return axis.profile_scale.Apply(sum);
  }
  double MappedEncoders(const Axis& axis) const {
    double sum = 0;
    ForEachBit(axis.encoder_map, axis_count_,
               [&](size_t encoder) { sum += state_.encoders[encoder].position; });
    return axis.encoder_scale.Apply(sum);
  }
  /// The planned values of an axis from its profiles now.
  MasterValue PlannedAxis(const Axis& axis) const;
  /// The current sample of a master.
  MasterValue ValueOf(const Master& master) const;
  /// True if a coordinate system runs.
  bool PathRuns() const {
    return std::ranges::any_of(state_.crds, [](const Crd& crd) { return crd.run.running; });
  }
  /// True for a slave whose master is planned by a coordinate system.
  bool FollowsCrd(const Profile& profile) const;

  /// The planned axis position that is sent to the drive.
  double CommandedPosition(size_t axis) const {
    const double position =
        state_.axes[axis].profile.position + state_.compensations[axis].Amount();
    return state_.shapers ? position + Shaper(axis).addition.position : position;
  }
  /// The same with velocity and acceleration.
  CommandedMotion Commanded(size_t axis) const;
  /// The same before the input shaper.
  CommandedMotion Unshaped(size_t axis) const {
    const AxisValue& planned = state_.axes[axis].profile;
    return {planned.position + state_.compensations[axis].Amount(), planned.velocity,
            planned.acceleration};
  }
  /// The input shaper of an axis, for a card with `shapers`.
  const InputShaper& Shaper(size_t axis) const { return (*state_.shapers)[axis]; }
  /// False while the input shaper of an axis has not yet passed all of a motion.
  bool ShaperSettled(size_t axis) const { return !state_.shapers || Shaper(axis).settled(); }
  /// The conditions to latch whose causes exist now; following errors are handled separately.
  uint32_t ActiveCauses(const Axis& axis) const;
  /// True if the planned position is beyond a software limit: the only cause without an input.
  bool BeyondSoftLimit(const Axis& axis) const {
    return BeyondPositiveLimit(axis) || BeyondNegativeLimit(axis);
  }
  /// True if |planned - measured| exceeds the limit of the axis' controller.
  bool FollowingErrorExceeded(size_t axis) const;
  /// True if an axis of the profile has a latched limit in a direction, given by its sign.
  bool LimitForbids(size_t profile, double direction) const;
  /// True if the axis' drive is commanded by a servo controller.
  bool InClosedLoop(size_t axis) const;
  /// True if the axis has a drive on a bus.
  bool OnBus(size_t axis) const { return state_.bus && state_.bus->axes[axis].on_bus(); }
  /// The mode of operation that the drive of a bus axis reports, or has if its process data do not
  /// contain 6061h.
  bus::DriveMode BusMode(size_t axis) const;
  /// False while the drive of a bus axis moves by itself.
  bool FollowsPlan(size_t axis) const { return !OnBus(axis) || state_.bus->axes[axis].follows; }
  /// The mode that the drive was given and takes with the next cycle.
  bus::DriveMode CommandedBusMode(size_t axis) const;
  bool IsGantrySlave(size_t axis) const { return state_.gantry.on && state_.gantry.slave == axis; }

  /// The strength of a laser now, in the unit of its mode.
  double LaserPower(size_t laser) const;

  /// The axis whose enable output enables a motor's drive; the axis with the same number if no axis
  /// commands it.
  size_t EnablingAxis(size_t plant) const {
    const int8_t axis = state_.plants[plant].axis;
    return axis >= 0 ? static_cast<size_t>(axis) : plant;
  }

  /// The count of an encoder's source, with fractions of pulses.
  double SourcePosition(size_t index) const {
    if (!OnBus(index)) return TerminalPosition(index);
    return state_.bus->axes[index].feedback() + state_.encoder_faults[index].slip;
  }
  /// The same of an encoder at the terminals; a card without a bus has no others.
  double TerminalPosition(size_t index) const {
    const Encoder& encoder = state_.encoders[index];
    if (!encoder.external) return state_.steps[index].position;
    const double direction = encoder.reversed == encoder.wired_reversed ? 1 : -1;
    return direction * state_.plants[index].position + state_.encoder_faults[index].slip;
  }
  /// The same in whole pulses, with the reading error.
  double EncoderSource(size_t index) const { return AsRead(index, SourcePosition(index)); }
  double AsRead(size_t index, double position) const {
    const double whole = Whole(position);
    return state_.encoders[index].external ? whole + state_.encoder_faults[index].error : whole;
  }
  /// An encoder's position with fractions of pulses.
  double CountedPosition(size_t index) const {
    const Encoder& encoder = state_.encoders[index];
    if (!encoder.active) return encoder.position;
    return encoder.position + (SourcePosition(index) - encoder.source);
  }

 private:
  /// True if the drive of an axis on a bus has a fault or does not answer.
  bool BusAlarm(const Axis& axis) const;
  static bool BeyondPositiveLimit(const Axis& axis) {
    return axis.soft_positive != kNoPositiveLimit && axis.profile.position > axis.soft_positive;
  }
  static bool BeyondNegativeLimit(const Axis& axis) {
    return axis.soft_negative != kNoNegativeLimit && axis.profile.position < axis.soft_negative;
  }

  const MotionState& state_;
  size_t axis_count_;
};

}  // namespace oncard::motion
