// Whole-file access. Reading takes regular files only and no more of them than their kind allows.
// Writing is atomic: a reader sees the old content or the new one, never a part, and a failed write
// leaves the old file as it was. Every function may be called from several threads and processes at
// once. What a system cannot do of this is in file_steps_windows.cc and file_steps_wasi.cc.
#pragma once

#include <string>
#include <string_view>

#include "base/limits.h"
#include "base/result.h"
#include "base/text_pieces.h"

namespace oncard {

/// The code of ReadFile's Error when there is no such file (GTS manual chapter 13, GT_Download).
inline constexpr int kNoSuchFile = 2007;

/// What some editors write at the beginning of a file in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The bytes of a regular file. Fails when it is missing (kNoSuchFile), unreadable, larger than its
/// kind allows (judged while reading, for files that grow), a folder, a device, a pipe or a socket:
/// these never end or make the reader wait. `path` must not contain a NUL.
Result<std::string> ReadFile(const std::string& path, const FileKind& kind = kOwnKind);

/// Writes a temporary file beside `path`, flushes it and renames it over `path`; the mode of an old
/// file is kept, and its owner where that is allowed. A symbolic link is followed and kept. A file
/// that is not regular (a device, a pipe), or is this process's own standard output, is written to
/// directly. Fails when `path` is a folder or may not be written. On failure the temporary file is
/// removed; one whose writer was killed is removed by the next write into the folder. SIGHUP,
/// SIGINT, SIGQUIT and SIGTERM are blocked in the calling thread until the file is complete.
Result<void> WriteFileAtomically(const std::string& path, std::string_view content);
/// The same for content that is made while it is written. After a failure the remaining pieces are
/// ignored.
Result<void> WriteFileAtomically(const std::string& path, TextSource content);

/// Writes two files of one folder that belong together: both are complete on disk before either is
/// renamed, and a failure leaves the old pair. Several writers take turns. A writer that is killed
/// between the renames leaves only the first file, never files of two different pairs.
Result<void> WritePairAtomically(const std::string& first_path, std::string_view first,
                                 const std::string& second_path, std::string_view second);

/// Undoes the writes of this thread that are not complete, as a failure does. For a process that
/// ends in the middle of one, because memory has run out: allocates nothing.
void UndoWrites();

/// True if a file or folder of this name exists and can be seen.
bool FileExists(const std::string& path);

/// True if a folder of this name exists and can be seen.
bool IsFolder(const std::string& path);

/// The shortest name of `path` as seen from `folder`; `path` itself if the current folder is gone.
std::string NameFromFolder(const std::string& path, const std::string& folder);

struct FilePair {
  Result<std::string> first;
  Result<std::string> second;
};

/// Reads two files that WritePairAtomically writes: both of the same pair.
FilePair ReadPair(const std::string& first_path, const std::string& second_path,
                  const FileKind& kind);

}  // namespace oncard
