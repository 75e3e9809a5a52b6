// Clocks of the host in virtual time.
#include "runtime/host/host_hooks.h"
#include "runtime/host/host_imports_windows.h"
#include "runtime/host/host_threads_windows.h"

namespace oncard::runtime {
namespace {

constexpr int64_t kNsPerMs = 1'000'000;
/// Clocks of files count these steps.
constexpr int64_t kNsPerFileTick = 100;
/// 2026-01-01 00:00:00 UTC, in steps since 1601.
constexpr int64_t kCalendarBegin = 134'116'992'000'000'000;
/// The steps of the performance counter in a second: those of Windows 10.
constexpr int64_t kCounterFrequency = 10'000'000;

int64_t Look() {
  EnrolThread();
  return oncard_host_time_ns();
}

FILETIME Calendar(int64_t now_ns) {
  const auto ticks = static_cast<uint64_t>(kCalendarBegin + now_ns / kNsPerFileTick);
  return {static_cast<DWORD>(ticks), static_cast<DWORD>(ticks >> 32)};
}

// --- Replacements --------------------------------------------------------------------------------

ULONGLONG WINAPI HostGetTickCount64() { return static_cast<ULONGLONG>(Look() / kNsPerMs); }

DWORD WINAPI HostGetTickCount() { return static_cast<DWORD>(Look() / kNsPerMs); }

DWORD WINAPI HostTimeGetTime() { return static_cast<DWORD>(Look() / kNsPerMs); }

BOOL WINAPI HostQueryPerformanceFrequency(LARGE_INTEGER* frequency) {
  frequency->QuadPart = kCounterFrequency;
  return TRUE;
}

BOOL WINAPI HostQueryPerformanceCounter(LARGE_INTEGER* counter) {
  counter->QuadPart = Look() / (1'000'000'000 / kCounterFrequency);
  return TRUE;
}

void WINAPI HostGetSystemTimeAsFileTime(FILETIME* time) { *time = Calendar(Look()); }

void WINAPI HostGetSystemTimePreciseAsFileTime(FILETIME* time) { *time = Calendar(Look()); }

void WINAPI HostGetSystemTime(SYSTEMTIME* time) {
  const FILETIME now = Calendar(Look());
  ::FileTimeToSystemTime(&now, time);
}

void WINAPI HostGetLocalTime(SYSTEMTIME* time) {
  const FILETIME now = Calendar(Look());
  SYSTEMTIME utc;
  ::FileTimeToSystemTime(&now, &utc);
  ::SystemTimeToTzSpecificLocalTime(nullptr, &utc, time);
}

}  // namespace

std::span<const Replacement> ClockImports() {
  static const Replacement kReplacements[] = {
      {"GetTickCount", HostGetTickCount},
      {"GetTickCount64", HostGetTickCount64},
      {"timeGetTime", HostTimeGetTime},
      {"QueryPerformanceFrequency", HostQueryPerformanceFrequency},
      {"QueryPerformanceCounter", HostQueryPerformanceCounter},
      {"GetSystemTimeAsFileTime", HostGetSystemTimeAsFileTime},
      {"GetSystemTimePreciseAsFileTime", HostGetSystemTimePreciseAsFileTime},
      {"GetSystemTime", HostGetSystemTime},
      {"GetLocalTime", HostGetLocalTime},
  };
  return kReplacements;
}

}  // namespace oncard::runtime
