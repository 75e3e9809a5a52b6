// Tested by tests/base/file_writer_test.cc and, call by call, tests/tools/failing_calls_test.cc.
#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <optional>
#include <utility>

#include "base/descriptor.h"
#include "base/files.h"

namespace oncard {
namespace {

// Temporary files are hidden and have different names. A writer holds a lock on its own, so that
// the next writer in the folder recognises those that were left behind.
constexpr std::string_view kTemporaryPrefix = ".oncard-";
constexpr std::string_view kTemporaryEnding = ".tmp";
// How many names are tried for a temporary file, and how often a folder in use is tried, before
// that is an error.
constexpr int kNameAttempts = 100;
constexpr int kLockAttempts = 1000;
constexpr long kLockPauseNs = 10'000'000;

Error WriteError(const std::string& path) {
  return MakeError(1, "cannot write '{0}': {1}", "无法写入“{0}”：{1}", path, std::strerror(errno));
}

std::string FolderOf(const std::string& path) {
  const size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

/// Blocks signals that would end the process in this thread, so that a write is completed or
/// undone; they are delivered afterwards.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t held;
    ::sigemptyset(&held);
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM}) ::sigaddset(&held, signal);
    ::pthread_sigmask(SIG_BLOCK, &held, &before_);
  }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
  ~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

