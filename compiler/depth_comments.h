// Comments `//@ depth: N` of structured C: how many calls of a function that calls itself, or of a
// circle of functions, run at the same time, at most; the first counts too. One that stands right
// above a function is for it, one that stands elsewhere outside of the functions for all that have
// none. Tested by tests/compiler/recursion_test.cc and tests/lang/structured.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "compiler/diagnostic.h"

namespace oncard::compiler {

/// A page has no more frames than slots.
inline constexpr int kFramesMax = 1024;

/// A comment `//@ depth`.
struct DepthComment {
  SourceRange range;         ///< the comment
  std::optional<int> depth;  ///< 1 to kFramesMax; nullopt: what it says is something else
};

/// Those of all files, in order.
std::vector<DepthComment> FindDepths(const std::deque<SourceFile>& files);

/// Whether only comments stand between a comment and the place where a function begins, both in one
/// text.
bool IsRightAbove(std::string_view text, const SourceRange& comment, const SourceRange& function);

}  // namespace oncard::compiler
