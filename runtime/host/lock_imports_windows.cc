// Locks and conditions of the host in virtual time: a thread that waits for a lock lets time go on,
// so that the one that has it may sleep.
#include <array>
#include <cstdint>

#include "runtime/host/call_scope.h"
#include "runtime/host/host_imports_windows.h"
#include "runtime/host/host_threads_windows.h"
#include "runtime/host/host_time.h"
#include "runtime/host/system_waits.h"

namespace oncard::runtime {
namespace {

constexpr int64_t kNsPerMs = 1'000'000;
/// How long a thread sleeps in real time where nobody is left who could wake it.
constexpr int64_t kNobodyNs = 10 * kNsPerMs;

/// All threads wait: perhaps Windows has the lock.
void WaitForWindows() {
  const WaitsForOutside outside;
  RealSleep(kNobodyNs);
}

/// `try_lock()` takes the lock or returns false at once; `lock()` waits in real time.
template <typename TryLock, typename Lock>
void LockInVirtualTime(const TryLock& try_lock, const Lock& lock) {
  if (try_lock()) return;
  if (call_state.depth != 0) return lock();
  EnrolThread();
  for (;;) {
    VirtualTime::Woken woken{};
    {
      const CallScope scope;
      const WaitWord::Waiter waiter(&lock_word);
      const int seen = lock_word.changes();
      if (try_lock()) return;
      woken = lock_word.SleepUntilChange(seen, VirtualTime::kNeverNs);
    }
    if (woken == VirtualTime::Woken::kNever) WaitForWindows();
  }
}

void Unlocked() {
  if (lock_word.has_waiters() && call_state.depth == 0) lock_word.Change();
}

// --- Locks ---------------------------------------------------------------------------------------

void WINAPI HostEnterCriticalSection(CRITICAL_SECTION* section) {
  LockInVirtualTime([&] { return ::TryEnterCriticalSection(section) != 0; },
                    [&] { ::EnterCriticalSection(section); });
}

void WINAPI HostLeaveCriticalSection(CRITICAL_SECTION* section) {
  ::LeaveCriticalSection(section);
  Unlocked();
}

void WINAPI HostAcquireSRWLockExclusive(SRWLOCK* lock) {
  LockInVirtualTime([&] { return ::TryAcquireSRWLockExclusive(lock) != 0; },
                    [&] { ::AcquireSRWLockExclusive(lock); });
}

void WINAPI HostReleaseSRWLockExclusive(SRWLOCK* lock) {
  ::ReleaseSRWLockExclusive(lock);
  Unlocked();
}

void WINAPI HostAcquireSRWLockShared(SRWLOCK* lock) {
  LockInVirtualTime([&] { return ::TryAcquireSRWLockShared(lock) != 0; },
                    [&] { ::AcquireSRWLockShared(lock); });
}

void WINAPI HostReleaseSRWLockShared(SRWLOCK* lock) {
  ::ReleaseSRWLockShared(lock);
  Unlocked();
}

// --- Conditions ----------------------------------------------------------------------------------

/// Those who wait for a condition; some conditions share a word, whose threads wake without reason,
/// which Windows allows.
constinit std::array<WaitWord, 64> condition_words;

WaitWord& WordOf(const CONDITION_VARIABLE* condition) {
  return condition_words[reinterpret_cast<uintptr_t>(condition) / sizeof *condition %
                         condition_words.size()];
}

/// A wait with a time-out takes as long as reading the clock.
template <typename Unlock, typename Lock>
BOOL SleepOnCondition(const CONDITION_VARIABLE* condition, DWORD milliseconds, const Unlock& unlock,
                      const Lock& lock) {
  EnrolThread();
  VirtualTime& time = VirtualTime::OfProcess();
  VirtualTime::Woken woken{};
  {
    const WaitWord::Waiter waiter(&WordOf(condition));
    const int seen = WordOf(condition).changes();
    unlock();
    {
      const CallScope scope;
      if (milliseconds != INFINITE) LookAtHostTimeNs();
      const int64_t deadline_ns =
          milliseconds == INFINITE ? VirtualTime::kNeverNs : time.After(milliseconds * kNsPerMs);
      woken = WordOf(condition).SleepUntilChange(seen, deadline_ns);
    }
  }
  if (woken == VirtualTime::Woken::kNever) WaitForWindows();
  lock();
  if (woken != VirtualTime::Woken::kAtDeadline) return TRUE;
  ::SetLastError(ERROR_TIMEOUT);
  return FALSE;
}

BOOL WINAPI HostSleepConditionVariableCS(CONDITION_VARIABLE* condition, CRITICAL_SECTION* section,
                                         DWORD milliseconds) {
  return SleepOnCondition(
      condition, milliseconds, [&] { HostLeaveCriticalSection(section); },
      [&] { HostEnterCriticalSection(section); });
}

BOOL WINAPI HostSleepConditionVariableSRW(CONDITION_VARIABLE* condition, SRWLOCK* lock,
                                          DWORD milliseconds, ULONG flags) {
  if ((flags & CONDITION_VARIABLE_LOCKMODE_SHARED) != 0) {
    return SleepOnCondition(
        condition, milliseconds, [&] { HostReleaseSRWLockShared(lock); },
        [&] { HostAcquireSRWLockShared(lock); });
  }
  return SleepOnCondition(
      condition, milliseconds, [&] { HostReleaseSRWLockExclusive(lock); },
      [&] { HostAcquireSRWLockExclusive(lock); });
}

/// Wakes all: one that was not meant looks at its condition and waits again.
void WINAPI HostWakeConditionVariable(CONDITION_VARIABLE* condition) {
  ::WakeAllConditionVariable(condition);
  WordOf(condition).Change();
}

}  // namespace

std::span<const Replacement> LockImports() {
  static const Replacement kReplacements[] = {
      {"EnterCriticalSection", HostEnterCriticalSection},
      {"LeaveCriticalSection", HostLeaveCriticalSection},
      {"AcquireSRWLockExclusive", HostAcquireSRWLockExclusive},
      {"ReleaseSRWLockExclusive", HostReleaseSRWLockExclusive},
      {"AcquireSRWLockShared", HostAcquireSRWLockShared},
      {"ReleaseSRWLockShared", HostReleaseSRWLockShared},
      {"SleepConditionVariableCS", HostSleepConditionVariableCS},
      {"SleepConditionVariableSRW", HostSleepConditionVariableSRW},
      {"WakeConditionVariable", HostWakeConditionVariable},
      {"WakeAllConditionVariable", HostWakeConditionVariable},
  };
  return kReplacements;
}

}  // namespace oncard::runtime
