// Watches a running search: shows its progress, saves it every minute, and ends it early on SIGINT
// (Ctrl-C), SIGTERM (Slurm before the time limit) and SIGHUP (a closed terminal), or when its limit
// of time or memory is reached.
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "explore/engines/progress.h"
#include "tools/invocation.h"

namespace oncard::tools {

/// A larger limit of memory is refused.
inline constexpr int64_t kMemoryMibMax = int64_t{1} << 30;

struct WatchOptions {
  bool shows = false;      ///< shows the progress every second in a line on standard error
  double seconds = 0;      ///< time limit of the search; 0: none
  int64_t memory_mib = 0;  ///< limit of what the process occupies; 0: its part of what is there
  int searches = 1;        ///< processes that search at a time, and share half of what is there
  bool pauses = false;     ///< the search pauses every minute (SearchProgress::pausing)
  std::string title = {};  ///< stands before the progress; empty: nothing
};

/// Only one at a time. During its lifetime a signal stops the search; the same signal again ends
/// the program as usual. An ignored SIGHUP (nohup) stays ignored.
class SearchWatch {
 public:
  SearchWatch(const Invocation& invocation, const WatchOptions& options);
  ~SearchWatch();
  SearchWatch(const SearchWatch&) = delete;
  SearchWatch& operator=(const SearchWatch&) = delete;

  /// For the search.
  explore::SearchProgress* progress() { return &progress_; }
  /// A signal stopped the search, or a limit did.
  bool interrupted() const { return progress_.interrupted; }
  bool out_of_time() const { return progress_.out_of_time; }
  bool out_of_memory() const { return progress_.out_of_memory; }

 private:
  /// What the process may occupy, in bytes.
  int64_t MemoryLimit() const;
  void Watch();
  /// The search ends; SearchProgress says why.
  void End(std::atomic<bool>* why);

  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

  const Invocation& invocation_;
  WatchOptions options_;
  explore::SearchProgress progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::array<struct sigaction, kSignals.size()> before_{};  ///< what the signals did
  std::thread watching_;
};

}  // namespace oncard::tools
