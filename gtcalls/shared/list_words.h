// The words of a card's buffer of path commands that are in use. Each segment counts with the
// commands before it, and is free when it has ended. A word for each command, two for each of its
// doubles and longs, one for each short (assumption). Tested by
// tests/gtcalls/ge/list_command_test.cc and tests/gtcalls/gt400/list_command_test.cc.
#pragma once

#include <cstdint>

#include "gtcalls/catalogue.h"
#include "motion/paths/item_queue.h"

namespace oncard::gtcalls {

struct ListWords {
  uint32_t used = 0;
  uint32_t since_segment = 0;            ///< of commands after the last segment
  motion::ItemQueue<uint32_t> segments;  ///< of those that have not ended
  int32_t freed = 0;                     ///< segments that are free again

  /// Forgets the segments that have ended, `done` of all.
  void Free(int32_t done);
  bool Fit(uint32_t words, uint32_t capacity) const { return used + words <= capacity; }
  void AddCommand(uint32_t words);
  void AddSegment(uint32_t words);

  auto Fields(auto visit) const { return visit(used, since_segment, segments, freed); }
};

/// The words that a command takes.
uint32_t WordsOf(const Command& command);

}  // namespace oncard::gtcalls
