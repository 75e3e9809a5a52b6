// Internal to gtcalls: the start of a list and what stands between its segments, for commands with
// and without look-ahead.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "motion/paths/coordinates.h"
#include "motion/paths/path_slot.h"

namespace oncard::gtcalls::ges {

/// GT_Mv... in pulses and ms.
struct ListStart {
  size_t dimension = 2;
  bool looks_ahead = false;
  motion::Coordinates point{};
  double feed = 0;
  double acceleration = 0;
};

/// 0, or 1 if a list cannot begin now.
int16_t CheckStart(Call& call, size_t dimension);
void BeginList(Call& call, const ListStart& start);

/// 0, or the code with which one more command between segments is refused.
int16_t CheckOutputs(Call& call, bool looks_ahead);
int16_t CheckBit(Call& call, bool looks_ahead);
int16_t CheckDelay(Call& call, bool looks_ahead);

/// All outputs; a rest of that many milliseconds.
motion::BufferedCommand OutputsOf(double levels);
motion::BufferedCommand DelayOf(double ms);
/// GT_BufIOBit: the bit waits for the next segment.
void NoteBit(Call& call);

}  // namespace oncard::gtcalls::ges
