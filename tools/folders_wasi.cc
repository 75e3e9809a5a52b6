#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "base/files.h"
#include "tools/folders.h"

namespace oncard::tools {

Result<void> MakeFolders(const std::string& path) {
  for (size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    const std::string folder = path.substr(0, end);
    if (IsFolder(folder) || ::mkdir(folder.c_str(), 0777) == 0) continue;
    return MakeError(1, "cannot make the folder '{0}': {1}", "无法创建文件夹“{0}”：{1}", path,
                     std::strerror(errno));
  }
  return {};
}

}  // namespace oncard::tools
