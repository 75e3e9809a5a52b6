#include "tools/folder_steps.h"

#include <filesystem>

#include "base/path_bytes.h"

namespace oncard::tools::folder_steps {

std::error_code MakeAll(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(PathOf(path), error);
  return error;
}

std::error_code AddPathsIn(const std::string& folder, std::vector<std::string>* paths) {
  std::error_code error;
  using Iterator = std::filesystem::recursive_directory_iterator;
  for (Iterator entry(PathOf(folder), error); !error && entry != Iterator();
       entry.increment(error)) {
    paths->push_back(FileNameOf(entry->path()));
  }
  return error;
}

}  // namespace oncard::tools::folder_steps
