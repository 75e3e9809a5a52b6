// Checks a TOML text before it is parsed: toml++ 3.3 recurses without limit for dotted keys, and
// has undefined behaviour for non-ASCII letters in bare keys and values.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/message.h"

namespace oncard::runtime {

/// A place in the text, counted from 1 (columns in bytes), and the error there.
struct TomlRefusal {
  uint32_t line = 1;
  uint32_t column = 1;
  Message message;
};

/// Empty if the text respects kTomlDepthMax, kTomlKeyPartMax and kTomlKeyMax of base/limits.h and
/// has non-ASCII bytes only in strings and comments (TOML 1.0). The parser decides whether it is
/// valid TOML. Takes linear time and constant memory.
std::optional<TomlRefusal> CheckToml(std::string_view text);

}  // namespace oncard::runtime
