#include "compiler/source_comments.h"

#include "compiler/dialect.h"
#include "compiler/text.h"

namespace oncard::compiler {
namespace {

// Whether the comment that begins at a place is a line for tools.
bool IsForTools(std::string_view text, size_t begin) {
  if (!text.substr(begin).starts_with(kToolComment)) return false;
  const size_t before = text.substr(0, begin).find_last_not_of(" \t\r");
  return before == std::string_view::npos || text[before] == '\n';
}

// Where a comment ends; npos: nowhere.
size_t EndOfComment(std::string_view text, size_t begin, bool utf8) {
  if (text.substr(begin).starts_with("//")) return EndOfLineComment(text, begin, true, utf8);
  const size_t close = text.find("*/", begin + 2);
  return close == std::string_view::npos ? close : close + 2;
}

}  // namespace

void AppendComments(std::string_view text, int file, const std::vector<Token>& tokens,
                    std::vector<SourceComment>* comments) {
  const bool utf8 = IsUtf8(text);
  SourceComment comment;
  comment.range.file = file;
  // Between two words there are only blanks and comments.
  size_t gap = 0;
  for (size_t next = 0; next <= tokens.size(); ++next) {
    const bool last = next == tokens.size();
    const size_t gap_end = last ? text.size() : tokens[next].range.begin;
    const std::string_view before = text.substr(0, gap_end);
    comment.behind = static_cast<uint32_t>(gap_end);
    size_t at = before.find('/', gap);
    if (at != std::string_view::npos) {
      const size_t first_line_end = before.find('\n', gap);
      const size_t last_line_end = before.substr(gap).rfind('\n');
      while (at != std::string_view::npos) {
        const size_t end = EndOfComment(text, at, utf8);
        if (end == std::string_view::npos) return;
        const bool code_before = next > 0 && first_line_end > at;
        const bool code_behind =
            !last && (last_line_end == std::string_view::npos || gap + last_line_end < end);
        comment.range.begin = static_cast<uint32_t>(at);
        comment.range.end = static_cast<uint32_t>(end);
        comment.alone = !code_before && !code_behind;
        if (!IsForTools(text, at)) comments->push_back(comment);
        at = before.find('/', end);
      }
    }
    if (last) return;
    comment.before = tokens[next].range.begin;
    gap = tokens[next].range.end;
  }
}

}  // namespace oncard::compiler
