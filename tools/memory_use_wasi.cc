// In WebAssembly, where a command has memory of its own.
#include "tools/memory_use.h"

#include <string>

namespace oncard::tools {
namespace {

constexpr int64_t kMemoryMax = int64_t{1} << 32;
constexpr int64_t kMemoryPage = 65536;

}  // namespace

int64_t MemoryInUse() { return static_cast<int64_t>(__builtin_wasm_memory_size(0)) * kMemoryPage; }

std::optional<int64_t> MemoryLeft(const std::string& /*root*/) {
  return kMemoryMax - MemoryInUse();
}

}  // namespace oncard::tools
