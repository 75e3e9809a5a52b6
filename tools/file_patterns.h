// Files by patterns, as a shell would find them: file_patterns.cc on Linux and in WebAssembly,
// file_patterns_windows.cc on Windows.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace oncard::tools {

/// The files whose names match a pattern with * and ?, sorted by name; nothing if the search fails.
/// On Windows only the last part of a name is a pattern, and there is no [ ].
std::optional<std::vector<std::string>> FilesMatching(const std::string& pattern);

}  // namespace oncard::tools
