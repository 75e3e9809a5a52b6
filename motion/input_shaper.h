// An input shaper between what an axis is commanded and its drive, so that a mechanism behind the
// axis does not go on swinging when the axis stops.
//
// A zero-vibration (ZV) shaper passes the command through two impulses: now, with the weight
// 1/(1+k), and `count` profile cycles later, with the weight k/(1+k). If `count` is half the damped
// period of the mechanism and k = exp(-zeta pi / sqrt(1 - zeta^2)), 1 without damping, the two
// responses cancel each other. Every motion takes `count` cycles longer. Source: Singer and
// Seering, "Preshaping command inputs to reduce system vibration", 1990; the public header of the
// command names its parameters only (docs/assumptions.md).
//
// Planned positions that commands read do not include it; drives, pulse outputs and encoders follow
// the shaped command. Units: pulse, pulse/ms, pulse/ms^2. Not thread-safe. Tested by
// tests/motion/input_shaper_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace oncard::motion {

/// The longest delay of an input shaper, profile cycles.
inline constexpr int kShaperCyclesMax = 1000;

/// What an axis is commanded at the end of a cycle.
struct CommandedMotion {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;

  auto Fields(auto visit) const { return visit(position, velocity, acceleration); }
  bool operator==(const CommandedMotion&) const = default;
};

struct InputShaper {
  // Registers.
  double k = 0;                       ///< second impulse divided by the first, in (0, 1]
  std::vector<CommandedMotion> past;  ///< of the last cycles, one for each of `count`; empty: off

  // State.
  CommandedMotion last;      ///< the command of the last cycle
  uint32_t unsettled = 0;    ///< cycles until the shaped command rests if the command does
  CommandedMotion addition;  ///< in effect: the shaped command minus the command itself

  bool on() const { return !past.empty(); }
  /// True if the shaped command is the command itself, and stays so until that changes.
  bool settled() const { return unsettled == 0; }
  /// Switches on, with `count` in [1, kShaperCyclesMax] and k in (0, 1], or off, with 0; begins at
  /// `command`.
  void Set(size_t count, double new_k, const CommandedMotion& command);
  /// One cycle, the number of which is given; allocates nothing.
  void Advance(int64_t cycle, const CommandedMotion& command);
  /// Forgets the past, as if the axis had rested there: the command is passed as it is.
  void Restart(const CommandedMotion& command);
  /// The last commanded position gets another value without motion.
  void Rename(double position);

  auto Fields(auto visit) const { return visit(k, past, last, unsettled, addition); }
};

}  // namespace oncard::motion
