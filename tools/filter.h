// Programs that read a text and write another: filter.cc on Linux, filter_windows.cc on Windows,
// filter_wasi.cc in WebAssembly, which starts none.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace oncard::tools {

struct FilterRun {
  std::string out;
  std::string err;
  bool good = false;  ///< it ended with 0
};

/// Runs a program, which is searched for as in a shell, on a text to its end; nothing if it cannot
/// be started.
std::optional<FilterRun> RunFilter(const std::vector<std::string>& words, const std::string& text);

}  // namespace oncard::tools
