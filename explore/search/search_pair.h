// Two searches of one problem at the same time, each in a thread of its own: what `auto` does with
// the search of traces and that of states. Nothing else in the explorer uses threads or a clock.
// Tested by tests/explore/explorer_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "explore/engines/progress.h"
#include "explore/engines/state_search.h"
#include "explore/engines/trace_search.h"

namespace oncard::explore {

struct SearchPair {
  /// True if the search of traces was stopped only to be saved, and is to continue.
  using TakesPause = std::function<bool()>;

  /// Both searches end soon after `stop` is set.
  std::function<TraceSearch(const std::atomic<bool>* stop, const TakesPause& takes_pause)> traces;
  std::function<StateSearch(const std::atomic<bool>* stop)> states;
  /// The problem is known to have a failure: the search of states continues to its own end.
  bool known_bad = false;
  SearchProgress* progress = nullptr;  ///< requests to stop; nullptr: none
};

struct PairResult {
  enum class First : uint8_t { kNeither, kTraces, kStates };

  TraceSearch traces;
  StateSearch states;
  First first = First::kNeither;  ///< the search that first had an answer
};

/// Runs both; each is stopped some time after the other has a result.
PairResult RunPair(const SearchPair& pair);

}  // namespace oncard::explore
