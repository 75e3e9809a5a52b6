#include "compiler/depth_comments.h"

#include <charconv>

#include "compiler/dialect.h"

namespace oncard::compiler {
namespace {

std::optional<int> ReadDepth(std::string_view text) {
  int depth = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, depth);
  if (error != std::errc() || rest != end || depth < 1 || depth > kFramesMax) return std::nullopt;
  return depth;
}

}  // namespace

std::vector<DepthComment> FindDepths(const std::deque<SourceFile>& files) {
  std::vector<DepthComment> comments;
  for (size_t number = 0; number < files.size(); ++number) {
    const std::string_view text = files[number].text();
    ForEachCommentLine(text, [&](int /*line*/, std::string_view line) {
      const std::optional<std::string_view> depth = DepthOf(line);
      if (depth) comments.push_back({RangeOf(number, text, Trim(line)), ReadDepth(*depth)});
    });
  }
  return comments;
}

bool IsRightAbove(std::string_view text, const SourceRange& comment, const SourceRange& function) {
  std::string_view between = text.substr(comment.end, function.begin - comment.end);
  // The rest of the comment's line; then lines that are comments.
  for (size_t line_end = between.find('\n'); line_end != std::string_view::npos;
       line_end = between.find('\n')) {
    between.remove_prefix(line_end + 1);
    const std::string_view line = Trim(between.substr(0, between.find('\n')));
    const bool last = between.find('\n') == std::string_view::npos;
    const bool is_comment =
        line.starts_with("//") || line.starts_with("/*") || line.starts_with("*");
    if (!last && !is_comment) return false;
  }
  return true;
}

}  // namespace oncard::compiler
