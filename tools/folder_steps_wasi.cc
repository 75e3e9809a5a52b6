#include "tools/folder_steps.h"

#include <dirent.h>
#include <sys/stat.h>

#include <cerrno>

#include "base/files.h"

namespace oncard::tools::folder_steps {
namespace {

std::error_code SystemError() { return {errno, std::generic_category()}; }

}  // namespace

std::error_code MakeAll(const std::string& path) {
  for (size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    const std::string folder = path.substr(0, end);
    if (!IsFolder(folder) && ::mkdir(folder.c_str(), 0777) != 0) return SystemError();
  }
  return {};
}

std::error_code AddPathsIn(const std::string& folder, std::vector<std::string>* paths) {
  DIR* entries = ::opendir(folder.c_str());
  if (entries == nullptr) return SystemError();
  std::vector<std::string> folders;
  while (const dirent* entry = ::readdir(entries)) {
    const std::string name = entry->d_name;
    if (name == "." || name == "..") continue;
    paths->push_back(folder + (folder.ends_with('/') ? "" : "/") + name);
    if (entry->d_type == DT_DIR) folders.push_back(paths->back());
  }
  ::closedir(entries);
  for (const std::string& each : folders) {
    if (const std::error_code error = AddPathsIn(each, paths)) return error;
  }
  return {};
}

}  // namespace oncard::tools::folder_steps
