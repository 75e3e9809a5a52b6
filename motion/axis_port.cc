#include "motion/axis_port.h"

#include "motion/axis_handle.h"
#include "motion/profile_handle.h"

namespace oncard::motion {

bool AxisPort::enabled() const { return registers().servo_on; }

Sample AxisPort::now() const {
  Sample now = core_.state.profiles[index_].now;
  now.moving = now.moving || !core_.readings().ShaperSettled(index_);
  return now;
}

bool AxisPort::stopping() const { return core_.state.profiles[index_].stopping; }

void AxisPort::SetRamps(const TrapParameters& parameters) {
  const ProfileHandle profile(core_, index_);
  profile.SetParameters(parameters);
  profile.ReserveReplanning();
}

void AxisPort::Move(int32_t target, double velocity) {
  const ProfileHandle profile(core_, index_);
  profile.SetTarget(target);
  profile.SetVelocity(velocity);
  profile.Start();
}

void AxisPort::Stop() { ProfileHandle(core_, index_).Stop(true); }

void AxisPort::Stop(double deceleration) { ProfileHandle(core_, index_).StopWith(deceleration); }

bool AxisPort::HomeActive() const {
  return core_.readings().InputActive({DiType::kHome, static_cast<int16_t>(index_)});
}

bool AxisPort::AtHome() const {
  const auto bit = static_cast<int>(index_);
  const DigitalIo& io = core_.state.io;
  const bool high = (io.Pins(DiType::kHome) >> bit & 1) != 0;
  const Capture& capture = core_.state.capture.capture(index_);
  return io.Driven(DiType::kHome, bit) && high == capture.RisesOf(CaptureSource::kHome);
}

bool AxisPort::LimitActive(int direction) const {
  return core_.readings().InputActive(direction > 0 ? registers().positive_limit
                                                    : registers().negative_limit);
}

bool AxisPort::LimitReached(int direction) const {
  const uint32_t bit = direction > 0 ? kPositiveLimitBit : kNegativeLimitBit;
  return (registers().latched & bit) != 0 || LimitActive(direction);
}

void AxisPort::ForgetLimit(int direction) {
  AxisHandle(core_, index_).ClearConditions(direction > 0 ? kPositiveLimitBit : kNegativeLimitBit);
}

void AxisPort::Arm(size_t capture, CaptureSource source) {
  core_.state.capture.Arm(capture, source);
}

void AxisPort::ArmOnce(size_t capture, CaptureSource source, bool rising) {
  CaptureUnit& unit = core_.state.capture;
  unit.SetSense(capture, source, rising);
  unit.SetRepeat(capture, 1);
  unit.Arm(capture, source);
}

void AxisPort::Disarm(size_t capture) { core_.state.capture.Disarm(capture); }

std::optional<double> AxisPort::Captured(size_t capture) const {
  const Capture& taken = core_.state.capture.capture(capture);
  return taken.captured ? std::optional(taken.value) : std::nullopt;
}

bool AxisPort::HasEncoder(size_t encoder) const { return core_.state.encoders[encoder].active; }

double AxisPort::PlannedAhead() const {
  const Readings readings = core_.readings();
  // A closed loop holds the axis at its planned position.
  if (readings.InClosedLoop(index_)) return 0;
  const Axis& axis = registers();
  double fraction = 0;
  ForEachBit(axis.encoder_map, core_.axis_count(), [&](size_t i) {
    fraction += readings.CountedPosition(i) - core_.state.encoders[i].position;
  });
  const double measured = axis.encoder.position + axis.encoder_scale.Apply(fraction);
  return readings.CommandedPosition(index_) - measured;
}

double AxisPort::ProfilePositionOf(size_t encoder, double position, double ahead) const {
  const Axis& axis = registers();
  const double measured =
      axis.encoder.position +
      axis.encoder_scale.Apply(position - core_.state.encoders[encoder].position);
  const double planned = measured + ahead - core_.state.compensations[index_].Amount();
  const Scale& scale = axis.profile_scale;
  const double way = planned - (core_.readings().MappedProfiles(axis) + axis.profile.offset);
  const Scale inverse = {scale.beta, scale.alpha};
  return now().position + inverse.Apply(way);
}

}  // namespace oncard::motion
