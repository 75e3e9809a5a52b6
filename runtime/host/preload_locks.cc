// Part of liboncard_host.so (preload.cc): makes waits for locks, conditions, semaphores, threads
// and signals with a time-out use virtual time.
//
//   pthread_cond_timedwait pthread_cond_clockwait cnd_timedwait, with the signals that end them
//   pthread_mutex_timedlock pthread_mutex_clocklock mtx_timedlock
//   pthread_rwlock_timedrdlock pthread_rwlock_timedwrlock and ..._clock...
//   sem_timedwait sem_clockwait mq_timedreceive mq_timedsend
//   pthread_timedjoin_np pthread_clockjoin_np sigtimedwait
//   syscall(SYS_futex), with which the C++ library waits for futures and semaphores
//
// A lock keeps its state, so waiting for it is done in slices with the C library's own functions. A
// condition has none: a signal between two slices would be lost. So threads that wait for a
// condition are in a list, which the signals check first. Tested by
// tests/tools/exec_command_test.cc.
#include <linux/futex.h>
#include <mqueue.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdarg.h>
#include <sys/syscall.h>
#include <threads.h>
#include <unistd.h>

#include "runtime/host/preload.h"

using namespace oncard::preload;

namespace {

/// The real calendar time after a slice.
timespec RealAfter(long long slice_ns, clockid_t clock = CLOCK_REALTIME) {
  timespec now;
  ORIGINAL(clock_gettime)(clock, &now);
  return ToTimespec(ToNs(now) + slice_ns);
}

/// Takes a lock or similar before a deadline on a clock. `try_now()` and `wait_for(until)` return
/// 0, EBUSY or ETIMEDOUT if it is not available yet, or another error.
template <typename TryNow, typename WaitFor>
int TakeUntil(const Hooks& hooks, long long begin_ns, const timespec& until, const TryNow& try_now,
              const WaitFor& wait_for) {
  int error = 0;
  const bool over = WaitUntil(hooks, ToNs(until) - begin_ns, [&](long long slice_ns) {
    if (slice_ns == 0) {
      error = try_now();
    } else {
      const timespec slice_end = RealAfter(slice_ns);
      error = wait_for(&slice_end);
    }
    return error != EBUSY && error != ETIMEDOUT;
  });
  return over ? error : ETIMEDOUT;
}

/// True if the wait is handled here; the C library reports errors in its arguments.
bool IsOurs(const Hooks* hooks, clockid_t clock, const timespec* until) {
  return hooks != nullptr && BeginOf(clock) >= 0 && IsAddress(until) && until->tv_nsec >= 0 &&
         until->tv_nsec < kSecondNs;
}

// --- Conditions ----------------------------------------------------------------------------------

/// A thread that waits for a condition with a deadline. It is on the thread's stack.
struct Waiter {
  const void* condition;
  int woken = 0;  // a futex; written while `list_lock` is held
  Waiter* next = nullptr;
};

pthread_mutex_t list_lock = PTHREAD_MUTEX_INITIALIZER;
Waiter* first_waiter = nullptr;  // in the order of arrival; protected by `list_lock`
int waiter_count = 0;            // also read without the lock

long Futex(int* word, int operation, int value, const timespec* timeout) {
  return ORIGINAL(syscall)(SYS_futex, word, operation, value, timeout, nullptr, 0);
}

void Enlist(Waiter* waiter) {
  pthread_mutex_lock(&list_lock);
  Waiter** end = &first_waiter;
  while (*end != nullptr) end = &(*end)->next;
  *end = waiter;
  __atomic_add_fetch(&waiter_count, 1, __ATOMIC_SEQ_CST);
  pthread_mutex_unlock(&list_lock);
}

/// Removes it from the list; true if it was woken.
bool Delist(Waiter* waiter) {
  pthread_mutex_lock(&list_lock);
  Waiter** link = &first_waiter;
  while (*link != waiter) link = &(*link)->next;
  *link = waiter->next;
  __atomic_sub_fetch(&waiter_count, 1, __ATOMIC_SEQ_CST);
  pthread_mutex_unlock(&list_lock);
  return waiter->woken != 0;
}

/// Wakes one waiter for a condition, or all; returns how many.
int Wake(const void* condition, bool all) {
  if (__atomic_load_n(&waiter_count, __ATOMIC_SEQ_CST) == 0) return 0;
  int count = 0;
  pthread_mutex_lock(&list_lock);
  for (Waiter* waiter = first_waiter; waiter != nullptr && (all || count == 0);
       waiter = waiter->next) {
    if (waiter->condition != condition || waiter->woken != 0) continue;
    __atomic_store_n(&waiter->woken, 1, __ATOMIC_SEQ_CST);
    Futex(&waiter->woken, FUTEX_WAKE_PRIVATE, 1, nullptr);
    ++count;
  }
  pthread_mutex_unlock(&list_lock);
  return count;
}

/// Waits for a condition. The mutex is released during the wait. It is taken again after this
/// thread has left the list of waiters in virtual time: the owner of the mutex may itself be
/// waiting for time to pass.
template <typename Unlock, typename Lock>
int WaitForCondition(const Hooks& hooks, const void* condition, long long deadline_ns,
                     const Unlock& unlock, const Lock& lock) {
  pthread_testcancel();
  Waiter waiter = {condition};
  Enlist(&waiter);
  const int not_held = unlock();
  if (not_held != 0) {
    Delist(&waiter);
    return not_held;
  }
  WaitUntil(hooks, deadline_ns, [&](long long slice_ns) {
    const timespec slice = ToTimespec(slice_ns);
    if (slice_ns != 0) Futex(&waiter.woken, FUTEX_WAIT_PRIVATE, 0, &slice);
    return __atomic_load_n(&waiter.woken, __ATOMIC_SEQ_CST) != 0;
  });
  const bool woken = Delist(&waiter);
  const int locked = lock();
  if (locked != 0) return locked;
  return woken ? 0 : ETIMEDOUT;
}

/// Bits of a condition in the GNU C library since 2.25: shared between processes, and its clock.
constexpr unsigned kSharedBit = 1;
constexpr unsigned kMonotonicBit = 2;

bool IsShared(const pthread_cond_t* condition) {
  return (condition->__data.__wrefs & kSharedBit) != 0;
}
clockid_t ClockOf(const pthread_cond_t* condition) {
  return (condition->__data.__wrefs & kMonotonicBit) != 0 ? CLOCK_MONOTONIC : CLOCK_REALTIME;
}

/// The C library has two versions of the functions for conditions; these are the ones since 2.3.2.
template <typename Function>
Function* OriginalOfConditions(const char* name) {
  void* found = dlvsym(RTLD_NEXT, name, "GLIBC_2.3.2");
  return found != nullptr ? reinterpret_cast<Function*>(found) : Original<Function>(name);
}

int WaitForCondition(const Hooks& hooks, pthread_cond_t* condition, pthread_mutex_t* mutex,
                     clockid_t clock, const timespec* until) {
  const long long deadline_ns = ToNs(*until) - BeginOf(clock);
  if (IsShared(condition)) {  // another process, which uses real time, may signal it
    const long long left_ns = deadline_ns - hooks.time_ns();
    const timespec end = RealAfter(left_ns > 0 ? left_ns : 0, CLOCK_MONOTONIC);
    return ORIGINAL(pthread_cond_clockwait)(condition, mutex, CLOCK_MONOTONIC, &end);
  }
  return WaitForCondition(
      hooks, condition, deadline_ns, [mutex] { return pthread_mutex_unlock(mutex); },
      [mutex] { return pthread_mutex_lock(mutex); });
}

/// A child of fork() contains only the thread that forked.
void ForgetWaiters() {
  list_lock = PTHREAD_MUTEX_INITIALIZER;
  first_waiter = nullptr;
  waiter_count = 0;
}

__attribute__((constructor)) void WatchForks() { pthread_atfork(nullptr, nullptr, ForgetWaiters); }

}  // namespace

