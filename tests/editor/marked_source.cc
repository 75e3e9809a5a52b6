#include "tests/editor/marked_source.h"

#include <cctype>

#include "base/files.h"

namespace oncard::editor {

MarkedSource::MarkedSource(std::string_view marked, bool structured) : structured_(structured) {
  constexpr std::string_view kHead = "=== ";
  std::string path = "p.c";
  Place place;
  for (size_t at = 0; at < marked.size();) {
    if (place.column == 1 && marked.substr(at).starts_with(kHead)) {
      const size_t end = marked.find('\n', at);
      path = marked.substr(at + kHead.size(), end - at - kHead.size());
      place = {};
      at = end + 1;
      continue;
    }
    if (main_.empty()) main_ = path;
    std::string& text = files_[path];
    if (marked[at] == '$' && at + 1 < marked.size() &&
        std::isdigit(static_cast<unsigned char>(marked[at + 1])) != 0) {
      marks_[marked[at + 1] - '0'] = {path, static_cast<uint32_t>(text.size()), place};
      at += 2;
      continue;
    }
    text += marked[at];
    if (marked[at] == '\n') {
      place = {place.line + 1, 1};
    } else if ((static_cast<unsigned char>(marked[at]) & 0xC0) != 0x80) {
      ++place.column;
    }
    ++at;
  }
}

compiler::FileReader MarkedSource::Reader() const {
  return [files = files_](const std::string& path) -> Result<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return MakeError(kNoSuchFile, "no {}", "没有 {}", path);
    return found->second;
  };
}

compiler::Options MarkedSource::Options() const {
  compiler::Options options;
  options.structured = structured_;
  return options;
}

const MarkedSource::Mark* MarkedSource::FindMark(int number) const {
  const auto found = marks_.find(number);
  return found == marks_.end() ? nullptr : &found->second;
}

AnalysedSource::AnalysedSource(std::string_view marked, bool structured)
    : MarkedSource(marked, structured),
      analysis_(main(), files().at(main()), Options(), Reader()),
      compilation_(compiler::CompileText(main(), files().at(main()), Options(), Reader())) {}

Cursor AnalysedSource::cursor(int number) const {
  return {analysis_.text.Find(mark(number).path).value_or(0), mark(number).offset};
}

std::string AnalysedSource::Apply(const Json& edits) const {
  const compiler::SourceFile& file = analysis_.text.file(0).file;
  std::string text = file.text();
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
    const uint32_t begin = OffsetOf(file, {(*edit)["line"], (*edit)["column"]});
    const uint32_t end = OffsetOf(file, {(*edit)["end_line"], (*edit)["end_column"]});
    text.replace(begin, end - begin, (*edit)["text"].get<std::string>());
  }
  return text;
}

std::string TestName(std::string_view rule) {
  std::string name(rule);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

}  // namespace oncard::editor
