#include "tools/scenario_folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/path_bytes.h"

namespace oncard::tools {

Result<std::vector<std::string>> FindScenarios(const std::string& path) {
  std::vector<std::string> found;
  if (!IsFolder(path)) {
    if (!FileExists(path)) {
      return MakeError(1, "cannot open '{0}': no such file or folder",
                       "无法打开“{0}”：没有该文件或文件夹", path);
    }
    found.push_back(path);
    return found;
  }
  std::error_code error;
  using Iterator = std::filesystem::recursive_directory_iterator;
  for (Iterator entry(PathOf(path), error); !error && entry != Iterator(); entry.increment(error)) {
    std::string name = FileNameOf(entry->path());
    if (name.ends_with(".toml")) found.push_back(std::move(name));
  }
  if (error) {
    return MakeError(1, "cannot read the folder '{0}': {1}", "无法读取文件夹“{0}”：{1}", path,
                     error.message());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace oncard::tools
