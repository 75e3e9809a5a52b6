// The threads of a host on Windows, which does not say who waits. A thread belongs to the host if
// it loaded the library, if the program or one of its modules has started it, or once it has called
// a function that the library replaces (host_imports_windows.h). Threads of Windows itself do not.
// It waits while it is in such a function; in any other call, which may last, it counts as working.
//
// Thread-safe.
#pragma once

#include <windows.h>

#include <atomic>

#include "runtime/host/virtual_time.h"

namespace oncard::runtime {

/// The calling thread belongs to the host from now on.
void EnrolThread();
/// So does a thread that has just been started.
void EnrolThread(DWORD thread);

/// What threads wait for in virtual time. Who waits looks at it, and sleeps until it changes:
///
///   const WaitWord::Waiter waiter(&word);
///   for (;;) {
///     const int seen = word.changes();
///     if (it is there) return;
///     word.SleepUntilChange(seen, deadline_ns);
///   }
class WaitWord {
 public:
  /// While it exists its thread waits.
  class Waiter {
   public:
    explicit Waiter(WaitWord* word) : word_(*word) { ++word_.waiters_; }
    Waiter(const Waiter&) = delete;
    Waiter& operator=(const Waiter&) = delete;
    ~Waiter() { --word_.waiters_; }

   private:
    WaitWord& word_;
  };

  constexpr WaitWord() = default;
  WaitWord(const WaitWord&) = delete;
  WaitWord& operator=(const WaitWord&) = delete;

  int changes() const { return changes_; }
  bool has_waiters() const { return waiters_ != 0; }
  /// Something has changed: who waits looks again.
  void Change();
  VirtualTime::Woken SleepUntilChange(int seen, int64_t deadline_ns);

 private:
  std::atomic<int> changes_ = 0;
  std::atomic<int> waiters_ = 0;
};

/// For handles of Windows, and for its locks. From time to time who waits looks although nobody has
/// said that something has changed: Windows itself, or another process, may have done so.
extern constinit WaitWord handle_word;
extern constinit WaitWord lock_word;

/// While it exists the calling thread waits for something that may come from outside.
class WaitsForOutside {
 public:
  WaitsForOutside();
  WaitsForOutside(const WaitsForOutside&) = delete;
  WaitsForOutside& operator=(const WaitsForOutside&) = delete;
  ~WaitsForOutside();
};

}  // namespace oncard::runtime
