#include "tools/terminal.h"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

namespace oncard::tools {

void PrepareStreams() {
  // If the shell's file size limit is exceeded, the error is reported like a full disk.
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
}

bool ErrorsGoToTerminal() { return ::isatty(STDERR_FILENO) == 1; }

bool ErrorsHaveColors() {
  const char* terminal = std::getenv("TERM");
  const bool capable = terminal != nullptr && std::string_view(terminal) != "dumb";
  return capable && ErrorsGoToTerminal();
}

}  // namespace oncard::tools
