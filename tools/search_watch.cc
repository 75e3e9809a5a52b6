// With a thread that watches, and signals that end the search.
#include "tools/search_watch.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>

#include "tools/search_look.h"
#include "tools/stop_signal_numbers.h"

namespace oncard::tools {
namespace {

/// The search that a signal stops.
std::atomic<explore::SearchProgress*> watched{nullptr};

extern "C" void StopSearch(int signal) {
  static_cast<void>(std::signal(signal, SIG_DFL));
  explore::SearchProgress* progress = watched.load();
  if (progress == nullptr) return;
  progress->interrupted = true;
  progress->stop = true;
}

class Watcher {
 public:
  Watcher(const Invocation& invocation, const WatchOptions& options,
          explore::SearchProgress* progress)
      : look_(invocation, options, progress) {
    watched = progress;
    std::ranges::transform(signals_, before_.begin(),
                           [](int signal) { return std::signal(signal, StopSearch); });
    if (before_.back() == SIG_IGN) static_cast<void>(std::signal(signals_.back(), SIG_IGN));
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
    for (size_t i = 0; i < signals_.size(); ++i) {
      static_cast<void>(std::signal(signals_[i], before_[i]));
    }
    watched = nullptr;
  }

 private:
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
  const std::array<int, 3> signals_ = kStopSignals.all();
  std::array<void (*)(int), 3> before_{};  ///< what the signals did
  std::thread watching_;
};

}  // namespace

std::shared_ptr<void> WatchSearch(const Invocation& invocation, const WatchOptions& options,
                                  explore::SearchProgress* progress) {
  return std::make_shared<Watcher>(invocation, options, progress);
}

}  // namespace oncard::tools
