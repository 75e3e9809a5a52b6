#include "editor/complete.h"

#include <fmt/core.h>

#include <algorithm>

#include "compiler/lexer.h"
#include "compiler/parser.hh"
#include "compiler/parser_driver.h"
#include "editor/command_help.h"
#include "editor/describe.h"

namespace oncard::editor {
namespace {

using compiler::SourceRange;
using compiler::Token;
using Kind = compiler::Parser::token;
using Words = std::span<const std::string_view>;

// An index with at most this many values is offered value by value.
constexpr double kValuesMax = 32;

constexpr std::string_view kCardStatements[] = {"if", "goto", "return"};
constexpr std::string_view kStructuredStatements[] = {"if",       "else",    "while", "for",
                                                      "do",       "switch",  "case",  "break",
                                                      "continue", "default", "goto",  "return"};
constexpr std::string_view kCardTypes[] = {"int", "double", "long", "short"};
constexpr std::string_view kStructuredTypes[] = {"int",  "double",   "long", "short",
                                                 "char", "unsigned", "bool"};
constexpr std::string_view kVoid[] = {"void"};
constexpr std::string_view kStructuredSpecifiers[] = {"const", "static", "enum", "struct",
                                                      "typedef"};
constexpr std::string_view kCardDirectives[] = {"define", "include"};
constexpr std::string_view kStructuredDirectives[] = {"define", "undef",  "include", "if",
                                                      "ifdef",  "ifndef", "elif",    "else",
                                                      "endif",  "error",  "pragma"};
constexpr std::string_view kCardFunctions[] = {"abs", "fabs"};

// What is declared near the place comes first.
int NearnessOf(const Symbol& symbol) {
  switch (symbol.kind) {
    case Symbol::Kind::kLocal:
      return 0;
    case Symbol::Kind::kParameter:
      return 1;
    case Symbol::Kind::kGlobal:
      return 2;
    case Symbol::Kind::kFunction:
      return 4;
    default:
      return 3;
  }
}

class Completion {
 public:
  Completion(const Analysis& analysis, Cursor cursor, Language language)
      : analysis_(analysis),
        tokens_(analysis.text.file(cursor.file).tokens),
        cursor_(cursor),
        language_(language) {}

  Json Run();

 private:
  void FindWord();
  int KindBefore(size_t back = 1) const {
    return next_ >= back ? tokens_[next_ - back].kind : static_cast<int>(Kind::kEnd);
  }
  const Directive* DirectiveHere() const;
  bool AtStatement() const;
  bool MayDeclare() const;

  void InDirective(const Directive& directive);
  void AfterDot();
  void Labels();
  void Structures();
  void AtFileLevel();
  void Statement();
  void Expression(const gtcalls::Parameter* parameter);
  void Values(const gtcalls::Parameter& parameter);
  void Symbols(const gtcalls::Parameter* parameter);
  void Commands();
  void Types();
  void AddWords(std::string_view kind, Words words);
  void AddSymbol(const Symbol& symbol, bool by_address);

