// Removes blanks around a text. Tested by tests/base/trim_test.cc.
#pragma once

#include <cstddef>
#include <string_view>

namespace oncard {

/// The text without the spaces, tabs and carriage returns before and after it.
inline std::string_view Trim(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace oncard
