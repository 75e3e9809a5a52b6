// In place of file_steps.cc on Windows. A file is kept from Sweep() by keeping it open: nobody may
// then open it alone. The system has neither modes nor owners that a new file could take over: it
// gets the rights that its folder gives. It takes the place of a symbolic link, which Linux
// follows.
#define _CRT_RAND_S  // of stdlib.h: rand_s(), the system's random numbers

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>

#include "base/descriptor.h"
#include "base/file_steps.h"
#include "base/temporary_names.h"

namespace oncard::file_steps {
namespace {

/// A reader, or a scanner for viruses, has a file open for a moment.
constexpr int kRenameAttempts = 100;
constexpr DWORD kRenamePauseMs = 10;
/// As much of a folder's name as the name of a lock may contain.
constexpr size_t kLockNameMax = 200;

constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

/// errno for what the system says last.
int ErrorNumber() {
  switch (::GetLastError()) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
      return ENOENT;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_WRITE_PROTECT:
      return EROFS;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
      return EACCES;
    default:
      return EIO;
  }
}

bool Failed() {
  errno = ErrorNumber();
  return false;
}

HANDLE Open(const std::string& path, DWORD access, DWORD share, DWORD creation) {
  return ::CreateFileA(path.c_str(), access, share, nullptr, creation, FILE_ATTRIBUTE_NORMAL,
                       nullptr);
}

Held Keep(HANDLE handle) {
  if (handle == INVALID_HANDLE_VALUE) return {};
  return {handle, [](HANDLE kept) { ::CloseHandle(kept); }};
}

/// Tries again while somebody else has one of the files open.
bool Move(const std::string& from, const std::string& to, DWORD how) {
  for (int attempt = 1;; ++attempt) {
    if (::MoveFileExA(from.c_str(), to.c_str(), how) != 0) return true;
    if (ErrorNumber() != EACCES || attempt == kRenameAttempts) return Failed();
    ::Sleep(kRenamePauseMs);
  }
}

}  // namespace

const std::string_view kSeparators = "/\\:";

bool FindPlace(const std::string& path, Place* place) {
  place->path = path;
  struct stat info;
  if (::stat(path.c_str(), &info) != 0) return errno == ENOENT;
  Take(info, place);
  return true;
}

bool MayWrite(const Place& place) {
  constexpr int kToWrite = 2;
  return ::_access(place.path.c_str(), kToWrite) == 0;
}

// Ctrl-C ends the process in a thread of its own, which nothing holds. The next writer removes what
// remains.
Held HoldSignals() { return {}; }

// A folder cannot be locked. Its name stands for it.
Held LockFolder(const std::string& folder, bool /*to_write*/) {
  std::string path(MAX_PATH, '\0');
  const DWORD size = ::GetFullPathNameA(folder.c_str(), MAX_PATH, path.data(), nullptr);
  if (size == 0 || size >= MAX_PATH) return {};
  path.resize(size);
  // Letters beyond ASCII keep their case: who spells a folder in two ways has two locks.
  std::ranges::transform(path, path.begin(), [](unsigned char c) {
    return c == '\\' ? '/' : static_cast<char>(std::tolower(c));
  });
  path.erase(0, path.size() - std::min(path.size(), kLockNameMax));
  const HANDLE lock = ::CreateMutexA(nullptr, FALSE, ("Local\\oncard:" + path).c_str());
  if (lock == nullptr) return {};
  const DWORD taken = ::WaitForSingleObject(lock, kLockAttempts * kLockPauseMs);
  if (taken != WAIT_OBJECT_0 && taken != WAIT_ABANDONED) {
    ::CloseHandle(lock);
    return {};
  }
  return {lock, [](HANDLE mutex) {
            ::ReleaseMutex(mutex);
            ::CloseHandle(mutex);
          }};
}

// An open file could not be replaced: MoveAway() keeps it instead.
Held KeepFromSweep(const std::string& /*path*/) { return {}; }

bool RandomNumber(uint64_t* number) {
  unsigned high = 0;
  unsigned low = 0;
  if ((errno = ::rand_s(&high)) != 0 || (errno = ::rand_s(&low)) != 0) return false;
  *number = uint64_t{high} << 32 | low;
  return true;
}

void Sweep(const std::string& folder) {
  const std::string pattern =
      folder + std::string(kTemporaryPrefix) + '*' + std::string(kTemporaryEnding);
  WIN32_FIND_DATAA entry;
  const HANDLE entries = ::FindFirstFileA(pattern.c_str(), &entry);
  if (entries == INVALID_HANDLE_VALUE) return;
  do {
    if (!IsTemporaryName(entry.cFileName)) continue;
    constexpr DWORD kNotShared = 0;
    const std::string path = folder + entry.cFileName;
    const HANDLE file =
        ::CreateFileA(path.c_str(), DELETE, kNotShared, nullptr, OPEN_EXISTING,
                      FILE_FLAG_DELETE_ON_CLOSE | FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
    if (file != INVALID_HANDLE_VALUE) ::CloseHandle(file);
  } while (::FindNextFileA(entries, &entry) != 0);
  ::FindClose(entries);
}

int CreateTemporary(const Place& /*place*/, const std::string& name) {
  const HANDLE file = Open(name, GENERIC_WRITE, kShared, CREATE_NEW);
  if (file == INVALID_HANDLE_VALUE) {
    errno = ErrorNumber();
    return -1;
  }
  const int number = ::_open_osfhandle(reinterpret_cast<intptr_t>(file), _O_WRONLY | _O_BINARY);
  if (number < 0) {  // there are too many open files
    ::CloseHandle(file);
    ::DeleteFileA(name.c_str());
    errno = EMFILE;
  }
  return number;
}

int OpenToWrite(const std::string& path, int /*own_output*/) {
  return ::_open(path.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT);
}

bool Complete(int descriptor, const Place& /*place*/) { return ::_commit(descriptor) == 0; }

bool Rename(const std::string& from, const std::string& to) {
  return Move(from, to, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH);
}

bool Exchange(const std::string& /*first*/, const std::string& /*second*/) {
  errno = ENOSYS;
  return false;
}

bool MoveAway(const std::string& from, const std::string& to, Held* held) {
  *held = Keep(Open(from, GENERIC_READ, kShared, OPEN_EXISTING));
  if (*held == nullptr) return Failed();
  return Move(from, to, MOVEFILE_WRITE_THROUGH);
}

void Remove(const std::string& path) { ::DeleteFileA(path.c_str()); }

}  // namespace oncard::file_steps
