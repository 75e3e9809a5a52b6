#include "motion/world.h"

#include <utility>

#include "motion/common/rounding.h"

namespace oncard::motion {

void World::PowerOn(std::shared_ptr<const WorldEvents> events) {
  state_.world = {std::move(events), 0};
  ApplyEvents();
  for (const PositionSwitch& contact : state_.switches) {
    state_.io.SetPin(contact.type, contact.bit,
                     contact.Level(state_.plants[contact.axis].position));
  }
  state_.io.Settle();
  for (Adc& adc : state_.adcs) adc.filtered = adc.volts;
}

void World::Replace(std::shared_ptr<const WorldEvents> events) {
  state_.world.events = std::move(events);
  for (size_t i = 0; i < state_.world.next; ++i) {
    const WorldEvent& event = (*state_.world.events)[i];
    if (event.kind == WorldEventKind::kHand) state_.plants[event.item].hand = event.value;
    if (event.kind == WorldEventKind::kEncoderDrift) {
      state_.encoder_faults[event.item].drift = event.value;
    }
  }
}

void World::ApplyEvents() {
  WorldProgress& world = state_.world;
  if (world.events == nullptr) return;
  const WorldEvents& events = *world.events;
  for (; world.next < events.size(); ++world.next) {
    const WorldEvent& event = events[static_cast<size_t>(world.next)];
    if (event.at > now()) break;
    Apply(event);
  }
}

void World::Happen(WorldEvent event) {
  event.at = now();
  Apply(event);
}

void World::Apply(const WorldEvent& event) {
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
      if (event.value == 0 && !state_.axes[readings_.EnablingAxis(item)].servo_on)
        state_.plants[item].velocity = 0;
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
    case WorldEventKind::kSwitchFirst:
      state_.switches[event.index].first = event.value;
      break;
    case WorldEventKind::kSwitchLast:
      state_.switches[event.index].last = event.value;
      break;
    case WorldEventKind::kBusProbe:
    case WorldEventKind::kBusTerminal:
    case WorldEventKind::kBusLost:
    case WorldEventKind::kBusSilent:
      ApplyToBus(event);
      break;
  }
}

void World::ApplyToBus(const WorldEvent& event) {
  bus::Bus& line = state_.bus->line;
  bus::SlaveState& slave = line.slave(event.item);
  switch (event.kind) {
    case WorldEventKind::kBusProbe:
      // The drive has already seen the edge in the cycle before.
      slave.drive->SetProbeLevel(event.index, event.value != 0);
      break;
    case WorldEventKind::kBusTerminal:
      line.SetTerminal(event.item, event.index, static_cast<int64_t>(event.value));
      break;
    case WorldEventKind::kBusLost:
      slave.lost = event.value != 0;
      break;
    default:
      slave.silent = event.value != 0;
  }
}

void World::DrivePin(const WorldEvent& event) {
  const auto type = static_cast<DiType>(event.item);
  const bool level = event.value != 0;
  const bool before = (state_.io.Pins(type) >> event.index & 1) != 0;
  state_.io.SetPin(type, event.index, level);
  // An edge within a cycle has already been handled there.
  if (level == before || event.at != now() || !state_.capture.armed()) return;
  state_.capture.Edge(type, event.index, level,
                      [&](size_t encoder) { return Whole(readings_.CountedPosition(encoder)); });
}

}  // namespace oncard::motion
