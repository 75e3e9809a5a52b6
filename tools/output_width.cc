#include <cstdlib>

#include "base/number.h"
#include "tools/terminal.h"

namespace oncard::tools {

int OutputWidth() {
  constexpr int kWidthMin = 40;
  const char* columns = std::getenv("COLUMNS");
  const auto wished = ReadWhole<int>(columns != nullptr ? columns : "");
  return wished && *wished >= kWidthMin ? *wished : TerminalWidth();
}

}  // namespace oncard::tools
