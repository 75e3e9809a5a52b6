#include "editor/overview.h"

#include <fmt/core.h>

#include <algorithm>

#include "compiler/lexer.h"
#include "compiler/parser.hh"
#include "compiler/parser_driver.h"
#include "editor/describe.h"

namespace oncard::editor {
namespace {

using compiler::SourceRange;
using compiler::Token;
using Kind = compiler::Parser::token;

// --- Outline -------------------------------------------------------------------------------------

Json OutlineEntry(const Analysis& analysis, const Symbol& symbol,
                  const Symbol::Declaration& declaration) {
  Json entry = {{"kind", KindName(symbol.kind)},
                {"name", symbol.name},
                {"detail", Declaration(analysis, symbol)},
                {"range", RangeJson(analysis.text, declaration.whole)},
                {"name_range", RangeJson(analysis.text, declaration.name)}};
  if (symbol.kind == Symbol::Kind::kFunction) {
    entry["thread_function"] = IsThreadFunction(analysis.text, symbol);
    entry["definition"] = declaration.definition;
  }
  return entry;
}

// --- Words ---------------------------------------------------------------------------------------

struct Word {
  SourceRange range;
  std::string_view kind;
  bool declaration = false;
  bool write = false;
};

std::string_view KindOf(const Token& token) {
  switch (token.kind) {
    case Kind::kInteger:
    case Kind::kFixed:
      return "number";
    case Kind::kString:
      return "string";
    case Kind::kHash:
      return "directive";
    default:
      break;
  }
  if (!compiler::IsWord(token) || token.kind == Kind::kName) return {};
  const bool specifies = token.kind == Kind::kConst || token.kind == Kind::kStatic ||
                         token.kind == Kind::kExtern || token.kind == Kind::kQualifier;
  return compiler::IsTypeWord(token.kind) && !specifies ? "type" : "keyword";
}

std::string_view KindOf(const ProgramText& text, const Symbol& symbol) {
  if (symbol.kind == Symbol::Kind::kFunction && IsThreadFunction(text, symbol)) {
    return "thread-function";
  }
  return KindName(symbol.kind);
}

void AddNames(const Analysis& analysis, int file, std::vector<Word>* words) {
  const std::vector<Token>& tokens = analysis.text.file(file).tokens;
  const auto& references = analysis.names.references();
  auto next = std::ranges::lower_bound(references, file, {},
                                       [](const Reference& each) { return each.range.file; });
  for (size_t i = 0; i < tokens.size(); ++i) {
    while (next != references.end() && next->range.file == file &&
           next->range.begin < tokens[i].range.begin) {
      ++next;
    }
    Word word{tokens[i].range, KindOf(tokens[i])};
    if (next != references.end() && next->range == tokens[i].range) {
      using enum Reference::Access;
      word.kind = KindOf(analysis.text, analysis.names.symbol(next->symbol));
      word.declaration = next->access == kDeclaration;
      word.write = next->access == kWrite || next->access == kReadWrite;
    } else if (i > 0 && tokens[i].kind == Kind::kName &&
               (tokens[i - 1].kind == Kind::kDot || tokens[i - 1].kind == Kind::kArrow)) {
      word.kind = "member";
    } else if (i > 0 && tokens[i - 1].kind == Kind::kHash && tokens[i - 1].on_new_line &&
               compiler::IsWord(tokens[i])) {
      word.kind = "directive";
    }
    if (!word.kind.empty()) words->push_back(word);
  }
}

// --- Folds ---------------------------------------------------------------------------------------

class FoldList {
 public:
  explicit FoldList(const compiler::SourceFile& file) : file_(file) {}

  void Add(std::string_view kind, uint32_t begin, uint32_t end) {
    const int first = file_.LineOf(begin);
    const int last = file_.LineOf(end);
    if (first < last) folds_.push_back({first, last, kind});
  }
  /// In the order of the text.
  Json Take() {
    std::ranges::stable_sort(folds_, {}, &Fold::line);
    Json json = Json::array();
    for (const Fold& fold : folds_) {
      json.push_back({{"kind", fold.kind}, {"line", fold.line}, {"end_line", fold.end_line}});
    }
    return json;
  }

