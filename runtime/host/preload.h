// What the parts of liboncard_host.so have in common: the way to the virtual time of libgts, the C
// library's own functions, and clocks and durations as nanoseconds that do not overflow.
//
// The library calls nothing of C++, so that it can be loaded before any program. Thread-safe.
#pragma once

#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <sys/time.h>
#include <time.h>

#include "runtime/host/host_hooks.h"

#define ONCARD_EXPORT extern "C" __attribute__((visibility("default")))

namespace oncard::preload {

inline constexpr long long kSecondNs = 1'000'000'000;
/// What a longer duration is cut to: 146 years, as far as virtual time goes.
inline constexpr long long kForeverNs = 0x3FFF'FFFF'FFFF'FFFF;

/// What the C library, or the next one that replaces it, has under a name.
template <typename Function>
Function* Original(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

#define ORIGINAL(name)                                                                \
  [] {                                                                                \
    static auto* const original = oncard::preload::Original<decltype(::name)>(#name); \
    return original;                                                                  \
  }()

/// The functions of libgts (host_hooks.h).
struct Hooks {
  decltype(oncard_host_time_ns)* time_ns;
  decltype(oncard_host_sleep_ns)* sleep_ns;
  decltype(oncard_host_wait_begin)* wait_begin;
  decltype(oncard_host_wait_slice_ns)* wait_slice_ns;
  decltype(oncard_host_wait_end)* wait_end;
};

/// The way to virtual time; NULL when this process does not go by it: one without libgts, such as a
/// shell that starts the host, or with another clock.
const Hooks* VirtualHooks();

/// The time of a clock when virtual time begins; -1 for one that is left alone.
long long BeginOf(clockid_t clock);

/// As nanoseconds, at most kForeverNs; less than nothing is nothing.
long long ToNs(const timespec& time);
long long ToNs(const timeval& time);
timespec ToTimespec(long long ns);
inline bool IsValid(const timespec& time) {
  return time.tv_sec >= 0 && time.tv_nsec >= 0 && time.tv_nsec < kSecondNs;
}

/// Sets errno and gives -1.
inline int Fail(int error) {
  errno = error;
  return -1;
}

/// While it lives the thread is not cancelled: virtual time would wait for it for ever. Waits at
/// which a thread may be cancelled begin with pthread_testcancel().
class Uncancelled {
 public:
  Uncancelled() { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_); }
  Uncancelled(const Uncancelled&) = delete;
  Uncancelled& operator=(const Uncancelled&) = delete;
  ~Uncancelled() { pthread_setcancelstate(before_, nullptr); }

 private:
  int before_ = PTHREAD_CANCEL_ENABLE;
};

inline void Sleep(const Hooks& hooks, long long duration_ns) {
  pthread_testcancel();
  const Uncancelled sleep;
  hooks.sleep_ns(duration_ns);
}

/// Waits until `attempt` has what it waits for, or a moment of virtual time has come: true or
/// false. `attempt(slice_ns)` waits in reality at most that long, with 0 not at all, and gives true
/// when the wait is over, with success or an error. Beginning takes a look at the clock, so that a
/// host that only looks gets on.
template <typename Attempt>
bool WaitUntil(const Hooks& hooks, long long deadline_ns, const Attempt& attempt) {
  const Uncancelled wait_to_its_end;
  hooks.time_ns();
  if (attempt(0)) return true;
  oncard_host_wait wait;
  hooks.wait_begin(deadline_ns, &wait);
  bool over = false;
  while (!over) {
    const long long slice_ns = hooks.wait_slice_ns(&wait);
    over = attempt(slice_ns);
    if (slice_ns == 0) break;
  }
  hooks.wait_end(&wait, over ? 0 : 1);
  return over;
}

}  // namespace oncard::preload
