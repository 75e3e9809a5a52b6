// The limits of time and memory of a search, for the command (search_look.h) and for Python.
// Tested by tests/explore/time_limit_test.cc and tests/python/test_explore.py.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "explore/engines/progress.h"

namespace oncard::tools {

/// A larger limit of memory is refused.
inline constexpr int64_t kMemoryMibMax = int64_t{1} << 30;

/// Ends a search that reaches one of them.
class SearchLimits {
 public:
  /// The search begins. `seconds` 0: no limit. `memory_mib` is the limit of what the process
  /// occupies; 0: half of what is there, shared by so many `searches` at a time. The progress must
  /// outlive this object.
  SearchLimits(double seconds, int64_t memory_mib, int searches, explore::SearchProgress* progress);

  /// Tells the search what it must do now. False if there is nothing more to look at.
  bool Look();

  /// The time until the next look.
  std::chrono::duration<double> Next() const;

 private:
  using Clock = std::chrono::steady_clock;

  /// The search ends; SearchProgress says why.
  void End(std::atomic<bool>* why);

  explore::SearchProgress* const progress_;
  const int64_t memory_;  ///< bytes that the process may occupy
  const Clock::time_point start_ = Clock::now();
  const std::chrono::duration<double> given_;  ///< 0: no limit
  const std::chrono::duration<double> searched_;
};

}  // namespace oncard::tools
