#include <dirent.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/files.h"
#include "tools/scenario_folder.h"

namespace oncard::tools {
namespace {

/// Adds the scenarios in a folder and its subfolders. Links to folders are not followed. False with
/// errno if a folder cannot be read.
bool AddScenarios(const std::string& folder, std::vector<std::string>* found) {
  DIR* entries = ::opendir(folder.c_str());
  if (entries == nullptr) return false;
  std::vector<std::string> folders;
  while (const dirent* entry = ::readdir(entries)) {
    const std::string name = entry->d_name;
    if (name == "." || name == "..") continue;
    const std::string path = folder + (folder.ends_with('/') ? "" : "/") + name;
    if (entry->d_type == DT_DIR) folders.push_back(path);
    if (name.ends_with(".toml")) found->push_back(path);
  }
  ::closedir(entries);
  return std::ranges::all_of(
      folders, [found](const std::string& each) { return AddScenarios(each, found); });
}

}  // namespace

Result<std::vector<std::string>> FindScenarios(const std::string& path) {
  std::vector<std::string> found;
  if (!FileExists(path)) {
    return MakeError(1, "cannot open '{0}': no such file or folder",
                     "无法打开“{0}”：没有该文件或文件夹", path);
  }
  if (!IsFolder(path)) {
    found.push_back(path);
    return found;
  }
  if (!AddScenarios(path, &found)) {
    return MakeError(1, "cannot read the folder '{0}': {1}", "无法读取文件夹“{0}”：{1}", path,
                     std::strerror(errno));
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace oncard::tools
