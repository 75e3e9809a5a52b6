// Corrections that are added to an axis' planned position before it goes to the drive: backlash and
// the pitch error of a lead screw. The planned positions that commands read do not include it;
// encoders count the motion of the drive.
//
// Backlash is added while the axis moves in one of the two directions. The pitch error is read from
// one of two tables, one per direction, by the planned position: linear between the points, none
// outside. The direction is that of the last motion. Source: comments in a public C# interface
// (backlash); a public note on GTS pitch compensation. Tested by tests/motion/compensation_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "motion/common/sizes.h"

namespace oncard::motion {

/// Largest values of GT_SetBacklash, pulse and pulse/ms.
inline constexpr int32_t kBacklashMax = 1073741824;

/// GT_SetBacklash.
struct Backlash {
  int32_t value = 0;      ///< pulses; 0: none
  double change = 0;      ///< pulse/ms; 0, or at least `value`: at once
  bool positive = false;  ///< the direction of motion in which it is added

  auto Fields(auto visit) const { return visit(value, change, positive); }
  bool operator==(const Backlash&) const = default;
};

/// Maximum and minimum number of points of a pitch error table (the minimum is one segment).
inline constexpr int kPitchPointsMax = 256;
inline constexpr int kPitchPointsMin = 2;

/// GT_SetLeadScrewComp: points at equal distances over `length` pulses from `start` on.
struct PitchTable {
  double start = 0;
  double length = 0;              ///< > 0
  std::vector<int32_t> positive;  ///< pulses at each point for motion in the positive direction
  std::vector<int32_t> negative;  ///< the same for the negative direction

  /// The correction at a planned position, pulses.
  double At(double position, bool moving_positive) const;

  auto Fields(auto visit) const { return visit(start, length, positive, negative); }
};
using PitchTablePointer = std::shared_ptr<const PitchTable>;

struct Compensation {
  // Registers.
  Backlash backlash;
  PitchTablePointer pitch_table;
  bool pitch_on = false;

  // State.
  int8_t direction = 0;       ///< of the last motion: -1, 1; 0: none yet
  double ramp_from = 0;       ///< backlash goes from here ...
  double ramp_to = 0;         ///< ... to here
  Micros ramp_begin = 0;      ///< since this instant
  double backlash_error = 0;  ///< in effect, pulses
  double pitch_error = 0;     ///< in effect, pulses
  double origin = 0;          ///< sum of both when planned and measured positions were made equal

  /// True if a cycle has work: a register requires it, or a compensation is still in effect.
  bool InUse() const { return pitch_on || backlash.value != 0 || Amount() != 0; }
  /// The compensation that is added to the planned position for the drive, pulses.
  double Amount() const { return backlash_error + pitch_error - origin; }
  /// Changes the backlash; the compensation in effect changes from its current to the new value.
  void SetBacklash(const Backlash& registers);
  /// The planned position is renamed from `from` to `to`: the compensation in effect is kept.
  void MoveOrigin(double from, double to);
  /// Processes a cycle from `begin` to `end`, at whose end the planned position and velocity are
  /// given.
  void Advance(Micros begin, Micros end, double position, double velocity);

  auto Fields(auto visit) const {
    return visit(backlash, pitch_table, pitch_on, direction, ramp_from, ramp_to, ramp_begin,
                 backlash_error, pitch_error, origin);
  }

 private:
  double PitchErrorAt(double position) const {
    return pitch_on ? pitch_table->At(position, direction >= 0) : 0;
  }
  void AdvanceBacklash(Micros begin, Micros end);
};

}  // namespace oncard::motion
