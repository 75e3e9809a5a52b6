// A file that only grows, and is written through memory that the process shares with the operating
// system. What has been appended is in the file, whatever happens to the process then, and costs no
// system call.
//
// The file is longer than what was appended until Finish(): zero bytes follow, also if the process
// is killed. Nothing of an appended text is seen before the whole of it: its first byte, which must
// not be zero, is written last.
//
// What cannot be mapped (a pipe, a device) or grow by as much as is mapped at a time (a full disk,
// a limit of the process) is written by system calls, as far as it goes. Who shortens the file
// while it is mapped ends the process by SIGBUS, as for every mapped file: so another MappedFile
// does not open it meanwhile.
//
// Not thread-safe. Linux only. Tested by tests/runtime/mapped_file_test.cc.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/host/kept_descriptor.h"

namespace oncard::runtime {

class MappedFile {
 public:
  MappedFile() = default;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile() { Finish(); }

  /// Creates the file, or empties an old one. False with errno if that fails; with EWOULDBLOCK if
  /// another process writes it in this way.
  bool Open(const std::string& path);
  bool is_open() const { return file_.get() >= 0; }
  /// False if not all of it could be written.
  bool Append(std::string_view text);
  /// Cuts off the zero bytes. What is appended after that is written by system calls.
  void Finish();
  /// In a child of fork(): closes the file and leaves it to the parent.
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

}  // namespace oncard::runtime
