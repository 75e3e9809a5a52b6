// In WebAssembly, whose system (web/cli/src/system.ts) says in COLUMNS how wide a terminal is.
#include "tools/terminal.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "base/number.h"

namespace oncard::tools {

void PrepareStreams() {}

int OutputWidth() {
  const char* columns = std::getenv("COLUMNS");
  return columns == nullptr ? 0 : ReadWhole<int>(columns).value_or(0);
}

bool ErrorsGoToTerminal() { return ::isatty(STDERR_FILENO) == 1; }

bool ErrorsHaveColors() {
  const char* terminal = std::getenv("TERM");
  const bool capable = terminal != nullptr && std::string_view(terminal) != "dumb";
  return capable && ErrorsGoToTerminal();
}

}  // namespace oncard::tools
