// Characters of source text, which is UTF-8 or GBK.
#pragma once

#include <cstddef>
#include <string_view>

namespace oncard::compiler {

/// True when the bytes are well-formed UTF-8.
bool IsUtf8(std::string_view text);

/// Bytes of the first character of `text`, at least 1; `utf8` says how to read bytes above 0x7F,
/// otherwise they are GBK.
size_t CharacterLength(std::string_view text, bool utf8);

}  // namespace oncard::compiler