 private:
  struct Fold {
    int line;
    int end_line;
    std::string_view kind;
  };
  const compiler::SourceFile& file_;
  std::vector<Fold> folds_;
};

void FoldBraces(const FileText& file, FoldList* folds) {
  std::vector<std::pair<uint32_t, bool>> open;  // and whether it is a function's
  for (size_t i = 0; i < file.tokens.size(); ++i) {
    if (file.tokens[i].kind == Kind::kOpenBrace) {
      const bool function = open.empty() && i > 0 && file.tokens[i - 1].kind == Kind::kCloseParen;
      open.emplace_back(file.tokens[i].range.begin, function);
    } else if (file.tokens[i].kind == Kind::kCloseBrace && !open.empty()) {
      folds->Add(open.back().second ? "function" : "block", open.back().first,
                 file.tokens[i].range.begin);
      open.pop_back();
    }
  }
}

// A comment of several lines, or several ones in lines of their own.
void FoldComments(const FileText& file, FoldList* folds) {
  const auto alone = [&file](const SourceRange& comment) {
    const std::string_view line = file.file.Line(file.file.LineOf(comment.begin));
    return line.find_first_not_of(" \t") ==
           comment.begin - static_cast<size_t>(line.data() - file.file.text().data());
  };
  for (size_t i = 0; i < file.comments.size();) {
    size_t last = i;
    while (last + 1 < file.comments.size() && alone(file.comments[last]) &&
           alone(file.comments[last + 1]) &&
           file.file.LineOf(file.comments[last + 1].begin) ==
               file.file.LineOf(file.comments[last].end) + 1) {
      ++last;
    }
    folds->Add("comment", file.comments[i].begin, file.comments[last].end);
    i = last + 1;
  }
}

void FoldDirectives(const FileText& file, FoldList* folds) {
  std::vector<uint32_t> open;
  for (const Directive& directive : file.directives) {
    const bool begins =
        directive.word == "if" || directive.word == "ifdef" || directive.word == "ifndef";
    const bool branches = directive.word == "else" || directive.word == "elif";
    if (directive.word == "endif" && !open.empty()) {
      folds->Add("directive", open.back(), directive.range.begin);
      open.pop_back();
    } else if (branches && !open.empty()) {
      // Up to the line before it.
      const uint32_t line_begin = static_cast<uint32_t>(
          file.file.Line(file.file.LineOf(directive.range.begin)).data() - file.file.text().data());
      folds->Add("directive", open.back(), std::max(line_begin, 1u) - 1);
      open.back() = directive.range.begin;
    } else if (begins) {
      open.push_back(directive.range.begin);
    }
  }
}

// --- Hints ---------------------------------------------------------------------------------------

void HintArguments(const Analysis& analysis, int file, Json* hints) {
  struct Open {
    const gtcalls::Command* command = nullptr;
    size_t argument = 0;
    bool begins = true;  // the next token is the first of an argument
  };
  const std::vector<Token>& tokens = analysis.text.file(file).tokens;
  std::vector<Open> open;
  for (size_t i = 0; i < tokens.size(); ++i) {
    const int kind = tokens[i].kind;
    if (kind == Kind::kSemicolon || kind == Kind::kOpenBrace || kind == Kind::kCloseBrace) {
      open.clear();
      continue;
    }
    if (kind == Kind::kCloseParen) {
      if (!open.empty()) open.pop_back();
      continue;
    }
    if (kind == Kind::kComma && !open.empty()) {
      ++open.back().argument;
      open.back().begins = true;
      continue;
    }
    if (!open.empty() && open.back().begins && open.back().command != nullptr &&
        open.back().argument < open.back().command->parameters.size()) {
      const gtcalls::Parameter& parameter = open.back().command->parameters[open.back().argument];
      const std::string_view unit = gtcalls::SpellUnit(parameter.unit);
      Json hint = RangeJson(analysis.text, {file, tokens[i].range.begin, tokens[i].range.begin});
      hint["kind"] = "argument";
      hint["name"] = parameter.name;
      if (!unit.empty()) hint["unit"] = unit;
      hint["label"] = unit.empty() ? fmt::format("{}:", parameter.name)
                                   : fmt::format("{} [{}]:", parameter.name, unit);
      hints->push_back(std::move(hint));
    }
    if (!open.empty()) open.back().begins = false;
    if (kind == Kind::kOpenParen) {
      const bool call = i > 0 && tokens[i - 1].kind == Kind::kName;
      open.push_back({call ? analysis.text.catalogue().Find(tokens[i - 1].text) : nullptr});
    }
  }
}

// The units of the members that get a value.
void HintMembers(const Analysis& analysis, int file, Json* hints) {
  const std::vector<Token>& tokens = analysis.text.file(file).tokens;
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (tokens[i + 1].kind != Kind::kAssign) continue;
    const gtcalls::Member* const member = CardMemberAt(analysis, file, i);
    const std::string_view unit = member != nullptr ? gtcalls::SpellUnit(member->unit) : "";
    if (unit.empty()) continue;
    const auto at = tokens[i + 2].range.begin;
    Json hint = RangeJson(analysis.text, {file, at, at});
    hint["kind"] = "member";
    hint["name"] = member->name;
    hint["unit"] = unit;
    hint["label"] = fmt::format("[{}]:", unit);
    hints->push_back(std::move(hint));
  }
}

}  // namespace

