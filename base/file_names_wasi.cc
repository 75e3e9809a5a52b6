// In WebAssembly, where the standard library knows of no folders: the system
// (web/cli/src/system.ts) says in PWD which one is the present one. Links are not followed.
#include <cstdlib>
#include <filesystem>

#include "base/files.h"

namespace oncard {
namespace {

std::filesystem::path Absolute(const std::string& path) {
  const char* present = std::getenv("PWD");
  return (std::filesystem::path(present == nullptr ? "/" : present) / path).lexically_normal();
}

}  // namespace

std::string NameFromFolder(const std::string& path, const std::string& folder) {
  const auto relative = Absolute(path).lexically_relative(Absolute(folder));
  return relative.empty() ? path : relative.generic_string();
}

}  // namespace oncard
