// A file descriptor that is closed with its scope, and the calls by which files.cc reads and
// file_writer.cc writes: those of descriptor.cc on Linux and in WebAssembly, of
// descriptor_windows.cc on Windows.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <string>

namespace oncard {

class Descriptor {
 public:
  /// Takes ownership of a descriptor; a negative number stands for none.
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int get() const { return number_; }

 private:
  int number_;
};

/// Opens a file to read its bytes, without waiting for anybody; -1 with errno.
int OpenToRead(const std::string& path);
/// Reads up to `size` bytes; 0 at the end, -1 with errno.
ptrdiff_t ReadSome(int descriptor, char* bytes, size_t size);
/// Writes up to `size` bytes; -1 with errno.
ptrdiff_t WriteSome(int descriptor, const char* bytes, size_t size);

}  // namespace oncard
