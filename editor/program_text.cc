#include "editor/program_text.h"

#include <algorithm>
#include <utility>

#include "base/limits.h"
#include "compiler/include_files.h"
#include "compiler/lexer.h"
#include "compiler/parser.hh"
#include "compiler/reporter.h"
#include "compiler/text.h"

namespace oncard::editor {
namespace {

using compiler::SourceRange;
using compiler::Token;
using Kind = compiler::Parser::token;

// Deeper files are not read; the compiler refuses them.
constexpr int kIncludeDepthMax = 32;

// Where a `//` comment ends: in structured C a `\` at the end of the line continues it.
size_t EndOfLineComment(std::string_view text, size_t begin, bool structured) {
  for (size_t end = begin;; ++end) {
    end = std::min(text.find('\n', end), text.size());
    if (end == text.size() || !structured) return end;
    size_t last = end;
    while (last > begin && (text[last - 1] == '\r' || text[last - 1] == ' ')) --last;
    if (last == begin || text[last - 1] != '\\') return end;
  }
}

// The comments between two tokens: nothing else but blanks and `\` stands there.
void AddComments(std::string_view text, size_t begin, size_t end, int file, bool structured,
                 std::vector<SourceRange>* comments) {
  for (size_t at = begin; at < end;) {
    if (text[at] != '/') {
      ++at;
      continue;
    }
    size_t close = end;
    if (text.substr(at, 2) == "/*") {
      const size_t found = text.find("*/", at + 2);
      if (found != std::string_view::npos) close = found + 2;
    } else {
      close = EndOfLineComment(text, at, structured);
      if (close > at && text[close - 1] == '\r') --close;
    }
    close = std::max(std::min(close, end), at + 1);
    comments->push_back({file, static_cast<uint32_t>(at), static_cast<uint32_t>(close)});
    at = close;
  }
}

}  // namespace

ProgramText::ProgramText(const std::string& path, std::string text,
                         const compiler::Options& options, const compiler::FileReader& reader)
    : dialect_(options.structured || compiler::WantsStructured(text)
                   ? compiler::Dialect::kStructured
                   : compiler::Dialect::kCard),
      catalogue_(options.catalogue) {
  Add(compiler::SourceFile(path, std::move(text)), options, reader, 0);
}

void ProgramText::Add(compiler::SourceFile source, const compiler::Options& options,
                      const compiler::FileReader& reader, int depth) {
  if (source.text().size() > kSourceKind.bytes_max - bytes_) return;
  bytes_ += source.text().size();
  const int index = static_cast<int>(files_.size());
  FileText& file = files_.emplace_back(std::move(source));
  compiler::Reporter reporter;  // the diagnostics of the compiler are another request
  file.tokens = compiler::Tokenize(file.file, index, kTokenMax - token_count_, *catalogue_,
                                   reporter, dialect_);
  token_count_ += file.tokens.size();

  const std::string_view text = file.file.text();
  uint32_t before = 0;
  for (const Token& token : file.tokens) {
    AddComments(text, before, token.range.begin, index, structured(), &file.comments);
    before = std::max(before, token.range.end);
  }
  AddComments(text, before, text.size(), index, structured(), &file.comments);

  const std::span<const Token> tokens = file.tokens;
  for (size_t i = 0; i < tokens.size();) {
    if (tokens[i].kind != Kind::kHash || !tokens[i].on_new_line) {
      file.orders.push_back(code_.size());
      code_.push_back(tokens[i++]);
      continue;
    }
    size_t end = i + 1;
    while (end < tokens.size() && !tokens[end].on_new_line) ++end;
    Directive directive;
    directive.tokens = tokens.subspan(i, end - i);
    if (directive.tokens.size() > 1) directive.word = directive.tokens[1].text;
    directive.range = {index, tokens[i].range.begin, tokens[end - 1].range.end};
    directive.order = code_.size();
    file.orders.insert(file.orders.end(), end - i, code_.size());
    file.directives.push_back(directive);
    directives_.push_back(directive);
    if (directive.word == "include") Include(directive, options, reader, depth);
    i = end;
  }
  file.orders.push_back(code_.size());
}

void ProgramText::Include(const Directive& directive, const compiler::Options& options,
                          const compiler::FileReader& reader, int depth) {
  const bool named = directive.tokens.size() == 3 && directive.tokens[2].kind == Kind::kString &&
                     directive.tokens[2].text.size() > 2;
  if (!named || depth == kIncludeDepthMax) return;
  const std::string name(directive.tokens[2].text.substr(1, directive.tokens[2].text.size() - 2));
  std::vector<std::string> beside = {file(directive.range.file).file.path()};
  if (directive.range.file != 0) beside.push_back(file(0).file.path());
  compiler::IncludedFile found = compiler::FindInclude(name, beside, options, reader);
  if (!found.found || Find(found.path)) return;
  Add(compiler::SourceFile(std::move(found.path), std::move(found.text)), options, reader,
      depth + 1);
}

std::optional<int> ProgramText::Find(std::string_view path) const {
  for (size_t i = 0; i < files_.size(); ++i) {
    if (files_[i].file.path() == path) return static_cast<int>(i);
  }
  return std::nullopt;
}

std::string_view ProgramText::TextOf(SourceRange range) const {
  return std::string_view(file(range.file).file.text())
      .substr(range.begin, range.end - range.begin);
}

size_t ProgramText::OrderAt(int index, uint32_t offset) const {
  const FileText& text = file(index);
  return text.orders.empty() ? code_.size() : text.orders[TokenAt(text.tokens, offset)];
}

uint32_t OffsetOf(const compiler::SourceFile& file, Place place) {
  const size_t size = file.text().size();
  if (place.line > file.line_count()) return static_cast<uint32_t>(size);
  const std::string_view line = file.Line(place.line);
  const bool utf8 = compiler::IsUtf8(line);
  size_t at = 0;
  for (int column = 1; column < place.column && at < line.size(); ++column) {
    at += compiler::CharacterLength(line.substr(at), utf8);
  }
  return static_cast<uint32_t>(static_cast<size_t>(line.data() - file.text().data()) +
                               std::min(at, line.size()));
}

size_t TokenAt(std::span<const Token> tokens, uint32_t offset) {
  const auto found = std::ranges::upper_bound(tokens, offset, {},
                                              [](const Token& token) { return token.range.end; });
  return static_cast<size_t>(found - tokens.begin());
}

}  // namespace oncard::editor
