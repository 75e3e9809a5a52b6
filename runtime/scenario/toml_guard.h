// What a TOML text must keep to before the parser may have it: toml++ 3.3 follows dotted keys as
// deep as they go, and has undefined behaviour for letters beyond ASCII in bare keys and values.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/message.h"

namespace oncard::runtime {

/// A place of the text, counted from 1 (columns in bytes), and what is wrong there.
struct TomlRefusal {
  uint32_t line = 1;
  uint32_t column = 1;
  Message message;
};

/// Nothing when the text keeps to kTomlDepthMax, kTomlKeyPartMax and kTomlKeyMax of base/limits.h
/// and has bytes beyond ASCII in strings and comments only (TOML 1.0). Whether it is TOML is left
/// to the parser. Time grows with the length, memory does not.
std::optional<TomlRefusal> CheckToml(std::string_view text);

}  // namespace oncard::runtime
