// In WebAssembly, which has neither threads nor signals: the search itself calls its watcher.
#include <cstdint>

#include "tools/search_watch.h"

namespace oncard::tools {
namespace {

/// How often a search asks whether it is to end before the clock is looked at: some milliseconds.
constexpr uint32_t kAskedMax = 1024;

class Watcher {
 public:
  Watcher(const Invocation& invocation, const WatchOptions& options,
          explore::SearchProgress* progress)
      : look_(invocation, options, progress) {
    watching = this;
    explore::ask_watcher = [] { watching->Ask(); };
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;
  ~Watcher() { explore::ask_watcher = nullptr; }

 private:
  void Ask() {
    if (++asked_ < kAskedMax) return;
    asked_ = 0;
    if (!look_.Look()) explore::ask_watcher = nullptr;
  }

  inline static Watcher* watching = nullptr;

  SearchLook look_;
  uint32_t asked_ = 0;
};

}  // namespace

std::shared_ptr<void> WatchSearch(const Invocation& invocation, const WatchOptions& options,
                                  explore::SearchProgress* progress) {
  return std::make_shared<Watcher>(invocation, options, progress);
}

}  // namespace oncard::tools
