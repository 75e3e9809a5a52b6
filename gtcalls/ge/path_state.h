// What a path card keeps for its path beside the coordinate system of the motion core: registers,
// the list of segments that a host fills, how a motion was stopped, the hand wheel. Source: GE
// manual chapter 6. Tested by tests/gtcalls/ge/path_command_test.cc and list_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "gtcalls/ge/path_look_ahead.h"
#include "gtcalls/shared/list_words.h"
#include "motion/common/rare.h"
#include "motion/paths/coordinates.h"

namespace oncard::gtcalls::ges {

/// The FIFOs of the coordinate system: the list, and an immediate motion.
inline constexpr size_t kListFifo = 0;
inline constexpr size_t kImmediateFifo = 1;

/// The buffer of the card: GE manual 6.3 (8k words).
inline constexpr uint32_t kListWords = 8192;
/// Segments are numbered from 1 to this, then from 1 again.
inline constexpr int32_t kSegmentNumberMax = 32767;

/// What waits between two segments.
struct BetweenSegments {
  int outputs = 0;  ///< GT_BufIO
  int delays = 0;   ///< GT_Delay
  // GT_BufIOBit, for the beginning of the next segment.
  uint16_t bit_mask = 0;
  uint16_t bit_levels = 0;

  auto Fields(auto visit) const { return visit(outputs, delays, bit_mask, bit_levels); }
};

/// The list as GT_StrtList begins it.
struct List {
  bool open = false;
  size_t dimension = 0;      ///< of GT_Mv...; 0: the list has no start yet
  bool looks_ahead = false;  ///< it has begun with GT_Mv...Ex
  double feed = 0;
  double acceleration = 0;
  /// GT_SetDccVel, for the next segment.
  std::optional<double> end_velocity;
  int32_t last_number = 0;  ///< of the segment appended last
  bool stopped = false;     ///< the last run was stopped before its end
  BetweenSegments between;
  ListWords words;

  auto Fields(auto visit) const {
    return visit(open, dimension, looks_ahead, feed, acceleration, end_velocity, last_number,
                 stopped, between, words);
  }
};

/// GT_HandWheel.
struct HandWheel {
  int axis = 0;            ///< its number; 0: none
  int64_t last_count = 0;  ///< the cycle in which the wheel has moved last, or was chosen
  double position = 0;     ///< of the wheel, then

  auto Fields(auto visit) const { return visit(axis, last_count, position); }
};

struct Path {
  // Registers.
  double velocity = 0;      ///< GT_SetSynVel
  double acceleration = 0;  ///< GT_SetSynAcc
  double start_velocity = 0.5;
  double max_velocity = 256;
  double stop_acceleration = 1;       ///< GT_SetStpAcc; the value after a reset is an assumption
  double emergency_acceleration = 0;  ///< GT_SetEStpAcc; 0: it has not been called

  List list;
  // The present run, or the last one.
  bool runs = false;                  ///< it has not ended when the card was looked at last
  bool commanded = false;             ///< a command of the host has stopped it
  bool held = false;                  ///< an axis has stopped it
  motion::Coordinates break_point{};  ///< machine position

  HandWheel wheel;
  motion::Rare<LookAhead> look_ahead;          ///< GT_InitLookAheadEx
  motion::Rare<VelocityTable> velocity_table;  ///< GT_InitLookAhead

  auto Fields(auto visit) const {
    return visit(velocity, acceleration, start_velocity, max_velocity, stop_acceleration,
                 emergency_acceleration, list, runs, commanded, held, break_point, wheel,
                 look_ahead, velocity_table);
  }
};

}  // namespace oncard::gtcalls::ges
