// The search of traces (dpor.h) for programs whose executions are short: the same search as the
// general one, execution by execution, with sets of events as bits of one word and remembered steps
// (step_model.h). Where that is not possible it hands over to the general search.
// Deterministic; not thread-safe. Tested by tests/explore/short_traces_test.cc.
#pragma once

#include <optional>
#include <vector>

#include "explore/engines/dpor.h"
#include "explore/engines/trace_names.h"

namespace oncard::explore {

/// The point at which the general search must continue.
struct TraceHandover {
  /// An execution has begun: `frames` are its steps so far, and then the state in which the next
  /// step is to be executed. Otherwise nothing has been done.
  bool begun = false;
  std::vector<SavedFrame> frames = {};
};

/// Explores a unit as ExploreUnit() does, from the start of the whole search. Adds to `result` and,
/// if limits.count_redundant is set, to `names`. With a handover the unit is left as it was.
std::optional<TraceHandover> ExploreShortTraces(const Model& model, const DporLimits& limits,
                                                const FinalVisitor& visit, TraceUnit* unit,
                                                DporResult* result, TraceNames* names);

}  // namespace oncard::explore
