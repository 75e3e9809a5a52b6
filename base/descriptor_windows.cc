#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <climits>

#include "base/descriptor.h"

namespace oncard {
namespace {

/// As much as the system takes at a time.
unsigned CountOf(size_t size) { return static_cast<unsigned>(std::min(size, size_t{INT_MAX})); }

}  // namespace

int OpenToRead(const std::string& path) {
  return ::_open(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

ptrdiff_t ReadSome(int descriptor, char* bytes, size_t size) {
  return ::_read(descriptor, bytes, CountOf(size));
}

ptrdiff_t WriteSome(int descriptor, const char* bytes, size_t size) {
  return ::_write(descriptor, bytes, CountOf(size));
}

}  // namespace oncard
