#include "motion/axis_port.h"

#include "motion/motion_core.h"

namespace oncard::motion {

bool AxisPort::enabled() const { return core_.state().axes[axis_].servo_on; }

Sample AxisPort::now() const {
  Sample now = core_.state().profiles[axis_].now;
  now.moving = now.moving || !core_.ShaperSettled(axis_);
  return now;
}

bool AxisPort::stopping() const { return core_.state().profiles[axis_].stopping; }

void AxisPort::SetRamps(const TrapParameters& parameters) {
  TrapMode& trap = core_.state().profiles[axis_].trap;
  trap.parameters = parameters;
  // Replanning with a smoothing time stores pieces; reserved here, so that a cycle does not
  // allocate.
  trap.past.reserve(4 * Plan::kPieceMax);
}

void AxisPort::Move(int32_t target, double velocity) {
  TrapMode& trap = core_.state().profiles[axis_].trap;
  trap.target = target;
  trap.velocity = velocity;
  core_.StartProfile(axis_);
}

void AxisPort::Stop() { core_.StopProfile(axis_, true); }

void AxisPort::Stop(double deceleration) {
  core_.state().profiles[axis_].Stop(core_.now(), deceleration);
}

bool AxisPort::HomeActive() const {
  return core_.InputActive({DiType::kHome, static_cast<int16_t>(axis_)});
}

bool AxisPort::LimitActive(int direction) const {
  const Axis& axis = core_.state().axes[axis_];
  return core_.InputActive(direction > 0 ? axis.positive_limit : axis.negative_limit);
}

bool AxisPort::LimitReached(int direction) const {
  const uint32_t bit = direction > 0 ? kPositiveLimitBit : kNegativeLimitBit;
  return (core_.state().axes[axis_].latched & bit) != 0 || LimitActive(direction);
}

void AxisPort::ForgetLimit(int direction) {
  Axis& axis = core_.state().axes[axis_];
  const uint32_t bit = direction > 0 ? kPositiveLimitBit : kNegativeLimitBit;
  axis.latched &= ~bit | core_.readings().ActiveCauses(axis);
}

void AxisPort::Arm(size_t capture, CaptureSource source) {
  core_.state().capture.Arm(capture, source);
}

void AxisPort::ArmOnce(size_t capture, CaptureSource source, bool rising) {
  Capture& registers = core_.state().capture.capture(capture);
  registers.SetRising(source, rising);
  registers.repeat = 1;
  Arm(capture, source);
}

void AxisPort::Disarm(size_t capture) { core_.state().capture.Disarm(capture); }

std::optional<double> AxisPort::Captured(size_t capture) const {
  const Capture& taken = core_.state().capture.capture(capture);
  return taken.captured ? std::optional(taken.value) : std::nullopt;
}

bool AxisPort::HasEncoder(size_t encoder) const { return core_.state().encoders[encoder].active; }

double AxisPort::PlannedAhead() const {
  const Readings readings = core_.readings();
  // A closed loop holds the axis at its planned position.
  if (readings.InClosedLoop(axis_)) return 0;
  const Axis& axis = core_.state().axes[axis_];
  double fraction = 0;
  for (size_t i = 0; i < core_.axis_count(); ++i) {
    if ((axis.encoder_map >> i & 1) != 0) {
      fraction += readings.CountedPosition(i) - core_.state().encoders[i].position;
    }
  }
  const double measured = axis.encoder.position + axis.encoder_scale.Apply(fraction);
  return readings.CommandedPosition(axis_) - measured;
}

double AxisPort::ProfilePositionOf(size_t encoder, double position, double ahead) const {
  const Axis& axis = core_.state().axes[axis_];
  const double measured =
      axis.encoder.position +
      axis.encoder_scale.Apply(position - core_.state().encoders[encoder].position);
  const double planned = measured + ahead - core_.state().compensations[axis_].Amount();
  const Scale& scale = axis.profile_scale;
  const double way = planned - (core_.readings().MappedProfiles(axis) + axis.profile.offset);
  const Scale inverse = {scale.beta, scale.alpha};
  return now().position + inverse.Apply(way);
}

}  // namespace oncard::motion