ONCARD_EXPORT int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                         const timespec* until) {
  static auto* const original =
      OriginalOfConditions<decltype(pthread_cond_timedwait)>("pthread_cond_timedwait");
  const Hooks* hooks = VirtualHooks();
  const clockid_t clock = ClockOf(condition);
  if (!IsOurs(hooks, clock, until)) return original(condition, mutex, until);
  return WaitForCondition(*hooks, condition, mutex, clock, until);
}

ONCARD_EXPORT int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                         clockid_t clock, const timespec* until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, clock, until)) {
    return ORIGINAL(pthread_cond_clockwait)(condition, mutex, clock, until);
  }
  return WaitForCondition(*hooks, condition, mutex, clock, until);
}

ONCARD_EXPORT int pthread_cond_signal(pthread_cond_t* condition) noexcept {
  static auto* const original =
      OriginalOfConditions<decltype(pthread_cond_signal)>("pthread_cond_signal");
  return Wake(condition, false) > 0 ? 0 : original(condition);
}

ONCARD_EXPORT int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
  static auto* const original =
      OriginalOfConditions<decltype(pthread_cond_broadcast)>("pthread_cond_broadcast");
  Wake(condition, true);
  return original(condition);
}

ONCARD_EXPORT int cnd_timedwait(cnd_t* __restrict condition, mtx_t* __restrict mutex,
                                const timespec* __restrict until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, CLOCK_REALTIME, until)) {
    return ORIGINAL(cnd_timedwait)(condition, mutex, until);
  }
  const int error = WaitForCondition(
      *hooks, condition, ToNs(*until) - BeginOf(CLOCK_REALTIME),
      [mutex] { return mtx_unlock(mutex) == thrd_success ? 0 : EPERM; },
      [mutex] { return mtx_lock(mutex) == thrd_success ? 0 : EPERM; });
  if (error == 0) return thrd_success;
  return error == ETIMEDOUT ? thrd_timedout : thrd_error;
}

