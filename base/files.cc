// Tested by tests/base/files_test.cc.
#include "base/files.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "base/descriptor.h"

namespace oncard {
namespace {

Error SystemError(std::string_view en, std::string_view zh, const std::string& path) {
  return MakeError(1, en, zh, path, std::strerror(errno));
}

Error OpenError(const std::string& path) {
  Error error = SystemError("cannot open '{0}': {1}", "无法打开“{0}”：{1}", path);
  if (errno == ENOENT || errno == ENOTDIR) error.code = kNoSuchFile;
  return error;
}

Error TooLarge(const std::string& path, uint64_t bytes, const FileKind& kind) {
  return MakeError(1, "cannot read '{0}': it has {1} bytes or more; {2} has at most {4}",
                   "无法读取“{0}”：它有 {1} 字节或更多；{3}最多 {4} 字节", path, bytes,
                   kind.name_en, kind.name_zh, kind.bytes_max);
}

Result<void> CheckRegular(const std::string& path, const struct stat& info) {
  if (S_ISREG(info.st_mode)) return {};
  if (S_ISDIR(info.st_mode)) {
    return MakeError(1, "cannot open '{0}': it is a folder", "无法打开“{0}”：它是文件夹", path);
  }
  return MakeError(1, "cannot open '{0}': it is not a regular file (a device, a pipe or a socket)",
                   "无法打开“{0}”：它不是普通文件（而是设备、管道或套接字）", path);
}

/// Reads to the end. `expected` is the probable number of bytes.
Result<std::string> ReadAll(int descriptor, const std::string& path, size_t expected,
                            const FileKind& kind) {
  constexpr size_t kStep = size_t{1} << 16;
  std::string content;
  content.reserve(expected + 1);
  for (;;) {
    const size_t before = content.size();
    // One byte more than the limit is read, to notice a file that is too large.
    const size_t wanted =
        std::min(std::max(content.capacity() - before, kStep), kind.bytes_max + 1 - before);
    content.resize(before + wanted);
    const ptrdiff_t count = ReadSome(descriptor, content.data() + before, wanted);
    content.resize(before + (count > 0 ? static_cast<size_t>(count) : 0));
    if (count == 0) return content;
    if (count < 0 && errno != EINTR) {
      return SystemError("cannot read '{0}': {1}", "无法读取“{0}”：{1}", path);
    }
    if (content.size() > kind.bytes_max) return TooLarge(path, content.size(), kind);
  }
}

}  // namespace

Result<std::string> ReadFile(const std::string& path, const FileKind& kind) {
  struct stat info;
  if (::stat(path.c_str(), &info) != 0) return OpenError(path);
  // Opening a device can have effects, so the type is checked first.
  if (auto regular = CheckRegular(path, info); !regular.ok()) return regular.error();
  // The name may have become a pipe in between: opening it must not block.
  const Descriptor file(OpenToRead(path));
  if (file.get() < 0 || ::fstat(file.get(), &info) != 0) return OpenError(path);
  if (auto regular = CheckRegular(path, info); !regular.ok()) return regular.error();
  if (static_cast<uint64_t>(info.st_size) > kind.bytes_max) {
    return TooLarge(path, static_cast<uint64_t>(info.st_size), kind);
  }
  return ReadAll(file.get(), path, static_cast<size_t>(info.st_size), kind);
}

bool FileExists(const std::string& path) {
  struct stat info;
  return ::stat(path.c_str(), &info) == 0;
}

bool IsFolder(const std::string& path) {
  struct stat info;
  return ::stat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode);
}

}  // namespace oncard
