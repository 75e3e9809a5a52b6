#include "compiler/header_types.h"

#include <algorithm>
#include <iterator>

namespace oncard::compiler {
namespace {

constexpr std::string_view kEnd = "_t";

struct Width {
  std::string_view digits;
  std::string_view with_sign;
  std::string_view without_sign;
};

constexpr Width kWidths[] = {{"8", "char", "unsigned char"},
                             {"16", "short", "unsigned short"},
                             {"32", "int", "unsigned int"},
                             {"64", "long long", "unsigned long long"}};

bool Take(std::string_view& text, std::string_view begin) {
  if (!text.starts_with(begin)) return false;
  text.remove_prefix(begin.size());
  return true;
}

struct Header {
  std::string_view name;
  std::string_view text;
};

// The least int and long cannot be written as one number, as in C.
constexpr Header kHeaders[] = {{"gts.h", ""},
                               {"stdbool.h", ""},
                               {"stddef.h", ""},
                               {"limits.h", R"(#define CHAR_BIT 8
#define CHAR_MIN (-128)
#define CHAR_MAX 127
#define SCHAR_MIN (-128)
#define SCHAR_MAX 127
#define UCHAR_MAX 255
#define SHRT_MIN (-32768)
#define SHRT_MAX 32767
#define USHRT_MAX 65535
#define INT_MIN (-2147483647 - 1)
#define INT_MAX 2147483647
#define UINT_MAX 4294967295U
#define LONG_MIN (-2147483647 - 1)
#define LONG_MAX 2147483647
#define ULONG_MAX 4294967295U
)"},
                               {"stdint.h", R"(#define INT8_MIN (-128)
#define INT8_MAX 127
#define UINT8_MAX 255
#define INT16_MIN (-32768)
#define INT16_MAX 32767
#define UINT16_MAX 65535
#define INT32_MIN (-2147483647 - 1)
#define INT32_MAX 2147483647
#define UINT32_MAX 4294967295U
#define INT_LEAST8_MIN (-128)
#define INT_LEAST8_MAX 127
#define UINT_LEAST8_MAX 255
#define INT_LEAST16_MIN (-32768)
#define INT_LEAST16_MAX 32767
#define UINT_LEAST16_MAX 65535
#define INT_LEAST32_MIN (-2147483647 - 1)
#define INT_LEAST32_MAX 2147483647
#define UINT_LEAST32_MAX 4294967295U
#define INT_FAST8_MIN (-128)
#define INT_FAST8_MAX 127
#define UINT_FAST8_MAX 255
#define INT_FAST16_MIN (-2147483647 - 1)
#define INT_FAST16_MAX 2147483647
#define UINT_FAST16_MAX 4294967295U
#define INT_FAST32_MIN (-2147483647 - 1)
#define INT_FAST32_MAX 2147483647
#define UINT_FAST32_MAX 4294967295U
#define INTPTR_MIN (-2147483647 - 1)
#define INTPTR_MAX 2147483647
#define UINTPTR_MAX 4294967295U
#define PTRDIFF_MIN (-2147483647 - 1)
#define PTRDIFF_MAX 2147483647
#define SIZE_MAX 4294967295U
)"}};

}  // namespace

std::optional<std::string_view> TextOfKnownHeader(std::string_view name) {
  const auto* const header = std::find_if(std::begin(kHeaders), std::end(kHeaders),
                                          [name](const Header& row) { return row.name == name; });
  if (header == std::end(kHeaders)) return std::nullopt;
  return header->text;
}

std::string_view TypeForHeaderType(std::string_view word) {
  if (!word.ends_with(kEnd)) return {};
  word.remove_suffix(kEnd.size());
  if (word == "size" || word == "uintptr") return "unsigned int";
  if (word == "ptrdiff" || word == "intptr") return "int";
  if (word == "intmax") return "long long";
  if (word == "uintmax") return "unsigned long long";
  const bool is_unsigned = Take(word, "u");
  if (!Take(word, "int")) return {};
  // The fast ones are as fast with 32 bits as with 16, and have them.
  if (!Take(word, "_least") && Take(word, "_fast") && word == "16") word = "32";
  const auto* const width = std::find_if(std::begin(kWidths), std::end(kWidths),
                                         [word](const Width& row) { return row.digits == word; });
  if (width == std::end(kWidths)) return {};
  return is_unsigned ? width->without_sign : width->with_sign;
}

}  // namespace oncard::compiler
