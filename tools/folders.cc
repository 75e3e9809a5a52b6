#include "tools/folders.h"

#include <filesystem>
#include <system_error>

#include "base/path_bytes.h"

namespace oncard::tools {

Result<void> MakeFolders(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(PathOf(path), error);
  if (!error) return {};
  return MakeError(1, "cannot make the folder '{0}': {1}", "无法创建文件夹“{0}”：{1}", path,
                   error.message());
}

}  // namespace oncard::tools
