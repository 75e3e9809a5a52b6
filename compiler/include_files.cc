#include "compiler/include_files.h"

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "base/path_bytes.h"

namespace oncard::compiler {
namespace {

/// The card has nothing of what they declare: messages advise to remove the line.
constexpr std::string_view kHeadersOfC[] = {
    "assert.h",   "complex.h",  "ctype.h",  "errno.h",       "fenv.h",    "float.h",
    "inttypes.h", "iso646.h",   "limits.h", "locale.h",      "math.h",    "setjmp.h",
    "signal.h",   "stdalign.h", "stdarg.h", "stdatomic.h",   "stdbool.h", "stddef.h",
    "stdint.h",   "stdio.h",    "stdlib.h", "stdnoreturn.h", "string.h",  "tgmath.h",
    "threads.h",  "time.h",     "uchar.h",  "wchar.h",       "wctype.h"};

std::string FolderOf(const std::string& path) {
  const size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

std::string InFolder(const std::string& folder, const std::string& name) {
  if (folder.empty() || folder.back() == '/' || folder.back() == '\\') return folder + name;
  return folder + '/' + name;
}

}  // namespace

IncludedFile FindInclude(const std::string& name, const std::vector<std::string>& beside,
                         const Options& options, const FileReader& reader) {
  std::vector<std::string> paths;
  if (PathOf(name).has_root_directory()) {
    paths.push_back(name);
  } else {
    for (const std::string& file : beside) paths.push_back(FolderOf(file) + name);
    for (const std::string& folder : options.include_folders) {
      paths.push_back(InFolder(folder, name));
    }
  }
  IncludedFile file;
  for (const std::string& path : paths) {
    Result<std::string> content = reader(path);
    if (content.ok()) {
      file.found = true;
      file.path = path;
      file.text = std::move(content).value();
      return file;
    }
    // A file that is there and cannot be read is not looked for elsewhere.
    if (content.error().code != kNoSuchFile) {
      file.unreadable = content.error().message;
      return file;
    }
  }
  return file;
}

void ReportMissingInclude(const std::string& name, SourceRange range, const IncludedFile& file,
                          const Options& options, Reporter& reporter) {
  if (file.unreadable) {
    reporter.Report(Code::kCannotOpen, range, name, *file.unreadable);
    return;
  }
  Diagnostic& diagnostic =
      reporter.Report(Code::kCannotOpen, range, name,
                      MakeMessage("it is neither beside the program nor in an include folder",
                                  "程序所在目录和包含目录中都没有该文件"));
  for (const std::string& folder : options.include_folders) {
    AddNote(diagnostic, MakeMessage("searched in '{}'", "已搜索 '{}'", folder));
  }
}

bool IsHeaderOfC(std::string_view name) {
  return std::find(std::begin(kHeadersOfC), std::end(kHeadersOfC), name) != std::end(kHeadersOfC);
}

}  // namespace oncard::compiler
