// Finds the files that #include names. Tested by tests/lang/include.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/reporter.h"

namespace oncard::compiler {

struct IncludedFile {
  bool found = false;
  std::string path;
  std::string text;
  /// Why the first file of this name cannot be read, if there is one.
  std::optional<Message> unreadable;
};

/// Searches for a file beside each of the files `beside`, then in the include folders.
IncludedFile FindInclude(const std::string& name, const std::vector<std::string>& beside,
                         const Options& options, const FileReader& reader);

/// Reports a file that was not found.
void ReportMissingInclude(const std::string& name, SourceRange range, const IncludedFile& file,
                          const Options& options, Reporter& reporter);

/// Whether `stdio.h` or the like belongs to C's library.
bool IsHeaderOfC(std::string_view name);

}  // namespace oncard::compiler
