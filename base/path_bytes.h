// The names of files are bytes: in any encoding on Linux, of the code page of the process on
// Windows, where / and \ part folders. std::filesystem takes them for something else there, so
// names become paths, and paths names, only by these. Tested by tests/base/path_bytes_test.cc.
#pragma once

#include <filesystem>
#include <string>

namespace oncard {

std::filesystem::path PathOf(const std::string& name);
/// With / between folders.
std::string FileNameOf(const std::filesystem::path& path);

}  // namespace oncard
