// The steps in which file_writer.cc writes a file, as the system takes them: file_steps.cc on
// Linux, file_steps_windows.cc on Windows. Those that fail say why in errno. For file_writer.cc
// only.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/text_pieces.h"

namespace oncard::file_steps {

/// Something that is given back when the last copy of this ends; it may be nothing.
using Held = std::shared_ptr<void>;

/// What a path refers to, links followed.
struct Place {
  enum class Kind { kNothing, kFile, kFolder, kOther };
  std::string path;  ///< with links in its last part resolved
  Kind kind = Kind::kNothing;
  bool dangling = false;  ///< a link pointed to nothing: an empty file has just been created there
  // Of Linux:
  uint32_t mode = 0;
  uint32_t owner = 0;
  uint32_t group = 0;
  uint64_t device = 0;
  uint64_t node = 0;
};

/// The folder of a file, with the separator at its end.
std::string FolderOf(const std::string& path);

bool FindPlace(const std::string& path, Place* place);
/// Standard output or standard error if it is this file, as in `--record /dev/stdout > file`;
/// otherwise -1.
int OwnOutput(const Place& place);
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

/// A new name for a temporary file in a folder; empty if there is none.
std::string TemporaryName(const std::string& folder);
/// Removes the temporary files of writers that were killed.
void Sweep(const std::string& folder);

/// Creates the file that is going to replace what is at a place, with a temporary name, and keeps
/// it from Sweep() until the descriptor is closed; -1 on failure.
int CreateTemporary(const Place& place, std::string* name);
/// Opens what is written to directly: its own output or a device; -1 on failure.
int OpenToWrite(const std::string& path, int own_output);
bool WriteAll(int descriptor, const TextSource& content);
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