ONCARD_EXPORT int cnd_signal(cnd_t* condition) {
  return Wake(condition, false) > 0 ? thrd_success : ORIGINAL(cnd_signal)(condition);
}

ONCARD_EXPORT int cnd_broadcast(cnd_t* condition) {
  Wake(condition, true);
  return ORIGINAL(cnd_broadcast)(condition);
}

// --- Locks ---------------------------------------------------------------------------------------

ONCARD_EXPORT int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock,
                                          const timespec* until) noexcept {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, clock, until)) return ORIGINAL(pthread_mutex_clocklock)(mutex, clock, until);
  return TakeUntil(
      *hooks, BeginOf(clock), *until, [mutex] { return pthread_mutex_trylock(mutex); },
      [mutex](const timespec* end) { return ORIGINAL(pthread_mutex_timedlock)(mutex, end); });
}

ONCARD_EXPORT int pthread_mutex_timedlock(pthread_mutex_t* mutex, const timespec* until) noexcept {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, CLOCK_REALTIME, until)) return ORIGINAL(pthread_mutex_timedlock)(mutex, until);
  return pthread_mutex_clocklock(mutex, CLOCK_REALTIME, until);
}

ONCARD_EXPORT int mtx_timedlock(mtx_t* __restrict mutex, const timespec* __restrict until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, CLOCK_REALTIME, until)) return ORIGINAL(mtx_timedlock)(mutex, until);
  const auto error_of = [](int result) {
    if (result == thrd_success) return 0;
    return result == thrd_busy || result == thrd_timedout ? EBUSY : EINVAL;
  };
  const int error = TakeUntil(
      *hooks, BeginOf(CLOCK_REALTIME), *until, [&] { return error_of(mtx_trylock(mutex)); },
      [&](const timespec* end) { return error_of(ORIGINAL(mtx_timedlock)(mutex, end)); });
  if (error == 0) return thrd_success;
  return error == ETIMEDOUT ? thrd_timedout : thrd_error;
}

