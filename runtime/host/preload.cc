// liboncard_host.so, which `oncard exec` loads before everything else of a host program: makes the
// C library's sleeps, clocks and time-outs use the virtual time of the host library, so that a
// program that sleeps during a ten-second move finishes at once. This file contains sleeps and
// clocks:
//
//   sleep usleep nanosleep clock_nanosleep thrd_sleep
//   clock_gettime gettimeofday time timespec_get times
//
// The calendar begins on 2026-01-01 00:00 UTC, the monotonic clocks at 1000 s.
//
// preload_locks.cc has the time-outs of locks and conditions, preload_descriptors.cc those of
// descriptors. The processor-time clocks are not changed.
// Tested by tests/tools/exec_command_test.cc.
#include <sys/syscall.h>
#include <sys/times.h>
#include <threads.h>
#include <unistd.h>

#include "runtime/host/preload.h"

namespace oncard::preload {
namespace {

/// The initial values of the clocks, the same in every run.
constexpr long long kCalendarBeginNs = 1'767'225'600 * kSecondNs;  // 2026-01-01 00:00:00 UTC
constexpr long long kMonotonicBeginNs = 1000 * kSecondNs;

/// The host libraries of the families, and those for declarations that were written for Windows, by
/// the names that they give themselves: whichever link leads to one, it is found.
constexpr const char* kHostLibraries[] = {
#define FAMILY(name, Name) \
  "lib" #name ".so." ONCARD_SOVERSION, "lib" #name "_long32.so." ONCARD_SOVERSION,
#include "gtcalls/families.def"
};

/// Finds a function of the host library, or NULL in a process without one. A library that was
/// loaded without RTLD_GLOBAL, as Python does, is found by its name.
template <typename Function>
bool FindInHostLibrary(const char* name, Function** function) {
  void* found = dlsym(RTLD_DEFAULT, name);
  for (const char* const each : kHostLibraries) {
    if (found != nullptr) break;
    void* library = dlopen(each, RTLD_LAZY | RTLD_NOLOAD);
    if (library != nullptr) found = dlsym(library, name);
  }
  *function = reinterpret_cast<Function*>(found);
  return found != nullptr;
}

timespec Calendar(const Hooks& hooks) { return ToTimespec(kCalendarBeginNs + hooks.time_ns()); }

/// What the kernel says to a clock function whose pointer is no address. The C library reads these
/// clocks without the kernel, and would crash.
template <typename A, typename B>
int AskKernel(long number, A a, B b) {
  return static_cast<int>(ORIGINAL(syscall)(number, a, b));
}

/// Sleeps; false if a signal ends the sleep: then `rest`, unless it is NULL, is what is left.
bool SleepAndTell(const Hooks& hooks, long long duration_ns, timespec* rest) {
  const long long left_ns = Sleep(hooks, duration_ns);
  if (left_ns > 0 && rest != nullptr) *rest = ToTimespec(left_ns);
  return left_ns <= 0;
}

/// The functions of a program that is linked with such a library are found here, so that its
/// handlers of signals need not look for them.
__attribute__((constructor)) void FindHooks() { VirtualHooks(); }

}  // namespace

const Hooks* VirtualHooks() {
  static Hooks hooks;
  static bool found = false;
  if (__atomic_load_n(&found, __ATOMIC_ACQUIRE)) return &hooks;
  decltype(oncard_host_virtual)* is_virtual = nullptr;
  if (!FindInHostLibrary("oncard_host_virtual", &is_virtual) || is_virtual() == 0) return nullptr;
  Hooks all;
  if (!FindInHostLibrary("oncard_host_time_ns", &all.time_ns) ||
      !FindInHostLibrary("oncard_host_sleep_ns", &all.sleep_ns) ||
      !FindInHostLibrary("oncard_host_wait_begin", &all.wait_begin) ||
      !FindInHostLibrary("oncard_host_wait_slice_ns", &all.wait_slice_ns) ||
      !FindInHostLibrary("oncard_host_wait_end", &all.wait_end)) {
    return nullptr;
  }
  hooks = all;
  __atomic_store_n(&found, true, __ATOMIC_RELEASE);
  return &hooks;
}

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

long long ToNs(const timespec& time) {
  if (time.tv_sec < 0) return 0;
  if (time.tv_sec >= kForeverNs / kSecondNs) return kForeverNs;
  return time.tv_sec * kSecondNs + time.tv_nsec;
}
long long ToNs(const timeval& time) {
  const long long seconds = time.tv_sec + time.tv_usec / 1'000'000;
  return ToNs(
      timespec{static_cast<time_t>(seconds), static_cast<long>(time.tv_usec % 1'000'000) * 1000});
}
timespec ToTimespec(long long ns) {
  return {static_cast<time_t>(ns / kSecondNs), static_cast<long>(ns % kSecondNs)};
}

}  // namespace oncard::preload

