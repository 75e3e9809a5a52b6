// Parts of a text. Tested by tests/base/split_test.cc.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace oncard {

/// The parts between separators, in their order; at least one, which may be empty.
inline std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t begin = 0;;) {
    const size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

}  // namespace oncard
