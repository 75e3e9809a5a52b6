// Reading Markdown pages of the documentation: what has to be equal in two languages, and links.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace oncard::docs {

/// What a page and its translation have in common, in order, a line for each: a heading with its
/// level, a line of a code block without its comment, a table with its number of rows.
/// Comments are those of the block's language: `//` in c, `#` in sh, none elsewhere.
std::string Skeleton(std::string_view page);

/// The targets of the links and pictures of a page, without those to the web and to a place of the
/// page itself; `file.md#place` is `file.md`. Code blocks have no links.
std::vector<std::string> Links(std::string_view page);

}  // namespace oncard::docs
