// The two languages that the front end reads: that of the card, and structured C, which
// compiler/lowering translates to it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
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
/// (explore/models/problem.h), and asserts.
inline constexpr std::string_view kToolComment = "//@";

/// The condition of a line `//@ assert: CONDITION`; empty for an assert that has none, nullopt for
/// any other line.
std::optional<std::string_view> AssertConditionOf(std::string_view line);

/// What stands behind `//@ depth:`, which bounds recursion (depth_comments.h); as with asserts.
std::optional<std::string_view> DepthOf(std::string_view line);

/// Calls `visit` with the number and the text of every line that is a comment for a tool, asserts
/// too. A first line `//@ structured` is for the compiler.
template <typename Visit>
void ForEachCommentLine(std::string_view source, const Visit& visit) {
  int number = 1;
  for (size_t begin = 0; begin < source.size(); ++number) {
    const size_t end = std::min(source.find('\n', begin), source.size());
    const std::string_view line = source.substr(begin, end - begin);
    begin = end + 1;
    if (number == 1 && WantsStructured(line)) continue;
    if (Trim(line).starts_with(kToolComment)) visit(number, line);
  }
}

/// The same without asserts and what is for the compiler.
template <typename Visit>
void ForEachToolComment(std::string_view source, const Visit& visit) {
  ForEachCommentLine(source, [&visit](int number, std::string_view line) {
    if (!AssertConditionOf(line) && !DepthOf(line)) visit(number, line);
  });
}

/// Calls `visit` with the comment and the condition of every assert; the condition may be empty.
template <typename Visit>
void ForEachAssertComment(std::string_view source, const Visit& visit) {
  ForEachCommentLine(source, [&visit](int /*number*/, std::string_view line) {
    if (const auto condition = AssertConditionOf(line)) visit(Trim(line), *condition);
  });
}

}  // namespace oncard::compiler
