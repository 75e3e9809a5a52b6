// Sleeps of the host, its waits for handles and messages, and what ends them, in virtual time. With
// the wall clock who sleeps or waits looks at the cards, which may interrupt the host.
#include <algorithm>

#include "runtime/host/call_scope.h"
#include "runtime/host/host_clock.h"
#include "runtime/host/host_hooks.h"
#include "runtime/host/host_imports_windows.h"
#include "runtime/host/host_interrupts.h"
#include "runtime/host/host_scenario.h"
#include "runtime/host/host_threads_windows.h"
#include "runtime/host/host_time.h"

namespace oncard::runtime {
namespace {

constexpr int64_t kNsPerMs = 1'000'000;
/// How long a thread waits in real time, while all others wait too, for what comes from outside.
constexpr DWORD kOutsideMs = 10;

int64_t DeadlineOf(DWORD milliseconds) {
  return milliseconds == INFINITE ? VirtualTime::kNeverNs
                                  : VirtualTime::OfProcess().After(milliseconds * kNsPerMs);
}

/// The wait of a host whose cards may interrupt it is in steps.
template <typename RealWait>
DWORD WaitInRealTime(DWORD milliseconds, const RealWait& wait) {
  constexpr DWORD kStepMs = kRealStepNs / kNsPerMs;
  HostInterrupts& interrupts = HostInterrupts::OfProcess();
  const int64_t begin_ns = HostClock::SteadyNanoseconds();
  for (;;) {
    interrupts.Come();
    DWORD left_ms = milliseconds;
    if (milliseconds != INFINITE) {
      const int64_t passed_ms = (HostClock::SteadyNanoseconds() - begin_ns) / kNsPerMs;
      left_ms = static_cast<DWORD>(std::max<int64_t>(milliseconds - passed_ms, 0));
    }
    if (!interrupts.Awaited()) return wait(left_ms);
    const DWORD end = wait(std::min(left_ms, kStepMs));
    if (end != WAIT_TIMEOUT || left_ms == 0) return end;
  }
}

/// A wait without a duration counts as reading the clock.
template <typename RealWait>
DWORD WaitInVirtualTime(DWORD milliseconds, const RealWait& wait) {
  EnrolThread();
  HostInterrupts& interrupts = HostInterrupts::OfProcess();
  if (milliseconds == 0) {
    const CallScope scope;
    LookAtHostTimeNs();
  }
  const int64_t deadline_ns = DeadlineOf(milliseconds);
  for (;;) {
    interrupts.Come();
    VirtualTime::Woken woken{};
    {
      const CallScope scope;
      const WaitWord::Waiter waiter(&handle_word);
      const int seen = handle_word.changes();
      if (const DWORD end = wait(0); end != WAIT_TIMEOUT) return end;
      if (VirtualTime::OfProcess().NowNs() >= deadline_ns) return WAIT_TIMEOUT;
      woken = handle_word.SleepUntilChange(seen, deadline_ns);
      LookForEndOfHost();
    }
    if (woken != VirtualTime::Woken::kNever) continue;
    if (interrupts.Awaited()) {
      ReportHopelessWait();
      return WAIT_FAILED;
    }
    const WaitsForOutside outside;
    if (const DWORD end = wait(kOutsideMs); end != WAIT_TIMEOUT) return end;
  }
}

/// `wait(milliseconds)` waits in real time, and says what has ended the wait.
template <typename RealWait>
DWORD WaitAsHost(DWORD milliseconds, const RealWait& wait) {
  if (call_state.depth != 0) return wait(milliseconds);
  return HostTimeIsVirtual() ? WaitInVirtualTime(milliseconds, wait)
                             : WaitInRealTime(milliseconds, wait);
}

/// Runs procedures that are queued for the thread. They end a wait that allows them.
bool RunsProcedures(BOOL alertable) {
  return alertable != 0 && ::SleepEx(0, TRUE) == WAIT_IO_COMPLETION;
}

// --- Sleeps --------------------------------------------------------------------------------------

/// Nothing but a procedure that is queued for the thread ends an endless sleep.
DWORD SleepInVirtualTime(DWORD milliseconds, BOOL alertable) {
  EnrolThread();
  if (milliseconds == INFINITE) {
    const WaitsForOutside outside;
    return ::SleepEx(INFINITE, alertable);
  }
  oncard_host_sleep_ns(milliseconds * kNsPerMs);
  return 0;
}

/// Procedures run before a sleep with an end in virtual time.
DWORD WINAPI HostSleepEx(DWORD milliseconds, BOOL alertable) {
  if (RunsProcedures(alertable)) return WAIT_IO_COMPLETION;
  if (HostTimeIsVirtual()) return SleepInVirtualTime(milliseconds, alertable);
  const auto sleep = [&](DWORD real_ms) -> DWORD {
    return ::SleepEx(real_ms, alertable) == 0 ? WAIT_TIMEOUT : WAIT_IO_COMPLETION;
  };
  return WaitAsHost(milliseconds, sleep) == WAIT_TIMEOUT ? 0 : WAIT_IO_COMPLETION;
}

void WINAPI HostSleep(DWORD milliseconds) { HostSleepEx(milliseconds, FALSE); }

// --- Handles -------------------------------------------------------------------------------------

DWORD WINAPI HostWaitForSingleObject(HANDLE handle, DWORD milliseconds) {
  return WaitAsHost(milliseconds,
                    [&](DWORD real_ms) { return ::WaitForSingleObject(handle, real_ms); });
}

DWORD WINAPI HostWaitForSingleObjectEx(HANDLE handle, DWORD milliseconds, BOOL alertable) {
  if (RunsProcedures(alertable)) return WAIT_IO_COMPLETION;
  return WaitAsHost(milliseconds, [&](DWORD real_ms) {
    return ::WaitForSingleObjectEx(handle, real_ms, alertable);
  });
}

DWORD WINAPI HostWaitForMultipleObjects(DWORD count, const HANDLE* handles, BOOL all,
                                        DWORD milliseconds) {
  return WaitAsHost(milliseconds, [&](DWORD real_ms) {
    return ::WaitForMultipleObjects(count, handles, all, real_ms);
  });
}

DWORD WINAPI HostWaitForMultipleObjectsEx(DWORD count, const HANDLE* handles, BOOL all,
                                          DWORD milliseconds, BOOL alertable) {
  if (RunsProcedures(alertable)) return WAIT_IO_COMPLETION;
  return WaitAsHost(milliseconds, [&](DWORD real_ms) {
    return ::WaitForMultipleObjectsEx(count, handles, all, real_ms, alertable);
  });
}

DWORD WINAPI HostSignalObjectAndWait(HANDLE to_signal, HANDLE handle, DWORD milliseconds,
                                     BOOL alertable) {
  const DWORD end = ::SignalObjectAndWait(to_signal, handle, 0, alertable);
  handle_word.Change();
  return end == WAIT_TIMEOUT ? HostWaitForSingleObjectEx(handle, milliseconds, alertable) : end;
}

BOOL Changed(BOOL result) {
  handle_word.Change();
  return result;
}

BOOL WINAPI HostSetEvent(HANDLE event) { return Changed(::SetEvent(event)); }

BOOL WINAPI HostReleaseMutex(HANDLE mutex) { return Changed(::ReleaseMutex(mutex)); }

BOOL WINAPI HostReleaseSemaphore(HANDLE semaphore, LONG count, LONG* before) {
  return Changed(::ReleaseSemaphore(semaphore, count, before));
}

// --- From outside --------------------------------------------------------------------------------

/// A file on a disk does not keep its reader waiting.
BOOL WINAPI HostReadFile(HANDLE file, void* buffer, DWORD size, DWORD* count, OVERLAPPED* later) {
  if (call_state.depth != 0 || ::GetFileType(file) == FILE_TYPE_DISK) {
    return ::ReadFile(file, buffer, size, count, later);
  }
  EnrolThread();
  const WaitsForOutside outside;
  return ::ReadFile(file, buffer, size, count, later);
}

/// A function of user32.dll, which a host need not have; who calls it has it.
template <typename Function>
Function* OfUser32(const char* name) {
  return reinterpret_cast<Function*>(
      reinterpret_cast<void*>(::GetProcAddress(::GetModuleHandleA("user32.dll"), name)));
}

BOOL WINAPI HostGetMessageA(MSG* message, HWND window, UINT first, UINT last) {
  static auto* const original = OfUser32<decltype(::GetMessageA)>("GetMessageA");
  EnrolThread();
  const WaitsForOutside outside;
  return original(message, window, first, last);
}

BOOL WINAPI HostGetMessageW(MSG* message, HWND window, UINT first, UINT last) {
  static auto* const original = OfUser32<decltype(::GetMessageW)>("GetMessageW");
  EnrolThread();
  const WaitsForOutside outside;
  return original(message, window, first, last);
}

DWORD WINAPI HostMsgWaitForMultipleObjectsEx(DWORD count, const HANDLE* handles, DWORD milliseconds,
                                             DWORD wake_mask, DWORD flags) {
  static auto* const original =
      OfUser32<decltype(::MsgWaitForMultipleObjectsEx)>("MsgWaitForMultipleObjectsEx");
  return WaitAsHost(milliseconds, [&](DWORD real_ms) {
    return original(count, handles, real_ms, wake_mask, flags);
  });
}

DWORD WINAPI HostMsgWaitForMultipleObjects(DWORD count, const HANDLE* handles, BOOL all,
                                           DWORD milliseconds, DWORD wake_mask) {
  return HostMsgWaitForMultipleObjectsEx(count, handles, milliseconds, wake_mask,
                                         all != 0 ? MWMO_WAITALL : 0);
}

}  // namespace

std::span<const Replacement> WaitImports() {
  static const Replacement kReplacements[] = {
      {"Sleep", HostSleep},
      {"SleepEx", HostSleepEx},
      {"WaitForSingleObject", HostWaitForSingleObject},
      {"WaitForSingleObjectEx", HostWaitForSingleObjectEx},
      {"WaitForMultipleObjects", HostWaitForMultipleObjects},
      {"WaitForMultipleObjectsEx", HostWaitForMultipleObjectsEx},
      {"SignalObjectAndWait", HostSignalObjectAndWait},
      {"SetEvent", HostSetEvent},
      {"ReleaseMutex", HostReleaseMutex},
      {"ReleaseSemaphore", HostReleaseSemaphore},
      {"ReadFile", HostReadFile},
      {"GetMessageA", HostGetMessageA},
      {"GetMessageW", HostGetMessageW},
      {"MsgWaitForMultipleObjects", HostMsgWaitForMultipleObjects},
      {"MsgWaitForMultipleObjectsEx", HostMsgWaitForMultipleObjectsEx},
  };
  return kReplacements;
}

}  // namespace oncard::runtime
