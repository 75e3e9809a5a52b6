#include "editor/analysis.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/command_help.h"

namespace oncard::editor {

Json RangeJson(const ProgramText& text, compiler::SourceRange range) {
  const compiler::SourceFile& file = text.file(range.file).file;
  return {{"file", file.path()},
          {"line", file.LineOf(range.begin)},
          {"column", file.ColumnOf(range.begin)},
          {"end_line", file.LineOf(range.end)},
          {"end_column", file.ColumnOf(range.end)}};
}

bool InComment(const ProgramText& text, Cursor cursor) {
  const auto& comments = text.file(cursor.file).comments;
  const auto after =
      std::ranges::lower_bound(comments, cursor.offset, {}, &compiler::SourceRange::begin);
  if (after == comments.begin()) return false;
  const compiler::SourceRange& comment = *(after - 1);
  // The place after `*/` is outside, the one at the end of a line is not.
  const bool block = text.TextOf(comment).ends_with("*/");
  return cursor.offset < comment.end || (cursor.offset == comment.end && !block);
}

std::string_view KindName(Symbol::Kind kind) {
  switch (kind) {
    case Symbol::Kind::kFunction:
      return "function";
    case Symbol::Kind::kGlobal:
      return "global";
    case Symbol::Kind::kLocal:
      return "local";
    case Symbol::Kind::kParameter:
      return "parameter";
    case Symbol::Kind::kLabel:
      return "label";
    case Symbol::Kind::kMacro:
      return "macro";
    case Symbol::Kind::kMacroParameter:
      return "macro-parameter";
    case Symbol::Kind::kConstant:
      return "constant";
    case Symbol::Kind::kEnumeration:
      return "enum";
    case Symbol::Kind::kStructure:
      return "struct";
    case Symbol::Kind::kType:
      return "typedef";
    case Symbol::Kind::kMember:
      return "member";
    case Symbol::Kind::kCommand:
      break;
  }
  return "command";
}

std::string Spell(const ProgramText& text, std::span<const compiler::Token> tokens) {
  std::string spelled;
  for (size_t i = 0; i < tokens.size(); ++i) {
    const bool apart = i > 0 && tokens[i].range.begin != tokens[i - 1].range.end;
    if (apart) spelled += ' ';
    spelled += text.TextOf(tokens[i].range);
  }
  return spelled;
}

std::string Declaration(const Analysis& analysis, const Symbol& symbol) {
  const std::string_view star = symbol.pointer ? " *" : " ";
  switch (symbol.kind) {
    case Symbol::Kind::kCommand:
      return Prototype(*symbol.command);
    case Symbol::Kind::kMacro: {
      const Symbol::Declaration& last = symbol.declarations.back();
      for (const Directive& directive : analysis.text.file(last.whole.file).directives) {
        if (directive.range == last.whole) return Spell(analysis.text, directive.tokens);
      }
      break;
    }
    case Symbol::Kind::kLabel:
      return fmt::format("{}:", symbol.name);
    case Symbol::Kind::kMacroParameter:
      break;
    case Symbol::Kind::kConstant:
      return symbol.value.empty()
                 ? std::string(symbol.name)
                 : fmt::format("{} = {}", symbol.name, Spell(analysis.text, symbol.value));
    case Symbol::Kind::kEnumeration:
      return fmt::format("enum {}", symbol.name);
    case Symbol::Kind::kStructure:
      return fmt::format("struct {}", symbol.name);
    case Symbol::Kind::kType:  // whose words begin with `typedef`
    case Symbol::Kind::kMember:
    case Symbol::Kind::kFunction:
      return fmt::format("{}{}{}{}", symbol.type, star, symbol.name, symbol.suffix);
    case Symbol::Kind::kGlobal:
    case Symbol::Kind::kLocal:
    case Symbol::Kind::kParameter:
      return symbol.value.empty()
                 ? fmt::format("{}{}{}{}", symbol.type, star, symbol.name, symbol.suffix)
                 : fmt::format("{}{}{}{} = {}", symbol.type, star, symbol.name, symbol.suffix,
                               Spell(analysis.text, symbol.value));
  }
  return std::string(symbol.name);
}

}  // namespace oncard::editor
