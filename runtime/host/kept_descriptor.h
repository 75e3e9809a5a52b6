// A descriptor of the host library in a host. Its number is above those that a host gets. A host
// may nevertheless close numbers that it does not know, and may then get ours for a file of its
// own: so what a descriptor refers to is compared with what was opened.
//
// Linux only. Tested by tests/runtime/waiting_threads_test.cc and mapped_file_test.cc.
#pragma once

#include <sys/stat.h>
#include <sys/types.h>

#include <optional>

namespace oncard::runtime {

/// Gives a new descriptor a number that hosts do not use, and closes the old one; keeps the old
/// one if there is no such number. A negative number stands for none.
int MoveToKept(int descriptor);

class KeptDescriptor {
 public:
  KeptDescriptor() = default;
  KeptDescriptor(const KeptDescriptor&) = delete;
  KeptDescriptor& operator=(const KeptDescriptor&) = delete;
  ~KeptDescriptor() { Close(); }

  int get() const { return number_; }
  /// Closes what was open and takes ownership of a new descriptor, which gets another number.
  void Reset(int descriptor);
  /// Closes it, unless it is the host's.
  void Close();
  /// Nothing if the descriptor is not open, or is the host's.
  std::optional<struct stat> Status() const;

 private:
  int number_ = -1;
  dev_t device_ = 0;
  ino_t inode_ = 0;
};

}  // namespace oncard::runtime
