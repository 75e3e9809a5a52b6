// The end of the process, its keys, its new threads and modules.
#include <cstdio>

#include "runtime/host/call_scope.h"
#include "runtime/host/host_end_windows.h"
#include "runtime/host/host_hooks.h"
#include "runtime/host/host_imports_windows.h"
#include "runtime/host/host_threads_windows.h"

namespace oncard::runtime {
namespace {

// --- End -----------------------------------------------------------------------------------------

[[noreturn]] void WINAPI HostExitProcess(UINT code) {
  {
    const CallScope scope;
    FinishOnce();
  }
  ::ExitProcess(static_cast<UINT>(ExitCodeFor(static_cast<int>(code))));
}

// --- Keys ----------------------------------------------------------------------------------------

int HostKbhit() { return oncard_host_kbhit(); }

int HostGetch() {
  EnrolThread();
  return oncard_host_getch();
}

int HostGetche() {
  const int key = HostGetch();
  if (key >= 0) {
    const char character = static_cast<char>(key);
    DWORD count = 0;
    ::WriteFile(::GetStdHandle(STD_OUTPUT_HANDLE), &character, 1, &count, nullptr);
  }
  return key;
}

// --- Threads and modules -------------------------------------------------------------------------

HANDLE WINAPI HostCreateThread(SECURITY_ATTRIBUTES* security, SIZE_T stack_size,
                               LPTHREAD_START_ROUTINE function, void* argument, DWORD flags,
                               DWORD* number) {
  DWORD own_number = 0;
  const HANDLE thread =
      ::CreateThread(security, stack_size, function, argument, flags, &own_number);
  if (number != nullptr) *number = own_number;
  if (thread != nullptr && (flags & CREATE_SUSPENDED) == 0) EnrolThread(own_number);
  return thread;
}

DWORD WINAPI HostResumeThread(HANDLE thread) {
  const DWORD number = ::GetThreadId(thread);
  if (number != 0) EnrolThread(number);
  return ::ResumeThread(thread);
}

/// The module that has been loaded, with those that it needs, uses the replacements, too.
HMODULE Patched(HMODULE module) {
  const DWORD error = ::GetLastError();
  if (module != nullptr) ImportPatches::OfProcess().PatchModules();
  ::SetLastError(error);
  return module;
}

HMODULE WINAPI HostLoadLibraryA(const char* name) { return Patched(::LoadLibraryA(name)); }

HMODULE WINAPI HostLoadLibraryW(const wchar_t* name) { return Patched(::LoadLibraryW(name)); }

HMODULE WINAPI HostLoadLibraryExA(const char* name, HANDLE file, DWORD flags) {
  return Patched(::LoadLibraryExA(name, file, flags));
}

HMODULE WINAPI HostLoadLibraryExW(const wchar_t* name, HANDLE file, DWORD flags) {
  return Patched(::LoadLibraryExW(name, file, flags));
}

FARPROC WINAPI HostGetProcAddress(HMODULE module, const char* name) {
  const FARPROC function = ::GetProcAddress(module, name);
  return function == nullptr ? nullptr : ImportPatches::OfProcess().ReplacementOf(function);
}

}  // namespace

std::span<const Replacement> ProcessImports() {
  static const Replacement kReplacements[] = {{"ExitProcess", HostExitProcess}};
  return kReplacements;
}

std::span<const Replacement> KeyImports() {
  static const Replacement kReplacements[] = {
      {"_kbhit", HostKbhit},        {"kbhit", HostKbhit},           {"_getch", HostGetch},
      {"getch", HostGetch},         {"_getche", HostGetche},        {"getche", HostGetche},
      {"_getch_nolock", HostGetch}, {"_getche_nolock", HostGetche},
  };
  return kReplacements;
}

std::span<const Replacement> LoaderImports() {
  static const Replacement kReplacements[] = {
      {"CreateThread", HostCreateThread},     {"ResumeThread", HostResumeThread},
      {"LoadLibraryA", HostLoadLibraryA},     {"LoadLibraryW", HostLoadLibraryW},
      {"LoadLibraryExA", HostLoadLibraryExA}, {"LoadLibraryExW", HostLoadLibraryExW},
      {"GetProcAddress", HostGetProcAddress},
  };
  return kReplacements;
}

}  // namespace oncard::runtime
