#include "tools/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

#include "base/number.h"

namespace oncard::tools {

int OutputWidth() {
  constexpr int kWidthMin = 40;
  if (const char* columns = std::getenv("COLUMNS")) {
    const auto width = ReadWhole<int>(columns);
    if (width && *width >= kWidthMin) return *width;
  }
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

}  // namespace oncard::tools
