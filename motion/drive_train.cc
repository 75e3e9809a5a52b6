#include "motion/drive_train.h"

#include <cmath>

#include "motion/common/rounding.h"

namespace oncard::motion {

void DriveTrain::Reset() {
  const CardDefaults& defaults = config_.defaults;
  state_.encoders.fill({.external = defaults.encoders_external,
                        .reversed = defaults.encoders_reversed,
                        .wired_reversed = defaults.encoders_reversed});
  // Auxiliary encoders have no pulse outputs that they could count.
  for (size_t i = 0; i < kAuxiliaryCount && HasAuxiliary(config_); ++i) {
    state_.encoders[kAuxiliaryFirst + i].external = true;
  }
  state_.dacs.fill({});
  for (size_t i = 0; i < kAxisMax; ++i) {
    state_.controls[i] = DefaultControl(static_cast<int>(i));
    state_.controls[i].error_limit = defaults.following_error_limit;
    state_.steps[i] = {};
    state_.steps[i].axis = static_cast<int8_t>(i);
    // The motor does not move; its encoder counts from here.
    Rebase(i);
    state_.plants[i].lead = state_.plants[i].position;
  }
  for (size_t i = 0; i < axis_count() && defaults.closed_loop; ++i) SetClosedLoop(i, true);
  Wire();
}

void DriveTrain::Wire() {
  for (size_t i = 0; i < kAxisMax; ++i) {
    Plant& plant = state_.plants[i];
    const Step& step = state_.steps[i];
    const int8_t owner = state_.dacs[i].control;
    const bool closed = owner >= 0 && state_.controls[static_cast<size_t>(owner)].closed;
    plant.control = closed ? owner : int8_t{-1};
    if (plant.control >= 0) {
      plant.axis = state_.controls[static_cast<size_t>(plant.control)].axis;
    } else {
      plant.axis = step.active ? step.axis : int8_t{-1};
    }
  }
}

void DriveTrain::KeepPulses() {
  for (Step& step : state_.steps) {
    if (step.axis < 0) continue;
    step.lead = step.position - readings_.CommandedPosition(static_cast<size_t>(step.axis));
  }
}

void DriveTrain::SetClosedLoop(size_t axis, bool closed) {
  Control& control = state_.controls[axis];
  control.closed = closed;
  if (closed) control.active = true;
  Dac& dac = state_.dacs[axis];
  dac.control = closed ? static_cast<int8_t>(axis) : int8_t{-1};
  dac.value = 0;
  Wire();
}

void DriveTrain::Enable(size_t axis) {
  const auto number = static_cast<int8_t>(axis);
  for (Control& control : state_.controls) {
    if (!control.closed || control.axis != number) continue;
    control.Begin(readings_.CommandedPosition(axis));
  }
  for (Plant& plant : state_.plants) {
    if (plant.axis == number) plant.lead = plant.position - readings_.CommandedPosition(axis);
  }
}

void DriveTrain::Disable(size_t axis) {
  for (size_t i = 0; i < kAxisMax; ++i) {
    const Plant& plant = state_.plants[i];
    if (plant.control >= 0 && plant.axis == static_cast<int8_t>(axis)) state_.dacs[i].value = 0;
  }
}

void DriveTrain::Keep(size_t axis, double difference) {
  const auto number = static_cast<int8_t>(axis);
  for (size_t i = 0; i < kAxisMax; ++i) {
    if (state_.plants[i].axis == number) state_.plants[i].lead += difference;
    if (state_.steps[i].axis == number) state_.steps[i].lead += difference;
    if (state_.controls[i].axis == number) state_.controls[i].reference -= difference;
  }
  if (readings_.OnBus(axis)) state_.bus->axes[axis].lead += difference;
}

void DriveTrain::Advance() {
  const size_t count = axis_count();
  // The drives on a bus have moved their motors (bus_axes.h).
  const bool bus = static_cast<bool>(state_.bus);
  for (size_t i = 0; i < count; ++i) {
    if (!bus || !readings_.OnBus(i)) AdvancePlant(i);
  }
  for (size_t i = 0; i < count; ++i) {
    if (state_.encoder_faults[i].any()) AdvanceEncoderFault(i);
    CountEncoder(i, bus);
  }
  if (HasAuxiliary(config_)) AdvanceAuxiliary();
  MapEncoders();
}

void DriveTrain::MapEncoders() {
  const size_t count = axis_count();
  for (size_t i = 0; i < count; ++i) {
    Axis& axis = state_.axes[i];
    if (!axis.active) continue;
    double velocity = 0;
    double acceleration = 0;
    ForEachBit(axis.encoder_map, count, [&](size_t encoder) {
      velocity += state_.encoders[encoder].velocity;
      acceleration += state_.encoders[encoder].acceleration;
    });
    axis.encoder.position = readings_.MappedEncoders(axis) + axis.encoder.offset;
    axis.encoder.velocity = axis.encoder_scale.Apply(velocity);
    axis.encoder.acceleration = axis.encoder_scale.Apply(acceleration);
    axis.encoder.filter.Add(axis.encoder.velocity);
  }
}

void DriveTrain::AdvanceAuxiliary() {
  constexpr bool kBus = false;  // auxiliary encoders are at the terminals
  for (size_t i = kAuxiliaryFirst; i < kAuxiliaryFirst + kAuxiliaryCount; ++i) {
    Plant& plant = state_.plants[i];
    const bool faulty = state_.encoder_faults[i].any();
    // They only count if they are turned by hand or have a fault.
    if (plant.hand == 0 && !faulty && state_.encoders[i].resting()) continue;
    if (plant.hand != 0) TurnByHand(plant);
    if (faulty) AdvanceEncoderFault(i);
    CountEncoder(i, kBus);
  }
}

void DriveTrain::AdvancePlant(size_t index) {
  Step& step = state_.steps[index];
  if (step.active && step.axis >= 0) {
    step.position = readings_.CommandedPosition(static_cast<size_t>(step.axis)) + step.lead;
  }
  Plant& plant = state_.plants[index];
  const Drive& drive = state_.drives[index];
  const size_t axis_index = readings_.EnablingAxis(index);
  const Axis& axis = state_.axes[axis_index];
  if (axis.servo_on && plant.control >= 0) {
    AdvanceClosedLoop(index);
  } else if (!axis.servo_on && plant.hand != 0) {
    TurnByHand(plant);
  } else if (drive.kind == DriveKind::kVelocity) {
    const double output = axis.servo_on ? state_.dacs[index].Output() : 0;
    for (int64_t t = 0; t < config_.cycle_us; t += config_.servo_us) {
      plant.Advance(drive, output, config_.ServoMs());
    }
  } else {
    plant.velocity = 0;
    if (plant.axis < 0 || !axis.servo_on) return;
    const CommandedMotion commanded = readings_.Commanded(axis_index);
    if (plant.stalled) {
      // Pulses output in the meantime are lost.
      plant.lead = plant.position - commanded.position;
    } else {
      plant.position = commanded.position + plant.lead;
      plant.velocity = commanded.velocity;
    }
  }
}

void DriveTrain::TurnByHand(Plant& plant) {
  plant.velocity = plant.stalled ? 0 : plant.hand;
  plant.position += plant.velocity * static_cast<double>(config_.cycle_us) / 1000;
}

void DriveTrain::AdvanceClosedLoop(size_t index) {
  Plant& plant = state_.plants[index];
  Control& control = state_.controls[static_cast<size_t>(plant.control)];
  const Drive& drive = state_.drives[index];
  const CommandedMotion commanded = readings_.Commanded(static_cast<size_t>(control.axis));
  const auto sub_steps = static_cast<int32_t>(config_.cycle_us / config_.servo_us);
  const double servo_ms = config_.ServoMs();
  const double advance = (commanded.position - control.reference) / sub_steps;
  const bool ideal = drive.kind == DriveKind::kIdeal;
  const double correction =
      state_.gantry.on ? state_.gantry.Correction(static_cast<size_t>(control.axis), state_.axes)
                       : 0;
  for (int32_t i = 0; i < sub_steps; ++i) {
    const double reference = control.reference + i * advance;
    const double error = reference - MeasuredPosition(control);
    state_.dacs[index].value =
        control.Advance(error, commanded.velocity, commanded.acceleration, servo_ms) + correction;
    if (ideal && !plant.stalled) plant.position = reference + advance + plant.lead;
    if (!ideal) plant.Advance(drive, state_.dacs[index].Output(), servo_ms);
  }
  control.reference = commanded.position;
  if (!ideal) return;
  plant.velocity = plant.stalled ? 0 : commanded.velocity;
  if (plant.stalled) {
    plant.lead = plant.position - commanded.position;
  } else {
    plant.position = commanded.position + plant.lead;
  }
}

double DriveTrain::MeasuredPosition(const Control& control) const {
  const Axis& axis = state_.axes[static_cast<size_t>(control.axis)];
  if (control.encoder < 0) return axis.encoder.position;
  const auto index = static_cast<size_t>(control.encoder);
  const Encoder& encoder = state_.encoders[index];
  if (!encoder.active || (axis.encoder_map >> index & 1) == 0) return axis.encoder.position;
  return axis.encoder.position +
         axis.encoder_scale.Apply(readings_.EncoderSource(index) - encoder.source);
}

void DriveTrain::CountEncoder(size_t index, bool bus) {
  Encoder& encoder = state_.encoders[index];
  const double place = bus ? readings_.SourcePosition(index) : readings_.TerminalPosition(index);
  const double source = readings_.AsRead(index, place);
  if (source == encoder.source && encoder.resting()) return;
  const double cycle_ms = static_cast<double>(config_.cycle_us) / 1000;
  const double counted = encoder.active ? source - encoder.source : 0;
  const double velocity = counted / cycle_ms;
  encoder.acceleration = (velocity - encoder.velocity) / cycle_ms;
  encoder.velocity = velocity;
  encoder.position += counted;
  encoder.source = source;
}

void DriveTrain::AdvanceEncoderFault(size_t index) {
  EncoderFault& fault = state_.encoder_faults[index];
  if (fault.held) {
    // Motion while the signal is interrupted is never counted.
    fault.slip += state_.encoders[index].source - readings_.EncoderSource(index);
    return;
  }
  fault.error = fault.noise == 0 ? 0 : fault.NextError();
  fault.slip += fault.drift * static_cast<double>(config_.cycle_us) / 1000;
}

bool DriveTrain::EncoderSilent(Control& control) {
  ResponseCheck& check = control.check;
  if (!check.on || !control.closed || control.encoder < 0) return false;
  double output = 0;
  for (size_t i = 0; i < axis_count(); ++i) {
    const Dac& dac = state_.dacs[i];
    if (dac.control >= 0 && &state_.controls[static_cast<size_t>(dac.control)] == &control) {
      output = std::fabs(static_cast<double>(dac.Output()));
    }
  }
  const Encoder& encoder = state_.encoders[static_cast<size_t>(control.encoder)];
  const bool silent = output > check.threshold && std::fabs(encoder.velocity) < check.min_velocity;
  if (silent && !check.silent) check.silent_since = now();
  check.silent = silent;
  return silent && now() - check.silent_since >= check.time;
}

}  // namespace oncard::motion
