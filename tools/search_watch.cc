// With a thread that watches, and signals that end the search. See search_watch_wasi.cc.
#include "tools/search_watch.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>

namespace oncard::tools {
namespace {

/// The search that a signal stops.
std::atomic<explore::SearchProgress*> watched{nullptr};

extern "C" void StopSearch(int /*signal*/) {
  explore::SearchProgress* progress = watched.load();
  if (progress == nullptr) return;
  progress->interrupted = true;
  progress->stop = true;
}

}  // namespace

class SearchWatch::Watcher {
 public:
  Watcher(const Invocation& invocation, const WatchOptions& options,
          explore::SearchProgress* progress)
      : look_(invocation, options, progress) {
    watched = progress;
    struct sigaction stops = {};
    stops.sa_handler = StopSearch;
    stops.sa_flags = static_cast<int>(SA_RESETHAND);
    for (size_t i = 0; i < kSignals.size(); ++i) {
      ::sigaction(kSignals[i], nullptr, &before_[i]);
      const bool ignored = before_[i].sa_handler == SIG_IGN;
      if (kSignals[i] != SIGHUP || !ignored) ::sigaction(kSignals[i], &stops, nullptr);
    }
    watching_ = std::thread([this] { Watch(); });
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;
  ~Watcher() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    changed_.notify_all();
    watching_.join();
    for (size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
    watched = nullptr;
  }

 private:
  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

  void Watch() {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, look_.Next(), [this] { return over_; })) {
      if (!look_.Look()) return;
    }
  }

  SearchLook look_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::array<struct sigaction, kSignals.size()> before_{};  ///< what the signals did
  std::thread watching_;
};

SearchWatch::SearchWatch(const Invocation& invocation, const WatchOptions& options)
    : watcher_(std::make_unique<Watcher>(invocation, options, &progress_)) {}

SearchWatch::~SearchWatch() = default;

}  // namespace oncard::tools
