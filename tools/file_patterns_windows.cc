#include "tools/file_patterns.h"

#include <windows.h>

#include <algorithm>

namespace oncard::tools {

std::optional<std::vector<std::string>> FilesMatching(const std::string& pattern) {
  const size_t separator = pattern.find_last_of("/\\:");
  const std::string folder =
      separator == std::string::npos ? std::string() : pattern.substr(0, separator + 1);
  std::vector<std::string> found;
  WIN32_FIND_DATAA entry;
  const HANDLE entries = ::FindFirstFileA(pattern.c_str(), &entry);
  if (entries == INVALID_HANDLE_VALUE) return found;
  do {
    if ((entry.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0) {
      found.push_back(folder + entry.cFileName);
    }
  } while (::FindNextFileA(entries, &entry) != 0);
  const bool all = ::GetLastError() == ERROR_NO_MORE_FILES;
  ::FindClose(entries);
  std::sort(found.begin(), found.end());
  return all ? std::optional(found) : std::nullopt;
}

}  // namespace oncard::tools
