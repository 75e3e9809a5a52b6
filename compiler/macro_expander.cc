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
  std::unordered_map<std::string_view, int> places;
  for (const std::string_view parameter : definition.parameters) {
    places.emplace(parameter, static_cast<int>(places.size()));
  }
  definition.parameter_of.reserve(definition.body.size());
  for (const Token& token : definition.body) {
    const auto place = places.find(token.text);
    definition.parameter_of.push_back(place == places.end() ? -1 : place->second);
  }
  definitions_.push_back(std::move(definition));
  macros_[definitions_.back().name] = &definitions_.back();
}

bool MacroExpander::Expand(std::span<const Token> text, std::vector<Token>* out) {
  if (!Count(text.size())) return false;
  open_.clear();
  Expansion expansion;
  Source& source = expansion.sources.emplace_back();
  source.own.reserve(text.size());
  for (const Token& token : text) source.own.push_back({token});
  source.pieces = source.own;
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
    open_.erase(source.macro);
    expansion.sources.pop_back();
  }
}

// Reads the body of a macro next.
void MacroExpander::Enter(Expansion& expansion, const MacroDefinition& macro,
                          std::vector<Piece> body) {
  Source& source = expansion.sources.emplace_back();
  source.own = std::move(body);
  source.pieces = source.own;
  source.macro = &macro;
  open_.insert(&macro);
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
    if (open_.contains(macro)) {
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
    std::vector<Piece> body;
    if (!Substitute(expansion, *macro, arguments, use, &body)) return;
    if (!body.empty()) body.front().token.on_new_line = piece.token.on_new_line;
    Enter(expansion, *macro, std::move(body));
  }
}

// Finds `(a, b)` in a source, which keeps the arguments. False if the source ends before.
bool MacroExpander::FindArguments(Source& source, SourceRange* use, Arguments* arguments) {
  size_t begin = source.next + 1;
  int depth = 0;
  for (size_t i = source.next; i < source.pieces.size(); ++i) {
    const int kind = source.pieces[i].token.kind;
    if (kind == Kind::kOpenParen) ++depth;
    if (kind == Kind::kCloseParen) --depth;
    const bool ends = depth == 0 || (kind == Kind::kComma && depth == 1);
    if (!ends) continue;
    arguments->pieces.push_back(source.pieces.subspan(begin, i - begin));
    begin = i + 1;
    if (depth != 0) continue;
    *use = Join(*use, source.pieces[i].token.range);
    source.next = begin;
    return true;
  }
  arguments->pieces.clear();
  return false;
}

// Reads `(a, b)` from several sources, where each argument has to be put together. False if they
// all end before.
bool MacroExpander::CollectArguments(Expansion& expansion, SourceRange* use, Arguments* arguments) {
  int depth = 0;
  for (const Piece* next = Peek(expansion); next != nullptr; next = Peek(expansion)) {
    if (!Count(1)) return true;
    const Piece piece = *next;
    ++expansion.sources.back().next;
    const int kind = piece.token.kind;
    if (kind == Kind::kCloseParen && --depth == 0) {
      *use = Join(*use, piece.token.range);
      arguments->pieces.assign(arguments->own.begin(), arguments->own.end());
      return true;
    }
    const bool opens = kind == Kind::kOpenParen && depth++ == 0;
    if (opens || (kind == Kind::kComma && depth == 1)) {
      arguments->own.emplace_back();
    } else {
      arguments->own.back().push_back(piece);
    }
  }
  return false;
}

// Reads the arguments and extends the range of the use to them. False, with a report, if they do
// not fit the macro.
bool MacroExpander::ReadArguments(Expansion& expansion, const MacroDefinition& macro,
                                  SourceRange* use, Arguments* arguments) {
  const SourceRange name = *use;
  const size_t after_open = expansion.sources.front().next + 1;
  if (!FindArguments(expansion.sources.back(), use, arguments) &&
      !CollectArguments(expansion, use, arguments)) {
    AddNote(reporter_.Report(Code::kMacroNotClosed, name, macro.name), macro.name_range,
            MakeMessage("the macro is defined here", "宏在此处定义"));
    // The text that is no argument is read as it is.
    Source& text = expansion.sources.front();
    text.next = std::min(after_open, text.pieces.size());
    return false;
  }
  if (count_ > kTokenMax) return false;
  std::vector<Pieces>& pieces = arguments->pieces;
  // `()` is one empty argument, or none.
  if (macro.parameters.empty() && pieces.size() == 1 && pieces.front().empty()) pieces.clear();
  if (pieces.size() == macro.parameters.size()) return true;
  AddNote(reporter_.Report(Code::kMacroArguments, *use, macro.name,
                           static_cast<int64_t>(macro.parameters.size()),
                           static_cast<int64_t>(pieces.size())),
          macro.name_range, MakeMessage("the macro is defined here", "宏在此处定义"));
  return false;
}

// Makes the body of a macro at its use, with the expanded arguments in it. False if there are too
// many tokens.
bool MacroExpander::Substitute(const Expansion& expansion, const MacroDefinition& macro,
                               const Arguments& arguments, SourceRange use,
                               std::vector<Piece>* body) {
  std::vector<std::vector<Piece>> expanded(arguments.pieces.size());
  for (size_t i = 0; i < expanded.size(); ++i) {
    if (expansion.depth == kDepthMax) {
      reporter_.Report(Code::kTooDeep, use, int64_t{kDepthMax});
      body->push_back(Invalid(use));
      return true;
    }
    Expansion argument;
    argument.depth = expansion.depth + 1;
    argument.sources.emplace_back().pieces = arguments.pieces[i];
    Run(argument, &expanded[i]);
  }
  const auto argument_at = [&](size_t place) -> const std::vector<Piece>* {
    const int parameter = macro.parameter_of[place];
    return parameter < 0 ? nullptr : &expanded[static_cast<size_t>(parameter)];
  };
  // They are counted before they are copied.
  size_t size = 0;
  for (size_t i = 0; i < macro.body.size(); ++i) {
    const std::vector<Piece>* const argument = argument_at(i);
    const size_t added = argument == nullptr ? 1 : argument->size();
    if (!Count(added)) return false;
    size += added;
  }
  body->reserve(size);
  for (size_t i = 0; i < macro.body.size(); ++i) {
    if (const std::vector<Piece>* const argument = argument_at(i)) {
      body->insert(body->end(), argument->begin(), argument->end());
      continue;
    }
    Piece& piece = body->emplace_back(Piece{macro.body[i]});
    piece.token.range = use;
    piece.token.on_new_line = false;
  }
  return true;
}

}  // namespace oncard::compiler
