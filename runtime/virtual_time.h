// The virtual time of a host process: what its cards, its sleeps and its clocks go by when
// ONCARD_CLOCK is `virtual`. There is one for the whole process; a card that is called catches up
// with it.
//
// Time passes in two ways. What a thread of the host does takes time: a call of a command, a look
// at a clock (Pass). And when every thread of the host waits, time jumps to the moment at which the
// first sleeper wants to wake (SleepUntil). A thread waits when the operating system has it asleep:
// in a sleep that came here, for a lock, for another thread, for input. Time never runs past a
// sleeper: whoever lets it pass waits until the sleepers that are due have been let go.
//
// So a host of one thread sees exactly the same times in every run. With several threads times are
// the same as long as only one of them runs at a time; threads that run at once race as they do
// anywhere. Waiting with a time-out for something else than time (a condition, a socket) is known
// to the operating system only and goes by real time.
//
// Thread-safe. Linux only: whether a thread waits is read from /proc.
// Tested by tests/runtime/virtual_time_test.cc.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <set>
#include <utility>

namespace oncard::runtime {

class VirtualTime {
 public:
  /// True when all threads of the process but the calling one wait.
  using OthersWait = std::function<bool()>;

  explicit VirtualTime(OthersWait others_wait = OtherThreadsWait)
      : others_wait_(std::move(others_wait)) {}
  VirtualTime(const VirtualTime&) = delete;
  VirtualTime& operator=(const VirtualTime&) = delete;

  /// The process's own.
  static VirtualTime& OfProcess();

  /// Nanoseconds since the process began.
  int64_t NowNs() const { return now_ns_.load(std::memory_order_relaxed); }
  /// The calling thread is busy for that long; gives the time afterwards.
  int64_t Pass(int64_t ns);
  /// Returns when the time has come.
  void SleepUntil(int64_t deadline_ns);

  /// Asks the operating system.
  static bool OtherThreadsWait();

 private:
  /// When to wake, and who came first among equals.
  using Sleeper = std::pair<int64_t, int64_t>;

  OthersWait others_wait_;
  std::mutex mutex_;                 // guards what follows; now_ns_ is written under it
  std::condition_variable changed_;  // a sleeper has come, gone, or is due
  std::set<Sleeper> sleepers_;
  int64_t next_sleeper_ = 0;
  std::atomic<int64_t> now_ns_ = 0;
};

}  // namespace oncard::runtime
