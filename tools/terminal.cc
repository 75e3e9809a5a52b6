#include "tools/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

#include "tools/columns.h"

namespace oncard::tools {

void PrepareStreams() {
  // If the shell's file size limit is exceeded, the error is reported like a full disk.
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
}

int OutputWidth() {
  if (const int wished = WishedColumns(); wished > 0) return wished;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

bool ErrorsGoToTerminal() { return ::isatty(STDERR_FILENO) == 1; }

bool ErrorsHaveColors() {
  const char* terminal = std::getenv("TERM");
  const bool capable = terminal != nullptr && std::string_view(terminal) != "dumb";
  return capable && ErrorsGoToTerminal();
}

}  // namespace oncard::tools
