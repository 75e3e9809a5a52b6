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
// A wait for something else than time that has a deadline (a condition, a lock, a descriptor) is a
// sleeper too. It waits in the operating system for what it waits for, so that it runs at once when
// that comes, but only for a moment at a time, and asks in between whether its deadline has come:
//
//   const Wait wait = time.BeginWait(deadline_ns);
//   while (int64_t slice_ns = time.NextSliceNs(wait)) {
//     if (it came within slice_ns of real time) { time.EndWait(wait, false); return; }
//   }
//   const bool came = it came by now;  // a last look, without waiting
//   time.EndWait(wait, !came);
//
// So a host of one thread sees exactly the same times in every run. With several threads times are
// the same as long as only one of them runs at a time; threads that run at once race as they do
// anywhere.
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
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace oncard::runtime {

class VirtualTime {
 public:
  /// A thread, as the operating system numbers them.
  using ThreadId = int;
  /// True when all threads of the process but the calling one wait. `in_slices` are in waits with a
  /// deadline and may have gone from one slice to the next.
  using OthersWait = std::function<bool(std::span<const ThreadId> in_slices)>;
  /// A wait with a deadline, from BeginWait() to EndWait().
  struct Wait {
    int64_t deadline_ns = 0;
    int64_t number = 0;  ///< in the order of their coming
  };

  /// The last moment: beyond it nothing counts on. 146 years.
  static constexpr int64_t kEndNs = INT64_MAX / 2;

  explicit VirtualTime(OthersWait others_wait = OtherThreadsWait)
      : others_wait_(std::move(others_wait)) {}
  VirtualTime(const VirtualTime&) = delete;
  VirtualTime& operator=(const VirtualTime&) = delete;

  /// The process's own.
  static VirtualTime& OfProcess();

  /// Nanoseconds since the process began.
  int64_t NowNs() const { return now_ns_.load(std::memory_order_relaxed); }
  /// The moment that far away; kEndNs when it is beyond that.
  int64_t After(int64_t ns) const;
  /// The calling thread is busy for that long; gives the time afterwards.
  int64_t Pass(int64_t ns);
  /// Returns when the time has come.
  void SleepUntil(int64_t deadline_ns);

  /// The calling thread begins to wait for something until a deadline.
  Wait BeginWait(int64_t deadline_ns);
  /// How long it is to wait in reality before it asks again; 0 when the deadline has come, or would
  /// come now, as every thread waits.
  int64_t NextSliceNs(const Wait& wait);
  /// The wait has ended; when it `expired` it is not before its deadline now.
  void EndWait(const Wait& wait, bool expired);

  /// Around fork(): the child goes on with the thread that forked, and no other waits.
  void LockForFork() { mutex_.lock(); }
  void UnlockAfterFork() { mutex_.unlock(); }
  void BecomeChild();

  /// Asks the operating system.
  static bool OtherThreadsWait(std::span<const ThreadId> in_slices);
  /// The calling thread is not the host's: it is asked no more whether it waits.
  static void LeaveOutCallingThread();

 private:
  /// When to wake, and who came first among equals.
  struct Sleeper {
    int64_t deadline_ns;
    int64_t number;
    ThreadId in_slices;  ///< a thread in a wait with a deadline; 0 for a sleep
    bool operator<(const Sleeper& other) const {
      return std::tie(deadline_ns, number) < std::tie(other.deadline_ns, other.number);
    }
  };

  /// Adds a sleeper and gives its number.
  int64_t Add(int64_t deadline_ns, ThreadId in_slices);
  void Remove(int64_t deadline_ns, int64_t number);
  bool IsFirst(int64_t number) const { return sleepers_.begin()->number == number; }
  /// True when every other thread waits and went on doing so while it was looked at. Unlocks in
  /// between.
  bool IsAlone(std::unique_lock<std::mutex>* lock, int64_t number);

  OthersWait others_wait_;
  std::mutex mutex_;                 // guards what follows; now_ns_ is written under it
  std::condition_variable changed_;  // a sleeper has come, gone, or is due
  std::set<Sleeper> sleepers_;
  int64_t next_number_ = 0;
  int64_t changes_ = 0;  // counts sleepers that came and went
  std::atomic<int64_t> now_ns_ = 0;
};

}  // namespace oncard::runtime
