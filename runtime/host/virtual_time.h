// The virtual time of a host process, used by its cards, sleeps and clocks if ONCARD_CLOCK is
// `virtual`. There is one for the whole process; a card catches up with it when it is called.
//
// Time advances in two ways. Actions of a host thread take time: a call of a command, or reading a
// clock (Pass). And when every thread of the host waits, time jumps to the instant at which the
// first sleeper is to wake (SleepUntil). A thread waits if it is asleep in the operating system: in
// a sleep that is handled here, for a lock, for another thread, or for input. Time never passes a
// sleeper: a thread that advances time waits until the sleepers that are due have been woken.
//
// Each sleeper has a futex of its own. The thread that falls asleep last lets time jump and wakes
// only those that are due, all at once. Where another thread still works and waits later, without a
// sleep, a helper notices: a thread of the host library that looks again and again while there are
// sleepers and nothing changes.
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
// Between two checks a handler of a signal may run, for which the wait cannot end. It lets time
// pass the deadline before it waits for another thread (LetOthersPass).
//
// A thread can also wait for another one without a deadline (SleepOn). If every thread waits, and
// none for what may come from outside, such as a key, these waits are given up. And what is no
// thread of the host, such as a card that interrupts it, may wake one: there can be one source of
// such wake-ups. When every thread waits, time never jumps past the instant at which the source may
// act; it acts there, and time goes on to its next instant, until a thread has been woken.
//
// A host with one thread therefore sees exactly the same times in every run. With several threads,
// times are the same as long as only one of them runs at a time; threads that run in parallel can
// race as usual.
//
// Thread-safe. Whether a thread waits is asked in thread_waits.h.
// Tested by tests/runtime/virtual_time_test.cc.
#pragma once

#include <pthread.h>
#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "runtime/host/calling_thread.h"
#include "runtime/host/thread_waits.h"

namespace oncard::runtime {

/// What may wake threads although all of them wait. Called with no lock of virtual time.
class WakeUps {
 public:
  WakeUps() = default;
  WakeUps(const WakeUps&) = delete;
  WakeUps& operator=(const WakeUps&) = delete;
  virtual ~WakeUps() = default;

  /// The instant, later than now, at which it may act next; VirtualTime::kNeverNs.
  virtual int64_t NextNs() = 0;
  /// The time has come. It may call Wake() and WakeFirst().
  virtual void Act() = 0;
};

class VirtualTime {
 public:
  /// HowOthersWait().
  using OthersWait =
      std::function<Waits(std::span<const ThreadId> asleep, std::span<const ThreadId> in_slices)>;
  /// A wait with a deadline, from BeginWait() to EndWait().
  struct Wait {
    int64_t deadline_ns = 0;
    int64_t number = 0;  ///< in the order of their coming
  };

  /// The end of virtual time, after 146 years.
  static constexpr int64_t kEndNs = INT64_MAX / 2;
  /// The deadline of a wait that has none.
  static constexpr int64_t kNeverNs = INT64_MAX;

  explicit VirtualTime(OthersWait others_wait = HowOthersWait)
      : others_wait_(std::move(others_wait)) {}
  VirtualTime(const VirtualTime&) = delete;
  VirtualTime& operator=(const VirtualTime&) = delete;
  ~VirtualTime();

  /// The process's own.
  static VirtualTime& OfProcess();

  /// Nanoseconds since the process began.
  int64_t NowNs() const { return now_ns_.load(std::memory_order_relaxed); }
  /// The instant after this duration; at most kEndNs.
  int64_t After(int64_t ns) const;
  /// The calling thread is busy for this duration; returns the time afterwards.
  int64_t Pass(int64_t ns);
  /// Returns when the time has come, a signal is held for the thread (call_scope.h), or WakeFirst()
  /// has woken it: then what is left of the sleep, otherwise 0.
  int64_t SleepUntil(int64_t deadline_ns);

  /// How SleepOn() has ended.
  enum class Woken : uint8_t {
    kAtDeadline,
    kByThread,  ///< by Wake() or WakeFirst(), or a signal is held for the thread
    kNever,     ///< nobody could wake it any more
  };
  /// Sleeps while the word has this value, until another thread changes it and calls Wake(), or the
  /// deadline has come.
  Woken SleepOn(const std::atomic<int>& word, int value, int64_t deadline_ns);
  /// Wakes the first thread that sleeps on the word, or all.
  void Wake(const std::atomic<int>& word, bool all);
  /// Ends the sleep, before its deadline, of the first thread that is to wake, so that it does
  /// something else.
  void WakeFirst();
  /// From now on asks the source before time jumps. It must exist as long as this object.
  void ListenTo(WakeUps* source);

