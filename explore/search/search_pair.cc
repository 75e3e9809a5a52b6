#include "explore/search/search_pair.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace oncard::explore {
namespace {

/// When one search has a result, the other may continue counting for this fraction of the time that
/// has passed, and at least for kGraceMin.
constexpr double kGracePart = 0.3;
constexpr std::chrono::milliseconds kGraceMin{10};
/// How often is checked whether both searches must be stopped.
constexpr std::chrono::milliseconds kStopPolled{50};

}  // namespace

PairResult RunPair(const SearchPair& pair) {
  using First = PairResult::First;
  PairResult result;
  std::mutex mutex;
  std::condition_variable answered;
  std::atomic<bool> stop{false};
  std::atomic<bool> stop_traces{false};
  std::atomic<bool> pause{false};  // the search of traces was stopped for a pause
  int running = 2;
  bool endless = false;  // the search of traces will never be complete
  bool stated = false;   // the search of states has ended
  const auto start = std::chrono::steady_clock::now();
  const auto report = [&](First search, bool answers) {
    const std::lock_guard lock(mutex);
    --running;
    if (answers && result.first == First::kNeither) result.first = search;
    answered.notify_all();
  };
  const auto take_pause = [&] {
    if (!pause.exchange(false)) return false;
    stop_traces = false;
    if (stop) stop_traces = true;
    return !stop;
  };
  std::thread tracing([&] {
    result.traces = pair.traces(&stop_traces, take_pause);
    report(First::kTraces, result.traces->complete() || result.traces->bad > 0);
  });
  std::thread stating([&] {
    result.states = pair.states(&stop);
    const StateCounts& counts = result.states.counts;
    const bool cyclic = counts.complete && IsCyclic(result.states.graph);
    {
      const std::lock_guard lock(mutex);
      endless = cyclic;
      stated = true;
    }
    report(First::kStates, counts.complete || counts.bad_states > 0);
  });
  {
    std::unique_lock lock(mutex);
    const auto done = [&] {
      return running == 0 || (pair.known_bad ? stated : result.first != First::kNeither);
    };
    while (!answered.wait_for(lock, kStopPolled, done)) {
      if (pair.progress == nullptr || !pair.progress->stop) continue;
      pause = pair.progress->TakePause();
      if (!pause) stop = true;
      stop_traces = true;
    }
    const auto passed = std::chrono::steady_clock::now() - start;
    const auto grace = std::max<std::chrono::nanoseconds>(
        kGraceMin, std::chrono::duration_cast<std::chrono::nanoseconds>(passed * kGracePart));
    answered.wait_for(lock, grace, [&] { return running == 0 || endless; });
    stop = true;
    stop_traces = true;
  }
  tracing.join();
  stating.join();
  if (pair.progress != nullptr) pair.progress->TakePause();
  return result;
}

}  // namespace oncard::explore
