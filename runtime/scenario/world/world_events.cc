#include "runtime/scenario/world/world_events.h"

#include <algorithm>
#include <memory>

namespace oncard::runtime {
namespace {

using motion::WorldEvent;
using motion::WorldEventKind;
using motion::WorldEvents;

AxisUnit UnitOf(const MotorSetup& motor) {
  return motor.unit.empty() ? AxisUnit() : AxisUnit{motor.unit, motor.pulses_per_unit};
}

static_assert(kReactionMax <= Reactions::kMax);

uint8_t FromZero(int number) { return static_cast<uint8_t>(number - 1); }

void AddInput(const InputEvent& input, WorldEvents& events) {
  for (int bit = 0; bit < motion::DiWidth(input.type); ++bit) {
    if (input.index != 0 && input.index != bit + 1) continue;
    const uint32_t level = input.index == 0 ? input.value >> bit & 1 : input.value;
    events.push_back({.at = input.at_us,
                      .kind = WorldEventKind::kPin,
                      .item = static_cast<uint8_t>(input.type),
                      .index = static_cast<uint16_t>(bit),
                      .value = static_cast<double>(level)});
  }
}

/// The event that begins a fault. The seed of noise is the number of the axis.
WorldEvent BeginOf(const World& world, const WorldFault& fault) {
  const uint8_t axis = FromZero(fault.number);
  switch (fault.kind) {
    case FaultKind::kStall:
      return {fault.at_us, WorldEventKind::kStall, axis, 0, 1};
    case FaultKind::kLostEncoder:
      return {fault.at_us, WorldEventKind::kEncoderHeld, axis, 0, 1};
    case FaultKind::kNoise:
      return {fault.at_us, WorldEventKind::kEncoderNoise, axis, axis, fault.amount};
    case FaultKind::kSlip:
      return {fault.at_us, WorldEventKind::kEncoderDrift, axis, 0,
              UnitOf(world, fault.number).ToPulses(fault.amount, AxisMeasure::kVelocity)};
    case FaultKind::kAlarm:
      return {fault.at_us, WorldEventKind::kPin, static_cast<uint8_t>(motion::DiType::kAlarm), axis,
              1};
    case FaultKind::kCutSwitch:
      break;
  }
  return {fault.at_us, WorldEventKind::kSwitchConnected, 0, axis, 0};
}

/// Ends come before beginnings, so that one fault can follow another at the same instant.
void AddFaults(const World& world, WorldEvents& events) {
  for (const WorldFault& fault : world.faults) {
    if (!fault.until_us) continue;
    WorldEvent end = BeginOf(world, fault);
    end.at = *fault.until_us;
    end.value = fault.kind == FaultKind::kCutSwitch ? 1 : 0;
    events.push_back(end);
  }
  for (const WorldFault& fault : world.faults) events.push_back(BeginOf(world, fault));
}

/// In whole cycles, so that the distance is exact. Ends come before beginnings, as with faults.
void AddHands(const std::vector<HandTurn>& hands, const CardClock& clock, WorldEvents& events) {
  for (const HandTurn& turn : hands) {
    events.push_back({turn.until_us, WorldEventKind::kHand, FromZero(turn.number), 0, 0});
  }
  for (const HandTurn& turn : hands) {
    const int64_t cycles = clock.CycleAt(turn.until_us) - clock.CycleAt(turn.at_us);
    const double ms = static_cast<double>(clock.CoreUsOf(cycles)) / 1000;
    events.push_back(
        {turn.at_us, WorldEventKind::kHand, FromZero(turn.number), 0, turn.pulses / ms});
  }
}

/// From instants and velocities outside to those of the core.
void TellCore(const CardClock& clock, WorldEvents& events) {
  for (WorldEvent& event : events) {
    const bool turns = event.kind == WorldEventKind::kHand;
    event.at = turns ? clock.CoreUsOf(clock.CycleAt(event.at)) : clock.CoreUs(event.at);
    if (event.kind == WorldEventKind::kEncoderDrift) event.value *= clock.MsPerCoreMs();
  }
}

double InPulses(const World& world, int axis, double position) {
  return UnitOf(world, axis).ToPulses(position, AxisMeasure::kPosition);
}

void AddMove(const World& world, const SwitchMove& move, WorldEvents& events) {
  const uint16_t contact = FromZero(move.number);
  const int axis = world.switches[contact].axis;
  events.push_back(
      {move.at_us, WorldEventKind::kSwitchFirst, 0, contact, InPulses(world, axis, move.from)});
  events.push_back(
      {move.at_us, WorldEventKind::kSwitchLast, 0, contact, InPulses(world, axis, move.to)});
}

void AddModule(const ModuleEvent& module, WorldEvents& events) {
  const auto item = static_cast<uint8_t>(module.module);
  if (module.inputs) {
    events.push_back({module.at_us, WorldEventKind::kModuleInputs, item, 0,
                      static_cast<double>(*module.inputs)});
  }
  for (size_t i = 0; i < module.volts.size(); ++i) {
    events.push_back({module.at_us, WorldEventKind::kModuleVoltage, item, static_cast<uint16_t>(i),
                      module.volts[i]});
  }
}

/// The setup in pulses and milliseconds.
MotorSetup InPulses(MotorSetup setup) {
  const AxisUnit unit = UnitOf(setup);
  for (double MotorSetup::*position :
       {&MotorSetup::position, &MotorSetup::index_offset, &MotorSetup::index_period}) {
    setup.*position = unit.ToPulses(setup.*position, AxisMeasure::kPosition);
  }
  for (double MotorSetup::*velocity :
       {&MotorSetup::gain, &MotorSetup::friction, &MotorSetup::max_vel}) {
    setup.*velocity = unit.ToPulses(setup.*velocity, AxisMeasure::kVelocity);
  }
  setup.max_acc = unit.ToPulses(setup.max_acc, AxisMeasure::kAcceleration);
  return setup;
}

/// What a drive does per millisecond, as the core counts them.
void SetUpDrive(const MotorSetup& setup, const CardClock& clock, motion::MotionCore& core) {
  const size_t index = FromZero(setup.axis);
  const double ms = clock.MsPerCoreMs();
  if (setup.drive == motion::DriveKind::kVelocity) {
    core.ConnectDrive(index, motion::VelocityDrive(setup.gain * ms, setup.tau_ms / ms,
                                                   setup.friction * ms, core.config().ServoMs()));
  }
  core.WatchLimits(index, {setup.max_vel * ms, setup.max_acc * ms * ms});
}

void SetUpMotor(const MotorSetup& setup, const CardClock& clock, motion::MotionCore& core) {
  const size_t index = FromZero(setup.axis);
  SetUpDrive(setup, clock, core);
  core.SetIndexMarks(index, {setup.index_offset, setup.index_period});
  core.PlaceMotor(index, setup.position);
}

/// The number of a slave among those that are connected.
uint8_t ConnectedNumber(const BusSetup& bus, size_t slave) {
  const auto end = bus.slaves.begin() + static_cast<std::ptrdiff_t>(slave);
  return static_cast<uint8_t>(std::count_if(
      bus.slaves.begin(), end, [](const BusSlaveSetup& each) { return !each.absent; }));
}

void AddBus(const BusSetup& bus, WorldEvents& events) {
  for (size_t i = 0; i < bus.slaves.size(); ++i) {
    const BusSlaveSetup& slave = bus.slaves[i];
    if (slave.absent) continue;
    const uint8_t number = ConnectedNumber(bus, i);
    const auto add = [&](const std::optional<int64_t>& at, WorldEventKind kind) {
      if (at) events.push_back({*at, kind, number, 0, 1});
    };
    add(slave.lost_at_us, WorldEventKind::kBusLost);
    add(slave.silent_at_us, WorldEventKind::kBusSilent);
  }
  for (const BusInputEvent& event : bus.inputs) {
    const auto number = static_cast<size_t>(event.slave);
    const auto terminal = FindTerminal(SlaveOf(bus.slaves[number]), event.object);
    if (bus.slaves[number].absent || !terminal) continue;
    events.push_back({event.at_us,
                      terminal->probe ? WorldEventKind::kBusProbe : WorldEventKind::kBusTerminal,
                      ConnectedNumber(bus, number), terminal->item, event.value});
  }
}

/// Slaves that an ENI file describes, and those that are connected.
void ConnectBus(const BusSetup& bus, motion::MotionCore& core) {
  if (bus.slaves.empty() && bus.configured.empty()) return;
  motion::bus::Slaves configured;
  motion::bus::Slaves connected;
  for (const BusSlaveSetup& setup : bus.configured) configured.push_back(SlaveOf(setup));
  for (const BusSlaveSetup& setup : bus.slaves) {
    if (bus.configured.empty()) configured.push_back(SlaveOf(setup));
    if (!setup.absent) connected.push_back(SlaveOf(setup));
  }
  core.ConnectBus(std::make_shared<const motion::bus::Slaves>(std::move(configured)),
                  std::make_shared<const motion::bus::Slaves>(std::move(connected)));
}

motion::PositionSwitch SwitchOf(const World& world, const SwitchSetup& setup) {
  return {.axis = FromZero(setup.axis),
          .type = setup.type,
          .bit = FromZero(setup.index),
          .first = InPulses(world, setup.axis, setup.from),
          .last = InPulses(world, setup.axis, setup.to),
          .active_low = setup.active_low};
}

}  // namespace

AxisUnit UnitOf(const World& world, int axis) {
  const auto motor = std::ranges::find(world.motors, axis, &MotorSetup::axis);
  return motor == world.motors.end() ? AxisUnit() : UnitOf(*motor);
}

WorldEvents EventsOf(const World& world, const BusSetup& bus, const CardClock& clock) {
  WorldEvents events;
  for (const InputEvent& input : world.inputs) AddInput(input, events);
  for (const SwitchMove& move : world.moves) AddMove(world, move, events);
  AddFaults(world, events);
  AddHands(world.hands, clock, events);
  for (const VoltageEvent& voltage : world.voltages) {
    events.push_back(
        {voltage.at_us, WorldEventKind::kAdc, FromZero(voltage.channel), 0, voltage.volts});
  }
  for (const ModuleEvent& module : world.modules) AddModule(module, events);
  AddBus(bus, events);
  TellCore(clock, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const WorldEvent& a, const WorldEvent& b) { return a.at < b.at; });
  return events;
}

