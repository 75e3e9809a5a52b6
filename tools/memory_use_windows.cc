#include "tools/memory_use.h"

#include <windows.h>

// After windows.h, whose types it uses.
#define PSAPI_VERSION 2  // of the kernel's library
#include <psapi.h>

namespace oncard::tools {

int64_t MemoryInUse() {
  PROCESS_MEMORY_COUNTERS counters;
  if (::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters) == 0) return 0;
  return static_cast<int64_t>(counters.WorkingSetSize);
}

// The system has no files that describe it.
std::optional<int64_t> MemoryLeft(const std::string& /*root*/) {
  MEMORYSTATUSEX status = {};
  status.dwLength = sizeof status;
  if (::GlobalMemoryStatusEx(&status) == 0) return std::nullopt;
  return static_cast<int64_t>(status.ullAvailPhys);
}

}  // namespace oncard::tools
