// Random cards for comparisons of two ways to advance a card: drives, controllers, inputs,
// switches, events outside the card, and random commands between cycles. The same seed gives the
// same card and the same commands.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

namespace oncard::motion {

/// splitmix64: the same numbers on every machine.
class RandomNumbers {
 public:
  explicit RandomNumbers(uint64_t seed) : state_(seed) {}

  uint64_t Next() {
    state_ += 0x9E3779B97F4A7C15u;
    uint64_t bits = state_;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    return bits ^ (bits >> 31);
  }
  int Below(int bound) { return static_cast<int>(Next() % static_cast<uint64_t>(bound)); }
  bool OneIn(int n) { return Below(n) == 0; }
  /// In [low, high), in steps of 2^-10 of the range.
  double Between(double low, double high) { return low + (high - low) * Below(1024) / 1024; }

 private:
  uint64_t state_;
};

inline MotionConfig RandomConfig(RandomNumbers& random) {
  constexpr int kAxisCounts[] = {1, 2, 3, 4, 8, 12};
  constexpr int64_t kTimes[][2] = {{250, 125}, {250, 125}, {1000, 125}, {500, 250}, {375, 125}};
  MotionConfig config;
  config.axis_count = kAxisCounts[random.Below(6)];
  const auto& times = kTimes[random.Below(5)];
  config.cycle_us = times[0];
  config.servo_us = times[1];
  return config;
}

/// Gives a motor a drive and, in half of the cases, a servo controller.
inline void RandomDrive(MotionCore& core, size_t axis, RandomNumbers& random) {
  MotionState& state = ChangeState(core);
  if (random.OneIn(2)) {
    state.drives[axis] = VelocityDrive(random.Between(20, 200), random.Between(0, 6),
                                       random.OneIn(3) ? 1.5 : 0, core.config().ServoMs());
  }
  PidSet& set = state.controls[axis].sets[0];
  set = {.kp = random.Between(1, 30),
         .ki = random.OneIn(2) ? random.Between(0, 8) : 0,
         .kd = random.OneIn(2) ? random.Between(0, 20) : 0,
         .kvff = random.OneIn(2) ? random.Between(0, 300) : 0,
         .kaff = random.OneIn(3) ? random.Between(0, 100) : 0};
  if (random.OneIn(4)) set.kvff_filter = static_cast<int16_t>(random.Below(4));
  if (random.OneIn(5)) set.kvff_acc_max = random.Between(0.1, 2);
  if (random.OneIn(5)) set.integral_limit = random.Below(2000);
  if (random.OneIn(5)) set.limit = static_cast<int16_t>(random.Below(32767));
  state.dacs[axis].bias = static_cast<int16_t>(random.OneIn(4) ? random.Below(200) - 100 : 0);
  if (random.OneIn(6)) state.controls[axis].error_limit = random.Below(400);
  if (random.OneIn(2)) core.AxisAt(axis).SetClosedLoop(true);
  if (random.OneIn(4)) core.EncoderAt(axis).SetSense(true);
  if (random.OneIn(5)) core.EncoderAt(axis).SetExternal(false);
}

inline WorldEvents RandomEvents(const MotionConfig& config, RandomNumbers& random) {
  WorldEvents events;
  Micros at = 0;
  for (int count = random.Below(12); count > 0; --count) {
    at += random.Below(2'000'000) * (random.OneIn(2) ? 1 : config.cycle_us / 125);
    const auto motor = static_cast<uint8_t>(random.Below(config.axis_count));
    const double level = random.Below(2);
    switch (random.Below(6)) {
      case 0:
        events.push_back({at, WorldEventKind::kPin, static_cast<uint8_t>(DiType::kGpi),
                          static_cast<uint16_t>(random.Below(16)), level});
        break;
      case 1:
        events.push_back({at, WorldEventKind::kPin, static_cast<uint8_t>(DiType::kLimitPositive),
                          static_cast<uint16_t>(random.Below(8)), level});
        break;
      case 2:
        events.push_back({at, WorldEventKind::kAdc, static_cast<uint8_t>(random.Below(8)), 0,
                          random.Between(-10, 10)});
        break;
      case 3:
        events.push_back({at, WorldEventKind::kStall, motor, 0, level});
        break;
      case 4:
        events.push_back({at, WorldEventKind::kHand, motor, 0, random.Between(-4, 4)});
        break;
      default:
        events.push_back({at, WorldEventKind::kEncoderDrift, motor, 0, level * 0.25});
    }
  }
  return events;
}

/// A card with everything that a power-on gives it.
inline std::unique_ptr<MotionCore> RandomCard(uint64_t seed) {
  RandomNumbers random(seed);
  const MotionConfig config = RandomConfig(random);
  auto core = std::make_unique<MotionCore>(config);
  const auto count = static_cast<size_t>(config.axis_count);
  for (size_t i = 0; i < count; ++i) RandomDrive(*core, i, random);
  for (int switches = random.Below(4); switches > 0; --switches) {
    const double first = random.Between(-4000, 4000);
    ChangeState(*core).switches.push_back(
        {.axis = static_cast<uint8_t>(random.Below(config.axis_count)),
         .type = random.OneIn(2) ? DiType::kHome : DiType::kLimitPositive,
         .bit = static_cast<uint8_t>(random.Below(8)),
         .first = first,
         .last = first + random.Between(1, 500),
         .active_low = random.OneIn(4)});
  }
  for (size_t i = 0; i < count; ++i) {
    if (!random.OneIn(5)) core->AxisAt(i).ServoOn();
  }
  core->PowerOn(std::make_shared<const WorldEvents>(RandomEvents(config, random)));
  return core;
}

/// Chooses a mode and begins a motion.
inline void RandomMove(MotionCore& core, size_t axis, RandomNumbers& random) {
  Profile& profile = ChangeState(core).profiles[axis];
  if (profile.mode == ProfileMode::kCrd || profile.driven) return;
  if (!profile.now.moving) {
    constexpr ProfileMode kModes[] = {ProfileMode::kTrap,   ProfileMode::kTrap,
                                      ProfileMode::kJog,    ProfileMode::kGear,
                                      ProfileMode::kSCurve, ProfileMode::kWheel};
    profile.mode = kModes[random.Below(6)];
  }
  const double rate = random.Between(0.05, 2);
  switch (profile.mode) {
    case ProfileMode::kJog:
      profile.jog.parameters = {rate, rate, random.OneIn(3) ? 0.75 : 0};
      profile.jog.velocity = random.OneIn(4) ? 0 : random.Between(-20, 20);
      break;
    case ProfileMode::kGear:
      if (profile.now.moving) return;
      profile.gear.master = {true, random.OneIn(2) ? MasterType::kProfile : MasterType::kEncoder,
                             static_cast<uint8_t>(random.Below(core.config().axis_count)), false};
      if (profile.gear.master.index == axis) return;
      profile.gear.slave_even = random.Below(7) - 3;
      profile.gear.ratio_set = true;
      break;
    case ProfileMode::kWheel:
      if (profile.now.moving) return;
      profile.wheel.master = {true, random.OneIn(2) ? MasterType::kProfile : MasterType::kEncoder,
                              static_cast<uint8_t>(random.Below(core.config().axis_count)), false};
      if (profile.wheel.master.index == axis) return;
      profile.wheel.ratio = random.Below(7) - 3;
      profile.wheel.limits = {random.Between(1, 40), rate, rate, random.Between(0, 1)};
      profile.wheel.cycle = MsBetween(0, core.config().cycle_us);
      break;
    case ProfileMode::kSCurve:
      profile.s_curve.limits = {random.Between(0, 40), rate, random.Between(0.001, 0.1)};
      profile.s_curve.target = random.Below(20'000) - 10'000;
      break;
    default:
      profile.mode = ProfileMode::kTrap;
      profile.trap.parameters = {rate, rate * 1.5, 0,
                                 static_cast<int16_t>(random.OneIn(3) ? 20 : 0)};
      profile.trap.velocity = random.Between(0.5, 40);
      profile.trap.target = random.Below(20'000) - 10'000;
  }
  core.ProfileAt(axis).Start();
}

/// Lines with buffered outputs and delays through a coordinate system of the first two axes.
inline void RandomPath(MotionCore& core, RandomNumbers& random) {
  MotionState& state = ChangeState(core);
  if (state.profiles[0].now.moving || state.profiles[1].now.moving) return;
  if (state.crds[0].run.running) return;
  CrdParameters parameters{.dimension = 2, .coordinates = {1, 2}};
  parameters.velocity_max = 1000;
  parameters.acceleration_max = 100;
  core.CrdAt(0).SetUp(parameters);
  Coordinates end = core.CrdPosition(0);
  for (int i = 0; i < 12; ++i) {
    PathSlot slot;
    if (random.OneIn(4)) {
      slot.command = {BufferedKind::kOutputs,
                      static_cast<int32_t>(DoType::kGpo),
                      0,
                      {255, static_cast<double>(random.Below(256))}};
    } else if (random.OneIn(6)) {
      slot.command = {BufferedKind::kDelay, 0, 0, {random.Between(0, 20)}};
    } else {
      const Coordinates begin = end;
      end[0] += random.Between(-600, 600);
      end[1] += random.Between(1, 600);
      const auto line = MakeLine(begin, end);
      if (!line) continue;
      slot.is_segment = true;
      slot.segment = *line;
      slot.velocity = random.Between(1, 30);
      slot.acceleration = random.Between(0.1, 2);
      slot.end_velocity = random.OneIn(2) ? slot.velocity / 2 : 0;
    }
    core.CrdAt(0).Append(0, slot);
  }
  core.CrdAt(0).Start(0, false);
}

/// Switches the input shaper of an axis at rest on or off.
inline void RandomShaper(MotionCore& core, size_t axis, RandomNumbers& random) {
  if (core.AxisMoving(core.state().axes[axis]) || !core.ShaperSettled(axis)) return;
  const auto count = static_cast<size_t>(random.OneIn(4) ? 0 : 1 + random.Below(100));
  core.AxisAt(axis).SetInputShaper(count, random.Between(0.25, 1));
}

/// Ends faults and what they have latched, so that a long run does not end with a card at rest.
inline void Repair(MotionCore& core) {
  MotionState& state = ChangeState(core);
  state.encoder_faults.fill({});
  state.compensations.fill({});
  state.compensates = false;
  state.shapers.Reset();
  for (size_t i = 0; i < core.axis_count(); ++i) {
    state.plants[i].stalled = false;
    state.plants[i].hand = 0;
    state.axes[i].soft_positive = kNoPositiveLimit;
    state.axes[i].soft_negative = kNoNegativeLimit;
    state.axes[i].positive_limit_on = false;
    core.EncoderAt(i).Rebase();
    core.AxisAt(i).ClearStatus();
    if (!state.axes[i].servo_on) core.AxisAt(i).ServoOn();
  }
}

/// One command of a host.
inline void RandomCommand(MotionCore& core, RandomNumbers& random) {
  MotionState& state = ChangeState(core);
  const auto axis = static_cast<size_t>(random.Below(core.config().axis_count));
  Axis& chosen = state.axes[axis];
  switch (random.Below(16)) {
    case 14:
    case 15:
      Repair(core);
      break;
    case 0:
      core.AxisAt(axis).Stop(random.OneIn(2));
      break;
    case 1:
      core.AxisAt(axis).ClearStatus();
      break;
    case 2:
      chosen.servo_on ? core.AxisAt(axis).ServoOff() : core.AxisAt(axis).ServoOn();
      break;
    case 3:
      chosen.soft_positive = random.OneIn(2) ? 6000 : kNoPositiveLimit;
      chosen.soft_negative = random.OneIn(2) ? -6000 : kNoNegativeLimit;
      break;
    case 4:
      chosen.band = random.Below(20);
      chosen.band_time = random.Below(200) * 125;
      chosen.band_set = true;
      break;
    case 5:
      state.io.StartPulses(DoType::kGpo, random.Below(16), 1000, 3000, random.Below(20), true);
      break;
    case 6:
      if (random.OneIn(3)) return RandomShaper(core, axis, random);
      core.AxisAt(axis).SetBacklash(
          {.value = random.OneIn(3) ? random.Below(30) : 0, .change = 0.5});
      break;
    case 7:
      RandomPath(core, random);
      break;
    case 8:
      if (state.dacs[axis].control < 0) state.dacs[axis].value = random.Between(-9000, 9000);
      break;
    default:
      RandomMove(core, axis, random);
  }
}

}  // namespace oncard::motion
