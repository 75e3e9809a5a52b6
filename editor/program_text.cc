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

// What decides where comments end.
struct CommentedText {
  std::string_view text;
  bool structured = false;
  bool utf8 = false;
};

// The comments between two tokens: nothing else but blanks and `\` stands there.
void AddComments(const CommentedText& source, size_t begin, size_t end, int file,
                 std::vector<SourceRange>* comments) {
  const std::string_view text = source.text;
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
      close = compiler::EndOfLineComment(text, at, source.structured, source.utf8);
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
    : dialect_(compiler::IsStructured(options, text) ? compiler::Dialect::kStructured
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
  const CommentedText source_text = {text, structured(), compiler::IsUtf8(text)};
  uint32_t before = 0;
  for (const Token& token : file.tokens) {
    AddComments(source_text, before, token.range.begin, index, &file.comments);
    before = std::max(before, token.range.end);
  }
  AddComments(source_text, before, text.size(), index, &file.comments);

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
