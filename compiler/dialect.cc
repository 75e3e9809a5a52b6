#include "compiler/dialect.h"

#include <algorithm>

#include "base/files.h"

namespace oncard::compiler {
namespace {

constexpr std::string_view kMark = "//@";
constexpr std::string_view kBlanks = " \t\r";

void SkipBlanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
}

}  // namespace

bool WantsStructured(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  text = text.substr(0, text.find('\n'));
  SkipBlanks(text);
  if (!text.starts_with(kMark)) return false;
  text.remove_prefix(kMark.size());
  SkipBlanks(text);
  return text.substr(0, text.find_last_not_of(kBlanks) + 1) == "structured";
}

}  // namespace oncard::compiler
