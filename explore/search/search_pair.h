// Two searches of one problem: what `auto` does with the search of traces and that of states. They
// run at the same time, each in a thread of its own; where there are no threads, one after the
// other. Nothing else in the explorer uses threads or a clock. Tested by
// tests/explore/explorer_test.cc and search_pair_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "explore/engines/progress.h"
#include "explore/engines/state_search.h"
#include "explore/engines/trace_search.h"

namespace oncard::explore {

struct SearchPair {
  /// True if the search of traces was stopped only to be saved, and is to continue.
  using TakesPause = std::function<bool()>;

  /// Both searches end soon after `stop` is set.
  std::function<TraceSearch(const std::atomic<bool>* stop, const TakesPause& takes_pause)> traces;
  /// That of states also ends at `most` states while it has found no failure (StateLimits).
  std::function<StateSearch(const std::atomic<bool>* stop, const std::atomic<uint32_t>* most)>
      states;
  /// The problem is known to have a failure: the search of states continues to its own end.
  bool known_bad = false;
  /// When one search has a result, the other may continue counting for this part of the time that
  /// has passed, and at least for some milliseconds, unless the progress is interrupted.
  double grace_part = 0.3;
  SearchProgress* progress = nullptr;  ///< requests to stop; nullptr: none
};

struct PairResult {
  enum class First : uint8_t { kNeither, kTraces, kStates };

  std::optional<TraceSearch> traces;  ///< if it was run
  StateSearch states;
  First first = First::kNeither;  ///< the search that first had an answer
};

/// How many states the search of states may reach, without a failure of its own, once the search of
/// traces has found one.
inline constexpr uint32_t kStatesBesideFailure = 4'000'000;

/// Runs both at the same time; each is stopped some time after the other has a result. When a
/// failure is known, the search of states goes on to its own end, so that the failure that is shown
/// does not depend on which search was the first, up to kStatesBesideFailure states. If the system
/// cannot start two threads, or in a build without threads (search_pair_without_threads.cc), as
/// RunInTurn().
PairResult RunPair(const SearchPair& pair);

/// Runs the search of states, whose number is limited, and that of traces only if the first one has
/// no answer and nobody has stopped it. Deterministic, counts included.
PairResult RunInTurn(const SearchPair& pair);

}  // namespace oncard::explore