Json Outline(const Analysis& analysis, int file) {
  const std::deque<Symbol>& symbols = analysis.names.symbols();
  Json entries = Json::array();
  std::map<int, size_t> entry_of_function;
  std::map<int, size_t> entry_of_members;  // by their scope; the first that has them
  const auto is_top = [](const Symbol& symbol) {
    using enum Symbol::Kind;
    return symbol.kind == kFunction || symbol.kind == kGlobal || symbol.kind == kMacro ||
           symbol.kind == kEnumeration || symbol.kind == kConstant || symbol.kind == kStructure ||
           symbol.kind == kType;
  };
  struct Entry {
    int symbol;
    const Symbol::Declaration* declaration;
  };
  std::vector<Entry> order;
  for (size_t i = 0; i < symbols.size(); ++i) {
    if (symbols[i].kind == Symbol::Kind::kMacroParameter) continue;
    for (const Symbol::Declaration& declaration : symbols[i].declarations) {
      if (declaration.name.file == file) order.push_back({static_cast<int>(i), &declaration});
    }
  }
  std::ranges::stable_sort(order, {},
                           [](const Entry& each) { return each.declaration->name.begin; });
  for (const auto& [index, declaration] : order) {
    const Symbol& symbol = analysis.names.symbol(index);
    if (is_top(symbol) && symbol.function < 0) {
      if (symbol.kind == Symbol::Kind::kFunction && declaration->definition) {
        entry_of_function[index] = entries.size();
      }
      if (symbol.members >= 0 && symbol.kind != Symbol::Kind::kFunction) {
        entry_of_members.try_emplace(symbol.members, entries.size());
      }
      entries.push_back(OutlineEntry(analysis, symbol, *declaration));
    }
  }
  for (const auto& [index, declaration] : order) {
    const Symbol& symbol = analysis.names.symbol(index);
    if (is_top(symbol) && symbol.function < 0) continue;
    const bool member = symbol.kind == Symbol::Kind::kMember;
    const auto& owners = member ? entry_of_members : entry_of_function;
    const auto owner = owners.find(member ? symbol.scope : symbol.function);
    if (owner == owners.end()) continue;
    entries[owner->second]["children"].push_back(OutlineEntry(analysis, symbol, *declaration));
  }
  return entries;
}

Json Tokens(const Analysis& analysis, int file) {
  std::vector<Word> words;
  AddNames(analysis, file, &words);
  for (const SourceRange& comment : analysis.text.file(file).comments) {
    words.push_back({comment, "comment"});
  }
  std::ranges::stable_sort(words, {}, [](const Word& word) { return word.range.begin; });
  const compiler::SourceFile& source = analysis.text.file(file).file;
  Json json = Json::array();
  for (const Word& word : words) {
    Json each = {{"kind", word.kind},
                 {"line", source.LineOf(word.range.begin)},
                 {"column", source.ColumnOf(word.range.begin)},
                 {"end_line", source.LineOf(word.range.end)},
                 {"end_column", source.ColumnOf(word.range.end)}};
    if (word.declaration) each["declaration"] = true;
    if (word.write) each["write"] = true;
    json.push_back(std::move(each));
  }
  return json;
}

Json Folds(const Analysis& analysis, int file) {
  const FileText& text = analysis.text.file(file);
  FoldList folds(text.file);
  FoldBraces(text, &folds);
  FoldComments(text, &folds);
  FoldDirectives(text, &folds);
  return folds.Take();
}

Json Hints(const Analysis& analysis, int file, const vm::Object* object) {
  Json hints = Json::array();
  HintArguments(analysis, file, &hints);
  HintMembers(analysis, file, &hints);
  if (object == nullptr) return hints;
  for (const auto& [index, slot] : SlotsOf(analysis, *object)) {
    const Symbol& symbol = analysis.names.symbol(index);
    for (const Symbol::Declaration& declaration : symbol.declarations) {
      if (declaration.name.file != file || !declaration.definition) continue;
      Json hint = RangeJson(analysis.text, {file, declaration.name.end, declaration.name.end});
      hint["kind"] = "slot";
      hint["slot"] = slot;
      hint["label"] = fmt::format("@{}", slot);
      hints.push_back(std::move(hint));
    }
  }
  return hints;
}

}  // namespace oncard::editor
