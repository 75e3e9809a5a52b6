// Watches a search while it runs: shows how far it is, lets it be kept every minute, and ends it
// early on SIGINT (Ctrl-C), SIGTERM (Slurm before the time limit) and SIGHUP (a closed terminal),
// or when the time that was given to it is over.
#pragma once

#include <array>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>

#include "explore/engines/progress.h"
#include "tools/session.h"

namespace oncard::tools {

struct WatchOptions {
  bool shows = false;   ///< a line on standard error says every second how far the search is
  double seconds = 0;   ///< after which the search is told to stop, too; 0: as long as it takes
  bool pauses = false;  ///< the search pauses every minute (SearchProgress::pausing)
};

/// One at a time. A signal tells the search to stop as long as it lives; the same signal again ends
/// the program as usual. SIGHUP that is ignored (nohup) stays so.
class SearchWatch {
 public:
  SearchWatch(const Session& session, const WatchOptions& options);
  ~SearchWatch();
  SearchWatch(const SearchWatch&) = delete;
  SearchWatch& operator=(const SearchWatch&) = delete;

  /// For the search.
  explore::SearchProgress* progress() { return &progress_; }
  bool interrupted() const { return progress_.interrupted; }

 private:
  void Watch();

  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

  const Session& session_;
  WatchOptions options_;
  explore::SearchProgress progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::array<struct sigaction, kSignals.size()> before_{};  ///< what the signals did
  std::thread watching_;
};

}  // namespace oncard::tools
