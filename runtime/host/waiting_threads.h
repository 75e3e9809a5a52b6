// Whether the other threads of this process wait, asked from the operating system. Virtual time
// (virtual_time.h) asks before every jump, so that the answer must be cheap:
//
// - The number of threads is the number of links of the folder /proc/self/task. If all of them are
//   known to wait, nothing else is looked at. It counts threads that any library began.
// - The files of each of the other threads stay open: `stat` says whether it sleeps, and
//   `schedstat` how often it has run. A thread seen asleep still sleeps while that number has not
//   changed, and what kind of wait it is in is asked only once.
// - `syscall` says in which system call a thread sleeps. One in a futex waits for other threads;
//   any other call, such as the read of a pipe, can be ended by something outside of the process.
// - Kernels that do not count runs have `status`, which takes twice as long and names no calls.
//
// If the host has closed the descriptor of the folder (kept_descriptor.h), all is opened anew.
//
// Thread-safe. Linux only. Tested by tests/runtime/waiting_threads_test.cc.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/host/calling_thread.h"
#include "runtime/host/kept_descriptor.h"
#include "runtime/host/thread_waits.h"

namespace oncard::runtime {

class WaitingThreads {
 public:
  WaitingThreads() = default;
  WaitingThreads(const WaitingThreads&) = delete;
  WaitingThreads& operator=(const WaitingThreads&) = delete;
  ~WaitingThreads();

  /// The process's own; never destroyed.
  static WaitingThreads& OfProcess();

  /// HowOthersWait().
  Waits OthersWait(std::span<const ThreadId> asleep, std::span<const ThreadId> in_slices);

  /// Around fork().
  void LockForFork() { mutex_.lock(); }
  void UnlockAfterFork() { mutex_.unlock(); }

  /// How often threads were listed and looked at, to count what an answer costs.
  struct Work {
    long listings = 0;
    long looks = 0;
  };
  Work work() const { return work_; }

 private:
  /// The files of a thread, -1: opened for each look; and how it was seen asleep.
  struct Thread {
    ThreadId id = 0;
    int state = -1;                   ///< `stat`, or `status` where the kernel does not count runs
    int runs = -1;                    ///< `schedstat`
    int call = -1;                    ///< `syscall`
    std::string asleep;               ///< its runs at that time; empty: was not seen asleep
    Waits wait = Waits::kForOutside;  ///< for what it slept
  };
  /// Those of which something is known.
  struct Known {
    std::span<const ThreadId> asleep;
    std::span<const ThreadId> in_slices;
    ThreadId caller = 0;
  };
  /// Empty: a thread has ended.
  using Answer = std::optional<Waits>;

  /// The number of threads; 0 if the operating system does not say.
  size_t Count();
  /// Of how many nothing need be asked: the caller, those asleep and those left out.
  static size_t CountKnown(const Known& known);
  void OpenFolder();
  void ListThreads();
  void OpenFiles(Thread* thread) const;
  void CloseFiles(const Thread& thread) const;
  void CloseAll();
  /// Looks at all threads but the known ones. `slept_on`: none has run since an earlier look that
  /// saw it asleep.
  Answer LookAtOthers(const Known& known, bool* slept_on);
  /// Sets `slept_on` to false or leaves it.
  Answer LookAt(Thread* thread, bool in_slices, bool* slept_on);
  Answer LookAtStatus(Thread* thread, bool in_slices, bool* slept_on);
  std::string Read(const Thread& thread, int file, const char* name) const;

  std::mutex mutex_;  // guards what follows
  pid_t process_ = 0;
  KeptDescriptor folder_;
  bool counts_runs_ = true;
  std::vector<Thread> threads_;
  Work work_;
};

}  // namespace oncard::runtime
