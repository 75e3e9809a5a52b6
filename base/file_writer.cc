// Tested by tests/base/file_writer_test.cc and, call by call, tests/tools/failing_calls_test.cc.
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "base/descriptor.h"
#include "base/file_steps.h"
#include "base/files.h"
#include "base/temporary_names.h"

namespace oncard {
namespace {

using file_steps::Held;
using file_steps::Place;

/// How many names are tried for a temporary file before that is an error.
constexpr int kNameAttempts = 100;

/// The folder of a file, with the separator at its end.
std::string FolderOf(const std::string& path) {
  const size_t separator = path.find_last_of(file_steps::kSeparators);
  return separator == std::string::npos ? "./" : path.substr(0, separator + 1);
}

/// A new name for a temporary file in the folder of a file; empty if there is none.
std::string TemporaryNameBeside(const std::string& path) {
  uint64_t number = 0;
  return file_steps::RandomNumber(&number) ? TemporaryNameOf(FolderOf(path), number)
                                           : std::string();
}

/// Standard output or standard error if it is this file, as in `--record /dev/stdout > file`;
/// otherwise -1.
int OwnOutput(const Place& place) {
  if (place.node == 0) return -1;
  for (const int number : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat info;
    if (::fstat(number, &info) == 0 && info.st_dev == place.device && info.st_ino == place.node) {
      return number;
    }
  }
  return -1;
}

bool WritePiece(int descriptor, std::string_view piece) {
  while (!piece.empty()) {
    const ptrdiff_t written = WriteSome(descriptor, piece.data(), piece.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    piece.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

bool WriteAll(int descriptor, const TextSource& content) {
  int failure = 0;  // the first one
  content([&](std::string_view piece) {
    if (failure == 0 && !WritePiece(descriptor, piece)) failure = errno;
  });
  errno = failure;
  return failure == 0;
}

Error WriteError(const std::string& path) {
  return MakeError(1, "cannot write '{0}': {1}", "无法写入“{0}”：{1}", path, std::strerror(errno));
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
    if (!file_steps::FindPlace(path_, &place_)) return WriteError(path_);
    if (place_.kind == Place::Kind::kFolder) {
      return MakeError(1, "cannot write '{0}': it is a folder; name a file in it, as in '{1}'",
                       "无法写入“{0}”：它是文件夹；应给出其中的文件名，如“{1}”", path_,
                       path_.ends_with('/') ? path_ + "NAME" : path_ + "/NAME");
    }
    if (!Replaces()) return {};
    // A file that the user has made read-only is not replaced.
    if (place_.kind == Place::Kind::kFile && !file_steps::MayWrite(place_)) {
      return WriteError(path_);
    }
    old_ = file_steps::KeepFromSweep(place_.path);
    signals_ = file_steps::HoldSignals();
    file_steps::Sweep(FolderOf(place_.path));
    new_.emplace(CreateTemporary());
    if (new_->get() < 0 || !WriteAll(new_->get(), content_) ||
        !file_steps::Complete(new_->get(), place_)) {
      return WriteError(path_);
    }
    return {};
  }

  /// True when the content replaces a file or creates one.
  bool Replaces() const {
    return place_.kind == Place::Kind::kNothing ||
           (place_.kind == Place::Kind::kFile && OwnOutput(place_) < 0);
  }

  /// Puts the content into its place.
  Result<void> Put() {
    if (!Replaces()) return WriteThrough();
    if (!file_steps::Rename(temporary_, place_.path)) return WriteError(path_);
    temporary_.clear();
    placed_ = true;
    return {};
  }

  /// The same, but keeps the old file, if there is one, for PutBack().
  Result<void> Exchange() {
    if (!Replaces()) return Put();
    if (file_steps::Exchange(temporary_, place_.path)) {
      exchanged_ = true;
      placed_ = true;
      return {};
    }
    // There is no old file, or the system cannot exchange two names.
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
      if (away_.empty()) file_steps::Remove(place_.path);
      BringBack();
    }
    if (!exchanged_) return;
    exchanged_ = false;
    placed_ = false;
    file_steps::Exchange(temporary_, place_.path);
  }

  /// Moves the old file, if there is one, out of the way.
  Result<void> TakeAway() {
    if (!Replaces()) return {};
    std::string name = TemporaryNameBeside(place_.path);
    if (name.empty()) return WriteError(path_);
    if (file_steps::MoveAway(place_.path, name, &away_held_)) {
      away_ = std::move(name);
    } else if (errno != ENOENT) {
      return WriteError(path_);
    }
    return {};
  }

  /// Undoes TakeAway().
  void BringBack() {
    if (away_.empty()) return;
    file_steps::Rename(away_, place_.path);
    away_.clear();
  }

  /// Removes the file that TakeAway() has kept.
  void Forget() {
    if (!away_.empty()) file_steps::Remove(away_);
    away_.clear();
  }

 private:
  /// The temporary file for the content; -1 on failure.
  int CreateTemporary() {
    for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
      temporary_ = TemporaryNameBeside(place_.path);
      if (temporary_.empty()) return -1;
      const int number = file_steps::CreateTemporary(place_, temporary_);
      if (number >= 0) return number;
      temporary_.clear();
      if (errno != EEXIST) return -1;
    }
    return -1;
  }

  /// Removes what has not been put into its place.
  void Remove() {
    if (!temporary_.empty()) file_steps::Remove(temporary_);
    temporary_.clear();
    if (!placed_ && place_.dangling) file_steps::Remove(place_.path);
  }

  Result<void> WriteThrough() {
    const Descriptor file(file_steps::OpenToWrite(path_, OwnOutput(place_)));
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
  // Kept so that no other writer removes the files while they have temporary names.
  Held old_;
  Held away_held_;
  std::optional<Descriptor> new_;
  Held signals_;
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
  const Held lock = file_steps::LockFolder(FolderOf(first_path), true);
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
  const Held lock = file_steps::LockFolder(FolderOf(first_path), false);
  return {ReadFile(first_path, kind), ReadFile(second_path, kind)};
}

}  // namespace oncard
