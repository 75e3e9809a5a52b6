// The two languages that the front end reads: that of the card, and structured C, which
// compiler/lowering translates to it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "base/trim.h"

namespace oncard::compiler {

enum class Dialect : uint8_t {
  kCard,       ///< docs/language.md: one operation per statement, jumps with `goto`
  kStructured  ///< C with loops, nested expressions and functions
};

/// The first line of a program of structured C.
inline constexpr std::string_view kStructuredLine = "//@ structured";

/// Whether a program's first line is `//@ structured`, with any blanks around its words. A byte
/// order mark before it does not matter.
bool WantsStructured(std::string_view text);

/// How a line begins, after blanks, that is a comment for a tool: the explorer's requirements
/// (explore/models/problem.h).
inline constexpr std::string_view kToolComment = "//@";

/// Calls `visit` with the number and the text of every line that is a comment for a tool. A first
/// line `//@ structured` is for the compiler.
template <typename Visit>
void ForEachToolComment(std::string_view source, const Visit& visit) {
  int number = 1;
  for (size_t begin = 0; begin < source.size(); ++number) {
    const size_t end = std::min(source.find('\n', begin), source.size());
    const std::string_view line = source.substr(begin, end - begin);
    begin = end + 1;
    if (number == 1 && WantsStructured(line)) continue;
    if (Trim(line).starts_with(kToolComment)) visit(number, line);
  }
}

}  // namespace oncard::compiler