/// A lock on a folder, for processes that write and read pairs of files in it. It is advisory and
/// only between processes of this project; a folder that cannot be locked is used without a lock.
class FolderLock {
 public:
  FolderLock(const std::string& folder, int kind)
      : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    for (int attempt = 0; folder_.get() >= 0 && attempt < kLockAttempts; ++attempt) {
      if (::flock(folder_.get(), kind | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
      // nanosleep() of the C library would take no time under `oncard exec`.
      const timespec pause = {0, kLockPauseNs};
      ::syscall(SYS_nanosleep, &pause, nullptr);
    }
  }

 private:
  Descriptor folder_;
};

// 16 hexadecimal digits: a number of 64 bits.
constexpr size_t kTemporaryDigits = 16;

/// True for names that TemporaryName() gives.
bool IsTemporaryName(std::string_view name) {
  if (!name.starts_with(kTemporaryPrefix) || !name.ends_with(kTemporaryEnding)) return false;
  if (name.size() != kTemporaryPrefix.size() + kTemporaryDigits + kTemporaryEnding.size()) {
    return false;
  }
  const std::string_view digits = name.substr(kTemporaryPrefix.size(), kTemporaryDigits);
  return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Result<std::string> TemporaryName(const std::string& folder, const std::string& path) {
  uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != sizeof number) return WriteError(path);
  return fmt::format("{}{}{:0{}x}{}", folder, kTemporaryPrefix, number, kTemporaryDigits,
                     kTemporaryEnding);
}

/// Removes the temporary files of writers that were killed.
void Sweep(const std::string& folder) {
  DIR* entries = ::opendir(folder.c_str());
  if (entries == nullptr) return;
  while (const dirent* entry = ::readdir(entries)) {
    if (!IsTemporaryName(entry->d_name)) continue;
    const Descriptor file(::openat(::dirfd(entries), entry->d_name,
                                   O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat info;
    if (file.get() < 0 || ::fstat(file.get(), &info) != 0) continue;
    if (!S_ISREG(info.st_mode) || info.st_uid != ::geteuid()) continue;
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) continue;
    ::unlinkat(::dirfd(entries), entry->d_name, 0);
  }
  ::closedir(entries);
}

bool WriteAll(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

/// The same for all pieces; errno is that of the first failure.
bool WriteAll(int descriptor, const TextSource& content) {
  int failure = 0;
  content([&](std::string_view piece) {
    if (failure == 0 && !WriteAll(descriptor, piece)) failure = errno;
  });
  errno = failure;
  return failure == 0;
}

/// What a path refers to, links followed.
struct Place {
  std::string path;  ///< with links in its last part resolved
  bool exists = false;
  bool dangling = false;  ///< a link pointed to nothing: an empty file has just been created there
  struct stat info = {};
};

Result<Place> FindPlace(const std::string& path) {
  Place place;
  place.path = path;
  if (::lstat(path.c_str(), &place.info) != 0) {
    if (errno == ENOENT) return place;
    return WriteError(path);
  }
  place.exists = true;
  if (!S_ISLNK(place.info.st_mode)) return place;
  // The kernel follows the link, with its own permission checks.
  int number = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (number < 0 && errno == ENOENT) {
    number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_NOCTTY | O_CLOEXEC, 0666);
    place.dangling = number >= 0;
  }
  const Descriptor target(number);
  if (number < 0 || ::fstat(number, &place.info) != 0) return WriteError(path);
  if (!S_ISREG(place.info.st_mode)) return place;
  char buffer[PATH_MAX];
  const ssize_t length =
      ::readlink(fmt::format("/proc/self/fd/{}", number).c_str(), buffer, sizeof buffer);
  if (length < 0) return WriteError(path);
  place.path.assign(buffer, static_cast<size_t>(length));
  return place;
}

/// Standard output or standard error if it is this file, as in `--record /dev/stdout > file`;
/// otherwise -1.
int OwnOutput(const Place& place) {
  for (const int number : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat info;
    if (place.exists && ::fstat(number, &info) == 0 && info.st_dev == place.info.st_dev &&
        info.st_ino == place.info.st_ino) {
      return number;
    }
  }
  return -1;
}

/// Content that is not in its place yet. A regular file, or a new one, is first written completely
/// to a temporary file, which then replaces it; a device, pipe or socket is written to directly.
/// Undone unless Put() or Exchange() succeeds.
class StagedFile {
 public:
  explicit StagedFile(const std::string& path) : path_(path) { newest_ = this; }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() {
    newest_ = before_;
    Remove();
  }

  /// Undoes all files of this thread that are not in their places. Allocates nothing.
  static void UndoAll() {
    for (StagedFile* file = newest_; file != nullptr; file = file->before_) {
      file->PutBack();
      file->BringBack();
      file->Remove();
    }
  }

  Result<void> Stage(TextSource content) {
    content_ = std::move(content);
    auto place = FindPlace(path_);
    if (!place.ok()) return place.error();
    place_ = std::move(place).value();
    if (S_ISDIR(place_.info.st_mode)) {
      return MakeError(1, "cannot write '{0}': it is a folder; name a file in it, as in '{1}'",
                       "无法写入“{0}”：它是文件夹；应给出其中的文件名，如“{1}”", path_,
                       path_.ends_with('/') ? path_ + "NAME" : path_ + "/NAME");
    }
    if (!Replaces()) return {};
    // A file that the user has made read-only is not replaced.
    if (place_.exists && ::faccessat(AT_FDCWD, place_.path.c_str(), W_OK, AT_EACCESS) != 0) {
      return WriteError(path_);
    }
    // The old file may have a temporary name for a moment.
    old_.emplace(::open(place_.path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    ::flock(old_->get(), LOCK_SH | LOCK_NB);
    signals_.emplace();
    Sweep(FolderOf(place_.path));
    const Descriptor file(Create());
    if (file.get() < 0 || !WriteAll(file.get(), content_) || !TakeOver(file.get()) ||
        ::fsync(file.get()) != 0) {
      return WriteError(path_);
    }
    new_.emplace(::fcntl(file.get(), F_DUPFD_CLOEXEC, 0));
    return {};
  }

  /// True when the content replaces a file or creates one.
  bool Replaces() const {
    return !place_.exists || (S_ISREG(place_.info.st_mode) && OwnOutput(place_) < 0);
  }

  /// Puts the content into its place.
  Result<void> Put() {
    if (!Replaces()) return WriteThrough();
    if (std::rename(temporary_.c_str(), place_.path.c_str()) != 0) return WriteError(path_);
    temporary_.clear();
    placed_ = true;
    return {};
  }

  /// The same, but keeps the old file, if there is one, for PutBack().
  Result<void> Exchange() {
    if (!Replaces()) return Put();
    if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, place_.path.c_str(), RENAME_EXCHANGE) ==
        0) {
      exchanged_ = true;
      placed_ = true;
      return {};
    }
    // There is no old file, or the file system cannot exchange two names.
    auto result = TakeAway();
    if (result.ok()) result = Put();
    created_ = result.ok();
    if (!result.ok()) BringBack();
    return result;
  }

  /// Undoes Exchange().
  void PutBack() {
    if (created_) {
      created_ = false;
      placed_ = false;
      if (away_.empty()) ::unlink(place_.path.c_str());
      BringBack();
    }
    if (!exchanged_) return;
    exchanged_ = false;
    placed_ = false;
    ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, place_.path.c_str(), RENAME_EXCHANGE);
  }

  /// Moves the old file, if there is one, out of the way.
  Result<void> TakeAway() {
    if (!Replaces()) return {};
    auto name = TemporaryName(FolderOf(place_.path), path_);
    if (!name.ok()) return name.error();
    if (std::rename(place_.path.c_str(), name.value().c_str()) == 0) {
      away_ = std::move(name).value();
    } else if (errno != ENOENT) {
      return WriteError(path_);
    }
    return {};
  }

  /// Undoes TakeAway().
  void BringBack() {
    if (away_.empty()) return;
    std::rename(away_.c_str(), place_.path.c_str());
    away_.clear();
  }

  /// Removes the file that TakeAway() has kept.
  void Forget() {
    if (!away_.empty()) ::unlink(away_.c_str());
    away_.clear();
  }

 private:
  /// Removes what has not been put into its place.
  void Remove() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    temporary_.clear();
    if (!placed_ && place_.dangling) ::unlink(place_.path.c_str());
  }

