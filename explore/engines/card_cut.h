// Divides the schedules of a card with a program: all of them are followed up to the start of a
// cycle at which there are enough different states, and what follows from one state can be searched
// apart from what follows from another. Two states can lead to the same third one, which both
// searches then find.
//
// The same program gives the same states in the same order everywhere. Deterministic; not
// thread-safe. Tested by tests/explore/card_cut_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "explore/engines/state_graph.h"
#include "explore/engines/state_search.h"
#include "explore/models/card_model.h"
#include "explore/models/ends.h"

namespace oncard::explore {

struct CardCut {
  /// Different states, none of which has ended; those of earlier cycles come first.
  std::vector<CardModel::State> starts;
  /// Threads of the model, one for each statement that leads to the start.
  std::vector<std::vector<uint8_t>> ways;
  // What comes before the starts:
  StateCounts counts;  ///< complete unless the search was stopped
  EndSet ends;         ///< if there are no requirements on results
  /// A failing run; empty, and not `fails`, if there is none.
  std::vector<uint8_t> failing;
  bool fails = false;
};

/// Goes on, cycle by cycle, until there are `enough` starts, a run fails, or StateLimits::states
/// would be exceeded in the next cycle: there are then fewer starts. No starts are left if all runs
/// have ended before. Of the limits only `states` and `stop` are used.
CardCut CutCard(CardModel* model, size_t enough, const StateLimits& limits);

}  // namespace oncard::explore
