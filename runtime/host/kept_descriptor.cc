#include "runtime/host/kept_descriptor.h"

#include <fcntl.h>
#include <unistd.h>

namespace oncard::runtime {
namespace {

/// Our numbers are above those that a host gets, and below the usual limit of 1024.
constexpr int kFirstNumber = 768;

}  // namespace

int MoveToKept(int descriptor) {
  if (descriptor < 0) return descriptor;
  const int high = ::fcntl(descriptor, F_DUPFD_CLOEXEC, kFirstNumber);
  if (high < 0) return descriptor;
  ::close(descriptor);
  return high;
}

void KeptDescriptor::Reset(int descriptor) {
  Close();
  struct stat status {};
  number_ = MoveToKept(descriptor);
  if (number_ < 0 || ::fstat(number_, &status) != 0) return;
  device_ = status.st_dev;
  inode_ = status.st_ino;
}

void KeptDescriptor::Close() {
  if (Status()) ::close(number_);
  number_ = -1;
}

std::optional<struct stat> KeptDescriptor::Status() const {
  struct stat status {};
  if (number_ < 0 || ::fstat(number_, &status) != 0) return std::nullopt;
  if (status.st_dev != device_ || status.st_ino != inode_) return std::nullopt;
  return status;
}

}  // namespace oncard::runtime
