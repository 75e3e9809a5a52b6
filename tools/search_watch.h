// Watches a running search: shows its progress, saves it every minute, and ends it early on SIGINT
// (Ctrl-C), SIGTERM (Slurm before the time limit) and SIGHUP (a closed terminal), or when its limit
// of time or memory is reached.
#pragma once

#include <memory>

#include "explore/engines/progress.h"
#include "tools/invocation.h"
#include "tools/search_look.h"

namespace oncard::tools {

/// Watches a search until the last copy of what it returns ends: search_watch.cc in a thread, and
/// with signals; search_watch_wasi.cc, where there are neither, when the search asks.
std::shared_ptr<void> WatchSearch(const Invocation& invocation, const WatchOptions& options,
                                  explore::SearchProgress* progress);

/// Only one at a time. During its lifetime a signal stops the search; the same signal again ends
/// the program as usual. An ignored SIGHUP (nohup) stays ignored.
class SearchWatch {
 public:
  SearchWatch(const Invocation& invocation, const WatchOptions& options)
      : watcher_(WatchSearch(invocation, options, &progress_)) {}
  SearchWatch(const SearchWatch&) = delete;
  SearchWatch& operator=(const SearchWatch&) = delete;

  /// For the search.
  explore::SearchProgress* progress() { return &progress_; }
  /// A signal stopped the search, or a limit did.
  bool interrupted() const { return progress_.interrupted; }
  bool out_of_time() const { return progress_.out_of_time; }
  bool out_of_memory() const { return progress_.out_of_memory; }

 private:
  explore::SearchProgress progress_;
  std::shared_ptr<void> watcher_;
};

}  // namespace oncard::tools
