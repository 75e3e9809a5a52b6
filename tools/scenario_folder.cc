#include "tools/scenario_folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace oncard::tools {

Result<std::vector<std::string>> FindScenarios(const std::string& path) {
  std::vector<std::string> found;
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) {
    if (!std::filesystem::exists(path, error)) {
      return MakeError(1, "cannot open '{0}': no such file or folder",
                       "无法打开“{0}”：没有该文件或文件夹", path);
    }
    found.push_back(path);
    return found;
  }
  using Iterator = std::filesystem::recursive_directory_iterator;
  for (Iterator entry(path, error); !error && entry != Iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.ends_with(".toml")) found.push_back(entry->path().generic_string());
  }
  if (error) {
    return MakeError(1, "cannot read the folder '{0}': {1}", "无法读取文件夹“{0}”：{1}", path,
                     error.message());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace oncard::tools
