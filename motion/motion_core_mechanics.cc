// The part of the motion core between planned positions and measured ones: servo controllers, pulse
// outputs, motors, encoders, and the world's events.
// Tested by tests/motion/control_test.cc, plant_test.cc, encoder_test.cc and world_test.cc.
#include <bit>
#include <cmath>
#include <utility>

#include "motion/common/rounding.h"
#include "motion/motion_core.h"

namespace oncard::motion {

// --- Outside the card --------------------------------------------------------------------------

void MotionCore::PowerOn(std::shared_ptr<const WorldEvents> events) {
  state_.world = {std::move(events), 0};
  ApplyWorldEvents();
  for (const PositionSwitch& contact : state_.switches) {
    state_.io.SetPin(contact.type, contact.bit,
                     contact.Level(state_.plants[contact.axis].position));
  }
  state_.io.Settle();
  for (Adc& adc : state_.adcs) adc.filtered = adc.volts;
  LatchCauses();
}

void MotionCore::PlaceMachine(size_t machine, double position) {
  Plant& plant = state_.plants[machine];
  plant.lead += position - plant.position;
  plant.position = position;
  RebaseEncoder(machine);
}

void MotionCore::ApplyWorldEvents() {
  WorldProgress& world = state_.world;
  if (world.events == nullptr) return;
  const WorldEvents& events = *world.events;
  for (; world.next < events.size(); ++world.next) {
    const WorldEvent& event = events[static_cast<size_t>(world.next)];
    if (event.at > now()) break;
    Apply(event);
  }
}

void MotionCore::Apply(const WorldEvent& event) {
  const size_t item = event.item;
  switch (event.kind) {
    case WorldEventKind::kPin:
      DrivePin(event);
      break;
    case WorldEventKind::kAdc:
      state_.adcs[item].volts = event.value;
      break;
    case WorldEventKind::kModuleInputs:
      state_.modules[item].inputs = static_cast<uint16_t>(event.value);
      break;
    case WorldEventKind::kModuleVoltage:
      state_.modules[item].input_volts[event.index] = event.value;
      break;
    case WorldEventKind::kStall:
      state_.plants[item].stalled = event.value != 0;
      if (event.value != 0) state_.plants[item].velocity = 0;
      break;
    case WorldEventKind::kHand:
      state_.plants[item].hand = event.value;
      if (event.value == 0 && !Enabled(item)) state_.plants[item].velocity = 0;
      break;
    case WorldEventKind::kEncoderHeld:
      state_.encoder_faults[item].held = event.value != 0;
      break;
    case WorldEventKind::kEncoderNoise:
      state_.encoder_faults[item].noise = static_cast<int32_t>(event.value);
      state_.encoder_faults[item].random = event.index;
      break;
    case WorldEventKind::kEncoderDrift:
      state_.encoder_faults[item].drift = event.value;
      break;
    case WorldEventKind::kSwitchConnected:
      state_.switches[event.index].connected = event.value != 0;
      break;
  }
}

void MotionCore::DrivePin(const WorldEvent& event) {
  const auto type = static_cast<DiType>(event.item);
  const bool level = event.value != 0;
  const bool before = (state_.io.Pins(type) >> event.index & 1) != 0;
  state_.io.SetPin(type, event.index, level);
  // An edge within a cycle has already been handled there.
  if (level == before || event.at != now() || !state_.capture.armed()) return;
  state_.capture.Edge(type, event.index, level,
                      [&](size_t encoder) { return Whole(CountedPosition(encoder)); });
}

// --- Configuration -----------------------------------------------------------------------------

void MotionCore::ResetMachine() {
  const CardDefaults& defaults = config_.defaults;
  state_.encoders.fill({.external = defaults.encoders_external,
                        .reversed = defaults.encoders_reversed,
                        .wired_reversed = defaults.encoders_reversed});
  state_.dacs.fill({});
  for (Adc& adc : state_.adcs) adc = {.volts = adc.volts, .filtered = adc.volts};
  for (ExtensionModule& module : state_.modules) {
    module.outputs = 0;
    module.output_volts.fill(0);
  }
  for (size_t i = 0; i < kAxisMax; ++i) {
    state_.controls[i] = DefaultControl(static_cast<int>(i));
    state_.controls[i].error_limit = defaults.following_error_limit;
    state_.steps[i] = {};
    state_.steps[i].axis = static_cast<int8_t>(i);
    // The machine does not move; its encoder counts from here.
    RebaseEncoder(i);
    state_.plants[i].lead = state_.plants[i].position;
  }
  Wire();
  for (size_t i = 0; i < axis_count() && defaults.closed_loop; ++i) SetClosedLoop(i, true);
}

void MotionCore::Wire() {
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

void MotionCore::RestartDrives() {
  Wire();
  for (Step& step : state_.steps) {
    if (step.axis >= 0) {
      step.lead = step.position - CommandedPosition(static_cast<uint8_t>(step.axis));
    }
  }
  for (size_t i = 0; i < kAxisMax; ++i) {
    if (state_.axes[i].servo_on) EnableMachine(i);
  }
}

void MotionCore::SetClosedLoop(size_t axis, bool closed) {
  Control& control = state_.controls[axis];
  control.closed = closed;
  if (closed) control.active = true;
  Dac& dac = state_.dacs[axis];
  dac.control = closed ? static_cast<int8_t>(axis) : int8_t{-1};
  dac.value = 0;
  Wire();
}

bool MotionCore::InClosedLoop(size_t axis) const {
  for (const Control& control : state_.controls) {
    if (control.closed && control.axis == static_cast<int8_t>(axis)) return true;
  }
  return false;
}

// --- Drives ------------------------------------------------------------------------------------

void MotionCore::EnableMachine(size_t axis) {
  const auto number = static_cast<int8_t>(axis);
  for (Control& control : state_.controls) {
    if (!control.closed || control.axis != number) continue;
    AlignWithEncoder(axis);
    control.Begin(CommandedPosition(axis));
  }
  for (Plant& plant : state_.plants) {
    if (plant.axis == number) plant.lead = plant.position - CommandedPosition(axis);
  }
}

void MotionCore::DisableMachine(size_t axis) {
  for (size_t i = 0; i < kAxisMax; ++i) {
    const Plant& plant = state_.plants[i];
    if (plant.control >= 0 && plant.axis == static_cast<int8_t>(axis)) state_.dacs[i].value = 0;
  }
}

void MotionCore::KeepMachine(size_t axis, double difference) {
  const auto number = static_cast<int8_t>(axis);
  for (size_t i = 0; i < kAxisMax; ++i) {
    if (state_.plants[i].axis == number) state_.plants[i].lead += difference;
    if (state_.steps[i].axis == number) state_.steps[i].lead += difference;
    if (state_.controls[i].axis == number) state_.controls[i].reference -= difference;
  }
}

void MotionCore::AlignWithEncoder(size_t index) {
  Axis& axis = state_.axes[index];
  // The measured position includes the compensation.
  const double measured = axis.encoder.position - state_.compensations[index].Amount();
  const uint32_t map = axis.profile_map & ((uint32_t{1} << axis_count()) - 1);
  if (std::has_single_bit(map) && !IsGantrySlave(index)) {
    // The position of the axis' own profile is set too, so that both agree as after
    // GT_SynchAxisPos.
    const auto profile = static_cast<size_t>(std::countr_zero(map));
    const Scale& scale = axis.profile_scale;
    SetProfilePosition(profile, measured * scale.alpha / scale.beta);
  }
  RenamePlanned(index, measured);
}

void MotionCore::AdvancePlant(size_t index) {
  Step& step = state_.steps[index];
  if (step.active && step.axis >= 0) {
    step.position = CommandedPosition(static_cast<size_t>(step.axis)) + step.lead;
  }
  Plant& plant = state_.plants[index];
  const Drive& drive = state_.drives[index];
  const size_t axis_index = EnablingAxis(index);
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
    const double commanded = CommandedPosition(axis_index);
    if (plant.stalled) {
      // Pulses output in the meantime are lost.
      plant.lead = plant.position - commanded;
    } else {
      plant.position = commanded + plant.lead;
      plant.velocity = axis.profile.velocity;
    }
  }
}

void MotionCore::TurnByHand(Plant& plant) {
  plant.velocity = plant.stalled ? 0 : plant.hand;
  plant.position += plant.velocity * static_cast<double>(config_.cycle_us) / 1000;
}

void MotionCore::AdvanceClosedLoop(size_t index) {
  Plant& plant = state_.plants[index];
  Control& control = state_.controls[static_cast<size_t>(plant.control)];
  const Drive& drive = state_.drives[index];
  const Axis& axis = state_.axes[static_cast<size_t>(control.axis)];
  const double commanded = CommandedPosition(static_cast<size_t>(control.axis));
  const auto sub_steps = static_cast<int32_t>(config_.cycle_us / config_.servo_us);
  const double servo_ms = config_.ServoMs();
  const double advance = (commanded - control.reference) / sub_steps;
  const bool ideal = drive.kind == DriveKind::kIdeal;
  const double correction =
      state_.gantry.on ? GantryCorrection(static_cast<size_t>(control.axis)) : 0;
  for (int32_t i = 0; i < sub_steps; ++i) {
    const double reference = control.reference + i * advance;
    const double error = reference - MeasuredPosition(control);
    state_.dacs[index].value =
        control.Advance(error, axis.profile.velocity, axis.profile.acceleration, servo_ms) +
        correction;
    if (ideal && !plant.stalled) plant.position = reference + advance + plant.lead;
    if (!ideal) plant.Advance(drive, state_.dacs[index].Output(), servo_ms);
  }
  control.reference = commanded;
  if (!ideal) return;
  plant.velocity = plant.stalled ? 0 : axis.profile.velocity;
  if (plant.stalled) {
    plant.lead = plant.position - commanded;
  } else {
    plant.position = commanded + plant.lead;
  }
}

double MotionCore::MeasuredPosition(const Control& control) const {
  const Axis& axis = state_.axes[static_cast<size_t>(control.axis)];
  if (control.encoder < 0) return axis.encoder.position;
  const auto index = static_cast<size_t>(control.encoder);
  const Encoder& encoder = state_.encoders[index];
  if (!encoder.active || (axis.encoder_map >> index & 1) == 0) return axis.encoder.position;
  return axis.encoder.position + axis.encoder_scale.Apply(EncoderSource(index) - encoder.source);
}

// --- Compensation ------------------------------------------------------------------------------

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

void MotionCore::SetBacklash(size_t axis, const Backlash& backlash) {
  state_.compensations[axis].SetBacklash(backlash);
  state_.compensates = true;
}

void MotionCore::SetPitchTable(size_t axis, PitchTablePointer table) {
  state_.compensations[axis].pitch_table = std::move(table);
}

void MotionCore::EnablePitchCompensation(size_t axis, bool on) {
  state_.compensations[axis].pitch_on = on;
  state_.compensates = true;
}

// --- Following error ---------------------------------------------------------------------------

bool MotionCore::FollowingErrorExceeded(size_t axis) const {
  const auto number = static_cast<int8_t>(axis);
  const double error = std::fabs(CommandedPosition(axis) - state_.axes[axis].encoder.position);
  for (const Control& control : state_.controls) {
    if (!control.active || control.axis != number) continue;
    if (error > static_cast<double>(control.error_limit)) return true;
  }
  return false;
}

void MotionCore::JudgeControl(Control& control) {
  if (!control.active || control.axis < 0) return;
  const auto index = static_cast<size_t>(control.axis);
  const Axis& axis = state_.axes[index];
  if (!axis.servo_on) return;
  const double error = std::fabs(CommandedPosition(index) - axis.encoder.position);
  if (error <= static_cast<double>(control.error_limit) && !EncoderSilent(control)) return;
  FailControl(control, error);
}

void MotionCore::FailControl(const Control& control, double error) {
  const auto index = static_cast<size_t>(control.axis);
  Axis& axis = state_.axes[index];
  const auto limit = static_cast<double>(control.error_limit);
  if (error > limit) {
    Tell(HappeningKind::kFollowingError, index, error, limit);
  } else {
    Tell(HappeningKind::kEncoderSilent, index, axis.encoder.velocity, control.check.min_velocity);
  }
  axis.latched |= kFollowingErrorBit;
  if (config_.defaults.following_error_stops) ServoOff(index);
}

bool MotionCore::EncoderSilent(Control& control) {
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

// --- Encoders ----------------------------------------------------------------------------------

void MotionCore::SetEncoderSense(size_t encoder, bool reversed) {
  state_.encoders[encoder].reversed = reversed;
  RebaseEncoder(encoder);
}

void MotionCore::SetEncoderExternal(size_t encoder, bool external) {
  state_.encoders[encoder].external = external;
  RebaseEncoder(encoder);
}

void MotionCore::CountEncoder(size_t index) {
  Encoder& encoder = state_.encoders[index];
  const double source = EncoderSource(index);
  if (source == encoder.source && encoder.resting()) return;
  const double cycle_ms = static_cast<double>(config_.cycle_us) / 1000;
  const double counted = encoder.active ? source - encoder.source : 0;
  const double velocity = counted / cycle_ms;
  encoder.acceleration = (velocity - encoder.velocity) / cycle_ms;
  encoder.velocity = velocity;
  encoder.position += counted;
  encoder.source = source;
}

void MotionCore::AdvanceEncoderFault(size_t index) {
  EncoderFault& fault = state_.encoder_faults[index];
  if (fault.held) {
    // Motion while the signal is interrupted is never counted.
    fault.slip += state_.encoders[index].source - EncoderSource(index);
    return;
  }
  fault.error = fault.noise == 0 ? 0 : fault.NextError();
  fault.slip += fault.drift * static_cast<double>(config_.cycle_us) / 1000;
}

}  // namespace oncard::motion