std::vector<Reactions::Reaction> ReactionsOf(const World& world) {
  std::vector<Reactions::Reaction> reactions;
  for (const InputReaction& each : world.reactions) {
    AddInput(each.input, reactions.emplace_back(Reactions::Reaction{each.after_us, {}}).events);
  }
  return reactions;
}

void SetUpWorld(const World& world, const BusSetup& bus, const CardClock& clock,
                motion::MotionCore& core) {
  for (const MotorSetup& motor : world.motors) SetUpMotor(InPulses(motor), clock, core);
  for (const SwitchSetup& contact : world.switches) core.AddSwitch(SwitchOf(world, contact));
  for (size_t i = 0; i < motion::kModuleCount && !world.modules.empty(); ++i) {
    core.module(i).present = false;
  }
  for (const ModuleEvent& module : world.modules) {
    core.module(static_cast<size_t>(module.module)).present = true;
  }
  ConnectBus(bus, core);
}

void FollowClock(const World& world, const BusSetup& bus, const CardClock& clock,
                 motion::MotionCore& core) {
  for (const MotorSetup& motor : world.motors) SetUpDrive(InPulses(motor), clock, core);
  // The events that have happened are the same ones, and come before the others as they did.
  core.SetEvents(std::make_shared<const WorldEvents>(EventsOf(world, bus, clock)));
}

}  // namespace oncard::runtime
