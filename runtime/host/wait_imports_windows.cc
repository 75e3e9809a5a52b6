// Waits of the host for handles and messages, and what ends them, in virtual time.
#include "runtime/host/call_scope.h"
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

/// `wait(milliseconds)` waits in real time, and says what has ended the wait. A wait without a
/// duration counts as reading the clock.
template <typename RealWait>
DWORD WaitInVirtualTime(DWORD milliseconds, const RealWait& wait) {
  if (call_state.depth != 0) return wait(milliseconds);
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

/// Runs procedures that are queued for the thread. They end a wait that allows them.
bool RunsProcedures(BOOL alertable) {
  return alertable != 0 && ::SleepEx(0, TRUE) == WAIT_IO_COMPLETION;
}

// --- Handles -------------------------------------------------------------------------------------

DWORD WINAPI HostWaitForSingleObject(HANDLE handle, DWORD milliseconds) {
  return WaitInVirtualTime(milliseconds,
                           [&](DWORD real_ms) { return ::WaitForSingleObject(handle, real_ms); });
}

DWORD WINAPI HostWaitForSingleObjectEx(HANDLE handle, DWORD milliseconds, BOOL alertable) {
  if (RunsProcedures(alertable)) return WAIT_IO_COMPLETION;
  return WaitInVirtualTime(milliseconds, [&](DWORD real_ms) {
    return ::WaitForSingleObjectEx(handle, real_ms, alertable);
  });
}

DWORD WINAPI HostWaitForMultipleObjects(DWORD count, const HANDLE* handles, BOOL all,
                                        DWORD milliseconds) {
  return WaitInVirtualTime(milliseconds, [&](DWORD real_ms) {
    return ::WaitForMultipleObjects(count, handles, all, real_ms);
  });
}

DWORD WINAPI HostWaitForMultipleObjectsEx(DWORD count, const HANDLE* handles, BOOL all,
                                          DWORD milliseconds, BOOL alertable) {
  if (RunsProcedures(alertable)) return WAIT_IO_COMPLETION;
  return WaitInVirtualTime(milliseconds, [&](DWORD real_ms) {
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
  return WaitInVirtualTime(milliseconds, [&](DWORD real_ms) {
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
