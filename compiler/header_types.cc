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

}  // namespace

std::string_view TypeForHeaderType(std::string_view word) {
  if (!word.ends_with(kEnd)) return {};
  word.remove_suffix(kEnd.size());
  if (word == "size" || word == "uintptr") return "unsigned int";
  if (word == "ptrdiff" || word == "intptr") return "int";
  if (word == "intmax") return "long long";
  if (word == "uintmax") return "unsigned long long";
  const bool is_unsigned = Take(word, "u");
  if (!Take(word, "int")) return {};
  if (!Take(word, "_least")) Take(word, "_fast");
  const auto* const width = std::find_if(std::begin(kWidths), std::end(kWidths),
                                         [word](const Width& row) { return row.digits == word; });
  if (width == std::end(kWidths)) return {};
  return is_unsigned ? width->without_sign : width->with_sign;
}

}  // namespace oncard::compiler