#define ONCARD_RWLOCK(clock_name, timed_name, try_name)                                  \
  ONCARD_EXPORT int clock_name(pthread_rwlock_t* lock, clockid_t clock,                  \
                               const timespec* until) noexcept {                         \
    const Hooks* hooks = VirtualHooks();                                                 \
    if (!IsOurs(hooks, clock, until)) return ORIGINAL(clock_name)(lock, clock, until);   \
    return TakeUntil(                                                                    \
        *hooks, BeginOf(clock), *until, [lock] { return try_name(lock); },               \
        [lock](const timespec* end) { return ORIGINAL(timed_name)(lock, end); });        \
  }                                                                                      \
  ONCARD_EXPORT int timed_name(pthread_rwlock_t* lock, const timespec* until) noexcept { \
    const Hooks* hooks = VirtualHooks();                                                 \
    if (!IsOurs(hooks, CLOCK_REALTIME, until)) return ORIGINAL(timed_name)(lock, until); \
    return clock_name(lock, CLOCK_REALTIME, until);                                      \
  }
ONCARD_RWLOCK(pthread_rwlock_clockrdlock, pthread_rwlock_timedrdlock, pthread_rwlock_tryrdlock)
ONCARD_RWLOCK(pthread_rwlock_clockwrlock, pthread_rwlock_timedwrlock, pthread_rwlock_trywrlock)

// --- Semaphores, queues, threads, signals --------------------------------------------------------

ONCARD_EXPORT int sem_clockwait(sem_t* semaphore, clockid_t clock, const timespec* until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, clock, until)) return ORIGINAL(sem_clockwait)(semaphore, clock, until);
  pthread_testcancel();
  const int error = TakeUntil(
      *hooks, BeginOf(clock), *until,
      [semaphore] {
        if (sem_trywait(semaphore) == 0) return 0;
        return errno == EAGAIN ? EBUSY : errno;
      },
      [semaphore](const timespec* end) {
        return ORIGINAL(sem_timedwait)(semaphore, end) == 0 ? 0 : errno;
      });
  return error == 0 ? 0 : Fail(error);
}

ONCARD_EXPORT int sem_timedwait(sem_t* semaphore, const timespec* until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, CLOCK_REALTIME, until)) return ORIGINAL(sem_timedwait)(semaphore, until);
  return sem_clockwait(semaphore, CLOCK_REALTIME, until);
}

/// Sends or receives a message before a deadline in calendar time. `exchange(end)` returns -1 with
/// ETIMEDOUT if that was not possible.
template <typename Exchange>
ssize_t ExchangeUntil(const Hooks& hooks, const timespec& until, const Exchange& exchange) {
  pthread_testcancel();
  constexpr timespec kLongAgo = {0, 0};
  ssize_t result = -1;
  const auto error_of = [&](const timespec* end) {
    result = exchange(end);
    return result >= 0 ? 0 : errno;
  };
  const int error = TakeUntil(
      hooks, BeginOf(CLOCK_REALTIME), until, [&] { return error_of(&kLongAgo); }, error_of);
  return error == 0 ? result : Fail(error);
}

ONCARD_EXPORT ssize_t mq_timedreceive(mqd_t queue, char* __restrict buffer, size_t size,
                                      unsigned* __restrict priority,
                                      const timespec* __restrict until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, CLOCK_REALTIME, until)) {
    return ORIGINAL(mq_timedreceive)(queue, buffer, size, priority, until);
  }
  return ExchangeUntil(*hooks, *until, [&](const timespec* end) {
    return ORIGINAL(mq_timedreceive)(queue, buffer, size, priority, end);
  });
}

ONCARD_EXPORT int mq_timedsend(mqd_t queue, const char* text, size_t size, unsigned priority,
                               const timespec* until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, CLOCK_REALTIME, until)) {
    return ORIGINAL(mq_timedsend)(queue, text, size, priority, until);
  }
  return static_cast<int>(ExchangeUntil(*hooks, *until, [&](const timespec* end) {
    return ORIGINAL(mq_timedsend)(queue, text, size, priority, end);
  }));
}

