// Blanks around a text that a person wrote. Tested by tests/base/trim_test.cc.
#pragma once

#include <string_view>

namespace oncard {

/// The text without the spaces and tabs before and after it.
inline std::string_view Trim(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

}  // namespace oncard
