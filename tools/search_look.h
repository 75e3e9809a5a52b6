// What is looked at from time to time while a search runs: its progress is shown, it pauses to be
// saved, and it ends early when its limit of time or memory is reached. For search_watch.h.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "explore/engines/progress.h"
#include "tools/invocation.h"
#include "tools/search_limits.h"

namespace oncard::tools {

struct WatchOptions {
  bool shows = false;      ///< shows the progress every second in a line on standard error
  double seconds = 0;      ///< time limit of the search; 0: none
  int64_t memory_mib = 0;  ///< limit of what the process occupies; 0: its part of what is there
  int searches = 1;        ///< processes that search at a time, and share half of what is there
  bool pauses = false;     ///< the search pauses every minute (SearchProgress::pausing)
  std::string title = {};  ///< stands before the progress; empty: nothing
};

class SearchLook {
 public:
  /// The search begins. The invocation and the progress must outlive this object.
  SearchLook(const Invocation& invocation, const WatchOptions& options,
             explore::SearchProgress* progress);

  /// Tells the search what it must do now. False if there is nothing more to look at.
  bool Look();

  /// The time until the next look.
  std::chrono::duration<double> Next() const { return limits_.Next(); }

 private:
  using Clock = std::chrono::steady_clock;

  const Invocation& invocation_;
  const WatchOptions options_;
  explore::SearchProgress* const progress_;
  SearchLimits limits_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point kept_ = start_;
  Clock::time_point shown_ = start_;
};

}  // namespace oncard::tools
