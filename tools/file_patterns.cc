#include "tools/file_patterns.h"

#include <glob.h>

namespace oncard::tools {

std::optional<std::vector<std::string>> FilesMatching(const std::string& pattern) {
  glob_t matches = {};
  const int code = ::glob(pattern.c_str(), 0, nullptr, &matches);
  std::vector<std::string> found;
  for (size_t i = 0; i < matches.gl_pathc; ++i) found.emplace_back(matches.gl_pathv[i]);
  ::globfree(&matches);
  if (code != 0 && code != GLOB_NOMATCH) return std::nullopt;
  return found;
}

}  // namespace oncard::tools
