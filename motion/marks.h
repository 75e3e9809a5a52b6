// What the machine has at certain places: switches that its moving parts operate, and the index
// marks of its encoders. Part of the world around the card: GT_Reset leaves it alone.
#pragma once

#include <cstdint>
#include <tuple>

#include "motion/digital_io.h"

namespace oncard::motion {

/// Drives an input's pin high while the machine of an axis is inside [first, last] (pulses of
/// Plant::position), or low when `active_low`. Infinite bounds are allowed.
struct PositionSwitch {
  uint8_t axis = 0;  ///< whose machine operates it, from 0
  DiType type = DiType::kHome;
  uint8_t bit = 0;  ///< the input, from 0
  double first = 0;
  double last = 0;
  bool active_low = false;
  bool connected = true;  ///< false: a cut wire, the pin stays at its inactive level

  auto Fields() const { return std::tie(axis, type, bit, first, last, active_low, connected); }
  bool operator==(const PositionSwitch&) const = default;
};

/// Index pulses of an encoder: at `offset` plus any whole multiple of `period` (Plant::position).
/// The default is one mark per revolution of a 10000-pulse encoder (assumption).
struct IndexMarks {
  double offset = 0;
  double period = 10000;  ///< > 0; 0: the encoder has no index

  auto Fields() const { return std::tie(offset, period); }
  bool operator==(const IndexMarks&) const = default;
};

}  // namespace oncard::motion
