// Tested by tests/base/files_test.cc.
#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace oncard {
namespace {

Error SystemError(std::string_view en, std::string_view zh, const std::string& path) {
  return MakeError(1, en, zh, path, std::strerror(errno));
}

Error WriteError(const std::string& path) {
  return SystemError("cannot write '{0}': {1}", "无法写入“{0}”：{1}", path);
}

bool WriteAll(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<size_t>(written));
  }
  return ::fsync(descriptor) == 0;
}

// A complete temporary file beside its final place, removed unless it is moved there.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path)
      : path_(path), temporary_(path + ".tmp" + std::to_string(::getpid())) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (written_) ::unlink(temporary_.c_str());
  }

  Result<void> Write(std::string_view content) {
    const int descriptor =
        ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) return WriteError(path_);
    written_ = true;
    const bool complete = WriteAll(descriptor, content);
    const bool closed = ::close(descriptor) == 0;
    if (!complete || !closed) return WriteError(path_);
    return {};
  }

  Result<void> Move() {
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) return WriteError(path_);
    written_ = false;
    return {};
  }

 private:
  std::string path_;
  std::string temporary_;
  bool written_ = false;
};

}  // namespace

Result<std::string> ReadFile(const std::string& path) {
  struct stat info;
  if (::stat(path.c_str(), &info) != 0) {
    return SystemError("cannot open '{0}': {1}", "无法打开“{0}”：{1}", path);
  }
  if (S_ISDIR(info.st_mode)) {
    return MakeError(1, "cannot open '{0}': it is a folder", "无法打开“{0}”：它是文件夹", path);
  }
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return SystemError("cannot open '{0}': {1}", "无法打开“{0}”：{1}", path);
  std::string content;
  char buffer[1 << 16];
  size_t count = 0;
  while ((count = std::fread(buffer, 1, sizeof buffer, file)) > 0) content.append(buffer, count);
  const bool failed = std::ferror(file) != 0;
  std::fclose(file);
  if (failed) return SystemError("cannot read '{0}': {1}", "无法读取“{0}”：{1}", path);
  return content;
}

Result<void> WriteFileAtomically(const std::string& path, std::string_view content) {
  TemporaryFile file(path);
  if (auto result = file.Write(content); !result.ok()) return result;
  return file.Move();
}

Result<void> WritePairAtomically(const std::string& first_path, std::string_view first,
                                 const std::string& second_path, std::string_view second) {
  TemporaryFile first_file(first_path);
  TemporaryFile second_file(second_path);
  if (auto result = first_file.Write(first); !result.ok()) return result;
  if (auto result = second_file.Write(second); !result.ok()) return result;
  if (auto result = first_file.Move(); !result.ok()) return result;
  return second_file.Move();
}

}  // namespace oncard
