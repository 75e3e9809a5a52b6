// A proof of a program with its card by its islands (islands.h): the states of each are searched
// while the other threads may take any statements. Deterministic; not thread-safe. Tested by
// tests/explore/island_search_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "explore/engines/state_graph.h"
#include "explore/models/card_model.h"
#include "explore/models/islands.h"

namespace oncard::explore {

struct IslandCounts {
  /// The numbers of the threads of each island on the card, in the order of the first ones.
  std::vector<std::vector<int>> threads;
  /// The globals whose value at the end is the sum of what several of them add.
  std::vector<std::string> sums;
  int64_t states = 0;  ///< of all islands, those that were joined included
  int64_t transitions = 0;
};

struct IslandProof {
  IslandCounts counts;
  std::vector<std::shared_ptr<const IslandCard>> cards;

  /// Takes over what the runs of the islands have put to the test, and what still goes on where
  /// they end.
  void IncludeIn(CardModel* whole) const;
};

struct IslandResult {
  /// Empty if a limit was reached, the islands turn out to be one, or something fails in one of
  /// them or for a sum of what they add, which need not happen in the program.
  std::optional<IslandProof> proof;
  /// If it does, and the failure of the island was found in the program, too: the threads of a
  /// schedule that fails.
  std::vector<uint8_t> failing;
};

IslandResult ProveByIslands(CardModel* whole, Islands islands, const StateLimits& limits);

}  // namespace oncard::explore
