#include "tools/scenario_folder.h"

#include <algorithm>

#include "base/files.h"
#include "tools/folder_steps.h"

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
  if (const std::error_code error = folder_steps::AddPathsIn(path, &found)) {
    return MakeError(1, "cannot read the folder '{0}': {1}", "无法读取文件夹“{0}”：{1}", path,
                     error.message());
  }
  std::erase_if(found, [](const std::string& each) { return !each.ends_with(".toml"); });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace oncard::tools