ONCARD_EXPORT int pthread_clockjoin_np(pthread_t thread, void** result, clockid_t clock,
                                       const timespec* until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, clock, until)) {
    return ORIGINAL(pthread_clockjoin_np)(thread, result, clock, until);
  }
  pthread_testcancel();
  return TakeUntil(
      *hooks, BeginOf(clock), *until, [&] { return pthread_tryjoin_np(thread, result); },
      [&](const timespec* end) { return ORIGINAL(pthread_timedjoin_np)(thread, result, end); });
}

ONCARD_EXPORT int pthread_timedjoin_np(pthread_t thread, void** result, const timespec* until) {
  const Hooks* hooks = VirtualHooks();
  if (!IsOurs(hooks, CLOCK_REALTIME, until)) {
    return ORIGINAL(pthread_timedjoin_np)(thread, result, until);
  }
  return pthread_clockjoin_np(thread, result, CLOCK_REALTIME, until);
}

ONCARD_EXPORT int sigtimedwait(const sigset_t* __restrict signals, siginfo_t* __restrict info,
                               const timespec* __restrict timeout) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || !IsAddress(timeout) || !IsValid(*timeout)) {
    return ORIGINAL(sigtimedwait)(signals, info, timeout);
  }
  pthread_testcancel();
  int signal = -1;
  const long long now_ns = hooks->time_ns();
  const long long timeout_ns = ToNs(*timeout);
  WaitUntil(*hooks, timeout_ns > kForeverNs - now_ns ? kForeverNs : now_ns + timeout_ns,
            [&](long long slice_ns) {
              const timespec slice = ToTimespec(slice_ns);
              signal = ORIGINAL(sigtimedwait)(signals, info, &slice);
              return signal >= 0 || errno != EAGAIN;
            });
  return signal;
}

// --- Futexes -------------------------------------------------------------------------------------

ONCARD_EXPORT long syscall(long number, ...) noexcept {
  va_list list;
  va_start(list, number);
  va_list pointers;
  va_copy(pointers, list);
  const int* word = va_arg(pointers, const int*);
  for (int skipped = 0; skipped < 2; ++skipped) va_arg(pointers, long);
  const timespec* timeout = va_arg(pointers, const timespec*);
  va_end(pointers);
  long a[6];
  for (long& argument : a) argument = va_arg(list, long);
  va_end(list);

  const auto plain = [&] { return ORIGINAL(syscall)(number, a[0], a[1], a[2], a[3], a[4], a[5]); };
  const long operation = a[1] & FUTEX_CMD_MASK;
  if (number != SYS_futex || (operation != FUTEX_WAIT && operation != FUTEX_WAIT_BITSET) ||
      !IsAddress(timeout) || !IsAddress(word)) {
    return plain();
  }
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || !IsValid(*timeout)) return plain();

  // FUTEX_WAIT takes a duration, FUTEX_WAIT_BITSET a point in time.
  long long deadline_ns = ToNs(*timeout);
  if (operation == FUTEX_WAIT) {
    const long long now_ns = hooks->time_ns();
    deadline_ns = deadline_ns > kForeverNs - now_ns ? kForeverNs : now_ns + deadline_ns;
  } else {
    deadline_ns -= BeginOf((a[1] & FUTEX_CLOCK_REALTIME) != 0 ? CLOCK_REALTIME : CLOCK_MONOTONIC);
  }
  const long slice_operation = FUTEX_WAIT_BITSET | (a[1] & FUTEX_PRIVATE_FLAG);
  const long bits = operation == FUTEX_WAIT ? static_cast<long>(FUTEX_BITSET_MATCH_ANY) : a[5];
  long result = -1;
  const bool over = WaitUntil(*hooks, deadline_ns, [&](long long slice_ns) {
    if (slice_ns == 0) {
      errno = EAGAIN;
      return __atomic_load_n(word, __ATOMIC_SEQ_CST) != static_cast<int>(a[2]);
    }
    const timespec end = RealAfter(slice_ns, CLOCK_MONOTONIC);
    result = ORIGINAL(syscall)(SYS_futex, a[0], slice_operation, a[2], &end, nullptr, bits);
    return result == 0 || errno != ETIMEDOUT;
  });
  return over ? result : Fail(ETIMEDOUT);
}
