// In place of files.cc, file_writer.cc and file_names.cc where there is no file system, as in
// WebAssembly: no file exists and none can be written. Callers there read from content that they
// were given.
#include <filesystem>

#include "base/files.h"

namespace oncard {
namespace {

Error NoFile(const std::string& path) {
  return MakeError(kNoSuchFile, "cannot open '{0}': there are no files here",
                   "无法打开“{0}”：此处没有文件", path);
}

Error NotWritten(const std::string& path) {
  return MakeError(1, "cannot write '{0}': there are no files here", "无法写入“{0}”：此处没有文件",
                   path);
}

}  // namespace

Result<std::string> ReadFile(const std::string& path, const FileKind&) { return NoFile(path); }

Result<void> WriteFileAtomically(const std::string& path, std::string_view) {
  return NotWritten(path);
}

Result<void> WriteFileAtomically(const std::string& path, TextSource) { return NotWritten(path); }

Result<void> WritePairAtomically(const std::string& first_path, std::string_view,
                                 const std::string&, std::string_view) {
  return NotWritten(first_path);
}

bool FileExists(const std::string&) { return false; }

bool IsFolder(const std::string&) { return false; }

std::string NameFromFolder(const std::string& path, const std::string& folder) {
  return std::filesystem::path(path).lexically_proximate(folder).generic_string();
}

FilePair ReadPair(const std::string& first_path, const std::string& second_path, const FileKind&) {
  return {NoFile(first_path), NoFile(second_path)};
}

}  // namespace oncard
