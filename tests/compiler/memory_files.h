// Files that only exist in a test.
#pragma once

#include <map>
#include <string>

#include "base/files.h"
#include "compiler/compiler.h"

namespace oncard::compiler {

/// Texts by path.
using MemoryFiles = std::map<std::string, std::string>;

/// Reads these files; all others are missing.
inline FileReader ReaderOf(const MemoryFiles& files) {
  return [files](const std::string& path) -> Result<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return MakeError(kNoSuchFile, "missing", "缺少");
    return found->second;
  };
}

/// For programs that include nothing.
inline FileReader NoFiles() { return ReaderOf({}); }

}  // namespace oncard::compiler
