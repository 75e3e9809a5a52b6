#include "base/path_bytes.h"

namespace oncard {

std::filesystem::path PathOf(const std::string& name) { return name; }

std::string FileNameOf(const std::filesystem::path& path) { return path.string(); }

}  // namespace oncard
