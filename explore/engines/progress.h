// The progress of a running search, and requests to it, for other threads.
#pragma once

#include <atomic>
#include <cstdint>

namespace oncard::explore {

#ifdef __wasi__
/// Where there are no threads, the work itself calls who watches it; nullptr: nobody.
inline void (*ask_watcher)() = nullptr;
#endif

/// True if the work that is given `flag` is to end; nullptr: never.
inline bool IsTold(const std::atomic<bool>* flag) {
#ifdef __wasi__
  if (ask_watcher != nullptr) ask_watcher();
#endif
  return flag != nullptr && flag->load(std::memory_order_relaxed);
}

struct SearchProgress {
  /// Set by the watcher: the search ends soon and reports what it knows.
  std::atomic<bool> stop{false};
  /// The reason, set before `stop`: to end the search, or only to save its progress
  /// (kept_search.h).
  std::atomic<bool> interrupted{false};
  std::atomic<bool> pausing{false};
  /// Set before `stop` if the limit of time, or of memory, is the reason.
  std::atomic<bool> out_of_time{false};
  std::atomic<bool> out_of_memory{false};
  /// Set some time after `stop`: what has been found is reported as it is, without making it
  /// simpler.
  std::atomic<bool> hurried{false};
  /// Set before the search: it first estimates how many executions there are.
  bool estimates = false;
  // Set by the search.
  std::atomic<int64_t> cases{0};  ///< of the scenario's choices; 0: it has none
  std::atomic<int64_t> cases_done{0};
  std::atomic<int64_t> executions{0};  ///< executions of the dpor engine, or random runs
  std::atomic<int64_t> states{0};
  std::atomic<int64_t> frontier{0};  ///< states some of whose successors are unknown
  /// Estimated number of executions, with the standard error; 0 if not known.
  std::atomic<double> expected{0};
  std::atomic<double> expected_error{0};

  /// For the search: true if it was stopped only to be saved, and is to continue. An interruption
  /// at the same time is not lost, because it is recorded before it stops the search.
  bool TakePause() {
    if (!pausing.exchange(false)) return false;
    stop = false;
    if (interrupted) stop = true;
    return !interrupted;
  }
};

/// SearchProgress::hurried, for IsTold().
inline const std::atomic<bool>* HurriedOf(const SearchProgress* progress) {
  return progress == nullptr ? nullptr : &progress->hurried;
}

}  // namespace oncard::explore
