#include <filesystem>
#include <system_error>

#include "base/files.h"
#include "base/path_bytes.h"

namespace oncard {

std::string NameFromFolder(const std::string& path, const std::string& folder) {
  std::error_code error;
  const auto relative = std::filesystem::proximate(PathOf(path), PathOf(folder), error);
  return error ? path : FileNameOf(relative);
}

}  // namespace oncard
