// liboncard_host.so, which `oncard exec` loads before everything else of a host program: the C
// library's sleeps and clocks go by the virtual time of libgts, so that a program that sleeps
// through a ten-second move finishes at once.
//
//   sleep usleep nanosleep clock_nanosleep        sleeps
//   select pselect poll ppoll without descriptors  likewise; with descriptors they are left alone
//   clock_gettime gettimeofday time timespec_get  clocks: the calendar begins on 2026-01-01 00:00
//                                                 UTC, the monotonic clocks at 1000 s
//
// The processor-time clocks are left alone, and so is everything in a process that has no libgts (a
// shell that starts the host) or that does not go by virtual time. The library has no state but the
// addresses that it has found, and calls nothing of C++.
// Tested by tests/tools/exec_command_test.cc.
#include <dlfcn.h>
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <sys/select.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "runtime/host_hooks.h"

#define ONCARD_EXPORT extern "C" __attribute__((visibility("default")))

namespace {

constexpr long long kSecondNs = 1'000'000'000;
/// Where the clocks begin: the same in every run.
constexpr long long kCalendarBeginNs = 1'767'225'600 * kSecondNs;  // 2026-01-01 00:00:00 UTC
constexpr long long kMonotonicBeginNs = 1000 * kSecondNs;

/// A function of libgts, or NULL in a process without it. A library that was loaded for one caller
/// only, as Python does, is found by its name.
template <typename Function>
Function* OfLibgts(const char* name) {
  void* found = dlsym(RTLD_DEFAULT, name);
  if (found == nullptr) {
    void* library = dlopen("libgts.so", RTLD_LAZY | RTLD_NOLOAD);
    if (library != nullptr) found = dlsym(library, name);
  }
  return reinterpret_cast<Function*>(found);
}

/// What the C library, or the next one that replaces it, has under a name.
template <typename Function>
Function* Original(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

#define ORIGINAL(name)                                             \
  [] {                                                             \
    static auto* const original = Original<decltype(name)>(#name); \
    return original;                                               \
  }()

struct Hooks {
  decltype(oncard_host_time_ns)* time_ns = [] { return 0LL; };
  decltype(oncard_host_sleep_ns)* sleep_ns = [](long long) {};
};

/// The way to virtual time; NULL when this process does not go by it.
const Hooks* VirtualHooks() {
  static Hooks hooks;
  static bool found = false;
  if (__atomic_load_n(&found, __ATOMIC_ACQUIRE)) return &hooks;
  auto* is_virtual = OfLibgts<decltype(oncard_host_virtual)>("oncard_host_virtual");
  if (is_virtual == nullptr || is_virtual() == 0) return nullptr;
  auto* time_ns = OfLibgts<decltype(oncard_host_time_ns)>("oncard_host_time_ns");
  auto* sleep_ns = OfLibgts<decltype(oncard_host_sleep_ns)>("oncard_host_sleep_ns");
  if (time_ns == nullptr || sleep_ns == nullptr) return nullptr;
  hooks = {time_ns, sleep_ns};
  __atomic_store_n(&found, true, __ATOMIC_RELEASE);
  return &hooks;
}

bool IsValid(const timespec& time) {
  return time.tv_sec >= 0 && time.tv_nsec >= 0 && time.tv_nsec < kSecondNs;
}
long long ToNs(const timespec& time) { return time.tv_sec * kSecondNs + time.tv_nsec; }
timespec ToTimespec(long long ns) {
  return {static_cast<time_t>(ns / kSecondNs), static_cast<long>(ns % kSecondNs)};
}

/// The time of a clock when virtual time begins; -1 for one that is left alone.
long long BeginOf(clockid_t clock) {
  switch (clock) {
    case CLOCK_REALTIME:
    case CLOCK_REALTIME_COARSE:
    case CLOCK_TAI:
      return kCalendarBeginNs;
    case CLOCK_MONOTONIC:
    case CLOCK_MONOTONIC_RAW:
    case CLOCK_MONOTONIC_COARSE:
    case CLOCK_BOOTTIME:
      return kMonotonicBeginNs;
    default:
      return -1;
  }
}

timespec Calendar(const Hooks& hooks) { return ToTimespec(kCalendarBeginNs + hooks.time_ns()); }

int Fail(int error) {
  errno = error;
  return -1;
}

bool IsEmpty(int count, const fd_set* set) {
  if (set == nullptr) return true;
  for (int descriptor = 0; descriptor < count; ++descriptor) {
    if (FD_ISSET(descriptor, set)) return false;
  }
  return true;
}

bool AreEmpty(int count, const fd_set* read, const fd_set* write, const fd_set* except) {
  return IsEmpty(count, read) && IsEmpty(count, write) && IsEmpty(count, except);
}

}  // namespace

// --- Sleeps --------------------------------------------------------------------------------------

ONCARD_EXPORT int nanosleep(const timespec* duration, timespec* rest) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr) return ORIGINAL(nanosleep)(duration, rest);
  if (!IsValid(*duration)) return Fail(EINVAL);
  hooks->sleep_ns(ToNs(*duration));
  return 0;
}

