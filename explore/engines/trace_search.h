// The search of a problem's traces (dpor.h) and its counts, undivided or in parts that can be
// interrupted, run on other computers, and merged.
//
// Deterministic; not thread-safe. Tested by tests/explore/search_file_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "explore/engines/dpor.h"
#include "explore/engines/progress.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/state_key.h"
#include "explore/models/statement_coverage.h"

namespace oncard::explore {

/// Counts of the dpor engine.
struct TraceCounts {
  int64_t executions = 0;
  int64_t blocked = 0;
  int64_t redundant = 0;
  int64_t bad_traces = 0;
  int64_t final_globals = 0;  ///< different values of the globals at the end
  int64_t final_full = 0;     ///< the same including the return values of the threads
  bool complete = false;
  bool counted = false;  ///< most executions were counted, not executed (TraceSearch)
};

/// A search, or a part of one: the remaining work and the results so far.
struct TraceSearch {
  std::vector<TraceUnit> units = {TraceUnit{}};  ///< still to be done
  int64_t executions = 0;
  int64_t blocked = 0;
  int64_t redundant = 0;  ///< without interruption in one unit
  int64_t bad = 0;
  bool too_deep = false;          ///< an execution was longer than the limit
  bool counted = false;           ///< the executions are those of TraceSearchLimits::counts
  std::vector<StateKey> globals;  ///< different final values, in order
  std::vector<StateKey> full;     ///< the same including the return values of the threads
  /// Only if there are no requirements on results: different ones that were found.
  EndSet ends;
  /// The threads of a failing execution, the shortest of the first thousand.
  std::vector<uint8_t> failing;
  /// Of what was executed since the search began or was read from a file.
  StatementCoverage coverage;

  bool complete() const { return units.empty() && !too_deep; }
  TraceCounts Counts() const;
};

struct TraceSearchLimits {
  int64_t executions = INT64_MAX;
  int64_t depth = 100'000;
  /// How far the search continues after the first failing execution, as the sum of the executions'
  /// statements.
  int64_t statements_after_bad = INT64_MAX;
  /// After some thousand executions of a whole search, all of which are good, those of all traces
  /// are counted without executing each, if that is possible (trace_count.h) and all are good. The
  /// results are those of executing them; their number is not limited.
  bool counts = false;
  const std::atomic<bool>* stop = nullptr;
  SearchProgress* progress = nullptr;
};

/// Continues a search until it is complete or a limit is reached. The limit of executions applies
/// to this call.
void SearchTraces(const Problem& problem, const TraceSearchLimits& limits, TraceSearch* search);

/// Merges two parts of one search; the order of parts does not matter.
void MergeInto(TraceSearch* search, const TraceSearch& other);

}  // namespace oncard::explore
