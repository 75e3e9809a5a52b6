#include "compiler/macro_expander.h"

#include <algorithm>
#include <iterator>

#include "base/limits.h"
#include "compiler/lexer.h"
#include "compiler/parser.hh"
#include "compiler/parser_driver.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;

std::pair<int, uint64_t> KeyOf(SourceRange range) {
  return {range.file, (uint64_t{range.begin} << 32) | range.end};
}

}  // namespace

const MacroUses::Macro* MacroUses::Find(SourceRange range) const {
  const auto found = macros_.find(KeyOf(range));
  return found == macros_.end() ? nullptr : &found->second;
}

void MacroUses::Add(SourceRange range, const MacroDefinition& macro) {
  macros_.emplace(KeyOf(range), Macro{macro.name, macro.name_range});
}

const MacroDefinition* MacroExpander::Find(std::string_view name) const {
  const auto found = macros_.find(name);
  return found == macros_.end() ? nullptr : found->second;
}

void MacroExpander::Define(MacroDefinition definition) {
  definitions_.push_back(std::move(definition));
  macros_[definitions_.back().name] = &definitions_.back();
}

bool MacroExpander::Expand(std::span<const Token> text, std::vector<Token>* out) {
  if (!Count(text.size())) return false;
  Expansion expansion;
  Source& source = expansion.sources.emplace_back();
  source.pieces.reserve(text.size());
  for (const Token& token : text) source.pieces.push_back({token});
  std::vector<Piece> pieces;
  Run(expansion, &pieces);
  out->reserve(out->size() + pieces.size());
  for (Piece& piece : pieces) out->push_back(piece.token);
  return count_ <= kTokenMax;
}

// The next token, or nullptr. Leaves the macros that have been read to their end.
const MacroExpander::Piece* MacroExpander::Peek(Expansion& expansion) {
  for (;;) {
    const Source& source = expansion.sources.back();
    if (source.next < source.pieces.size()) return &source.pieces[source.next];
    if (expansion.sources.size() == 1) return nullptr;
    expansion.sources.pop_back();
  }
}

bool MacroExpander::IsActive(const Expansion& expansion, const MacroDefinition& macro) {
  return std::find(expansion.outside.begin(), expansion.outside.end(), &macro) !=
             expansion.outside.end() ||
         std::any_of(expansion.sources.begin(), expansion.sources.end(),
                     [&macro](const Source& source) { return source.macro == &macro; });
}

bool MacroExpander::Count(size_t tokens) {
  count_ = std::min(count_ + tokens, kTokenMax + 1);
  return count_ <= kTokenMax;
}

MacroExpander::Piece MacroExpander::Invalid(SourceRange range) {
  Piece piece;
  piece.token.kind = Kind::kInteger;
  piece.token.range = range;
  piece.token.text = "0";
  piece.token.literal.invalid = true;
  return piece;
}

void MacroExpander::Run(Expansion& expansion, std::vector<Piece>* out) {
  while (Peek(expansion) != nullptr && count_ <= kTokenMax) {
    Source& source = expansion.sources.back();
    Piece piece = source.pieces[source.next++];
    const MacroDefinition* const macro =
        IsWord(piece.token) && !piece.final ? Find(piece.token.text) : nullptr;
    if (macro == nullptr) {
      out->push_back(piece);
      continue;
    }
    if (IsActive(expansion, *macro)) {
      piece.final = true;
      out->push_back(piece);
      continue;
    }
    SourceRange use = piece.token.range;
    Arguments arguments;
    if (macro->has_parameters) {
      // Without a parenthesis the name is no call of the macro.
      const Piece* const next = Peek(expansion);
      if (next == nullptr || next->token.kind != Kind::kOpenParen) {
        out->push_back(piece);
        continue;
      }
      if (!ReadArguments(expansion, *macro, &use, &arguments)) {
        out->push_back(Invalid(use));
        continue;
      }
    }
    uses_.Add(use, *macro);
    Source body;
    body.macro = macro;
    body.pieces = Substitute(expansion, *macro, arguments, use);
    if (!body.pieces.empty()) {
      body.pieces.front().token.on_new_line = piece.token.on_new_line;
    }
    if (!Count(body.pieces.size())) return;
    expansion.sources.push_back(std::move(body));
  }
}

// Reads `(a, b)` and extends the range of the use to it. False, with a report, if it does not fit
// the macro.
bool MacroExpander::ReadArguments(Expansion& expansion, const MacroDefinition& macro,
                                  SourceRange* use, Arguments* arguments) {
  const SourceRange name = *use;
  const size_t after_open = expansion.sources.front().next + 1;
  int depth = 0;
  for (const Piece* next = Peek(expansion); next != nullptr; next = Peek(expansion)) {
    const Piece piece = *next;
    ++expansion.sources.back().next;
    const int kind = piece.token.kind;
    if (kind == Kind::kCloseParen && --depth == 0) {
      *use = Join(name, piece.token.range);
      break;
    }
    const bool opens = kind == Kind::kOpenParen && depth++ == 0;
    if (opens || (kind == Kind::kComma && depth == 1)) {
      arguments->emplace_back();
    } else {
      arguments->back().push_back(piece);
    }
  }
  if (depth != 0) {
    AddNote(reporter_.Report(Code::kMacroNotClosed, name, macro.name), macro.name_range,
            MakeMessage("the macro is defined here", "宏在此处定义"));
    // The text that is no argument is read as it is.
    Source& text = expansion.sources.front();
    text.next = std::min(after_open, text.pieces.size());
    return false;
  }
  // `()` is one empty argument, or none.
  if (macro.parameters.empty() && arguments->size() == 1 && arguments->front().empty()) {
    arguments->clear();
  }
  if (arguments->size() == macro.parameters.size()) return true;
  AddNote(reporter_.Report(Code::kMacroArguments, *use, macro.name,
                           static_cast<int64_t>(macro.parameters.size()),
                           static_cast<int64_t>(arguments->size())),
          macro.name_range, MakeMessage("the macro is defined here", "宏在此处定义"));
  return false;
}

// The body of a macro at its use, with the expanded arguments in it.
std::vector<MacroExpander::Piece> MacroExpander::Substitute(const Expansion& expansion,
                                                            const MacroDefinition& macro,
                                                            const Arguments& arguments,
                                                            SourceRange use) {
  Arguments expanded(arguments.size());
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (expansion.depth == kDepthMax) {
      reporter_.Report(Code::kTooDeep, use, int64_t{kDepthMax});
      return {Invalid(use)};
    }
    Expansion argument;
    argument.depth = expansion.depth + 1;
    argument.outside = expansion.outside;
    for (const Source& source : expansion.sources) {
      if (source.macro != nullptr) argument.outside.push_back(source.macro);
    }
    argument.sources.emplace_back().pieces = arguments[i];
    Run(argument, &expanded[i]);
  }
  std::vector<Piece> pieces;
  for (const Token& token : macro.body) {
    const auto parameter = std::find(macro.parameters.begin(), macro.parameters.end(), token.text);
    if (parameter == macro.parameters.end()) {
      Piece& piece = pieces.emplace_back(Piece{token});
      piece.token.range = use;
      piece.token.on_new_line = false;
      continue;
    }
    const std::vector<Piece>& argument =
        expanded[static_cast<size_t>(parameter - macro.parameters.begin())];
    if (pieces.size() + argument.size() > kTokenMax) {
      Count(kTokenMax);
      return {};
    }
    pieces.insert(pieces.end(), argument.begin(), argument.end());
  }
  return pieces;
}

}  // namespace oncard::compiler
