#include "tools/memory_use.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace oncard::tools {
namespace {

constexpr int64_t kKiB = 1024;

/// The number in a file that has only that; nothing for `max`, or where there is no such file.
std::optional<int64_t> NumberIn(const std::string& path) {
  int64_t number = 0;
  return std::ifstream(path) >> number ? std::optional(number) : std::nullopt;
}

/// The number behind a name in a file of names and numbers.
std::optional<int64_t> NumberBehind(const std::string& name, const std::string& path) {
  std::ifstream file(path);
  for (std::string word; file >> word;) {
    int64_t number = 0;
    if (word == name && file >> number) return number;
  }
  return std::nullopt;
}

std::optional<int64_t> LeftInContainer(const std::string& folder) {
  const auto limit = NumberIn(folder + "/memory.max");
  const auto used = NumberIn(folder + "/memory.current");
  if (!limit || !used) return std::nullopt;
  const int64_t of_files = NumberBehind("inactive_file", folder + "/memory.stat").value_or(0);
  return std::max(*limit - *used + of_files, int64_t{0});
}

}  // namespace

int64_t MemoryInUse() {
  int64_t size = 0;
  int64_t resident = 0;
  if (!(std::ifstream("/proc/self/statm") >> size >> resident)) return 0;
  return resident * ::sysconf(_SC_PAGESIZE);
}

std::optional<int64_t> MemoryLeft(const std::string& root) {
  const auto available = NumberBehind("MemAvailable:", root + "/proc/meminfo");
  const auto contained = LeftInContainer(root + "/sys/fs/cgroup");
  if (!available) return contained;
  return std::min(*available * kKiB, contained.value_or(INT64_MAX));
}

}  // namespace oncard::tools
