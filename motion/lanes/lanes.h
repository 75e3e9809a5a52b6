// The values of a card's axes that change in every cycle, as arrays over the axes: a lane is one
// axis. A kernel advances all lanes by cycles with vector instructions, with the same operations in
// the same order as the parts that advance one axis at a time, and so with the same bits on every
// instruction set.
//
// Lanes do only what an undisturbed axis does in most cycles (cycle_block.h says which axes). A
// kernel ends before the first cycle in which an axis would do something else: exceed a limit or
// its following error, reach or leave its in-position band, operate a switch.
// Tested by tests/motion/cycle_block_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "motion/common/sizes.h"

namespace oncard::motion {

/// What moves the motor of a lane. Lanes of one kind follow each other.
enum class LaneKind : uint8_t {
  kServo,       ///< a velocity drive, commanded by a servo controller
  kServoIdeal,  ///< an ideal drive, commanded by a servo controller
  kVoltage,     ///< a velocity drive at a constant voltage
  kFollow,      ///< an ideal drive that follows the planned position, or is off
  kBusIdeal,    ///< an ideal drive on a bus, or any that is off
  kBusVelocity  ///< a velocity drive on a bus, commanded by the position loop of the drive
};
inline constexpr size_t kLaneKindCount = 6;

/// Lanes that a vector instruction of any supported set processes together.
inline constexpr size_t kLaneGroup = 4;
/// Every axis, and unused lanes that complete the last group of each kind: whole groups.
inline constexpr size_t kLaneMax =
    (kAxisMax + kLaneKindCount * (kLaneGroup - 1)) / kLaneGroup * kLaneGroup;

/// Most pieces of a plan before the one that applies.
inline constexpr size_t kLanePieceMax = 4;

/// Lanes count sources below this, pulses: they fit an int32_t.
inline constexpr double kLaneWholeMax = 2147483647;
/// Positions of drives on a bus are at most this far from 0, counts: the difference of two fits an
/// int32_t, and none wraps.
inline constexpr double kLaneCountMax = 1073741823;

/// One value of each lane.
using Lane = std::array<double, kLaneMax>;
/// A choice of each lane: all bits set, or none.
using LaneMask = std::array<int64_t, kLaneMax>;
inline constexpr int64_t kChosen = -1;

/// What stays the same as long as the lanes are valid.
struct LaneConstants {
  // The piece of a plan that the profile runs on.
  alignas(32) LaneMask planned{};
  alignas(32) Lane clock_us{};                            ///< a cycle, or 0 without a plan
  alignas(32) std::array<Lane, kLanePieceMax> earlier{};  ///< durations of the pieces before, ms
  alignas(32) Lane piece_position{};
  alignas(32) Lane piece_velocity{};
  alignas(32) Lane piece_acceleration{};
  size_t earlier_count = 0;  ///< largest number of pieces before, of any lane

  // Planned positions.
  alignas(32) Lane offset{};
  alignas(32) Lane compensation{};
  alignas(32) Lane soft_positive{};
  alignas(32) Lane soft_negative{};

  // Servo controller and output.
  alignas(32) Lane kp{};
  alignas(32) Lane ki{};
  alignas(32) Lane kd{};
  alignas(32) Lane kvff{};
  alignas(32) Lane kaff{};
  alignas(32) Lane sum_limit{};
  alignas(32) Lane difference_limit{};
  alignas(32) Lane output_limit{};
  bool filters_feed = false;  ///< of any lane
  alignas(32) LaneMask feed_filtered{};
  alignas(32) Lane feed_divisor{};
  alignas(32) Lane feed_change_max{};
  alignas(32) Lane bias{};
  alignas(32) Lane dac_limit{};
  alignas(32) LaneMask dac_active{};
  alignas(32) Lane voltage{};  ///< kVoltage: the output, DAC units

  // Drive and motor.
  alignas(32) Lane unit{};
  alignas(32) Lane friction{};
  alignas(32) Lane decay{};
  alignas(32) Lane lag{};
  alignas(32) Lane lead{};
  alignas(32) LaneMask follows{};  ///< kFollow, kBus...: the drive is on
  alignas(32) Lane motor_low{};    ///< the motor operates no switch between these
  alignas(32) Lane motor_high{};
  alignas(32) LaneMask stepping{};
  alignas(32) Lane step_lead{};

  // Drive on a bus, in counts. It uses output_limit and lead, too.
  alignas(32) Lane origin{};  ///< the motor's position that it counts as 0
  alignas(32) Lane counts_per_pulse{};
  alignas(32) Lane target_low{};  ///< it reaches the targets between these
  alignas(32) Lane target_high{};
  alignas(32) Lane loop_gain{};
  alignas(32) Lane error_window{};

  // Encoder.
  alignas(32) LaneMask external{};
  alignas(32) LaneMask counting{};
  alignas(32) Lane direction{};  ///< 1 or -1; 0: it counts pulses; kBus...: pulses per count
  alignas(32) Lane slip{};
  alignas(32) Lane encoder_offset{};

  // Judgements.
  alignas(32) Lane error_limit{};
  alignas(32) Lane band{};  ///< 0: none
  alignas(32) LaneMask in_band{};

  // Timing of the card.
  double cycle_ms = 0;
  double per_cycle_ms = 0;  ///< the reciprocal if it is exact, or 0
  double servo_ms = 0;
  double per_servo_ms = 0;  ///< as above
  int32_t sub_steps = 0;
  double per_sub_steps = 0;  ///< as above
  double integral_unit = 0;  ///< what an integral gain counts

  /// The lanes of each kind, from `begin` to before `end`; multiples of kLaneGroup.
  std::array<size_t, kLaneKindCount> begin{};
  std::array<size_t, kLaneKindCount> end{};
};

/// What changes with every cycle.
struct LaneValues {
  alignas(32) Lane elapsed_us{};  ///< since the begin of the plan
  alignas(32) Lane position{};    ///< of the profile, like the next two
  alignas(32) Lane velocity{};
  alignas(32) Lane acceleration{};
  alignas(32) LaneMask moving{};
  alignas(32) Lane reference{};
  alignas(32) Lane sum{};
  alignas(32) Lane error_before{};
  alignas(32) Lane feed{};
  alignas(32) Lane output{};
  alignas(32) Lane motor{};
  alignas(32) Lane motor_velocity{};
  alignas(32) Lane ramp{};  ///< kBus...: the drive's set-point, a position of the motor
  alignas(32) Lane step{};
  alignas(32) Lane source{};
  alignas(32) Lane count{};  ///< the encoder's position
  alignas(32) Lane count_velocity{};
  alignas(32) Lane count_acceleration{};
  alignas(32) Lane measured{};  ///< the axis position from the encoder
};

/// Two states of the lanes: the one before a cycle and the one after it.
struct LaneStates {
  std::array<LaneValues, 2> values;
  size_t now = 0;  ///< which of the two is valid

  LaneValues& current() { return values[now]; }
  LaneValues& other() { return values[1 - now]; }
};

/// Advances the lanes by at most `cycles` and returns by how many; states.other() is then the state
/// one cycle earlier. If these are fewer, an axis would do something else in the cycle after them:
/// states.current() is the state before that cycle, and states.other() is of no use.
using LaneKernel = int64_t (*)(const LaneConstants& constants, LaneStates& states, int64_t cycles);

struct NamedLaneKernel {
  std::string_view name;  ///< of the instruction set
  LaneKernel run = nullptr;
};

/// The kernels that this computer can execute, the fastest one first. All compute the same bits.
std::span<const NamedLaneKernel> LaneKernels();

}  // namespace oncard::motion
