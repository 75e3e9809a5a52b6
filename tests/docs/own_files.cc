#include "tests/docs/own_files.h"

namespace oncard::docs {

namespace fs = std::filesystem;

std::vector<fs::path> OwnFiles(const std::string& ending) {
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(ONCARD_SOURCE_DIR), end; entry != end; ++entry) {
    const std::string name = entry->path().filename();
    const bool foreign = name == "build" || name == "node_modules";
    if (name.starts_with('.') || foreign) entry.disable_recursion_pending();
    if (entry->path().extension() == ending) files.push_back(entry->path());
  }
  return files;
}

}  // namespace oncard::docs
