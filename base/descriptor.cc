#include "base/descriptor.h"

#include <fcntl.h>

namespace oncard {

int OpenToRead(const std::string& path) {
  return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

ptrdiff_t ReadSome(int descriptor, char* bytes, size_t size) {
  return ::read(descriptor, bytes, size);
}

ptrdiff_t WriteSome(int descriptor, const char* bytes, size_t size) {
  return ::write(descriptor, bytes, size);
}

}  // namespace oncard
