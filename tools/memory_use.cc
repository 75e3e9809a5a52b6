#include "tools/memory_use.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

namespace oncard::tools {
namespace {

/// The number in a file that has only that; nothing for `max`, or where there is no such file.
std::optional<int64_t> NumberIn(const char* path) {
  int64_t number = 0;
  return std::ifstream(path) >> number ? std::optional(number) : std::nullopt;
}

}  // namespace

int64_t MemoryInUse() {
  int64_t size = 0;
  int64_t resident = 0;
  if (!(std::ifstream("/proc/self/statm") >> size >> resident)) return 0;
  return resident * ::sysconf(_SC_PAGESIZE);
}

int64_t MemoryLeft() {
  int64_t left = 0;
  std::ifstream info("/proc/meminfo");
  for (std::string name, unit; info >> name >> left >> unit;) {
    if (name == "MemAvailable:") break;
    left = 0;
  }
  left *= 1024;
  const auto limit = NumberIn("/sys/fs/cgroup/memory.max");
  const auto used = NumberIn("/sys/fs/cgroup/memory.current");
  if (limit && used) left = std::min(left, std::max(*limit - *used, int64_t{0}));
  return left;
}

}  // namespace oncard::tools
