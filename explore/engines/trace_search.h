// The search of a problem's traces (dpor.h): what it counts, in one piece or in parts that can be
// interrupted, done elsewhere, and put together again.
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

namespace oncard::explore {

/// What the dpor engine counted.
struct TraceCounts {
  int64_t executions = 0;
  int64_t blocked = 0;
  int64_t redundant = 0;
  int64_t bad_traces = 0;
  int64_t final_globals = 0;  ///< different values of the globals at the end
  int64_t final_full = 0;     ///< the same with what the threads returned
  bool complete = false;
};

/// A search, or a part of one: what is still to be done, and what came of the rest.
struct TraceSearch {
  std::vector<TraceUnit> units = {TraceUnit{}};  ///< still to be done
  int64_t executions = 0;
  int64_t blocked = 0;
  int64_t redundant = 0;  ///< within one unit and without interruption
  int64_t bad = 0;
  bool too_deep = false;          ///< an execution was longer than the limit
  std::vector<StateKey> globals;  ///< different final values, in order
  std::vector<StateKey> full;     ///< the same with what the threads returned
  /// Where nothing is asked of results: different ones that were found.
  EndSet ends;
  /// The threads of an execution that went wrong, the shortest of the first thousand.
  std::vector<uint8_t> failing;

  bool complete() const { return units.empty() && !too_deep; }
  TraceCounts Counts() const;
};

struct TraceSearchLimits {
  int64_t executions = INT64_MAX;
  int64_t depth = 100'000;
  /// How far the search goes on after the first execution that goes wrong, as the sum of the
  /// executions' statements.
  int64_t statements_after_bad = INT64_MAX;
  const std::atomic<bool>* stop = nullptr;
  SearchProgress* progress = nullptr;
};

/// Goes on with a search until it is done or a limit is reached. The limit of executions is that of
/// this call.
void SearchTraces(const Problem& problem, const TraceSearchLimits& limits, TraceSearch* search);

/// Puts two parts of one search together: it does not matter in which order parts are.
void MergeInto(TraceSearch* search, const TraceSearch& other);

}  // namespace oncard::explore
