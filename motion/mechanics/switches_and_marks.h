// Marks of the mechanics: switches that the moving parts operate, and the index marks of the
// encoders. They are outside the card, so GT_Reset does not change them.
#pragma once

#include <cmath>
#include <cstdint>

#include "motion/io/digital_io.h"

namespace oncard::motion {

/// Drives an input's pin high while the motor of an axis is inside [first, last] (pulses of
/// Plant::position), or low when `active_low`. Infinite bounds are allowed.
struct PositionSwitch {
  uint8_t axis = 0;  ///< the axis that operates it, from 0
  DiType type = DiType::kHome;
  uint8_t bit = 0;  ///< the input, from 0
  double first = 0;
  double last = 0;
  bool active_low = false;
  bool connected = true;  ///< false: its wire is cut, and the pin stays at its inactive level

  bool Inside(double position) const { return first <= position && position <= last; }
  /// The pin's level with the motor at `position`.
  bool Level(double position) const { return (connected && Inside(position)) != active_low; }

  auto Fields(auto visit) const {
    return visit(axis, type, bit, first, last, active_low, connected);
  }
  bool operator==(const PositionSwitch&) const = default;
};

/// Index pulses of an encoder: at `offset` plus any whole multiple of `period` (Plant::position).
/// The default is one mark per revolution of a 10000-pulse encoder (assumption).
struct IndexMarks {
  double offset = 0;
  double period = 10000;  ///< > 0; 0: the encoder has no index

  auto Fields(auto visit) const { return visit(offset, period); }
  bool operator==(const IndexMarks&) const = default;
};

/// The positions at which a switch is entered and then left during a move from one position to
/// another.
struct SwitchPassage {
  bool enters = false;
  bool leaves = false;
  double entry = 0;
  double exit = 0;
};
SwitchPassage PassSwitch(const PositionSwitch& contact, double from, double to);

/// Calls `visit(position)` for every index mark between two positions, in the order in which the
/// motor passes them, excluding the first position and including the last, until it returns false.
template <typename Visit>
void ForEachMark(const IndexMarks& marks, double from, double to, Visit visit) {
  if (marks.period <= 0 || from == to) return;
  const double begin = (from - marks.offset) / marks.period;
  const double step = from < to ? 1 : -1;
  double mark = from < to ? std::floor(begin) : std::ceil(begin);
  for (;;) {
    mark += step;
    const double position = marks.offset + mark * marks.period;
    if (step > 0 ? position > to : position < to) return;
    if (!visit(position)) return;
  }
}

}  // namespace oncard::motion
