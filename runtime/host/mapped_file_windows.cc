// Every text is written by a system call, which Windows keeps in the file whatever happens to the
// process then.
#include "runtime/host/mapped_file.h"

#include <windows.h>

#include <cerrno>

namespace oncard::runtime {

class MappedFile::Content {
 public:
  ~Content() { Close(); }

  bool Open(const std::string& path) {
    // Others may read what is there, but not write.
    file_ = ::CreateFileA(path.c_str(), GENERIC_WRITE, FILE_SHARE_READ, nullptr, CREATE_ALWAYS,
                          FILE_ATTRIBUTE_NORMAL, nullptr);
    if (is_open()) return true;
    errno = ErrnoOf(::GetLastError());
    return false;
  }

  bool is_open() const { return file_ != INVALID_HANDLE_VALUE; }

  bool Append(std::string_view text) const {
    while (!text.empty()) {
      DWORD written = 0;
      const auto size = static_cast<DWORD>(text.size());
      if (::WriteFile(file_, text.data(), size, &written, nullptr) == 0) return false;
      text.remove_prefix(written);
    }
    return true;
  }

  void Close() {
    if (is_open()) ::CloseHandle(file_);
    file_ = INVALID_HANDLE_VALUE;
  }

 private:
  static int ErrnoOf(DWORD error) {
    switch (error) {
      case ERROR_SHARING_VIOLATION:
        return EWOULDBLOCK;
      case ERROR_FILE_NOT_FOUND:
      case ERROR_PATH_NOT_FOUND:
      case ERROR_INVALID_NAME:
        return ENOENT;
      case ERROR_DISK_FULL:
        return ENOSPC;
      default:
        return EACCES;
    }
  }

  HANDLE file_ = INVALID_HANDLE_VALUE;
};

MappedFile::MappedFile() : content_(std::make_unique<Content>()) {}
MappedFile::~MappedFile() = default;
bool MappedFile::Open(const std::string& path) { return content_->Open(path); }
bool MappedFile::is_open() const { return content_->is_open(); }
bool MappedFile::Append(std::string_view text) { return content_->Append(text); }
void MappedFile::Finish() {}
void MappedFile::Abandon() { content_->Close(); }

}  // namespace oncard::runtime
