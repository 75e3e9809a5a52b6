// What another thread can see of a search while it runs, and tell it.
#pragma once

#include <atomic>
#include <cstdint>

namespace oncard::explore {

struct SearchProgress {
  /// Set by the watcher: the search ends soon, with what it knows.
  std::atomic<bool> stop{false};
  /// Set before `stop`: why. For good; or only so that what is known can be kept (kept_search.h).
  std::atomic<bool> interrupted{false};
  std::atomic<bool> pausing{false};
  /// Set before `stop`, when that is because the time that was given is over.
  std::atomic<bool> out_of_time{false};
  /// Set before the search: it first estimates how many executions there are.
  bool estimates = false;
  // Set by the search.
  std::atomic<int64_t> executions{0};  ///< of the dpor engine, or random runs
  std::atomic<int64_t> states{0};
  std::atomic<int64_t> frontier{0};  ///< states whose successors are not all known
  /// About how many executions there are, with the standard error; 0 when nobody knows.
  std::atomic<double> expected{0};
  std::atomic<double> expected_error{0};

  /// For the search: true when it was stopped only to be kept, and is to go on. An interruption
  /// that comes at the same time is not lost: it is said before it stops the search.
  bool TakePause() {
    if (!pausing.exchange(false)) return false;
    stop = false;
    if (interrupted) stop = true;
    return !interrupted;
  }
};

}  // namespace oncard::explore
