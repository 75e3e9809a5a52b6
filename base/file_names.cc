#include <filesystem>
#include <system_error>

#include "base/files.h"

namespace oncard {

std::string NameFromFolder(const std::string& path, const std::string& folder) {
  std::error_code error;
  const auto relative = std::filesystem::proximate(path, folder, error);
  return error ? path : relative.generic_string();
}

}  // namespace oncard
