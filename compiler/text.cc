#include "compiler/text.h"

#include <algorithm>
#include <cstdint>

namespace oncard::compiler {
namespace {

uint8_t Byte(char c) { return static_cast<uint8_t>(c); }

// Length of the well-formed UTF-8 sequence at the beginning, 0 if there is none.
size_t Utf8Length(std::string_view text) {
  const uint8_t lead = Byte(text[0]);
  if (lead < 0x80) return 1;
  size_t length = 0;
  uint8_t low = 0x80;
  uint8_t high = 0xBF;
  if (lead >= 0xC2 && lead <= 0xDF) {
    length = 2;
  } else if (lead >= 0xE0 && lead <= 0xEF) {
    length = 3;
    if (lead == 0xE0) low = 0xA0;   // longer encodings than necessary are not allowed
    if (lead == 0xED) high = 0x9F;  // nor are surrogates
  } else if (lead >= 0xF0 && lead <= 0xF4) {
    length = 4;
    if (lead == 0xF0) low = 0x90;
    if (lead == 0xF4) high = 0x8F;  // nor is anything past U+10FFFF
  }
  if (length == 0 || text.size() < length) return 0;
  if (Byte(text[1]) < low || Byte(text[1]) > high) return 0;
  for (size_t i = 2; i < length; ++i) {
    if (Byte(text[i]) < 0x80 || Byte(text[i]) > 0xBF) return 0;
  }
  return length;
}

}  // namespace

bool IsUtf8(std::string_view text) {
  while (!text.empty()) {
    const size_t length = Utf8Length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

size_t CharacterLength(std::string_view text, bool utf8) {
  if (utf8) return std::max<size_t>(1, Utf8Length(text));
  const bool pair = text.size() >= 2 && Byte(text[0]) >= 0x81 && Byte(text[0]) <= 0xFE &&
                    Byte(text[1]) >= 0x40 && Byte(text[1]) <= 0xFE && Byte(text[1]) != 0x7F;
  return pair ? 2 : 1;
}

size_t EndOfLineComment(std::string_view text, size_t begin, bool continued, bool utf8) {
  if (!continued) return std::min(text.find('\n', begin), text.size());
  bool backslash = false;  // the last character that is no blank
  for (size_t at = begin; at < text.size();) {
    const char c = text[at];
    if (c == '\n' && !backslash) return at;
    const size_t length = CharacterLength(text.substr(at), utf8);
    const bool blank = c == ' ' || c == '\t' || c == '\r';
    if (!blank) backslash = length == 1 && c == '\\';
    at += length;
  }
  return text.size();
}

}  // namespace oncard::compiler
