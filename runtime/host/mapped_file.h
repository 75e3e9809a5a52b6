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
// That is so on Linux. On Windows every text is written by a system call, and nothing has to be cut
// off.
//
// Not thread-safe. Tested by tests/runtime/mapped_file_test.cc.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace oncard::runtime {

class MappedFile {
 public:
  MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  /// As Finish().
  ~MappedFile();

  /// Creates the file, or empties an old one. False with errno if that fails; with EWOULDBLOCK if
  /// another process writes it in this way.
  bool Open(const std::string& path);
  bool is_open() const;
  /// False if not all of it could be written.
  bool Append(std::string_view text);
  /// Cuts off the zero bytes. What is appended after that is written by system calls.
  void Finish();
  /// In a child of fork(): closes the file and leaves it to the parent.
  void Abandon();

 private:
  class Content;
  std::unique_ptr<Content> content_;
};

}  // namespace oncard::runtime
