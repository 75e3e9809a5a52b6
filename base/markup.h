// Text inside XML, HTML and Markdown. Tested by tests/base/markup_test.cc.
#pragma once

#include <string>
#include <string_view>

namespace oncard {

/// The text with the special characters of markup escaped: & < > and ".
std::string EscapeMarkup(std::string_view text);

/// The text for a cell of a table in Markdown, which a bar would end.
std::string EscapeTableCell(std::string_view text);

}  // namespace oncard
