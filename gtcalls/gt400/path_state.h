// What a GT400 card keeps for its path beside the coordinate system of the motion core: registers,
// the list of segments that a host fills, how the last motion ended. Source: GT manual chapter 5.
// Tested by tests/gtcalls/gt400/path_command_test.cc and list_command_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "gtcalls/gt400/limits.h"
#include "gtcalls/shared/list_words.h"
#include "motion/paths/coordinates.h"

namespace oncard::gtcalls::gt400 {

/// The FIFOs of the coordinate system: the list, and a single segment.
inline constexpr size_t kListFifo = 0;
inline constexpr size_t kSingleFifo = 1;

/// The buffer of the card: GT manual 5.4.
inline constexpr uint32_t kListWords = 4096;

struct PathList {
  bool started = false;  ///< GT_StrtList has been called
  bool open = false;
  /// The coordinates from here on are named by none of its commands; 0: it has no start point yet.
  size_t dimension = 0;
  // Of its start point.
  double velocity = 0;
  double acceleration = 0;
  uint16_t last_number = 0;  ///< of the segment appended last
  ListWords words;

  auto Fields(auto visit) const {
    return visit(started, open, dimension, velocity, acceleration, last_number, words);
  }
};

struct Path {
  // Of segments that are commanded from now on. Assumption: the list has no registers of its own.
  double velocity = 0;
  double acceleration = 0;
  PathList list;
  motion::Coordinates break_point{};
  // Bits of the status word.
  bool immediate = true;
  bool jumped = false;  ///< an axis has changed its velocity by more than its limit
  // The present run, or the last one.
  bool runs = false;       ///< it had not ended when the card was looked at last
  bool commanded = false;  ///< a command of the host has stopped it
  // As the last tick has left them.
  int32_t done = 0;  ///< the segments of the run that had ended
  // Of the axes.
  std::array<double, kAxisMax> velocities{};
  std::array<uint8_t, kAxisMax> limits{};  ///< the events of limits

  auto Fields(auto visit) const {
    return visit(velocity, acceleration, list, break_point, immediate, jumped, runs, commanded,
                 done, velocities, limits);
  }
};

}  // namespace oncard::gtcalls::gt400
