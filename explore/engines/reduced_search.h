// A search of a card with a program (card_model.h), cycle by cycle, that leaves out states which
// are found again in another order of the same statements. It gives the same verdict and the same
// ends as the graph of all states (card_graph.h).
//
// - A statement that nobody notices (cycle_accesses.h) commutes with all that the others can still
//   do in the cycle. So it is executed now, or no more in this cycle: its thread is then frozen up
//   to the next one. That is possible only if the thread has been served and the others can use up
//   the statements that are left.
// - Where all threads together cannot use them up, it does not matter how many are left.
//
// Of the states at the start of a cycle only those of the present one and of later ones are kept,
// of those within a cycle only the keys, up to its end. Tested by
// tests/explore/reduced_search_test.cc. Deterministic; not thread-safe.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "explore/engines/state_graph.h"
#include "explore/models/card_model.h"
#include "explore/models/ends.h"

namespace oncard::explore {

struct ReducedCounts {
  int64_t states = 0;  ///< of all cycles, with those that are not kept
  int64_t transitions = 0;
  int64_t starts = 0;  ///< states at the start of a cycle
};

struct ReducedSearch {
  ReducedCounts counts;
  int64_t final_globals = 0;  ///< as those of CardGraph
  int64_t final_full = 0;
  EndSet ends;
  bool complete = false;
  bool fails = false;
  std::vector<uint8_t> failing = {};  ///< the threads of a run that fails
  /// Not complete: a state at the start of the first cycle that was not searched to its end.
  std::optional<CardModel::State> open = {};
};

/// Searches up to the first failure. Empty if states of the model cannot be left out. Of the limits
/// only `states`, `stop` and `progress` are used.
std::optional<ReducedSearch> SearchReduced(CardModel* model, const StateLimits& limits);

}  // namespace oncard::explore
