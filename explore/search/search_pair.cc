#include "explore/search/search_pair.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>

namespace oncard::explore {
namespace {

/// See SearchPair::grace_part.
constexpr std::chrono::milliseconds kGraceMin{10};
/// How often is checked whether both searches must be stopped.
constexpr std::chrono::milliseconds kStopPolled{5};

/// Starts a thread; false if the system cannot.
template <typename Work>
bool Start(const Work& work, std::thread* thread) {
  try {
    *thread = std::thread(work);
  } catch (const std::system_error&) {
    return false;
  }
  return true;
}

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
  bool bad = pair.known_bad;
  std::atomic<uint32_t> most{std::numeric_limits<uint32_t>::max()};
  bool stated = false;  // the search of states has ended
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
  const auto trace = [&] {
    result.traces = pair.traces(&stop_traces, take_pause);
    if (result.traces->bad > 0) {
      const std::lock_guard lock(mutex);
      bad = true;
      most = kStatesBesideFailure;
    }
    report(First::kTraces, result.traces->complete() || result.traces->bad > 0);
  };
  const auto state = [&] {
    result.states = pair.states(&stop, &most);
    const StateCounts& counts = result.states.counts;
    const bool cyclic = counts.complete && IsCyclic(result.states.graph, HurriedOf(pair.progress));
    {
      const std::lock_guard lock(mutex);
      endless = cyclic;
      stated = true;
    }
    report(First::kStates, counts.complete || counts.bad_states > 0);
  };
  std::thread tracing;
  std::thread stating;
  if (!Start(trace, &tracing)) return RunInTurn(pair);
  if (!Start(state, &stating)) {
    stop_traces = true;
    tracing.join();
    return RunInTurn(pair);
  }
  {
    std::unique_lock lock(mutex);
    const auto done = [&] {
      return running == 0 || (bad ? stated : result.first != First::kNeither);
    };
    while (!answered.wait_for(lock, kStopPolled, done)) {
      if (pair.progress == nullptr || !pair.progress->stop) continue;
      pause = pair.progress->TakePause();
      if (!pause) stop = true;
      stop_traces = true;
    }
    const auto passed = std::chrono::steady_clock::now() - start;
    const std::chrono::duration<double> grace =
        std::max<std::chrono::duration<double>>(kGraceMin, passed * pair.grace_part);
    const auto counted = [&] { return running == 0 || endless; };
    const auto interrupted = [&] { return pair.progress != nullptr && pair.progress->interrupted; };
    while (!interrupted() && !answered.wait_for(lock, kStopPolled, counted)) {
      if (std::chrono::steady_clock::now() - start > passed + grace) break;
    }
    stop = true;
    stop_traces = true;
  }
  tracing.join();
  stating.join();
  if (pair.progress != nullptr) pair.progress->TakePause();
  return result;
}

}  // namespace oncard::explore
