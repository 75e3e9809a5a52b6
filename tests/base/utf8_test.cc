#include "base/utf8.h"

#include <gtest/gtest.h>

namespace oncard {
namespace {

// The first and the last character of each length.
TEST(Utf8, TakesAsManyBytesAsACharacterNeeds) {
  std::string text;
  for (const char32_t code : {0x1u, 0x7Fu, 0x80u, 0x7FFu, 0x800u, 0xFFFFu, 0x10000u, 0x10FFFFu}) {
    AppendUtf8(text, code);
  }
  EXPECT_EQ(text,
            "\x01\x7F"
            "\xC2\x80\xDF\xBF"
            "\xE0\xA0\x80\xEF\xBF\xBF"
            "\xF0\x90\x80\x80\xF4\x8F\xBF\xBF");
}

}  // namespace
}  // namespace oncard
