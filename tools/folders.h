// Folders that the command makes.
#pragma once

#include <string>

#include "base/result.h"

namespace oncard::tools {

/// Makes a folder, and those around it that are missing; one that is there is left as it is. `path`
/// has / between folders. Fails where the system refuses it, as when a file has the name.
Result<void> MakeFolders(const std::string& path);

}  // namespace oncard::tools
