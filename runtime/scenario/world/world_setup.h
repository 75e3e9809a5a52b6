// The surroundings of the card as a scenario describes them: drives and mechanics, positions of
// switches and index marks, inputs over time, and faults. Axes, inputs, channels and switches count
// from 1 as in the file, modules from 0 as the commands count them. Docs: docs/scenarios.md. Tested
// by tests/runtime/scenario_world_test.cc.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/io/digital_io.h"
#include "motion/mechanics/plant.h"
#include "motion/mechanics/switches_and_marks.h"
#include "motion/motion_state.h"
#include "runtime/sim/axis_unit.h"

namespace oncard::runtime {

/// A level at an input pin, or at all pins of a word.
struct InputEvent {
  int64_t at_us = 0;
  motion::DiType type = motion::DiType::kGpi;
  int index = 0;  ///< from 1; 0 = the whole word
  uint32_t value = 0;
  /// It comes at the beginning of any cycle from at_us to here; empty: at at_us.
  std::optional<int64_t> last_us = {};
  bool any_level = false;  ///< the level is 0 or 1, and `value` the smaller one
  bool operator==(const InputEvent&) const = default;
};

/// An input that changes some time after a condition (runtime/conditions) has become true.
struct InputReaction {
  std::string when;
  int64_t after_us = 0;
  InputEvent input = {};  ///< its instant does not matter
  bool operator==(const InputReaction&) const = default;
};

/// So many of them at most: bits of a word.
inline constexpr size_t kReactionMax = 64;
/// Their largest delay: a minute. A condition can become true at every other boundary of cycles
/// only, so this also bounds how many can be pending.
inline constexpr int64_t kReactionUsMax = 60'000'000;

/// The bytes of the longest name of a unit.
inline constexpr size_t kUnitBytes = 16;

/// The drive and mechanics of an axis. Its numbers, and those of switches and faults of the axis,
/// are in its unit: positions in `unit`, velocities in `unit`/s, accelerations in `unit`/s^2.
struct MotorSetup {
  int axis = 1;
  std::string unit;            ///< empty: pulses and milliseconds, as noted
  double pulses_per_unit = 0;  ///< 0: without `unit`
  motion::DriveKind drive = motion::DriveKind::kIdeal;
  double gain = motion::Drive{}.gain;  ///< pulse/ms at full output
  double tau_ms = motion::Drive{}.tau;
  double friction = 0;  ///< pulse/ms
  double position = 0;  ///< at power-on, pulses; the encoder reads 0 there
  double index_offset = 0;
  double index_period = motion::IndexMarks{}.period;  ///< pulses; 0: no index marks
  double max_vel = motion::DriveLimits::kNone;        ///< pulse/ms that it can follow
  double max_acc = motion::DriveLimits::kNone;        ///< pulse/ms^2
  bool operator==(const MotorSetup&) const = default;
};

/// A switch that an axis operates between two positions.
struct SwitchSetup {
  int axis = 1;  ///< the axis that operates it
  motion::DiType type = motion::DiType::kHome;
  int index = 1;  ///< the input it is wired to
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  bool active_low = false;
  bool operator==(const SwitchSetup&) const = default;
};

/// A switch is moved: from now on other positions operate it.
struct SwitchMove {
  int64_t at_us = 0;
  int number = 1;  ///< of the switch, in the order of the file
  double from = SwitchSetup{}.from;
  double to = SwitchSetup{}.to;
  bool operator==(const SwitchMove&) const = default;
};

enum class FaultKind : uint8_t {
  kStall,        ///< the motor does not move
  kLostEncoder,  ///< the encoder no longer counts
  kNoise,        ///< the encoder reads up to `amount` pulses too much or too little
  kSlip,         ///< the encoder slips by `amount` pulse/ms
  kAlarm,        ///< the drive raises its alarm input
  kCutSwitch     ///< the wire of a switch is cut
};

/// A fault and its duration.
struct WorldFault {
  FaultKind kind = FaultKind::kStall;
  int number = 1;  ///< the axis; kCutSwitch: the switch, in the order of the file
  int64_t at_us = 0;
  std::optional<int64_t> until_us;  ///< empty: permanently
  double amount = 0;
  /// It begins with any cycle from at_us to here; empty: at at_us.
  std::optional<int64_t> last_us = {};
  bool operator==(const WorldFault&) const = default;
};

/// An axis whose drive is off, or the shaft of an auxiliary encoder, is turned by hand.
struct HandTurn {
  int number = 1;  ///< of the axis, or of the encoder
  double pulses = 0;
  int64_t at_us = 0;
  int64_t until_us = 0;
  bool operator==(const HandTurn&) const = default;
};
/// Largest velocity of a drive or a turn, pulse/ms.
inline constexpr double kWorldVelocityMax = 32767;
/// Minimum duration of a turn: the longest profile cycle.
inline constexpr int64_t kHandTurnUsMin = 4000;

/// A voltage at an analogue input.
struct VoltageEvent {
  int64_t at_us = 0;
  int channel = 1;
  double volts = 0;
  bool operator==(const VoltageEvent&) const = default;
};

/// An extension module that is present, and its inputs.
struct ModuleEvent {
  int64_t at_us = 0;
  int module = 0;
  std::optional<uint16_t> inputs;
  std::vector<double> volts;  ///< of the channels from the first on
  bool operator==(const ModuleEvent&) const = default;
};

struct World {
  std::vector<InputEvent> inputs;  ///< in order of time
  std::vector<InputReaction> reactions;
  std::vector<MotorSetup> motors;
  std::vector<SwitchSetup> switches;
  std::vector<SwitchMove> moves;  ///< in order of time
  std::vector<WorldFault> faults;
  std::vector<HandTurn> hands;
  std::vector<VoltageEvent> voltages;  ///< in order of time
  /// In order of time. Empty: every module is present; otherwise only those that are listed.
  std::vector<ModuleEvent> modules;
  bool operator==(const World&) const = default;
};

/// The unit of an axis.
AxisUnit UnitOf(const World& world, int axis);

/// `stall` `lost_encoder` `noise` `slip` `alarm` `cut_switch`, in the order of FaultKind.
inline constexpr std::string_view kFaultNames[] = {"stall", "lost_encoder", "noise",
                                                   "slip",  "alarm",        "cut_switch"};
/// `ideal` `velocity`, in the order of DriveKind.
inline constexpr std::string_view kDriveNames[] = {"ideal", "velocity"};

}  // namespace oncard::runtime
