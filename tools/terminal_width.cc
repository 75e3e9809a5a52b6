#include <sys/ioctl.h>
#include <unistd.h>

#include "tools/terminal.h"

namespace oncard::tools {

int TerminalWidth() {
  winsize size{};
  return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace oncard::tools
