// Watches a search while it runs: shows how far it is, and ends it early on Ctrl-C.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "explore/progress.h"
#include "tools/session.h"

namespace oncard::tools {

/// One at a time. Ctrl-C tells the search to stop as long as it lives; a second one ends the
/// program as usual.
class SearchWatch {
 public:
  /// With `shows`, a line on standard error says every second how far the search is.
  SearchWatch(const Session& session, bool shows);
  ~SearchWatch();
  SearchWatch(const SearchWatch&) = delete;
  SearchWatch& operator=(const SearchWatch&) = delete;

  /// For the search.
  explore::SearchProgress* progress() { return &progress_; }
  bool interrupted() const { return progress_.stop; }

 private:
  void Show();

  const Session& session_;
  explore::SearchProgress progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread showing_;
};

}  // namespace oncard::tools
