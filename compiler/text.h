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

/// Where the `//` comment at `begin` ends: before the end of its line, or of the file. If lines are
/// `continued`, as in structured C, a `\` at their end appends the next one; the second byte of a
/// GBK character is none, although it can have the same value.
size_t EndOfLineComment(std::string_view text, size_t begin, bool continued, bool utf8);

}  // namespace oncard::compiler
