// Text inside XML and HTML. Tested by tests/base/markup_test.cc.
#pragma once

#include <string>
#include <string_view>

namespace oncard {

/// The text with the special characters of markup escaped: & < > and ".
std::string EscapeMarkup(std::string_view text);

}  // namespace oncard