  /// The calling thread begins to wait for something until a deadline.
  Wait BeginWait(int64_t deadline_ns);
  /// How long to wait in real time before the next check; 0 if the deadline has been reached, or is
  /// reached now because every thread waits.
  int64_t NextSliceNs(const Wait& wait);
  /// Ends the wait; if it `expired`, time is now at least its deadline.
  void EndWait(const Wait& wait, bool expired);
  /// To be called in a handler of a signal that has interrupted waits of the calling thread: time
  /// may pass the deadline of each until its next check.
  void LetOthersPass();

  /// Around fork(), for the process's own: the child continues with only the thread that forked,
  /// and no other thread waits.
  void LockForFork();
  void UnlockAfterFork();
  void BecomeChild();

 private:
  /// What a sleeping thread waits for, on its stack.
  struct Bed {
    std::atomic<int> changes = 0;  ///< a futex
    // Guarded by mutex_.
    const std::atomic<int>* word = nullptr;  ///< SleepOn(), as is the next
    int value = 0;
    bool woken = false;
    bool is_going = false;  ///< counted in going_
    Woken how = Woken::kAtDeadline;
  };
  /// The time to wake, and the order of arrival among equal times.
  struct Sleeper {
    int64_t deadline_ns;
    int64_t number;
    ThreadId thread = 0;
    Bed* bed = nullptr;                ///< null: a wait in slices
    mutable bool interrupted = false;  ///< a handler runs during the wait
    bool operator<(const Sleeper& other) const {
      return std::tie(deadline_ns, number) < std::tie(other.deadline_ns, other.number);
    }
  };

  /// Locks, for a thread of the host. Whoever looks whether the others wait sees that it came.
  std::unique_lock<std::mutex> Enter();
  void Add(const Sleeper& sleeper);
  void Remove(int64_t deadline_ns, int64_t number);
  void MarkInterrupted(ThreadId thread);
  /// The first whose thread does not do something else in a handler; nullptr if there is none.
  const Sleeper* First() const;
  void AdvanceTo(int64_t ns);
  /// Sleeps until the bed's owner is woken; returns what is left until the deadline if that is
  /// before it.
  int64_t Sleep(int64_t deadline_ns, Bed* bed);
  /// Takes the sleeper out of its bed. A thread other than the calling one counts as going until it
  /// runs.
  void WakeOne(const Sleeper& sleeper, Woken how);
  /// Lets time jump to the first sleeper and wakes those that are due, if every other thread waits;
  /// the first in slices finds that out itself. True if someone was woken. Unlocks in between.
  bool Jump(std::unique_lock<std::mutex>* lock);
  /// Every thread waits: lets time go on as long as the source acts before the first deadline.
  /// False if a thread was woken or came in meanwhile. Unlocks in between.
  bool FollowSource(std::unique_lock<std::mutex>* lock);
  /// Ends the waits that have no deadline; false if there is none.
  bool GiveUpWaiting();
  /// Wakes the sleepers whose moment has come; true if there was one.
  bool WakeDue();
  /// Whether every other thread waits, and kept waiting during the check. Unlocks in between.
  Waits AskOthers(std::unique_lock<std::mutex>* lock);
  /// True while sleepers whose moment has come have not gone on; waits of `own` and those that a
  /// handler has interrupted do not count.
  bool IsPassingSomeone(int64_t now) const;
  /// Tells threads in Pass() that a sleeper has gone.
  void TellPassing();

  /// Makes the helper look; false if it cannot be started.
  bool CallHelper();
  bool StartHelper();
  void Help();

  OthersWait others_wait_;
  std::mutex mutex_;  // guards what follows, but not the atomic members
  std::set<Sleeper> sleepers_;
  int64_t next_number_ = 0;
  int64_t changes_ = 0;        // counts sleepers that came and went
  int64_t visits_ = 0;         // counts threads that have come in
  int going_ = 0;              // sleepers that were woken and have not gone on yet
  int passing_ = 0;            // threads in Pass() that wait for them
  std::atomic<int> gone_ = 0;  // a futex for these
  pid_t helped_process_ = 0;   // the process whose helper runs
  pthread_t helper_{};
  bool helper_rests_ = false;
  WakeUps* source_ = nullptr;
  std::atomic<ThreadId> acting_ = 0;  // follows the source: nobody else lets time jump
  bool ends_ = false;
  std::atomic<int> helper_calls_ = 0;  // a futex for the helper that rests
  std::atomic<int> entering_ = 0;      // threads that wait for the lock in Enter()
  std::atomic<int64_t> first_deadline_ns_ = INT64_MAX;
  std::atomic<int64_t> now_ns_ = 0;
};

}  // namespace oncard::runtime
