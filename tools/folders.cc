#include "tools/folders.h"

#include "tools/folder_steps.h"

namespace oncard::tools {

Result<void> MakeFolders(const std::string& path) {
  const std::error_code error = folder_steps::MakeAll(path);
  if (!error) return {};
  return MakeError(1, "cannot make the folder '{0}': {1}", "无法创建文件夹“{0}”：{1}", path,
                   error.message());
}

}  // namespace oncard::tools
