#include "motion/readings.h"

#include <cmath>

namespace oncard::motion {

std::optional<size_t> Readings::AxisWithDriveOff(size_t profile) const {
  std::optional<size_t> off;
  for (size_t i = 0; i < axis_count_; ++i) {
    const Axis& axis = state_.axes[i];
    if (!axis.active || (axis.profile_map >> profile & 1) == 0) continue;
    if (axis.servo_on) return std::nullopt;
    if (!off) off = i;
  }
  return off;
}

MasterValue Readings::PlannedAxis(const Axis& axis) const {
  MasterValue sum;
  ForEachBit(axis.profile_map, axis_count_, [&](size_t profile) {
    const Sample& sample = state_.profiles[profile].now;
    sum.position += sample.position;
    sum.velocity += sample.velocity;
    sum.acceleration += sample.acceleration;
  });
  return {axis.profile_scale.Apply(sum.position) + axis.profile.offset,
          axis.profile_scale.Apply(sum.velocity), axis.profile_scale.Apply(sum.acceleration)};
}

MasterValue Readings::ValueOf(const Master& master) const {
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

CommandedMotion Readings::Commanded(size_t index) const {
  CommandedMotion commanded = Unshaped(index);
  if (!state_.shapers) return commanded;
  const CommandedMotion& addition = Shaper(index).addition;
  commanded.position += addition.position;
  commanded.velocity += addition.velocity;
  commanded.acceleration += addition.acceleration;
  return commanded;
}

bool Readings::FollowsCrd(const Profile& profile) const {
  const Master* master = profile.FollowedMaster();
  if (master == nullptr || master->type == MasterType::kEncoder) return false;
  if (master->type == MasterType::kAxis && master->encoder_side) return false;
  const uint32_t profiles = master->type == MasterType::kProfile
                                ? uint32_t{1} << master->index
                                : state_.axes[master->index].profile_map;
  bool found = false;
  ForEachBit(profiles, axis_count_,
             [&](size_t i) { found = found || state_.profiles[i].mode == ProfileMode::kCrd; });
  return found;
}

bool Readings::InClosedLoop(size_t axis) const {
  for (const Control& control : state_.controls) {
    if (control.closed && control.axis == static_cast<int8_t>(axis)) return true;
  }
  return false;
}

bool Readings::BusAlarm(const Axis& axis) const {
  if (!state_.bus) return false;
  const auto index = static_cast<size_t>(&axis - state_.axes.data());
  return OnBus(index) && state_.bus->axes[index].alarm;
}

bus::DriveMode Readings::BusMode(size_t axis) const {
  const bus::Bus& line = state_.bus->line;
  const auto number = static_cast<size_t>(state_.bus->axes[axis].slave);
  const std::optional<int64_t> shown = line.Input(number, bus::ObjectId::kModeDisplay);
  return shown ? static_cast<bus::DriveMode>(*shown) : line.slave(number).drive->mode();
}

uint32_t Readings::ActiveCauses(const Axis& axis) const {
  uint32_t causes = 0;
  if (axis.alarm_on && (InputActive(axis.alarm) || BusAlarm(axis))) causes |= kAlarmBit;
  if (InputActive(axis.smooth_stop)) causes |= kSmoothStopBit;
  if (InputActive(axis.abrupt_stop)) causes |= kAbruptStopBit;
  if ((axis.positive_limit_on && InputActive(axis.positive_limit)) || BeyondPositiveLimit(axis)) {
    causes |= kPositiveLimitBit;
  }
  if ((axis.negative_limit_on && InputActive(axis.negative_limit)) || BeyondNegativeLimit(axis)) {
    causes |= kNegativeLimitBit;
  }
  return causes;
}

double Readings::LaserPower(size_t index) const {
  const Laser& laser = state_.lasers.channels[index];
  const Crd& crd = state_.crds[laser.crd];
  double velocity = crd.run.velocity;
  if (laser.source == LaserSource::kMeasured) {
    double sum = 0;
    for (size_t i = 0; i < crd.dimension(); ++i) {
      const double measured = state_.axes[static_cast<size_t>(crd.members[i])].encoder.velocity;
      sum += measured * measured;
    }
    velocity = std::sqrt(sum);
  }
  return laser.Power(velocity);
}

bool Readings::FollowingErrorExceeded(size_t axis) const {
  const auto number = static_cast<int8_t>(axis);
  const double error = std::fabs(CommandedPosition(axis) - state_.axes[axis].encoder.position);
  for (const Control& control : state_.controls) {
    if (!control.active || control.axis != number) continue;
    if (error > static_cast<double>(control.error_limit)) return true;
  }
  return false;
}

bool Readings::LimitForbids(size_t profile, double direction) const {
  for (size_t i = 0; i < axis_count_; ++i) {
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

bus::DriveMode Readings::CommandedBusMode(size_t axis) const {
  const bus::Bus& line = state_.bus->line;
  const auto slave = static_cast<size_t>(state_.bus->axes[axis].slave);
  const bus::ObjectValues& values = line.slave(slave).drive->values();
  const auto output = line.Output(slave, bus::ObjectId::kMode);
  return static_cast<bus::DriveMode>(output.value_or(values[bus::ObjectId::kMode]));
}

}  // namespace oncard::motion
