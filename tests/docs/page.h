// Reads Markdown pages of the documentation: links, and what must be equal in two languages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace oncard::docs {

/// The parts that a page and its translation must have in common, in order, one line each: a
/// heading with its level, a line of a code block without its comment, a table with its number of
/// rows. Comments are those of the block's language: `//` in c, `#` in sh, none elsewhere.
std::string Skeleton(std::string_view page);

/// The targets of the links and pictures of a page, without those to the web and to places in the
/// page itself; `file.md#place` is `file.md`. Links in code blocks are ignored.
std::vector<std::string> Links(std::string_view page);

/// A block between lines of three backquotes.
struct CodeBlock {
  /// What follows the backquotes: the language, and what else is said of the block.
  std::string info;
  /// Its lines, each with its end.
  std::string text;
};

/// The code blocks of a page in their order.
std::vector<CodeBlock> CodeBlocks(std::string_view page);

}  // namespace oncard::docs