  /// Creates a temporary file and locks it; -1 with errno on failure.
  int Create() {
    // A new file gets the mode that the creation mask allows. A replacement is private until it
    // gets the mode of the old file.
    const mode_t mode = place_.exists ? 0600 : 0666;
    for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
      auto name = TemporaryName(FolderOf(place_.path), path_);
      if (!name.ok()) return -1;
      const int number =
          ::open(name.value().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
      if (number < 0) {
        if (errno == EEXIST) continue;
        return -1;
      }
      temporary_ = std::move(name).value();
      // Another writer may have removed it before it was locked.
      struct stat info;
      const bool swept = ::flock(number, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
      if (!swept && ::fstat(number, &info) == 0 && info.st_nlink > 0) return number;
      ::unlink(temporary_.c_str());
      temporary_.clear();
      ::close(number);
    }
    errno = EEXIST;
    return -1;
  }

  /// Gives the new file the owner and mode of the old one.
  bool TakeOver(int number) {
    if (!place_.exists) return true;
    mode_t mode = place_.info.st_mode & 07777;
    if (::fchown(number, place_.info.st_uid, place_.info.st_gid) != 0) mode &= 0777;
    return ::fchmod(number, mode) == 0;
  }

  Result<void> WriteThrough() {
    const int own = OwnOutput(place_);
    const Descriptor file(own >= 0 ? ::fcntl(own, F_DUPFD_CLOEXEC, 0)
                                   : ::open(path_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
    if (file.get() < 0 || !WriteAll(file.get(), content_)) return WriteError(path_);
    placed_ = true;
    return {};
  }

  static thread_local StagedFile* newest_;
  StagedFile* const before_ = newest_;
  std::string path_;
  TextSource content_;
  Place place_;
  std::string temporary_;
  std::string away_;
  bool placed_ = false;
  bool exchanged_ = false;
  bool created_ = false;  ///< put into its place without exchanging names
  // Kept open for their locks.
  std::optional<Descriptor> old_;
  std::optional<Descriptor> new_;
  std::optional<SignalsHeld> signals_;
};

thread_local StagedFile* StagedFile::newest_ = nullptr;

}  // namespace

void UndoWrites() { StagedFile::UndoAll(); }

Result<void> WriteFileAtomically(const std::string& path, std::string_view content) {
  return WriteFileAtomically(path, SourceOf(content));
}

Result<void> WriteFileAtomically(const std::string& path, TextSource content) {
  StagedFile file(path);
  if (auto result = file.Stage(std::move(content)); !result.ok()) return result;
  return file.Put();
}

Result<void> WritePairAtomically(const std::string& first_path, std::string_view first,
                                 const std::string& second_path, std::string_view second) {
  // Another writer of this pair moves the old files away for a moment; this must not be visible
  // here.
  const FolderLock lock(FolderOf(first_path), LOCK_EX);
  StagedFile first_file(first_path);
  StagedFile second_file(second_path);
  if (auto result = first_file.Stage(SourceOf(first)); !result.ok()) return result;
  if (auto result = second_file.Stage(SourceOf(second)); !result.ok()) return result;
  // The second file is moved away while the first one changes: if the process is killed in between,
  // the pair is incomplete, but never a mixture of two pairs.
  if (auto result = second_file.TakeAway(); !result.ok()) return result;
  auto result = first_file.Exchange();
  if (result.ok()) {
    result = second_file.Put();
    if (!result.ok()) first_file.PutBack();
  }
  if (result.ok()) {
    first_file.Forget();
    second_file.Forget();
  } else {
    second_file.BringBack();
  }
  return result;
}

FilePair ReadPair(const std::string& first_path, const std::string& second_path,
                  const FileKind& kind) {
  const FolderLock lock(FolderOf(first_path), LOCK_SH);
  return {ReadFile(first_path, kind), ReadFile(second_path, kind)};
}

}  // namespace oncard
