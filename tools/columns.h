// The width that the user wishes for output.
#pragma once

#include <cstdlib>

#include "base/number.h"

namespace oncard::tools {

/// The variable COLUMNS; 0 if it is not set, or less than 40.
inline int WishedColumns() {
  constexpr int kWidthMin = 40;
  const char* columns = std::getenv("COLUMNS");
  const auto width = ReadWhole<int>(columns != nullptr ? columns : "");
  return width && *width >= kWidthMin ? *width : 0;
}

}  // namespace oncard::tools
