#include "runtime/host/host_system.h"

#include <windows.h>

#include <atomic>

#include "runtime/host/host_end_windows.h"
#include "runtime/host/host_scenario.h"

namespace oncard::runtime {
namespace {

std::atomic<int> success = 0;

/// Each compiler's C library has streams of its own. One that is linked into the program cannot be
/// found.
void FlushHost() {
  static constexpr const char* kCLibraries[] = {
      "msvcrt.dll",  "ucrtbase.dll", "ucrtbased.dll", "msvcr71.dll",  "msvcr80.dll",
      "msvcr90.dll", "msvcr100.dll", "msvcr110.dll",  "msvcr120.dll",
  };
  for (const char* const name : kCLibraries) {
    const HMODULE library = ::GetModuleHandleA(name);
    if (library == nullptr) continue;
    const auto flush = reinterpret_cast<int (*)(void*)>(
        reinterpret_cast<void*>(::GetProcAddress(library, "fflush")));
    if (flush != nullptr) flush(nullptr);
  }
}

}  // namespace

// Windows itself says which numbers are handles.
bool CanBeHandle(const void* /*handle*/) { return true; }

const char kNameSeparator = ';';

std::string FolderOfProgram() {
  std::string name(32767, '\0');  // the longest path
  name.resize(::GetModuleFileNameA(nullptr, name.data(), static_cast<DWORD>(name.size())));
  const size_t end = name.find_last_of('\\');
  return end == std::string::npos ? std::string() : name.substr(0, end);
}

bool AppendLine(const char* path, std::string_view line) {
  const HANDLE file =
      ::CreateFileA(path, FILE_APPEND_DATA, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                    nullptr, OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file == INVALID_HANDLE_VALUE) return false;
  DWORD count = 0;
  const auto size = static_cast<DWORD>(line.size());
  const bool written = ::WriteFile(file, line.data(), size, &count, nullptr) != 0 && count == size;
  ::CloseHandle(file);
  return written;
}

void WriteToStandardError(std::span<const std::string_view> parts) {
  for (const std::string_view part : parts) {
    DWORD count = 0;
    ::WriteFile(::GetStdHandle(STD_ERROR_HANDLE), part.data(), static_cast<DWORD>(part.size()),
                &count, nullptr);
  }
}

void ExitHost(int code) {
  FlushHost();
  FinishOnce();
  ::ExitProcess(static_cast<UINT>(ExitCodeFor(code)));
}

void EndProcess(int code) {
  FlushHost();
  ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(code));
  for (;;) ::Sleep(INFINITE);
}

void ReplaceSuccess(int code) { success = code; }

int ExitCodeFor(int code) { return code == 0 ? success.load() : code; }

void FinishOnce() {
  static std::atomic<bool> finished = false;
  if (!finished.exchange(true)) FinishHost();
}

}  // namespace oncard::runtime
