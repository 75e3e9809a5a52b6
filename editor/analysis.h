// A program with its names: what every answer is made of. The answers are functions of their own:
// describe.h, complete.h, places.h, overview.h. They are JSON with the members that
// docs/session-protocol.md describes, and depend on nothing but their arguments.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/message.h"
#include "editor/names.h"
#include "editor/program_text.h"

namespace oncard::editor {

using Json = nlohmann::ordered_json;

struct Analysis {
  Analysis(const std::string& path, std::string source, const compiler::Options& options,
           const compiler::FileReader& reader)
      : text(path, std::move(source), options, reader), names(text) {}
  // The names point into the text.
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;

  ProgramText text;
  Names names;
};

/// A place in a program: an offset in the text of one of its files.
struct Cursor {
  int file = 0;
  uint32_t offset = 0;
};

/// `file`, `line`, `column`, `end_line` and `end_column`.
Json RangeJson(const ProgramText& text, compiler::SourceRange range);

/// Whether a place is inside a comment.
bool InComment(const ProgramText& text, Cursor cursor);

/// What a symbol is called in answers, such as `global` or `command`.
std::string_view KindName(Symbol::Kind kind);
/// As its program declares it: `int a[3]`, `int f(int k)`, `#define N 4`.
std::string Declaration(const Analysis& analysis, const Symbol& symbol);
/// The tokens as text, with single blanks where there are any.
std::string Spell(const ProgramText& text, std::span<const compiler::Token> tokens);

}  // namespace oncard::editor
