// In WebAssembly, which starts no other programs.
#include "tools/filter.h"

namespace oncard::tools {

std::optional<FilterRun> RunFilter(const std::vector<std::string>& /*words*/,
                                   const std::string& /*text*/) {
  return std::nullopt;
}

}  // namespace oncard::tools
