#include "base/file_steps.h"

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
#include <cstdio>
#include <ctime>
#include <memory>

#include "base/descriptor.h"
#include "base/temporary_names.h"

namespace oncard::file_steps {
namespace {

constexpr long kNsPerMs = 1'000'000;

/// Gives the new file the owner and mode of the old one.
bool TakeOver(int descriptor, const Place& place) {
  if (place.kind == Place::Kind::kNothing) return true;
  mode_t mode = place.mode & 07777;
  if (::fchown(descriptor, place.owner, place.group) != 0) mode &= 0777;
  return ::fchmod(descriptor, mode) == 0;
}

}  // namespace

const std::string_view kSeparators = "/";

bool FindPlace(const std::string& path, Place* place) {
  place->path = path;
  struct stat info;
  if (::lstat(path.c_str(), &info) != 0) return errno == ENOENT;
  if (!S_ISLNK(info.st_mode)) {
    Take(info, place);
    return true;
  }
  // The kernel follows the link, with its own permission checks.
  int number = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (number < 0 && errno == ENOENT) {
    number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_NOCTTY | O_CLOEXEC, 0666);
    place->dangling = number >= 0;
  }
  const Descriptor target(number);
  if (number < 0 || ::fstat(number, &info) != 0) return false;
  Take(info, place);
  if (place->kind != Place::Kind::kFile) return true;
  char buffer[PATH_MAX];
  const ssize_t length =
      ::readlink(fmt::format("/proc/self/fd/{}", number).c_str(), buffer, sizeof buffer);
  if (length < 0) return false;
  place->path.assign(buffer, static_cast<size_t>(length));
  return true;
}

bool MayWrite(const Place& place) {
  return ::faccessat(AT_FDCWD, place.path.c_str(), W_OK, AT_EACCESS) == 0;
}

Held HoldSignals() {
  sigset_t held;
  sigset_t before;
  ::sigemptyset(&held);
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM}) ::sigaddset(&held, signal);
  ::pthread_sigmask(SIG_BLOCK, &held, &before);
  return {nullptr, [before](void*) { ::pthread_sigmask(SIG_SETMASK, &before, nullptr); }};
}

Held LockFolder(const std::string& path, bool to_write) {
  auto folder =
      std::make_shared<Descriptor>(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const int kind = to_write ? LOCK_EX : LOCK_SH;
  for (int attempt = 0; folder->get() >= 0 && attempt < kLockAttempts; ++attempt) {
    if (::flock(folder->get(), kind | LOCK_NB) == 0 || errno != EWOULDBLOCK) break;
    // nanosleep() of the C library would take no time under `oncard exec`.
    const timespec pause = {0, kLockPauseMs * kNsPerMs};
    ::syscall(SYS_nanosleep, &pause, nullptr);
  }
  return folder;
}

Held KeepFromSweep(const std::string& path) {
  auto file = std::make_shared<Descriptor>(
      ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  ::flock(file->get(), LOCK_SH | LOCK_NB);
  return file;
}

bool RandomNumber(uint64_t* number) {
  return ::getrandom(number, sizeof *number, 0) == sizeof *number;
}

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

int CreateTemporary(const Place& place, const std::string& name) {
  // A new file gets the mode that the creation mask allows. A replacement is private until it gets
  // the mode of the old file.
  const mode_t mode = place.kind == Place::Kind::kNothing ? 0666 : 0600;
  const int number =
      ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  if (number < 0) return -1;
  // Another writer may have removed it before it was locked.
  struct stat info;
  const bool swept = ::flock(number, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (!swept && ::fstat(number, &info) == 0 && info.st_nlink > 0) return number;
  ::unlink(name.c_str());
  ::close(number);
  errno = EEXIST;
  return -1;
}

int OpenToWrite(const std::string& path, int own_output) {
  return own_output >= 0 ? ::fcntl(own_output, F_DUPFD_CLOEXEC, 0)
                         : ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
}

bool Complete(int descriptor, const Place& place) {
  return TakeOver(descriptor, place) && ::fsync(descriptor) == 0;
}

bool Rename(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) == 0;
}

bool Exchange(const std::string& first, const std::string& second) {
  return ::renameat2(AT_FDCWD, first.c_str(), AT_FDCWD, second.c_str(), RENAME_EXCHANGE) == 0;
}

// KeepFromSweep() has locked it before.
bool MoveAway(const std::string& from, const std::string& to, Held* /*held*/) {
  return Rename(from, to);
}

void Remove(const std::string& path) { ::unlink(path.c_str()); }

}  // namespace oncard::file_steps
