// The card's body. In this state of the project: time, digital inputs and outputs, user variables;
// axes, profiles and coordinate systems join it here.
//
// All state is plain data in MotionState: a snapshot is a copy, comparison is memberwise. Tick() is
// the only function that lets time pass. Deterministic: integers and IEEE basic operations only.
// Not thread-safe: one caller at a time.
#pragma once

#include <array>
#include <cstdint>

#include "motion/digital_io.h"

namespace oncard::motion {

/// Sizes and timing of a card.
struct MotionConfig {
  int axis_count = 8;      ///< 4, 8 or 12
  int64_t cycle_us = 250;  ///< profile cycle; a multiple of 125, 125..4000
};

/// GT_SetLongVar, GT_SetDoubleVar (assumption: 1024 of each, the manuals name no number).
inline constexpr int kUserVariableCount = 1024;

struct MotionState {
  int64_t cycle = 0;        ///< profile cycles since power-on
  int64_t clock_cycle = 0;  ///< profile cycles since the last GT_Reset
  DigitalIo io;
  std::array<int32_t, kUserVariableCount> long_vars{};
  std::array<double, kUserVariableCount> double_vars{};
};

class MotionCore {
 public:
  explicit MotionCore(const MotionConfig& config);

  const MotionConfig& config() const { return config_; }
  const MotionState& state() const { return state_; }
  MotionState& state() { return state_; }

  /// One profile cycle: samples the inputs, counts their edges, advances timed outputs and time.
  void Tick();
  /// GT_Reset: every register to its default, the clock to 0; inputs keep their pins' levels.
  void Reset();

  /// Milliseconds since GT_Reset, rounded down (GT_GetClock).
  int64_t ClockMs() const;
  /// The same in units of 125 us (GT_GetClockHighPrecision).
  int64_t Clock125us() const;

  /// XXH64 of the whole state.
  uint64_t Hash() const;

 private:
  MotionConfig config_;
  MotionState state_;
};

}  // namespace oncard::motion
