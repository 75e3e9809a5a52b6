#include "runtime/host/mapped_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "runtime/host/kept_descriptor.h"

namespace oncard::runtime {
namespace {

/// The file grows by multiples of this; also a multiple of the size of a page.
constexpr int64_t kStep = int64_t{1} << 20;

/// The same file for reading and writing, as a mapping needs it; the one for writing if that is not
/// allowed.
int ReopenForMapping(int file) {
  const std::string name = "/proc/self/fd/" + std::to_string(file);
  const int both = ::open(name.c_str(), O_RDWR | O_CLOEXEC);
  if (both < 0) return file;
  ::close(file);
  return both;
}

/// True if the process may have files of this size. One that grows beyond it ends by SIGXFSZ.
bool IsAllowed(int64_t size) {
  rlimit limit{};
  return ::getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ||
         static_cast<uint64_t>(size) <= limit.rlim_cur;
}

/// Reserves blocks for a part of a file: a page of a mapping for which the disk has none would end
/// the process.
bool ReserveBlocks(int file, int64_t begin, int64_t end) {
  int error = EINTR;
  while (error == EINTR) error = ::posix_fallocate(file, begin, end - begin);
  return error == 0;
}

}  // namespace

class MappedFile::Content {
 public:
  bool Open(const std::string& path);
  bool is_open() const { return file_.get() >= 0; }
  bool Append(std::string_view text);
  void Finish();
  void Abandon();

 private:
  /// Maps room for this many bytes after those that are there. False if that is impossible: the
  /// file is finished then.
  bool MakeRoom(int64_t size);
  void Unmap();
  bool Write(std::string_view text) const;

  KeptDescriptor file_;
  bool maps_ = false;
  int64_t size_ = 0;  ///< of what was appended
  // The part of the file that is mapped; it contains its end.
  char* window_ = nullptr;
  int64_t window_begin_ = 0;
  int64_t window_end_ = 0;
};

bool MappedFile::Content::Open(const std::string& path) {
  // Only for writing: this waits for the reader of a named pipe.
  const int opened = ::open(path.c_str(), O_WRONLY | O_CREAT | O_NOCTTY | O_CLOEXEC, 0666);
  if (opened < 0) return false;
  struct stat status {};
  maps_ = ::fstat(opened, &status) == 0 && S_ISREG(status.st_mode);
  file_.Reset(maps_ ? ReopenForMapping(opened) : opened);
  if (!maps_) return true;
  // Emptied only with the lock. File systems without locks have none to wait for.
  const bool own = ::flock(file_.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  if (own && ::ftruncate(file_.get(), 0) == 0) return true;
  const int error = errno;
  Abandon();
  errno = error;
  return false;
}

bool MappedFile::Content::Append(std::string_view text) {
  if (text.empty()) return true;
  const auto size = static_cast<int64_t>(text.size());
  if (size_ + size > window_end_ && !MakeRoom(size)) return Write(text);
  char* const to = window_ + (size_ - window_begin_);
  std::memcpy(to + 1, text.data() + 1, text.size() - 1);
  std::atomic_ref(*to).store(text.front(), std::memory_order_release);
  size_ += size;
  return true;
}

bool MappedFile::Content::MakeRoom(int64_t size) {
  if (!maps_) return false;
  Unmap();
  const int64_t begin = size_ / kStep * kStep;
  const int64_t end = (size_ + size + kStep - 1) / kStep * kStep;
  if (file_.Status() && IsAllowed(end) && ReserveBlocks(file_.get(), size_, end)) {
    void* const memory = ::mmap(nullptr, static_cast<size_t>(end - begin), PROT_READ | PROT_WRITE,
                                MAP_SHARED, file_.get(), begin);
    if (memory != MAP_FAILED) {
      window_ = static_cast<char*>(memory);
      window_begin_ = begin;
      window_end_ = end;
      return true;
    }
  }
  Finish();
  return false;
}

void MappedFile::Content::Finish() {
  if (!maps_) return;
  maps_ = false;
  Unmap();
  // Where the host has closed the descriptor the zero bytes stay.
  if (!file_.Status()) return;
  while (::ftruncate(file_.get(), size_) != 0 && errno == EINTR) {
  }
  ::lseek(file_.get(), size_, SEEK_SET);
}

void MappedFile::Content::Abandon() {
  maps_ = false;
  Unmap();
  file_.Close();
}

void MappedFile::Content::Unmap() {
  if (window_ != nullptr) ::munmap(window_, static_cast<size_t>(window_end_ - window_begin_));
  window_ = nullptr;
  window_begin_ = 0;
  window_end_ = 0;
}

bool MappedFile::Content::Write(std::string_view text) const {
  if (!file_.Status()) return false;
  while (!text.empty()) {
    const ssize_t written = ::write(file_.get(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

MappedFile::MappedFile() : content_(std::make_unique<Content>()) {}
MappedFile::~MappedFile() { content_->Finish(); }
bool MappedFile::Open(const std::string& path) { return content_->Open(path); }
bool MappedFile::is_open() const { return content_->is_open(); }
bool MappedFile::Append(std::string_view text) { return content_->Append(text); }
void MappedFile::Finish() { content_->Finish(); }
void MappedFile::Abandon() { content_->Abandon(); }

}  // namespace oncard::runtime
