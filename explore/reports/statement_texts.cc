#include "explore/reports/statement_texts.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/trim.h"
#include "compiler/display_text.h"

namespace oncard::explore {
namespace {

using runtime::LoggedStep;

std::string_view FirstWord(std::string_view text) {
  const auto in_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  size_t size = 0;
  while (size < text.size() && in_word(text[size])) ++size;
  return text.substr(0, size);
}

std::string_view WithoutBlanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

/// A statement without the blanks and labels before it.
std::string_view WithoutLabels(std::string_view piece) {
  for (;;) {
    piece = WithoutBlanks(piece);
    const std::string_view label = FirstWord(piece);
    const std::string_view behind = WithoutBlanks(piece.substr(label.size()));
    if (label.empty() || !behind.starts_with(':')) return piece;
    piece = behind.substr(1);
  }
}

bool Declares(std::string_view statement) {
  constexpr std::array<std::string_view, 6> kTypes = {"int",   "double",   "long",
                                                      "short", "unsigned", "const"};
  return std::ranges::find(kTypes, FirstWord(statement)) != kTypes.end();
}

/// A program with blanks for its comments and directives; line ends stay.
std::string CodeOf(std::string_view text) {
  std::string code(text);
  for (size_t at = 0; at < code.size();) {
    const std::string_view rest = std::string_view(code).substr(at);
    size_t size = 0;
    if (rest.starts_with("//") || rest.starts_with('#')) size = rest.find('\n');
    if (rest.starts_with("/*")) size = rest.find("*/", 2);
    if (size == 0) {
      ++at;
      continue;
    }
    const size_t close = rest.starts_with("/*") ? 2 : 0;
    const size_t end = size == std::string_view::npos ? code.size() : at + size + close;
    for (; at < end; ++at) {
      if (code[at] != '\n') code[at] = ' ';
    }
  }
  return code;
}

}  // namespace

ProgramText TextOf(const compiler::Compilation& compilation) {
  if (compilation.files.empty()) return {};
  const compiler::SourceFile& program = compilation.files[0];
  return {program.text(), program.IniName(), compilation.places};
}

StatementTexts::StatementTexts(const ProgramText& program, const vm::Object& object)
    : program_(program), object_(object), code_(CodeOf(program.text)) {
  for (size_t begin = 0; begin < code_.size();) {
    const size_t end = std::min(code_.find('\n', begin), code_.size());
    lines_.push_back({begin, end});
    begin = end + 1;
  }
  FindParts();
}

/// What ends in a semicolon, without the braces and the head of the function before it.
void StatementTexts::FindParts() {
  int depth = 0;  // of parentheses: a `for` has semicolons in them
  size_t begin = 0;
  for (size_t at = 0; at < code_.size(); ++at) {
    const char c = code_[at];
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    const bool ends = c == ';' && depth <= 0;
    if (ends) {
      const std::string_view labelled =
          WithoutBlanks(std::string_view(code_).substr(begin, at + 1 - begin));
      const std::string_view text = WithoutLabels(labelled);
      if (text.size() > 1) {
        parts_.push_back(
            {at + 1 - labelled.size(), {at + 1 - text.size(), at + 1}, Declares(text)});
      }
    }
    if (ends || c == '{' || c == '}') {
      begin = at + 1;
      depth = 0;
    }
  }
}

bool StatementTexts::IsAlone(const Part& part, Span line) const {
  const std::string_view code = std::string_view(code_).substr(0, line.end);
  const size_t first = code.find_first_not_of(" \t\r", line.begin);
  const size_t last = code.find_last_not_of(" \t\r");
  return part.begin <= first && last + 1 == part.statement.end;
}

std::string StatementTexts::Shown(Span span) const {
  const std::string_view text =
      std::string_view(program_.text).substr(span.begin, span.end - span.begin);
  return compiler::DisplayLine(Trim(text)).text();
}

bool StatementTexts::IsOfFile(const LoggedStep& step) const {
  return program_.file.empty() ||
         object_.functions[static_cast<size_t>(step.function)].file == program_.file;
}

StatementTexts::Span StatementTexts::LineOf(const LoggedStep& step) const {
  const auto line = static_cast<size_t>(step.line);
  return step.line > 0 && line <= lines_.size() ? lines_[line - 1] : Span{};
}

const StatementTexts::Part* StatementTexts::PartAt(size_t place) const {
  const auto behind =
      std::ranges::upper_bound(parts_, place, {}, [](const Part& part) { return part.begin; });
  if (behind == parts_.begin()) return nullptr;
  const Part& part = *std::prev(behind);
  return place < part.statement.end ? &part : nullptr;
}

/// Without places: if each statement of the line is one instruction, as in the card's language, or
/// the line has only one.
const StatementTexts::Part* StatementTexts::CountedPart(const LoggedStep& step) const {
  const Span line = LineOf(step);
  std::vector<const Part*> statements;
  for (const Part& part : parts_) {
    if (line.Has(part.statement) && !part.declares) statements.push_back(&part);
  }
  if (statements.size() == 1 && IsAlone(*statements.front(), line)) return statements.front();
  const std::vector<uint16_t>& lines = object_.functions[static_cast<size_t>(step.function)].lines;
  const auto number = static_cast<uint16_t>(step.line);
  if (std::ranges::count(lines, number) != static_cast<int64_t>(statements.size())) return nullptr;
  const auto before = std::count(lines.begin(), lines.begin() + step.position, number);
  return statements[static_cast<size_t>(before)];
}

const StatementTexts::Part* StatementTexts::PartOf(const LoggedStep& step) const {
  if (!IsOfFile(step)) return nullptr;
  const auto function = static_cast<size_t>(step.function);
  const auto position = static_cast<size_t>(step.position);
  const auto& places = program_.places;
  if (function >= places.size() || position >= places[function].size()) return CountedPart(step);
  const compiler::SourceRange& place = places[function][position];
  return place.file == 0 ? PartAt(place.begin) : nullptr;
}

std::string StatementTexts::Of(const LoggedStep& step) const {
  const Span line = LineOf(step);
  if (program_.text.empty()) return {};
  if (!IsOfFile(step)) {
    return fmt::format("{}:{}", object_.functions[static_cast<size_t>(step.function)].file,
                       step.line);
  }
  const Part* part = PartOf(step);
  const bool apart = part != nullptr && line.Has(part->statement) && !IsAlone(*part, line);
  return Shown(apart ? part->statement : line);
}

bool StatementTexts::InOneStatement(const LoggedStep& one, const LoggedStep& other) const {
  const Part* part = PartOf(one);
  return part != nullptr && part == PartOf(other);
}

}  // namespace oncard::explore