  const Analysis& analysis_;
  const std::vector<Token>& tokens_;
  Cursor cursor_;
  Language language_;
  SourceRange word_;      // what the candidates replace
  size_t next_ = 0;       // the first token that is not before the word
  size_t order_ = 0;      // of the word in the program
  bool nothing_ = false;  // no name can stand here
  Json items_ = Json::array();
};

void Completion::FindWord() {
  word_ = {cursor_.file, cursor_.offset, cursor_.offset};
  next_ = static_cast<size_t>(
      std::ranges::lower_bound(tokens_, cursor_.offset, {},
                               [](const Token& token) { return token.range.begin; }) -
      tokens_.begin());
  if (next_ > 0 && tokens_[next_ - 1].range.end >= cursor_.offset) {
    const Token& token = tokens_[next_ - 1];
    if (compiler::IsWord(token)) {
      word_ = token.range;
      --next_;
    } else {
      nothing_ =
          token.kind == Kind::kInteger || token.kind == Kind::kFixed || token.kind == Kind::kString;
    }
  }
  order_ = analysis_.text.file(cursor_.file).orders[next_];
}

const Directive* Completion::DirectiveHere() const {
  const compiler::SourceFile& file = analysis_.text.file(cursor_.file).file;
  for (const Directive& directive : analysis_.text.file(cursor_.file).directives) {
    if (directive.range.begin >= cursor_.offset) break;
    if (cursor_.offset <= directive.range.end ||
        file.LineOf(cursor_.offset) == file.LineOf(directive.range.end)) {
      return &directive;
    }
  }
  return nullptr;
}

// Whether a statement begins here.
bool Completion::AtStatement() const {
  const int before = KindBefore();
  switch (before) {
    case Kind::kEnd:
    case Kind::kSemicolon:
    case Kind::kOpenBrace:
    case Kind::kCloseBrace:
    case Kind::kElse:
    case Kind::kDo:
      return true;
    case Kind::kColon: {
      // After a label or a case, not in a conditional expression.
      for (size_t back = 2; back <= next_; ++back) {
        const int kind = KindBefore(back);
        if (kind == Kind::kQuestion) return false;
        if (kind == Kind::kSemicolon || kind == Kind::kOpenBrace || kind == Kind::kCloseBrace) {
          break;
        }
      }
      return true;
    }
    case Kind::kName:
    case Kind::kInteger:
    case Kind::kFixed:
    case Kind::kCloseBracket:
    case Kind::kCloseParen: {
      // After the condition of a statement, or where a `;` seems to be missing.
      const compiler::SourceFile& file = analysis_.text.file(cursor_.file).file;
      const bool new_line = file.LineOf(word_.begin) != file.LineOf(tokens_[next_ - 1].range.begin);
      return before == Kind::kCloseParen || new_line;
    }
    default:
      return false;
  }
}

// The card's language has its declarations before the statements of a function.
bool Completion::MayDeclare() const {
  if (analysis_.text.structured()) return true;
  if (KindBefore() == Kind::kOpenBrace) return true;
  size_t back = 2;
  while (back <= next_ && KindBefore(back) != Kind::kSemicolon &&
         KindBefore(back) != Kind::kOpenBrace) {
    ++back;
  }
  return back <= next_ && compiler::IsTypeWord(KindBefore(back - 1));
}

void Completion::AddWords(std::string_view kind, Words words) {
  for (const std::string_view word : words) items_.push_back({{"label", word}, {"kind", kind}});
}

void Completion::AddSymbol(const Symbol& symbol, bool by_address) {
  Json item = {{"label", symbol.name},
               {"kind", KindName(symbol.kind)},
               {"detail", Declaration(analysis_, symbol)}};
  if (by_address) item["insert"] = fmt::format("&{}", symbol.name);
  items_.push_back(std::move(item));
}

void Completion::Types() {
  if (analysis_.text.structured()) {
    AddWords("type", kStructuredTypes);
    AddWords("keyword", kStructuredSpecifiers);
  } else {
    AddWords("type", kCardTypes);
  }
  for (const gtcalls::Structure& structure : analysis_.text.catalogue().structures()) {
    if (structure.in_motion_program) AddWords("type", {&structure.name, 1});
  }
  for (const int index : analysis_.names.VisibleAt(order_)) {
    const Symbol& symbol = analysis_.names.symbol(index);
    if (symbol.kind == Symbol::Kind::kType) AddSymbol(symbol, false);
  }
}

void Completion::InDirective(const Directive& directive) {
  const bool structured = analysis_.text.structured();
  const bool after_hash = next_ > 0 && &tokens_[next_ - 1] == directive.tokens.data();
  if (after_hash) {
    AddWords("directive", structured ? Words(kStructuredDirectives) : Words(kCardDirectives));
    return;
  }
  const bool names_it = directive.word == "define" || directive.word == "include" ||
                        directive.word == "error" || directive.word == "pragma";
  const bool second = next_ > 1 && &tokens_[next_ - 2] == directive.tokens.data();
  if (names_it && (second || directive.word != "define")) return;
  Symbols(nullptr);
}

void Completion::AfterDot() {
  const Symbol* const operand = OperandBefore(analysis_, cursor_.file, next_ - 1);
  if (operand == nullptr) return;
  for (const Symbol& symbol : analysis_.names.symbols()) {
    const bool member = symbol.kind == Symbol::Kind::kMember && symbol.scope == operand->members;
    if (member) AddSymbol(symbol, false);
  }
  if (operand->structure == nullptr) return;
  for (const gtcalls::Member& member : operand->structure->members) {
    items_.push_back(
        {{"label", member.name},
         {"kind", "member"},
         {"detail", fmt::format("{} {}", gtcalls::SpellScalar(member.type), member.name)}});
  }
}

void Completion::Labels() {
  const int scope = analysis_.names.ScopeAt(order_);
  for (const Symbol& symbol : analysis_.names.symbols()) {
    const bool here =
        symbol.kind == Symbol::Kind::kLabel && analysis_.names.FindLabel(symbol.name, scope) >= 0 &&
        &analysis_.names.symbol(analysis_.names.FindLabel(symbol.name, scope)) == &symbol;
    if (here) AddSymbol(symbol, false);
  }
}

void Completion::Structures() {
  const int scope = analysis_.names.ScopeAt(order_);
  for (const Symbol& symbol : analysis_.names.symbols()) {
    if (symbol.kind != Symbol::Kind::kStructure) continue;
    const int found = analysis_.names.FindStructure(symbol.name, scope, order_);
    if (found >= 0 && &analysis_.names.symbol(found) == &symbol) AddSymbol(symbol, false);
  }
}

void Completion::Values(const gtcalls::Parameter& parameter) {
  const bool few = parameter.unit == gtcalls::Unit::kIndex && !IsPointer(parameter) &&
                   parameter.maximum - parameter.minimum < kValuesMax;
  if (!few) return;
  for (int value = static_cast<int>(parameter.minimum); value <= parameter.maximum; ++value) {
    items_.push_back({{"label", fmt::format("{}", value)},
                      {"kind", "value"},
                      {"detail", ParameterLabel(parameter)}});
  }
}

// Those that suit the parameter come first.
void Completion::Symbols(const gtcalls::Parameter* parameter) {
  const bool pointer = parameter != nullptr && IsPointer(*parameter);
  const bool has_sign = KindBefore() == Kind::kAnd;
  std::vector<const Symbol*> good;
  std::vector<const Symbol*> others;
  for (const int index : analysis_.names.VisibleAt(order_)) {
    const Symbol& symbol = analysis_.names.symbol(index);
    const bool function = symbol.kind == Symbol::Kind::kFunction;
    if (symbol.kind == Symbol::Kind::kEnumeration || symbol.kind == Symbol::Kind::kType) continue;
    if (function && (!analysis_.text.structured() || pointer)) continue;
    const bool variable = symbol.kind == Symbol::Kind::kGlobal ||
                          symbol.kind == Symbol::Kind::kLocal ||
                          symbol.kind == Symbol::Kind::kParameter;
    if (pointer && !variable) continue;
    const bool is_double = symbol.type.find("double") != std::string_view::npos;
    const bool suits =
        parameter == nullptr || (parameter->structure == symbol.structure &&
                                 (!pointer || parameter->structure != nullptr ||
                                  is_double == (parameter->type == gtcalls::Scalar::kDouble)));
    if (pointer && parameter->structure != symbol.structure) continue;
    (suits ? good : others).push_back(&symbol);
  }
  for (auto* list : {&good, &others}) {
    std::ranges::stable_sort(*list, {}, [](const Symbol* symbol) { return NearnessOf(*symbol); });
    for (const Symbol* symbol : *list) {
      AddSymbol(*symbol, pointer && !has_sign && symbol->suffix.empty() && !symbol->pointer);
    }
  }
}

void Completion::Commands() {
  for (const gtcalls::Command& command : analysis_.text.catalogue().commands()) {
    if (!command.in_motion_program) continue;
    items_.push_back({{"label", command.name},
                      {"kind", "command"},
                      {"detail", Prototype(command)},
                      {"documentation", Brief(command, language_)}});
  }
}

void Completion::AtFileLevel() {
  if (AtStatement()) {
    Types();
    AddWords("type", kVoid);
  } else {
    Expression(nullptr);
  }
}

void Completion::Statement() {
  Symbols(nullptr);
  Commands();
  AddWords("keyword",
           analysis_.text.structured() ? Words(kStructuredStatements) : Words(kCardStatements));
  if (MayDeclare()) Types();
}

void Completion::Expression(const gtcalls::Parameter* parameter) {
  if (parameter != nullptr) Values(*parameter);
  Symbols(parameter);
  if (parameter != nullptr && IsPointer(*parameter)) return;
  AddWords("function", kCardFunctions);
  if (KindBefore() == Kind::kOpenParen && analysis_.text.structured()) {
    AddWords("type", kStructuredTypes);
  }
}

Json Completion::Run() {
  Json answer = Json::object();
  FindWord();
  answer["range"] = RangeJson(analysis_.text, word_);
  if (!nothing_ && !InComment(analysis_.text, cursor_)) {
    const CallAt call = FindCall(analysis_, {cursor_.file, word_.begin});
    const gtcalls::Command* command = call.callee != nullptr ? call.callee->command : nullptr;
    const gtcalls::Parameter* parameter =
        command != nullptr && call.argument < command->parameters.size()
            ? &command->parameters[call.argument]
            : nullptr;
    const int before = KindBefore();
    if (const Directive* directive = DirectiveHere()) {
      InDirective(*directive);
    } else if (before == Kind::kDot || before == Kind::kArrow) {
      AfterDot();
    } else if (before == Kind::kGoto) {
      Labels();
    } else if (before == Kind::kStruct) {
      Structures();
    } else if (compiler::IsTypeWord(before) || before == Kind::kEnum) {
      const bool open = before == Kind::kConst || before == Kind::kStatic ||
                        before == Kind::kUnsigned || before == Kind::kSigned ||
                        before == Kind::kQualifier;
      if (open) Types();
    } else if (call.callee != nullptr) {
      Expression(parameter);
    } else if (analysis_.names.ScopeAt(order_) == 0) {
      AtFileLevel();
    } else if (AtStatement()) {
      Statement();
    } else {
      Expression(nullptr);
    }
    if (parameter != nullptr) {
      answer["argument"] = ParameterJson(*command, *parameter, language_);
      answer["argument"]["command"] = command->name;
      answer["argument"]["index"] = call.argument;
    }
  }
  answer["items"] = std::move(items_);
  return answer;
}

}  // namespace

Json Complete(const Analysis& analysis, Cursor cursor, Language language) {
  return Completion(analysis, cursor, language).Run();
}

}  // namespace oncard::editor
