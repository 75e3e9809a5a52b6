#include "explore/reports/statement_texts.h"

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

/// A statement without blanks and labels.
std::string_view WithoutLabels(std::string_view piece) {
  for (;;) {
    piece = Trim(piece);
    const std::string_view label = FirstWord(piece);
    const std::string_view behind = Trim(piece.substr(label.size()));
    if (label.empty() || !behind.starts_with(':')) return piece;
    piece = behind.substr(1);
  }
}

bool Declares(std::string_view statement) {
  constexpr std::array<std::string_view, 6> kTypes = {"int",   "double",   "long",
                                                      "short", "unsigned", "const"};
  return std::ranges::find(kTypes, FirstWord(statement)) != kTypes.end();
}

/// A line with blanks for its comments.
std::string WithoutComments(std::string_view line) {
  std::string text(line);
  for (size_t at = 0; at + 1 < text.size(); ++at) {
    if (text[at] != '/' || (text[at + 1] != '*' && text[at + 1] != '/')) continue;
    const size_t close = text[at + 1] == '/' ? std::string::npos : text.find("*/", at + 2);
    const size_t end = close == std::string::npos ? text.size() : close + 2;
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(at),
              text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
  }
  return text;
}

}  // namespace

ProgramText TextOf(const compiler::Compilation& compilation) {
  if (compilation.files.empty()) return {};
  return {compilation.files[0].text(), compilation.places};
}

StatementTexts::StatementTexts(const ProgramText& program, const vm::Object& object)
    : program_(program), object_(object) {
  const std::string_view source = program.text;
  for (size_t begin = 0; begin < source.size();) {
    const size_t end = std::min(source.find('\n', begin), source.size());
    Line line;
    line.begin = begin;
    line.text = compiler::DisplayLine(source.substr(begin, end - begin)).text();
    const std::string code = WithoutComments(line.text);
    line.parts = PartsOf(code);
    line.alone = line.parts.size() == 1 &&
                 Trim(code) == Trim(std::string_view(code).substr(
                                   line.parts[0].begin, line.parts[0].end - line.parts[0].begin));
    lines_.push_back(std::move(line));
    begin = end + 1;
  }
}

/// The statements of a line, each with its semicolon, and what stands before and between them.
std::vector<StatementTexts::Part> StatementTexts::PartsOf(const std::string& code) {
  std::vector<Part> parts;
  int depth = 0;  // of parentheses: a `for` has semicolons in them
  size_t begin = 0;
  for (size_t at = 0; at < code.size(); ++at) {
    const char c = code[at];
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    const bool brace = c == '{' || c == '}';
    if (c == ';' && depth <= 0) {
      Part part = {begin, at + 1, {}, false};
      part.statement = WithoutLabels(std::string_view(code).substr(begin, at + 1 - begin));
      part.declares = Declares(part.statement);
      if (part.statement.size() > 1) parts.push_back(std::move(part));
    }
    if (brace || (c == ';' && depth <= 0)) begin = at + 1;
  }
  return parts;
}

const StatementTexts::Line* StatementTexts::LineOf(const LoggedStep& step) const {
  if (step.line <= 0 || static_cast<size_t>(step.line) > lines_.size()) return nullptr;
  return &lines_[static_cast<size_t>(step.line) - 1];
}

const StatementTexts::Part* StatementTexts::PlacedPart(const Line& line,
                                                       const compiler::SourceRange& place) const {
  const size_t end = std::min(program_.text.find('\n', line.begin), program_.text.size());
  if (place.file != 0 || place.begin < line.begin || place.begin >= end) return nullptr;
  const std::string_view before =
      std::string_view(program_.text).substr(line.begin, place.begin - line.begin);
  const size_t at = compiler::DisplayLine(before).text().size();
  const auto found = std::ranges::find_if(
      line.parts, [at](const Part& part) { return part.begin <= at && at < part.end; });
  return found == line.parts.end() ? nullptr : &*found;
}

const StatementTexts::Part* StatementTexts::PartOf(const Line& line, const LoggedStep& step) const {
  const size_t function = static_cast<size_t>(step.function);
  const size_t position = static_cast<size_t>(step.position);
  if (function < program_.places.size() && position < program_.places[function].size()) {
    return PlacedPart(line, program_.places[function][position]);
  }
  // Without places: if each statement is one instruction, as in the card's language.
  const std::vector<uint16_t>& lines = object_.functions[function].lines;
  const auto number = static_cast<uint16_t>(step.line);
  auto before = std::count(lines.begin(), lines.begin() + step.position, number);
  const auto statements =
      std::ranges::count_if(line.parts, [](const Part& part) { return !part.declares; });
  if (std::ranges::count(lines, number) != statements) return nullptr;
  for (const Part& part : line.parts) {
    if (!part.declares && before-- == 0) return &part;
  }
  return nullptr;
}

std::string StatementTexts::Of(const LoggedStep& step) const {
  const Line* line = LineOf(step);
  if (line == nullptr) return {};
  const Part* part = line->alone ? nullptr : PartOf(*line, step);
  return part != nullptr ? part->statement : std::string(Trim(line->text));
}

bool StatementTexts::InOneStatement(const LoggedStep& one, const LoggedStep& other) const {
  const Line* line = LineOf(one);
  if (line == nullptr || one.function != other.function || one.line != other.line) return false;
  const Part* part = PartOf(*line, one);
  return line->alone || (part != nullptr && part == PartOf(*line, other));
}

}  // namespace oncard::explore
