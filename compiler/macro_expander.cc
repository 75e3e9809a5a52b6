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

// Whether an argument is that for `...`, which has all that follow, too.
bool TakesRest(const MacroDefinition& macro, size_t argument) {
  return macro.is_variadic && argument + 1 >= macro.parameters.size();
}

// Whether a token of the body stands before or after `##`.
bool IsJoined(const std::vector<Token>& body, size_t place) {
  return (place > 0 && IsJoining(body[place - 1])) ||
         (place + 1 < body.size() && IsJoining(body[place + 1]));
}

// Whether an argument stands somewhere in the body without `#` and `##`.
bool IsExpanded(const MacroDefinition& macro, int argument) {
  for (size_t i = 0; i < macro.body.size(); ++i) {
    if (macro.parameter_of[i] != argument || IsJoined(macro.body, i)) continue;
    if (i == 0 || macro.body[i - 1].kind != Kind::kHash) return true;
  }
  return false;
}

}  // namespace

bool IsJoining(const Token& token) { return token.kind == Kind::kHash && token.text.size() > 1; }

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
bool MacroExpander::FindArguments(const MacroDefinition& macro, Source& source, SourceRange* use,
                                  Arguments* arguments) {
  size_t begin = source.next + 1;
  int depth = 0;
  for (size_t i = source.next; i < source.pieces.size(); ++i) {
    const int kind = source.pieces[i].token.kind;
    if (kind == Kind::kOpenParen) ++depth;
    if (kind == Kind::kCloseParen) --depth;
    const bool ends = depth == 0 || (kind == Kind::kComma && depth == 1 &&
                                     !TakesRest(macro, arguments->pieces.size()));
    if (!ends) continue;
    arguments->pieces.push_back(source.pieces.subspan(begin, i - begin));
    begin = i + 1;
    if (depth != 0) continue;
    *use = compiler::Join(*use, source.pieces[i].token.range);
    source.next = begin;
    return true;
  }
  arguments->pieces.clear();
  return false;
}

// Reads `(a, b)` from several sources, where each argument has to be put together. False if they
// all end before.
bool MacroExpander::CollectArguments(const MacroDefinition& macro, Expansion& expansion,
                                     SourceRange* use, Arguments* arguments) {
  int depth = 0;
  for (const Piece* next = Peek(expansion); next != nullptr; next = Peek(expansion)) {
    if (!Count(1)) return true;
    const Piece piece = *next;
    ++expansion.sources.back().next;
    const int kind = piece.token.kind;
    if (kind == Kind::kCloseParen && --depth == 0) {
      *use = compiler::Join(*use, piece.token.range);
      arguments->pieces.assign(arguments->own.begin(), arguments->own.end());
      return true;
    }
    const bool opens = kind == Kind::kOpenParen && depth++ == 0;
    const bool ends = kind == Kind::kComma && depth == 1 && !arguments->own.empty() &&
                      !TakesRest(macro, arguments->own.size() - 1);
    if (opens || ends) {
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
  if (!FindArguments(macro, expansion.sources.back(), use, arguments) &&
      !CollectArguments(macro, expansion, use, arguments)) {
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
  // Those for `...` may be left out.
  if (macro.is_variadic && pieces.size() + 1 == macro.parameters.size()) pieces.emplace_back();
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
    if (!IsExpanded(macro, static_cast<int>(i))) continue;
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
  // What is empty beside `##` leaves the other side as it is.
  bool joins = false;
  bool empty = false;
  for (size_t i = 0; i < macro.body.size(); ++i) {
    const Token& token = macro.body[i];
    if (IsJoining(token)) {
      joins = true;
      continue;
    }
    const int parameter = macro.parameter_of[i];
    const size_t argument = static_cast<size_t>(std::max(parameter, 0));
    Piece own{token};
    own.token.range = use;
    own.token.on_new_line = false;
    Pieces added(&own, 1);
    if (parameter >= 0) {
      added = IsJoined(macro.body, i) ? arguments.pieces[argument] : Pieces(expanded[argument]);
      // `, ##args`: the comma goes with them.
      const bool rest = joins && i > 1 && macro.body[i - 2].kind == Kind::kComma &&
                        TakesRest(macro, argument) && !body->empty();
      if (rest && added.empty()) body->pop_back();
      if (rest) joins = false;
    } else if (token.kind == Kind::kHash && macro.has_parameters) {
      ++i;
      own = MakeText(arguments.pieces[static_cast<size_t>(macro.parameter_of[i])], use);
    }
    if (!Count(added.size())) return false;
    if (joins && !empty && !added.empty() && !body->empty()) {
      body->back() = Join(macro, body->back(), added.front());
      added = added.subspan(1);
      empty = false;
    } else {
      empty = added.empty() && (!joins || empty);
    }
    joins = false;
    body->insert(body->end(), added.begin(), added.end());
  }
  return true;
}

// The words of an argument as a string, as `#` makes it.
MacroExpander::Piece MacroExpander::MakeText(Pieces argument, SourceRange range) {
  std::string text = "\"";
  for (size_t i = 0; i < argument.size(); ++i) {
    const Token& token = argument[i].token;
    if (i > 0 && argument[i - 1].token.range.end != token.range.begin) text += ' ';
    const bool quoted = token.text.find_first_of("\"'") != std::string_view::npos;
    for (const char c : token.text) {
      if (quoted && (c == '"' || c == '\\')) text += '\\';
      text += c;
    }
  }
  Piece piece;
  piece.token.kind = Kind::kString;
  piece.token.range = range;
  piece.token.text = made_.emplace_back(std::string(), text + '"').text();
  return piece;
}

// The word that `##` makes of two.
MacroExpander::Piece MacroExpander::Join(const MacroDefinition& macro, const Piece& left,
                                         const Piece& right) {
  const SourceFile& text = made_.emplace_back(
      std::string(), std::string(left.token.text) + std::string(right.token.text));
  Reporter unheard;
  const std::vector<Token> tokens = Tokenize(text, 0, 2, catalogue_, unheard, Dialect::kStructured);
  if (tokens.size() != 1 || unheard.HasErrors() || tokens[0].text.size() != text.text().size()) {
    AddNote(reporter_.Report(
                Code::kMacroOperator, left.token.range, std::string_view("##"),
                MakeMessage("joins '{0}' and '{1}', which are no word together; write a blank",
                            "把 '{0}' 和 '{1}' 连在一起，得到的不是一个单词；请改用空格",
                            left.token.text, right.token.text)),
            macro.name_range, MakeMessage("the macro is defined here", "宏在此处定义"));
    return Invalid(left.token.range);
  }
  Piece piece{tokens[0]};
  piece.token.range = left.token.range;
  piece.token.on_new_line = left.token.on_new_line;
  return piece;
}

}  // namespace oncard::compiler
