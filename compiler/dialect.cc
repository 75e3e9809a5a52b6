#include "compiler/dialect.h"

#include "base/files.h"

namespace oncard::compiler {

bool WantsStructured(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::string_view line = Trim(text.substr(0, text.find('\n')));
  return line.starts_with(kToolComment) && Trim(line.substr(kToolComment.size())) == "structured";
}

}  // namespace oncard::compiler
