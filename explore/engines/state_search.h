// The search of a problem's states (state_graph.h): what it counts, and how the graph goes wrong.
// Deterministic; not thread-safe. Tested by tests/explore/explorer_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "explore/engines/failure.h"
#include "explore/engines/state_graph.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/races.h"

namespace oncard::explore {

/// A race that some schedule has.
struct FoundRace {
  Race race;
  bool benign = false;  ///< neither order of the two statements changes what ends can be reached
};

/// What the stateful engine counted.
struct StateCounts {
  int64_t states = 0;
  int64_t transitions = 0;
  int64_t bad_states = 0;
  int64_t final_globals = 0;
  int64_t final_full = 0;
  /// Different final globals with at most that many preemptions.
  std::vector<int64_t> finals_within;
  bool complete = false;
};

/// Number of elements of StateCounts::finals_within.
inline constexpr int kPreemptionBounds = 4;

/// What the stateful engine found. With merged statements (StateLimits::merge_private) the graph's
/// steps are several statements; failures are told in statements all the same.
struct StateSearch {
  StateCounts counts;
  StateGraph graph;
  std::vector<FoundRace> races;
  EndSet ends;  ///< where nothing is asked of results
  bool merged = false;
};

StateSearch SearchStates(const Problem& problem, const StateLimits& limits);

/// The way to a state with one of the flags that avoids those with others; its fault is left to the
/// caller. Nothing when there is none.
std::optional<Failure> WayTo(const StateGraph& graph, uint32_t flag, uint32_t avoid = 0);

/// Where the graph goes wrong: in a state, at the end of a run, for ever, or by a race; nothing
/// when it does not.
std::optional<Failure> FailureIn(const Problem& problem, const StateSearch& search);

}  // namespace oncard::explore
