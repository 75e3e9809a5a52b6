// In WebAssembly, whose system (web/cli/src/system.ts) gives a file that takes the place of another
// one its mode. There are no locks there: what a writer that was killed has left behind stays, and
// of two writers of a pair the last one wins.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "base/file_steps.h"

namespace oncard::file_steps {

const std::string_view kSeparators = "/";

bool FindPlace(const std::string& path, Place* place) {
  place->path = path;
  struct stat info;
  if (::lstat(path.c_str(), &info) != 0) return errno == ENOENT;
  if (!S_ISLNK(info.st_mode)) {
    Take(info, place);
    return true;
  }
  if (::stat(path.c_str(), &info) != 0) {
    const int number = errno == ENOENT ? ::open(path.c_str(), O_WRONLY | O_CREAT, 0666) : -1;
    if (number < 0) return false;
    place->dangling = true;
    ::close(number);
    if (::stat(path.c_str(), &info) != 0) return false;
  }
  Take(info, place);
  if (place->kind != Place::Kind::kFile) return true;
  // The system resolves all links of a path that ends in them.
  std::string real(PATH_MAX, '\0');
  const ssize_t length = ::readlink(path.c_str(), real.data(), real.size());
  if (length < 0) return false;
  real.resize(static_cast<size_t>(length));
  place->path = std::move(real);
  return true;
}

bool MayWrite(const Place& place) {
  const int number = ::open(place.path.c_str(), O_WRONLY);
  if (number < 0) return false;
  ::close(number);
  return true;
}

// The system ends the command at a signal between two of its calls, none of which is a part of a
// file: its temporary files stay.
Held HoldSignals() { return {}; }

Held LockFolder(const std::string& /*folder*/, bool /*to_write*/) { return {}; }

Held KeepFromSweep(const std::string& /*path*/) { return {}; }

bool RandomNumber(uint64_t* number) { return ::getentropy(number, sizeof *number) == 0; }

// Without locks, nobody can tell which temporary files are in use.
void Sweep(const std::string& /*folder*/) {}

int CreateTemporary(const Place& /*place*/, const std::string& name) {
  return ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
}

int OpenToWrite(const std::string& path, int own_output) {
  if (own_output < 0) return ::open(path.c_str(), O_WRONLY);
  return ::open(own_output == STDOUT_FILENO ? "/dev/stdout" : "/dev/stderr", O_WRONLY);
}

bool Complete(int descriptor, const Place& /*place*/) { return ::fsync(descriptor) == 0; }

bool Rename(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) == 0;
}

bool Exchange(const std::string& /*first*/, const std::string& /*second*/) {
  errno = ENOTSUP;
  return false;
}

bool MoveAway(const std::string& from, const std::string& to, Held* /*held*/) {
  return Rename(from, to);
}

void Remove(const std::string& path) { ::unlink(path.c_str()); }

}  // namespace oncard::file_steps