ONCARD_EXPORT int clock_nanosleep(clockid_t clock, int flags, const timespec* time,
                                  timespec* rest) {
  const Hooks* hooks = VirtualHooks();
  const long long begin_ns = BeginOf(clock);
  if (hooks == nullptr || begin_ns < 0) {
    return ORIGINAL(clock_nanosleep)(clock, flags, time, rest);
  }
  if (!IsValid(*time)) return EINVAL;
  if ((flags & TIMER_ABSTIME) == 0) {
    hooks->sleep_ns(ToNs(*time));
  } else {
    hooks->sleep_ns(ToNs(*time) - begin_ns - hooks->time_ns());
  }
  return 0;
}

ONCARD_EXPORT unsigned sleep(unsigned seconds) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr) return ORIGINAL(sleep)(seconds);
  hooks->sleep_ns(seconds * kSecondNs);
  return 0;
}

ONCARD_EXPORT int usleep(useconds_t microseconds) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr) return ORIGINAL(usleep)(microseconds);
  hooks->sleep_ns(microseconds * 1000LL);
  return 0;
}

// --- Time-outs without descriptors
// ----------------------------------------------------------------

ONCARD_EXPORT int select(int count, fd_set* read, fd_set* write, fd_set* except, timeval* timeout) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || timeout == nullptr || !AreEmpty(count, read, write, except)) {
    return ORIGINAL(select)(count, read, write, except, timeout);
  }
  if (timeout->tv_sec < 0 || timeout->tv_usec < 0) return Fail(EINVAL);
  hooks->sleep_ns(timeout->tv_sec * kSecondNs + timeout->tv_usec * 1000LL);
  *timeout = {0, 0};
  return 0;
}

ONCARD_EXPORT int pselect(int count, fd_set* read, fd_set* write, fd_set* except,
                          const timespec* timeout, const sigset_t* mask) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || timeout == nullptr || !AreEmpty(count, read, write, except)) {
    return ORIGINAL(pselect)(count, read, write, except, timeout, mask);
  }
  if (!IsValid(*timeout)) return Fail(EINVAL);
  hooks->sleep_ns(ToNs(*timeout));
  return 0;
}

ONCARD_EXPORT int poll(pollfd* descriptors, nfds_t count, int timeout_ms) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || count != 0 || timeout_ms < 0) {
    return ORIGINAL(poll)(descriptors, count, timeout_ms);
  }
  hooks->sleep_ns(timeout_ms * 1'000'000LL);
  return 0;
}

ONCARD_EXPORT int ppoll(pollfd* descriptors, nfds_t count, const timespec* timeout,
                        const sigset_t* mask) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || count != 0 || timeout == nullptr) {
    return ORIGINAL(ppoll)(descriptors, count, timeout, mask);
  }
  if (!IsValid(*timeout)) return Fail(EINVAL);
  hooks->sleep_ns(ToNs(*timeout));
  return 0;
}

// --- Clocks --------------------------------------------------------------------------------------

ONCARD_EXPORT int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const Hooks* hooks = VirtualHooks();
  const long long begin_ns = BeginOf(clock);
  if (hooks == nullptr || begin_ns < 0) return ORIGINAL(clock_gettime)(clock, time);
  *time = ToTimespec(begin_ns + hooks->time_ns());
  return 0;
}

ONCARD_EXPORT int gettimeofday(timeval* __restrict time, void* __restrict zone) noexcept {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr) return ORIGINAL(gettimeofday)(time, zone);
  const timespec now = Calendar(*hooks);
  *time = {now.tv_sec, now.tv_nsec / 1000};
  return 0;
}

ONCARD_EXPORT time_t time(time_t* result) noexcept {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr) return ORIGINAL(time)(result);
  const timespec now = Calendar(*hooks);
  if (result != nullptr) *result = now.tv_sec;
  return now.tv_sec;
}

ONCARD_EXPORT int timespec_get(timespec* time, int base) noexcept {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || base != TIME_UTC) return ORIGINAL(timespec_get)(time, base);
  *time = Calendar(*hooks);
  return base;
}
