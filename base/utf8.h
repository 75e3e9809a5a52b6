// Characters in UTF-8. Tested by tests/base/utf8_test.cc.
#pragma once

#include <string>

namespace oncard {

/// Appends the character with this number, at most 0x10FFFF. Half of a pair of UTF-16 is none.
void AppendUtf8(std::string& text, char32_t code);

}  // namespace oncard
