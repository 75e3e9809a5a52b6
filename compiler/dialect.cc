#include "compiler/dialect.h"

#include "base/files.h"

namespace oncard::compiler {

bool WantsStructured(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::string_view line = Trim(text.substr(0, text.find('\n')));
  return line.starts_with(kToolComment) && Trim(line.substr(kToolComment.size())) == "structured";
}

bool IsAssertComment(std::string_view line) {
  constexpr std::string_view kWord = "assert";
  line = Trim(line);
  if (!line.starts_with(kToolComment)) return false;
  line = Trim(line.substr(kToolComment.size()));
  if (!line.starts_with(kWord)) return false;
  return line.size() == kWord.size() ||
         std::string_view(": \t").find(line[kWord.size()]) != std::string_view::npos;
}

}  // namespace oncard::compiler
