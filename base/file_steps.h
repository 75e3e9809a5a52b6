// The steps in which file_writer.cc writes a file, as the system takes them: file_steps.cc on
// Linux, file_steps_windows.cc on Windows, file_steps_wasi.cc in WebAssembly. Those that fail say
// why in errno. For file_writer.cc only.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace oncard::file_steps {

/// How often a folder in use is tried before it is used without a lock, and the pause in between.
inline constexpr int kLockAttempts = 1000;
inline constexpr int kLockPauseMs = 10;

/// Something that is given back when the last copy of this ends; it may be nothing.
using Held = std::shared_ptr<void>;

/// What a path refers to, links followed.
struct Place {
  enum class Kind { kNothing, kFile, kFolder, kOther };
  std::string path;  ///< with links in its last part resolved
  Kind kind = Kind::kNothing;
  bool dangling = false;  ///< a link pointed to nothing: an empty file has just been created there
  uint32_t mode = 0;
  uint32_t owner = 0;
  uint32_t group = 0;
  uint64_t device = 0;
  uint64_t node = 0;  ///< 0: the system does not number files
};

/// Puts what the system says of a file into its place.
inline void Take(const struct stat& info, Place* place) {
  place->kind = S_ISREG(info.st_mode)   ? Place::Kind::kFile
                : S_ISDIR(info.st_mode) ? Place::Kind::kFolder
                                        : Place::Kind::kOther;
  place->mode = info.st_mode;
  place->owner = info.st_uid;
  place->group = info.st_gid;
  place->device = info.st_dev;
  place->node = info.st_ino;
}

/// The characters that part folders in a name.
extern const std::string_view kSeparators;

bool FindPlace(const std::string& path, Place* place);
/// False if the user has made the file read-only.
bool MayWrite(const Place& place);

/// Blocks signals that would end the process in this thread, so that a write is completed or
/// undone; they are delivered afterwards.
Held HoldSignals();
/// Takes a lock on a folder, for processes that write and read pairs of files in it: many readers,
/// or one writer. It is advisory and only between processes of this project; a folder that cannot
/// be locked is used without a lock.
Held LockFolder(const std::string& folder, bool to_write);
/// Keeps Sweep() from a file that is going to have a temporary name for a moment.
Held KeepFromSweep(const std::string& path);

/// A number that nobody can guess, for the name of a temporary file.
bool RandomNumber(uint64_t* number);
/// Removes the temporary files of writers that were killed.
void Sweep(const std::string& folder);

/// Creates the file that is going to replace what is at a place, with a temporary name, and keeps
/// it from Sweep() until the descriptor is closed; -1 on failure, with EEXIST if another name is to
/// be tried.
int CreateTemporary(const Place& place, const std::string& name);
/// Opens what is written to directly: its own output or a device; -1 on failure.
int OpenToWrite(const std::string& path, int own_output);
/// Gives a new file the owner and mode of the old one at its place, as far as there are any, and
/// flushes it.
bool Complete(int descriptor, const Place& place);

/// Gives a file another name, and replaces what has it.
bool Rename(const std::string& from, const std::string& to);
/// Gives each of two files the name of the other. Fails where the system cannot do that.
bool Exchange(const std::string& first, const std::string& second);
/// Gives a file a temporary name, and keeps it from Sweep() while `held` lasts.
bool MoveAway(const std::string& from, const std::string& to, Held* held);
void Remove(const std::string& path);

}  // namespace oncard::file_steps
