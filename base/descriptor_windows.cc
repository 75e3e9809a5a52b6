#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <climits>

#include "base/descriptor.h"

namespace oncard {

int OpenToRead(const std::string& path) {
  return ::_open(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

ptrdiff_t ReadSome(int descriptor, char* bytes, size_t size) {
  return ::_read(descriptor, bytes, static_cast<unsigned>(std::min(size, size_t{INT_MAX})));
}

}  // namespace oncard
