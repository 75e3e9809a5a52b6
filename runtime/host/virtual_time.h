// The virtual time of a host process, used by its cards, sleeps and clocks if ONCARD_CLOCK is
// `virtual`. There is one for the whole process; a card catches up with it when it is called.
//
// Time advances in two ways. Actions of a host thread take time: a call of a command, or reading a
// clock (Pass). And when every thread of the host waits, time jumps to the instant at which the
// first sleeper is to wake (SleepUntil). A thread waits if it is asleep in the operating system: in
// a sleep that is handled here, for a lock, for another thread, or for input. Time never passes a
// sleeper: a thread that advances time waits until the sleepers that are due have been woken.
//
// A wait with a deadline for a condition, a lock or a descriptor is a sleeper too. It waits in the
// operating system, so that it continues at once when the event occurs, but only in short slices,
// and checks its deadline between them:
//
//   const Wait wait = time.BeginWait(deadline_ns);
//   while (int64_t slice_ns = time.NextSliceNs(wait)) {
//     if (it came within slice_ns of real time) { time.EndWait(wait, false); return; }
//   }
//   const bool came = it came by now;  // a last look, without waiting
//   time.EndWait(wait, !came);
//
// A host with one thread therefore sees exactly the same times in every run. With several threads,
// times are the same as long as only one of them runs at a time; threads that run in parallel can
// race as usual.
//
// Thread-safe. Linux only: whether a thread waits is read from /proc.
// Tested by tests/runtime/virtual_time_test.cc.
#pragma once

#include <atomic>
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
  /// A thread, by its number in the operating system.
  using ThreadId = int;
  /// True if all threads of the process except the calling one wait. Threads `in_slices` are in
  /// waits with a deadline and may be between two slices.
  using OthersWait = std::function<bool(std::span<const ThreadId> in_slices)>;
  /// A wait with a deadline, from BeginWait() to EndWait().
  struct Wait {
    int64_t deadline_ns = 0;
    int64_t number = 0;  ///< in the order of their coming
  };

  /// The end of virtual time, after 146 years.
  static constexpr int64_t kEndNs = INT64_MAX / 2;

  explicit VirtualTime(OthersWait others_wait = OtherThreadsWait)
      : others_wait_(std::move(others_wait)) {}
  VirtualTime(const VirtualTime&) = delete;
  VirtualTime& operator=(const VirtualTime&) = delete;

  /// The process's own.
  static VirtualTime& OfProcess();

  /// Nanoseconds since the process began.
  int64_t NowNs() const { return now_ns_.load(std::memory_order_relaxed); }
  /// The instant after this duration; at most kEndNs.
  int64_t After(int64_t ns) const;
  /// The calling thread is busy for this duration; returns the time afterwards.
  int64_t Pass(int64_t ns);
  /// Returns when the time has come, or a signal is held for the thread (call_scope.h): then what
  /// is left of the sleep, otherwise 0.
  int64_t SleepUntil(int64_t deadline_ns);

  /// The calling thread begins to wait for something until a deadline.
  Wait BeginWait(int64_t deadline_ns);
  /// How long to wait in real time before the next check; 0 if the deadline has been reached, or is
  /// reached now because every thread waits.
  int64_t NextSliceNs(const Wait& wait);
  /// Ends the wait; if it `expired`, time is now at least its deadline.
  void EndWait(const Wait& wait, bool expired);

  /// Around fork(): the child continues with only the thread that forked, and no other thread
  /// waits.
  void LockForFork() { mutex_.lock(); }
  void UnlockAfterFork() { mutex_.unlock(); }
  void BecomeChild();

  /// Asks the operating system.
  static bool OtherThreadsWait(std::span<const ThreadId> in_slices);
  /// The calling thread does not belong to the host: it is no longer checked for waiting.
  static void LeaveOutCallingThread();

 private:
  /// The time to wake, and the order of arrival among equal times.
  struct Sleeper {
    int64_t deadline_ns;
    int64_t number;
    ThreadId in_slices;  ///< a thread in a wait with a deadline; 0 for a sleep
    bool operator<(const Sleeper& other) const {
      return std::tie(deadline_ns, number) < std::tie(other.deadline_ns, other.number);
    }
  };

  /// Adds a sleeper and returns its number.
  int64_t Add(int64_t deadline_ns, ThreadId in_slices);
  void Remove(int64_t deadline_ns, int64_t number);
  bool IsFirst(int64_t number) const { return sleepers_.begin()->number == number; }
  /// True if every other thread waits, and kept waiting during the check. Unlocks in between.
  bool IsAlone(std::unique_lock<std::mutex>* lock, int64_t number);

  /// Wakes the threads in WaitForChange().
  void NotifyAll();
  /// Waits, unlocked, until changed_ is no longer as it was seen.
  void WaitForChange(std::unique_lock<std::mutex>* lock, int seen);
  /// True if the moment of a sleeper has come; waits of the thread `but_of` do not count.
  bool IsDue(int64_t now, ThreadId but_of = 0) const;

  OthersWait others_wait_;
  std::mutex mutex_;              // guards what follows; now_ns_ is written under it
  std::atomic<int> changed_ = 0;  // a futex: a sleeper has gone or is due
  int waiting_ = 0;               // threads in WaitForChange()
  std::set<Sleeper> sleepers_;
  int64_t next_number_ = 0;
  int64_t changes_ = 0;  // counts sleepers that came and went
  std::atomic<int64_t> now_ns_ = 0;
};

}  // namespace oncard::runtime
