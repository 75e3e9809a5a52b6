// In WebAssembly, whose system (web/cli/src/oncard.ts) says it in a variable.
#include <cstdlib>

#include "base/number.h"
#include "tools/terminal.h"

namespace oncard::tools {

int TerminalWidth() {
  const char* width = std::getenv("ONCARD_TERMINAL_WIDTH");
  return ReadWhole<int>(width != nullptr ? width : "").value_or(0);
}

}  // namespace oncard::tools
