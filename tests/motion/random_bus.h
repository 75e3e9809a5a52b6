// Random cards with drives on a bus, and random commands for them. The same seed gives the same
// card and the same commands.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "motion/motion_core.h"
#include "tests/motion/bus/bus_card.h"
#include "tests/motion/random_world.h"

namespace oncard::motion {

/// A drive with all process data, the manual's, or some that few drives have.
inline bus::Slave RandomBusDrive(int axis, RandomNumbers& random) {
  bus::Slave drive = bus::FullDrive(axis);
  if (random.OneIn(3)) {
    drive = bus::DefaultSlave(bus::SlaveKind::kDrive);
    drive.axis = static_cast<int8_t>(axis);
  }
  switch (random.Below(100)) {
    case 0:
      drive.outputs[1].bits = 16;  // of the target position
      break;
    case 1:
      drive.outputs.push_back({0x607A, 0, 32});
      break;
    case 2:
      drive.outputs.push_back({0x6065, 0, 32});
      break;
    case 3:
      drive.inputs[1].bits = 24;  // of the measured position
      break;
    case 4:
      drive.inputs.push_back({0x6062, 0, 32});
      drive.inputs.push_back({0x6077, 0, 16});
      break;
    case 5:
      drive.outputs.push_back({0x607D, 1, 32});
      drive.outputs.push_back({0x607D, 2, 32});
      break;
    default:
      break;
  }
  return drive;
}

inline bus::Slaves RandomSlaves(const MotionConfig& config, RandomNumbers& random) {
  bus::Slaves slaves;
  for (int axis = 0; axis < config.axis_count; ++axis) {
    if (random.OneIn(8)) slaves.push_back(bus::DefaultSlave(bus::SlaveKind::kIo));
    if (random.OneIn(16)) slaves.push_back(bus::DefaultSlave(bus::SlaveKind::kCoupler));
    if (random.OneIn(100)) slaves.push_back(RandomBusDrive(random.OneIn(2) ? -1 : axis, random));
    if (!random.OneIn(6)) slaves.push_back(RandomBusDrive(axis, random));
  }
  return slaves;
}

inline void AppendBusEvents(const bus::Slaves& slaves, WorldEvents& events, RandomNumbers& random) {
  Micros at = 0;
  for (int count = random.Below(16); count > 0 && !slaves.empty(); --count) {
    at += random.Below(200'000);
    const auto number = static_cast<uint8_t>(random.Below(static_cast<int>(slaves.size())));
    const double level = random.Below(2);
    if (random.OneIn(12)) {
      const auto kind = random.OneIn(2) ? WorldEventKind::kBusLost : WorldEventKind::kBusSilent;
      events.push_back({at, kind, number, 0, 1});
      events.push_back({at + 20'000, kind, number, 0, 0});
    } else if (slaves[number].kind != bus::SlaveKind::kDrive) {
      events.push_back({at, WorldEventKind::kBusTerminal, number, 0, level * 77});
    } else if (random.OneIn(3)) {
      events.push_back({at, WorldEventKind::kBusTerminal, number,
                        static_cast<uint16_t>(bus::ObjectId::kAnalogInput1), level * 50});
    } else {
      const auto probe = static_cast<uint16_t>(random.Below(bus::kProbeCount));
      events.push_back({at, WorldEventKind::kBusProbe, number, probe, level});
      events.push_back(
          {at + random.Below(3000), WorldEventKind::kBusProbe, number, probe, 1 - level});
    }
  }
  std::ranges::stable_sort(events, {}, &WorldEvent::at);
}

/// Brings communication to OP; if it starts, the drives of all axes are enabled.
inline void BringUp(MotionCore& core, bool starts) {
  core.bus_line()->Init(core.now());
  for (Micros end = core.now() + 5 * bus::kBusStepUs; core.now() < end;) core.Tick();
  if (!starts) return;
  core.bus_line()->Start();
  for (size_t i = 0; i < core.axis_count(); ++i) core.AxisAt(i).ServoOn();
  for (int i = 0; i < 8; ++i) core.Tick();
}

/// Twelve axes with drives on a bus that have jogged for a while, until 277 ms after power-on.
inline std::unique_ptr<MotionCore> JoggingBusCard(DriveKind kind, WorldEvents events = {}) {
  auto core = std::make_unique<MotionCore>(MotionConfig{.axis_count = 12});
  bus::Slaves slaves;
  for (int i = 0; i < 12; ++i) slaves.push_back(bus::FullDrive(i));
  const auto shared = std::make_shared<const bus::Slaves>(std::move(slaves));
  core->ConnectBus(shared, shared);
  for (size_t i = 0; i < core->axis_count() && kind == DriveKind::kVelocity; ++i) {
    core->ConnectDrive(i, VelocityDrive(100, 2, 0, core->config().ServoMs()));
  }
  core->PowerOn(std::make_shared<const WorldEvents>(std::move(events)));
  BringUp(*core, true);
  for (size_t i = 0; i < core->axis_count(); ++i) {
    core->ProfileAt(i).SelectMode(ProfileMode::kJog);
    core->ProfileAt(i).SetVelocity(10 + static_cast<double>(i));
    core->ProfileAt(i).Start();
  }
  core->Advance(100);
  return core;
}

inline std::unique_ptr<MotionCore> RandomBusCard(uint64_t seed) {
  RandomNumbers random(seed);
  const MotionConfig config = RandomConfig(random);
  auto core = std::make_unique<MotionCore>(config);
  const bool velocity = random.OneIn(2);
  for (size_t i = 0; i < core->axis_count(); ++i) {
    RandomDrive(*core, i, random);
    if (random.OneIn(4)) continue;
    core->ConnectDrive(i, {});
    if (!velocity) continue;
    core->ConnectDrive(i, VelocityDrive(random.Between(20, 200), random.Between(0, 6),
                                        random.OneIn(3) ? 1.5 : 0, config.ServoMs()));
  }
  const bus::Slaves slaves = RandomSlaves(config, random);
  const auto shared = std::make_shared<const bus::Slaves>(slaves);
  core->ConnectBus(shared, shared);
  constexpr DiType kTypes[] = {DiType::kHome, DiType::kLimitPositive, DiType::kLimitNegative};
  for (int switches = random.Below(4); switches > 0; --switches) {
    const double first = random.Between(-4000, 4000);
    core->AddSwitch({.axis = static_cast<uint8_t>(random.Below(config.axis_count)),
                     .type = kTypes[random.Below(3)],
                     .bit = static_cast<uint8_t>(random.Below(8)),
                     .first = first,
                     .last = first + random.Between(1, 500)});
  }
  WorldEvents events = RandomEvents(config, random);
  AppendBusEvents(slaves, events, random);
  core->PowerOn(std::make_shared<const WorldEvents>(std::move(events)));
  BringUp(*core, !random.OneIn(20));
  return core;
}

/// Downloads an object that changes what a drive does, or what it may do.
inline void RandomDownload(MotionCore& core, size_t slave, RandomNumbers& random) {
  using enum bus::ObjectId;
  constexpr bus::ObjectId kObjects[] = {kErrorWindow,   kSoftLimitMin,   kSoftLimitMax,
                                        kProbeFunction, kMode,           kTargetPosition,
                                        kControlWord,   kTargetVelocity, kQuickStopOption};
  const bus::ObjectId id = kObjects[random.Below(9)];
  const bus::ObjectEntry& entry = bus::EntryOf(id);
  int64_t value = random.Below(8000) - 4000;
  if (id == kErrorWindow) value = random.OneIn(2) ? random.Below(200) : 1'000'000;
  if (id == kProbeFunction) value = 0x0101 * (1 + 16 * random.Below(4) + 2 * random.Below(2));
  if (id == kMode) value = random.OneIn(2) ? 8 : random.Below(11);
  if (id == kControlWord) value = random.Below(16);
  if (id == kQuickStopOption) value = random.Below(7);
  std::array<uint8_t, 4> bytes{};
  const std::span<uint8_t> data = std::span(bytes).first(entry.bytes());
  bus::WriteNumber(value, data);
  core.bus_line()->Download(slave, entry.index, entry.subindex, data);
}

/// What a host writes over the process image, for one exchange.
inline void RandomImage(MotionCore& core, RandomNumbers& random) {
  bus::ProcessImage& image = core.bus_line()->image();
  if (image.size() == 0) return;
  const auto offset = static_cast<size_t>(random.Below(static_cast<int>(image.size())));
  const std::array<uint8_t, 1> data = {static_cast<uint8_t>(random.Below(16))};
  image.WriteByHost(offset, data);
}

inline void RandomHoming(MotionCore& core, size_t axis, RandomNumbers& random) {
  constexpr int kMethods[] = {1, 2, 17, 18, 19, 24, 33, 35, 37};
  BusAxes axes = core.bus_axes();
  axes.SetMode(axis, bus::DriveMode::kHoming);
  axes.PrepareHoming(axis, {.method = kMethods[random.Below(9)],
                            .search_speed = random.Between(1, 20),
                            .index_speed = random.Between(1, 5),
                            .acceleration = random.Between(0.1, 1),
                            .offset = random.Below(200)});
  axes.StartHoming(axis);
}

/// Ends faults and what they have latched; all drives in cyclic synchronous position.
inline void RepairBus(MotionCore& core) {
  for (size_t i = 0; i < core.axis_count(); ++i) {
    if (!core.OnBus(i)) continue;
    BusAxes axes = core.bus_axes();
    axes.StopHoming(i);
    axes.SetMode(i, bus::DriveMode::kCyclicPosition);
    axes.ResetFault(i);
  }
  core.Tick();
  core.Tick();
  Repair(core);
}

/// One command of a host to a card with a bus.
inline void RandomBusCommand(MotionCore& core, RandomNumbers& random) {
  if (random.OneIn(3)) return RandomCommand(core, random);
  const auto axis = static_cast<size_t>(random.Below(core.config().axis_count));
  if (!core.OnBus(axis)) return RandomMove(core, axis, random);
  const auto slave = static_cast<size_t>(core.state().bus->axes[axis].slave);
  switch (random.Below(24)) {
    case 0:
      core.bus_axes().SetMode(axis, static_cast<bus::DriveMode>(random.Below(11)));
      break;
    case 1:
      RandomHoming(core, axis, random);
      break;
    case 2:
      core.bus_axes().SetScale(axis, static_cast<uint8_t>(random.Below(5)));
      break;
    case 3:
    case 4:
      RandomDownload(core, slave, random);
      break;
    case 5:
      RandomImage(core, random);
      break;
    case 6:
      core.bus_line()->SetOutput(slave, bus::ObjectId::kProbeFunction, 0x1111 * random.Below(4));
      break;
    case 7:
      if (random.OneIn(3)) core.TerminateBus();
      break;
    case 8:
      if (core.state().bus->line.phase() == bus::BusPhase::kDown) BringUp(core, true);
      break;
    case 9:
      core.PlaceMotor(axis, random.Below(1000));
      break;
    case 10:
      if (random.OneIn(4)) core.Reset();
      break;
    case 11:
      core.EncoderAt(axis).SetPosition(random.Below(1000));
      break;
    case 12:
    case 13:
    case 14:
      RepairBus(core);
      break;
    default:
      RandomMove(core, axis, random);
  }
}

}  // namespace oncard::motion
