// The search of a problem's states (state_graph.h): its counts, and how it finds failures in the
// graph. Deterministic; not thread-safe. Tested by tests/explore/explorer_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "explore/engines/failure.h"
#include "explore/engines/state_graph.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/races.h"
#include "explore/models/statement_coverage.h"

namespace oncard::explore {

/// A race under some schedule.
struct FoundRace {
  Race race;
  bool benign =
      false;  ///< the order of the two statements does not change which ends can be reached
};

/// Counts of the stateful engine.
struct StateCounts {
  int64_t states = 0;
  int64_t transitions = 0;
  int64_t bad_states = 0;
  int64_t final_globals = 0;
  int64_t final_full = 0;
  /// The states are those between steps of several statements (StateLimits::merge_private).
  bool merged = false;
  /// They are sums over groups of schedules (card_cut.h), several of which can have the same one.
  bool in_groups = false;
  /// Different final globals with at most this number of preemptions.
  std::vector<int64_t> finals_within;
  bool complete = false;
  /// A state stands for all that differ in an exchange of equal threads (StateLimits::symmetry);
  /// finals_within is not known.
  bool symmetric = false;
};

/// Number of elements of StateCounts::finals_within.
inline constexpr int kPreemptionBounds = 4;

/// Results of the stateful engine. With merged statements (StateLimits::merge_private) a step of
/// the graph is several statements; failures are still described in single statements.
struct StateSearch {
  StateCounts counts;
  StateGraph graph;
  std::vector<FoundRace> races;
  EndSet ends;  ///< if there are no requirements on results
  StatementCoverage coverage;
};

/// Equal threads (StateLimits::symmetry) only shorten the search of a graph without a failure and,
/// unless runs may last for ever, without a circle: otherwise all states are searched. There are
/// none where a requirement can tell threads apart.
StateSearch SearchStates(const Problem& problem, const StateLimits& limits);

/// The path to a state with one of the flags that avoids states with others; the caller fills in
/// its fault. Empty if there is none, or if `hurried` is set from another thread.
std::optional<Failure> WayTo(const StateGraph& graph, uint32_t flag, uint32_t avoid = 0,
                             const std::atomic<bool>* hurried = nullptr);

/// The failure in the graph: in a state, at the end of a run, in an infinite run, or by a race;
/// empty if there is none. If `hurried` is set from another thread, it is not the simplest one, and
/// one that is not in a single state may be missed.
std::optional<Failure> FailureIn(const Problem& problem, const StateSearch& search,
                                 const std::atomic<bool>* hurried = nullptr);

}  // namespace oncard::explore
