// The comments of structured C, for those who show a program to people. Tested by
// tests/compiler/structured_source_test.cc.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "compiler/syntax.h"

namespace oncard::compiler {

/// A comment, without the end of its line. Lines `//@`, which are for tools (dialect.h), are none.
struct SourceComment {
  SourceRange range;
  /// No word of the program stands on its lines.
  bool alone = false;
  /// Where the words before and behind it begin: 0 and the end of the text if there are none.
  uint32_t before = 0;
  uint32_t behind = 0;
};

/// Appends the comments of a file, whose tokens are all those that it has.
void AppendComments(std::string_view text, int file, const std::vector<Token>& tokens,
                    std::vector<SourceComment>* comments);

}  // namespace oncard::compiler