using namespace oncard::preload;

// --- Sleeps --------------------------------------------------------------------------------------

ONCARD_EXPORT int nanosleep(const timespec* duration, timespec* rest) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || !IsAddress(duration)) return ORIGINAL(nanosleep)(duration, rest);
  if (!IsValid(*duration)) return Fail(EINVAL);
  return SleepAndTell(*hooks, ToNs(*duration), rest) ? 0 : Fail(EINTR);
}

ONCARD_EXPORT int clock_nanosleep(clockid_t clock, int flags, const timespec* time,
                                  timespec* rest) {
  const Hooks* hooks = VirtualHooks();
  const long long begin_ns = BeginOf(clock);
  if (hooks == nullptr || begin_ns < 0 || !IsAddress(time)) {
    return ORIGINAL(clock_nanosleep)(clock, flags, time, rest);
  }
  if (!IsValid(*time)) return EINVAL;
  const bool relative = (flags & TIMER_ABSTIME) == 0;
  const long long duration_ns = relative ? ToNs(*time) : ToNs(*time) - begin_ns - hooks->time_ns();
  return SleepAndTell(*hooks, duration_ns, relative ? rest : nullptr) ? 0 : EINTR;
}

ONCARD_EXPORT unsigned sleep(unsigned seconds) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr) return ORIGINAL(sleep)(seconds);
  const long long left_ns = Sleep(*hooks, seconds * kSecondNs);
  return static_cast<unsigned>((left_ns + kSecondNs - 1) / kSecondNs);
}

ONCARD_EXPORT int usleep(useconds_t microseconds) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr) return ORIGINAL(usleep)(microseconds);
  return SleepAndTell(*hooks, microseconds * 1000LL, nullptr) ? 0 : Fail(EINTR);
}

ONCARD_EXPORT int thrd_sleep(const timespec* duration, timespec* rest) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || !IsAddress(duration)) return ORIGINAL(thrd_sleep)(duration, rest);
  if (!IsValid(*duration)) return -2;  // below -1, which means a signal
  return SleepAndTell(*hooks, ToNs(*duration), rest) ? 0 : -1;
}

// --- Clocks --------------------------------------------------------------------------------------

ONCARD_EXPORT int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const Hooks* hooks = VirtualHooks();
  const long long begin_ns = BeginOf(clock);
  if (hooks == nullptr || begin_ns < 0) return ORIGINAL(clock_gettime)(clock, time);
  if (!IsAddress(time)) return AskKernel(SYS_clock_gettime, clock, time);
  *time = ToTimespec(begin_ns + hooks->time_ns());
  return 0;
}

ONCARD_EXPORT int gettimeofday(timeval* __restrict time, void* __restrict zone) noexcept {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr) return ORIGINAL(gettimeofday)(time, zone);
  if (!IsAddress(time)) return AskKernel(SYS_gettimeofday, time, zone);
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
  if (hooks == nullptr || base != TIME_UTC || !IsAddress(time))
    return ORIGINAL(timespec_get)(time, base);
  *time = Calendar(*hooks);
  return base;
}

ONCARD_EXPORT clock_t times(tms* buffer) noexcept {
  const Hooks* hooks = VirtualHooks();
  const clock_t real = ORIGINAL(times)(buffer);
  if (hooks == nullptr || real == static_cast<clock_t>(-1)) return real;
  const long long tick_ns = kSecondNs / sysconf(_SC_CLK_TCK);
  return static_cast<clock_t>((BeginOf(CLOCK_MONOTONIC) + hooks->time_ns()) / tick_ns);
}
