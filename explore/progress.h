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
};

}  // namespace oncard::explore
