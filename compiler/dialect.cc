#include "compiler/dialect.h"

#include "base/files.h"

namespace oncard::compiler {
namespace {

// What stands behind `//@ WORD:`; empty if there is no colon, nullopt for any other line.
std::optional<std::string_view> BehindWord(std::string_view line, std::string_view word) {
  line = Trim(line);
  if (!line.starts_with(kToolComment)) return std::nullopt;
  line = Trim(line.substr(kToolComment.size()));
  if (!line.starts_with(word)) return std::nullopt;
  line.remove_prefix(word.size());
  const std::string_view rest = Trim(line);
  if (rest.starts_with(':')) return Trim(rest.substr(1));
  // `assert x` lacks its colon; `asserted` is another word.
  if (rest.empty() || rest.size() < line.size()) return std::string_view();
  return std::nullopt;
}

}  // namespace

bool WantsStructured(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::string_view line = Trim(text.substr(0, text.find('\n')));
  return line.starts_with(kToolComment) && Trim(line.substr(kToolComment.size())) == "structured";
}

std::optional<std::string_view> AssertConditionOf(std::string_view line) {
  return BehindWord(line, "assert");
}

std::optional<std::string_view> DepthOf(std::string_view line) { return BehindWord(line, "depth"); }

}  // namespace oncard::compiler
