// Common parts of liboncard_host.so: access to the virtual time of the host library, the C
// library's own functions, and overflow-free clocks and durations in nanoseconds.
//
// The library does not need the C++ library, so that it can be preloaded into any program.
// Thread-safe.
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
/// The longest duration, 146 years, the end of virtual time; longer ones are cut to it.
inline constexpr long long kForeverNs = 0x3FFF'FFFF'FFFF'FFFF;

/// The function with a name in the C library, or in the next library that replaces it.
template <typename Function>
Function* Original(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

#define ORIGINAL(name)                                                                \
  [] {                                                                                \
    static auto* const original = oncard::preload::Original<decltype(::name)>(#name); \
    return original;                                                                  \
  }()

/// The functions of the host library (host_hooks.h).
struct Hooks {
  decltype(oncard_host_time_ns)* time_ns;
  decltype(oncard_host_sleep_ns)* sleep_ns;
  decltype(oncard_host_wait_begin)* wait_begin;
  decltype(oncard_host_wait_slice_ns)* wait_slice_ns;
  decltype(oncard_host_wait_end)* wait_end;
};

/// Access to virtual time; NULL if this process does not use it: a process without a host library,
/// such as a shell that starts the host, or with another clock.
const Hooks* VirtualHooks();

/// The time of a clock at the start of virtual time; -1 for a clock that is not replaced.
long long BeginOf(clockid_t clock);

/// As nanoseconds, at most kForeverNs; negative durations are 0.
long long ToNs(const timespec& time);
long long ToNs(const timeval& time);
timespec ToTimespec(long long ns);
inline bool IsValid(const timespec& time) {
  return time.tv_sec >= 0 && time.tv_nsec >= 0 && time.tv_nsec < kSecondNs;
}

/// False for NULL and what else can be no address. Such a pointer is left to the C library, which
/// says EFAULT where the kernel reads it.
inline bool IsAddress(const void* pointer) {
  constexpr unsigned long kPageSize = 4096;  // the lowest memory is never mapped
  return reinterpret_cast<unsigned long>(pointer) >= kPageSize;
}

/// Sets errno and returns -1.
inline int Fail(int error) {
  errno = error;
  return -1;
}

/// Disables cancellation of the thread during its lifetime, because virtual time would wait for a
/// cancelled thread for ever. Waits that are cancellation points begin with pthread_testcancel().
class Uncancelled {
 public:
  Uncancelled() { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_); }
  Uncancelled(const Uncancelled&) = delete;
  Uncancelled& operator=(const Uncancelled&) = delete;
  ~Uncancelled() { pthread_setcancelstate(before_, nullptr); }

 private:
  int before_ = PTHREAD_CANCEL_ENABLE;
};

/// Returns what is left of the duration if a signal ends the sleep, otherwise 0.
inline long long Sleep(const Hooks& hooks, long long duration_ns) {
  pthread_testcancel();
  const Uncancelled sleep;
  return hooks.sleep_ns(duration_ns);
}

/// Waits until `attempt` succeeds (true), or until an instant of virtual time (false).
/// `attempt(slice_ns)` waits in real time at most that long, with 0 not at all, and returns true
/// when the wait is over, with success or an error. The call counts as reading the clock, so that a
/// polling host makes progress.
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
