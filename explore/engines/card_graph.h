// The graph of all states of a card with a program (card_model.h).
// Deterministic; not thread-safe. Tested by tests/explore/card_model_test.cc.
#pragma once

#include <optional>
#include <vector>

#include "explore/engines/state_graph.h"
#include "explore/models/card_model.h"
#include "explore/models/ends.h"

namespace oncard::explore {

struct CardGraph {
  StateGraph graph;
  int64_t bad_states = 0;
  int64_t final_globals = 0;  ///< different values of the globals at the end
  int64_t final_full = 0;     ///< the same including the return values of the threads
  EndSet ends;                ///< if there are no requirements on results
  bool by_rows = false;       ///< the states were rows (models/card_rows.h)
  /// Not complete: of the states whose successors are not known, one with the earliest instant.
  std::optional<CardModel::State> open;
};

/// Explores from the start of the run, the states with the fewest statements first; or from several
/// states that are different, which then are the first ones of the graph.
CardGraph BuildCardGraph(CardModel* model, const StateLimits& limits,
                         const std::vector<CardModel::State>& starts = {});

}  // namespace oncard::explore
