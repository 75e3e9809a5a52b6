// The two languages that the front end reads: that of the card, and structured C, which
// compiler/lowering translates to it.
#pragma once

#include <cstdint>
#include <string_view>

namespace oncard::compiler {

enum class Dialect : uint8_t {
  kCard,       ///< docs/language.md: one operation per statement, jumps with `goto`
  kStructured  ///< C with loops, nested expressions and functions
};

/// Whether a program's first line is `//@ structured`, with any blanks around its words. A byte
/// order mark before it does not matter.
bool WantsStructured(std::string_view text);

}  // namespace oncard::compiler
