// Tested by tests/compiler/explain_test.cc.
#include "compiler/explain.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>

#include "compiler/diagnostic.h"
#include "compiler/display_text.h"
#include "compiler/text.h"

namespace oncard::compiler {
namespace {

constexpr int kPageWidth = 80;
constexpr std::string_view kIndent = "    ";

// The raw strings of the tables begin with a line end, to make them readable there.
constexpr std::string_view Program(std::string_view text) {
  if (text.starts_with('\n')) text.remove_prefix(1);
  return text;
}

constexpr Explanation kExplanations[] = {
#define EXPLAIN(code, en, zh, failing, fixed) {code, en, zh, Program(failing), Program(fixed)},
#define EXPLAIN_FILE(code, name, text)
#include "compiler/explain_pages.def"
};

constexpr ExplanationFile kFiles[] = {
#define EXPLAIN(code, en, zh, failing, fixed)
#define EXPLAIN_FILE(code, name, text) {code, name, Program(text)},
#include "compiler/explain_pages.def"
};

// Replaces {0}, {1}, ... by `...`, and doubled braces, the escape of fmt, by single ones.
std::string WithoutArguments(std::string_view pattern) {
  std::string text;
  for (size_t i = 0; i < pattern.size(); ++i) {
    const char c = pattern[i];
    const bool brace = c == '{' || c == '}';
    if (brace && i + 1 < pattern.size() && pattern[i + 1] == c) {
      text += c;
      ++i;
    } else if (c == '{') {
      text += "...";
      i = pattern.find('}', i);
    } else {
      text += c;
    }
  }
  return text;
}

bool IsOneOf(std::string_view character, std::span<const std::string_view> set) {
  return std::find(set.begin(), set.end(), character) != set.end();
}

// Chinese text can be broken between any two characters, but a line must neither begin with a
// closing mark nor end with an opening one. Other text is broken at blanks.
bool MayBreak(std::string_view before, std::string_view after) {
  static constexpr std::array<std::string_view, 9> kClosing = {"，", "。", "；", "：", "、",
                                                               "）", "”",  "？", "！"};
  static constexpr std::array<std::string_view, 2> kOpening = {"（", "“"};
  const bool wide = before.size() > 1 || after.size() > 1;
  return wide && !IsOneOf(after, kClosing) && !IsOneOf(before, kOpening);
}

struct Piece {
  std::string_view text;
  bool blank_before;
};

std::vector<Piece> Pieces(std::string_view text) {
  std::vector<Piece> pieces;
  std::string_view before = " ";
  for (size_t i = 0; i < text.size();) {
    const std::string_view character = text.substr(i, CharacterLength(text.substr(i), true));
    if (character != " ") {
      if (before == " " || MayBreak(before, character)) {
        pieces.push_back({character, before == " "});
      } else {
        std::string_view& last = pieces.back().text;
        last = std::string_view(last.data(), last.size() + character.size());
      }
    }
    before = character;
    i += character.size();
  }
  return pieces;
}

int ColumnsOf(std::string_view text) { return DisplayLine(text).ColumnOf(text.size()); }

void AppendProgram(std::string& page, std::string_view title, std::string_view program) {
  page += fmt::format("\n{}\n\n", title);
  while (!program.empty()) {
    const std::string_view line = program.substr(0, program.find('\n'));
    if (!line.empty()) page += fmt::format("{}{}", kIndent, line);
    page += '\n';
    program.remove_prefix(std::min(program.size(), line.size() + 1));
  }
}

}  // namespace

void AppendWrapped(std::string& page, std::string_view text, std::string_view indent) {
  int column = 0;
  for (const Piece& piece : Pieces(text)) {
    const int blank = piece.blank_before ? 1 : 0;
    const int width = ColumnsOf(piece.text);
    if (column > 0 && column + blank + width <= kPageWidth) {
      page.append(static_cast<size_t>(blank), ' ');
      column += blank;
    } else {
      if (column > 0) page += '\n';
      page += indent;
      column = ColumnsOf(indent);
    }
    page += piece.text;
    column += width;
  }
  page += '\n';
}

const Explanation* FindExplanation(int code) {
  const auto row = std::find_if(std::begin(kExplanations), std::end(kExplanations),
                                [code](const Explanation& page) { return page.code == code; });
  return row != std::end(kExplanations) ? row : nullptr;
}

std::vector<ExplanationFile> ExplanationFiles(int code) {
  std::vector<ExplanationFile> files;
  std::copy_if(std::begin(kFiles), std::end(kFiles), std::back_inserter(files),
               [code](const ExplanationFile& file) { return file.code == code; });
  return files;
}

Message MessagePattern(int code) {
  const DiagnosticInfo* info = FindDiagnostic(code);
  if (info == nullptr) return {};
  return {WithoutArguments(info->en), WithoutArguments(info->zh)};
}

std::optional<std::string> ExplainPage(int code, Language language) {
  const DiagnosticInfo* info = FindDiagnostic(code);
  const Explanation* explanation = FindExplanation(code);
  if (info == nullptr || explanation == nullptr) return std::nullopt;
  const bool chinese = language == Language::kChinese;
  const Message severity =
      info->severity == Severity::kError ? Message{"error", "错误"} : Message{"warning", "警告"};

  std::string page =
      fmt::format("{} {} ({})\n\n", DiagnosticName(code), info->slug, severity.In(language));
  AppendWrapped(page, MessagePattern(code).In(language), kIndent);
  page += '\n';
  AppendWrapped(page, chinese ? explanation->zh : explanation->en, "");
  if (explanation->failing.empty()) return page;

  for (const ExplanationFile& file : ExplanationFiles(code)) {
    AppendProgram(page,
                  fmt::format(fmt::runtime(chinese ? "文件 {}：" : "The file {}:"), file.name),
                  file.text);
  }
  AppendProgram(page, chinese ? "出错的程序：" : "A program that causes it:", explanation->failing);
  AppendProgram(page, chinese ? "改正后：" : "The corrected program:", explanation->fixed);
  return page;
}

std::string ExplainList(std::span<const int> codes, Language language) {
  std::string list;
  for (const int code : codes) {
    list += fmt::format("{} {}\n", DiagnosticName(code), FindDiagnostic(code)->slug);
    AppendWrapped(list, MessagePattern(code).In(language), kIndent);
  }
  return list;
}

}  // namespace oncard::compiler
