#include "editor/name_scanner.h"

#include <algorithm>
#include <deque>

#include "compiler/lexer.h"
#include "compiler/parser.hh"
#include "compiler/parser_driver.h"
#include "compiler/syntax.h"

namespace oncard::editor {
namespace {

using compiler::SourceRange;
using compiler::Token;
using Kind = compiler::Parser::token;
using Access = Reference::Access;

// Deeper statements end where the next `;` does.
constexpr int kStatementDepthMax = 200;

bool Opens(int kind) {
  return kind == Kind::kOpenParen || kind == Kind::kOpenBrace || kind == Kind::kOpenBracket;
}

bool EndsOperand(int kind) {
  return kind == Kind::kName || kind == Kind::kInteger || kind == Kind::kFixed ||
         kind == Kind::kCloseParen || kind == Kind::kCloseBracket;
}

bool EndsStatement(int kind) {
  return kind == Kind::kSemicolon || kind == Kind::kOpenBrace || kind == Kind::kCloseBrace ||
         kind == Kind::kColon || kind == Kind::kElse || kind == Kind::kDo;
}

bool BeginsWithKeyword(int kind) {
  return kind == Kind::kIf || kind == Kind::kGoto || kind == Kind::kReturn || kind == Kind::kElse ||
         kind == Kind::kWhile || kind == Kind::kFor || kind == Kind::kDo || kind == Kind::kSwitch ||
         kind == Kind::kCase || kind == Kind::kDefault || kind == Kind::kBreak ||
         kind == Kind::kContinue;
}

bool IsType(int kind) {
  return compiler::IsTypeWord(kind) || kind == Kind::kEnum || kind == Kind::kStruct;
}

}  // namespace

NameScanner::NameScanner(const ProgramText& text, Names& names)
    : text_(text), names_(names), code_(text.code()) {}

void NameScanner::Run() {
  names_.scopes_.push_back({-1, -1, 0, code_.size() + 1, false});
  open_.push_back({0, code_.size() + 1, false});
  MatchBrackets();
  ScanDirectives();
  while (at_ < code_.size()) {
    CloseFinishedScopes();
    ScanToken();
  }
  while (open_.size() > 1) CloseScope(code_.size() + 1);
  ResolveUses();
  ResolveBodies();
  ResolveConditions();
}

int NameScanner::KindAt(size_t at) const {
  return at < code_.size() ? code_[at].kind : static_cast<int>(Kind::kEnd);
}

// Whether a type stands here: its words, or a name of a typedef before what it declares.
bool NameScanner::BeginsType(size_t at) const {
  if (IsType(KindAt(at))) return true;
  if (KindAt(at) != Kind::kName) return false;
  size_t next = at + 1;
  while (KindAt(next) == Kind::kStar) ++next;
  if (KindAt(next) != Kind::kName) return false;
  const int found = names_.Find(code_[at].text, open_.back().scope, at);
  return found >= 0 && names_.symbol(found).kind == Symbol::Kind::kType;
}

void NameScanner::MatchBrackets() {
  match_.assign(code_.size(), code_.size());
  semicolon_.assign(code_.size() + 1, code_.size());
  stop_ = semicolon_;
  std::vector<size_t> open;
  for (size_t i = 0; i < code_.size(); ++i) {
    const int kind = code_[i].kind;
    if (Opens(kind)) open.push_back(i);
    if (kind == Kind::kCloseBrace) {
      while (!open.empty() && code_[open.back()].kind != Kind::kOpenBrace) open.pop_back();
    }
    const bool pairs =
        !open.empty() &&
        ((kind == Kind::kCloseBrace && code_[open.back()].kind == Kind::kOpenBrace) ||
         (kind == Kind::kCloseParen && code_[open.back()].kind == Kind::kOpenParen) ||
         (kind == Kind::kCloseBracket && code_[open.back()].kind == Kind::kOpenBracket));
    if (!pairs) continue;
    match_[open.back()] = i;
    match_[i] = open.back();
    open.pop_back();
  }
  for (size_t i = code_.size(); i-- > 0;) {
    const bool ends = code_[i].kind == Kind::kSemicolon || code_[i].kind == Kind::kCloseBrace;
    semicolon_[i] = ends ? i : semicolon_[i + 1];
    stop_[i] = ends || code_[i].kind == Kind::kOpenBrace ? i : stop_[i + 1];
  }
}

// The index after a statement.
size_t NameScanner::StatementEnd(size_t at, int depth) const {
  const size_t end = code_.size();
  const auto after = [end](size_t index) { return std::min(index + 1, end); };
  while (at < end && depth < kStatementDepthMax) {
    const int kind = code_[at].kind;
    if (kind == Kind::kOpenBrace) return after(match_[at]);
    if (kind == Kind::kDo) return after(semicolon_[StatementEnd(at + 1, depth + 1)]);
    const bool heads =
        kind == Kind::kIf || kind == Kind::kWhile || kind == Kind::kFor || kind == Kind::kSwitch;
    if (!heads || KindAt(at + 1) != Kind::kOpenParen) break;
    const size_t body = after(match_[at + 1]);
    if (kind != Kind::kIf) {
      at = body;
      ++depth;
      continue;
    }
    const size_t next = StatementEnd(body, depth + 1);
    if (KindAt(next) != Kind::kElse) return next;
    at = next + 1;
    ++depth;
  }
  const size_t last = semicolon_[at];
  return KindAt(last) == Kind::kSemicolon ? after(last) : last;
}

bool NameScanner::BeginsStatement() const {
  if (at_ == 0) return true;
  const int before = code_[at_ - 1].kind;
  if (EndsStatement(before)) return true;
  if (before == Kind::kCloseParen && calls_.empty()) return true;
  return code_[at_].on_new_line && (EndsOperand(before) || before == Kind::kGoto) && calls_.empty();
}

// Whether the type at the present place is that of a declaration, and not of a cast.
bool NameScanner::BeginsDeclaration() const {
  if (at_ == 0) return true;
  const int before = code_[at_ - 1].kind;
  if (before == Kind::kOpenParen) return at_ >= 2 && code_[at_ - 2].kind == Kind::kFor;
  return before != Kind::kSizeof && before != Kind::kComma;
}

// --- Declarations --------------------------------------------------------------------------------

SourceRange NameScanner::RangeOf(size_t begin, size_t end) const {
  const SourceRange first = code_[begin].range;
  const SourceRange last = code_[end - 1].range;
  return first.file == last.file ? SourceRange{first.file, first.begin, last.end} : first;
}

int NameScanner::OpenScope(size_t end, bool of_function, int function) {
  Scope scope;
  scope.parent = open_.back().scope;
  scope.function =
      of_function ? function : names_.scopes_[static_cast<size_t>(scope.parent)].function;
  scope.begin = at_;
  scope.end = code_.size() + 1;
  scope.of_function = of_function;
  const int index = static_cast<int>(names_.scopes_.size());
  names_.scopes_.push_back(scope);
  open_.push_back({index, end, of_function});
  return index;
}

void NameScanner::CloseScope(size_t end) {
  names_.scopes_[static_cast<size_t>(open_.back().scope)].end = end;
  open_.pop_back();
}

void NameScanner::CloseFinishedScopes() {
  while (open_.size() > 1 && open_.back().end != 0 && open_.back().end <= at_) CloseScope(at_);
}

int NameScanner::Declare(Symbol::Kind kind, const Token& name, int scope, Declared declared) {
  declared.name = name.range;
  int index = static_cast<int>(names_.symbols_.size());
  if (kind == Symbol::Kind::kMacro) {
    index = names_.macros_.try_emplace(name.text, index).first->second;
  } else {
    auto& known = kind == Symbol::Kind::kLabel       ? names_.labels_
                  : kind == Symbol::Kind::kStructure ? names_.structures_
                                                     : names_.by_name_;
    index = known.try_emplace({scope, name.text}, index).first->second;
  }
  if (index == static_cast<int>(names_.symbols_.size())) {
    Symbol symbol;
    symbol.kind = kind;
    symbol.name = name.text;
    symbol.scope = scope;
    symbol.function = names_.scopes_[static_cast<size_t>(scope)].function;
    names_.symbols_.push_back(std::move(symbol));
  }
  names_.symbols_[static_cast<size_t>(index)].declarations.push_back(declared);
  AddReference(name, index, Access::kDeclaration);
  return index;
}

void NameScanner::AddReference(const Token& token, int symbol, Access access) {
  names_.references_.push_back({token.range, symbol, access});
  if (access == Access::kCall) names_.symbols_[static_cast<size_t>(symbol)].called = true;
}

void NameScanner::ScanDirectives() {
  for (const Directive& directive : text_.directives()) {
    if (directive.tokens.size() < 3 || !compiler::IsWord(directive.tokens[2])) continue;
    const std::string_view name = directive.tokens[2].text;
    if (directive.word == "define") Define(directive);
    if (directive.word == "define" || directive.word == "undef") {
      names_.macro_events_[name].push_back({directive.order, directive.word == "define"});
    }
  }
}

void NameScanner::Define(const Directive& directive) {
  const std::span<const Token> line = directive.tokens;
  const int index = Declare(Symbol::Kind::kMacro, line[2], 0,
                            {line[2].range, directive.range, directive.order, true});
  Symbol& macro = names_.symbols_[static_cast<size_t>(index)];
  size_t next = 3;
  macro.parameters.clear();
  macro.has_parameters = next < line.size() && line[next].kind == Kind::kOpenParen &&
                         line[next].range.begin == line[2].range.end;
  if (macro.has_parameters) {
    for (++next; next < line.size() && line[next].kind != Kind::kCloseParen; ++next) {
      if (!compiler::IsWord(line[next])) continue;
      Symbol parameter;
      parameter.kind = Symbol::Kind::kMacroParameter;
      parameter.name = line[next].text;
      parameter.declarations.push_back({line[next].range, line[next].range, directive.order, true});
      const int symbol = static_cast<int>(names_.symbols_.size());
      names_.symbols_[static_cast<size_t>(index)].parameters.push_back(symbol);
      names_.symbols_.push_back(std::move(parameter));
      AddReference(line[next], symbol, Access::kDeclaration);
    }
    ++next;
  }
  const size_t body = std::min(next, line.size());
  names_.symbols_[static_cast<size_t>(index)].value.assign(
      line.begin() + static_cast<std::ptrdiff_t>(body), line.end());
}

// The words of a type, from the present place on.
NameScanner::Type NameScanner::ScanType() {
  Type type;
  type.begin = at_;
  size_t last = at_;
  bool named = false;  // what follows a name of a typedef is declared
  while (IsType(KindAt(at_)) || (!named && BeginsType(at_))) {
    const Token& word = code_[at_];
    type.is_const |= word.kind == Kind::kConst;
    type.external |= word.kind == Kind::kExtern;
    type.is_typedef |= word.kind == Kind::kTypedef;
    if (word.kind == Kind::kStructureName) {
      type.structure = text_.catalogue().FindStructure(word.text);
    }
    if (word.kind == Kind::kName) {
      const Symbol& symbol = names_.symbol(names_.Find(word.text, open_.back().scope, at_));
      type.structure = symbol.structure;
      type.members = symbol.members;
      uses_.push_back({at_, open_.back().scope, Use::Kind::kPlain, Access::kRead});
    }
    named |= compiler::NamesType(word.kind) || word.kind == Kind::kName ||
             word.kind == Kind::kEnum || word.kind == Kind::kStruct;
    last = at_++;
    if (word.kind == Kind::kStruct) ScanStructureName(&type, &last);
    if (word.kind != Kind::kEnum) continue;
    if (KindAt(at_) == Kind::kName) last = at_++;
    if (KindAt(at_) == Kind::kOpenBrace) {
      ScanEnumeration(last);
    } else if (code_[last].kind == Kind::kName) {
      uses_.push_back({last, open_.back().scope, Use::Kind::kPlain, Access::kRead});
    }
  }
  type.text = text_.TextOf(RangeOf(type.begin, last + 1));
  return type;
}

// What follows `struct`: its name, its members, or both.
void NameScanner::ScanStructureName(Type* type, size_t* last) {
  if (KindAt(at_) == Kind::kName) *last = at_++;
  if (KindAt(at_) == Kind::kOpenBrace) {
    type->members = ScanMembers(*last);
    return;
  }
  if (code_[*last].kind != Kind::kName) return;
  const int found = names_.FindStructure(code_[*last].text, open_.back().scope, *last);
  if (found < 0) return;
  type->members = names_.symbol(found).members;
  AddReference(code_[*last], found, Access::kRead);
}

// The members of a structure; `last` is the token before the brace. Gives their scope, or -1 of a
// structure in more others than the compiler accepts.
int NameScanner::ScanMembers(size_t last) {
  const size_t close = std::min(match_[at_], code_.size());
  if (structures_ == compiler::kDepthMax) {
    at_ = std::min(close + 1, code_.size());
    return -1;
  }
  ++structures_;
  const int members = ScanMembersUpTo(close, last);
  --structures_;
  return members;
}

int NameScanner::ScanMembersUpTo(size_t close, size_t last) {
  const int outer = open_.back().scope;
  Scope scope;
  scope.parent = outer;
  scope.function = names_.scopes_[static_cast<size_t>(outer)].function;
  scope.begin = scope.end = at_;
  const int members = static_cast<int>(names_.scopes_.size());
  names_.scopes_.push_back(scope);
  if (code_[last].kind == Kind::kName) {
    const int index =
        Declare(Symbol::Kind::kStructure, code_[last], outer,
                {{}, RangeOf(last - 1, std::min(close + 1, code_.size())), last, true});
    names_.symbols_[static_cast<size_t>(index)].members = members;
  }
  ++at_;
  while (at_ < close) {
    if (!BeginsType(at_)) {
      ++at_;
      continue;
    }
    const size_t begin = at_;
    const Type type = ScanType();
    if (KindAt(at_) == Kind::kName && KindAt(at_ + 1) == Kind::kOpenParen) {
      // A function: the `}` before it is missing.
      at_ = begin;
      return members;
    }
    ScanMember(type, members);
    while (at_ < close && KindAt(at_) == Kind::kComma) {
      ++at_;
      ScanMember(type, members);
    }
  }
  at_ = std::min(close + 1, code_.size());
  return members;
}

void NameScanner::ScanMember(const Type& type, int members) {
  bool pointer = false;
  for (; KindAt(at_) == Kind::kStar; ++at_) pointer = true;
  if (KindAt(at_) != Kind::kName) return;
  const size_t name = at_++;
  const int index = Declare(Symbol::Kind::kMember, code_[name], members,
                            {{}, RangeOf(name, name + 1), name, true});
  const size_t dimensions = at_;
  ScanDimensions();
  Symbol& symbol = names_.symbols_[static_cast<size_t>(index)];
  symbol.declarations.back().whole = RangeOf(name, at_);
  symbol.type = type.text;
  symbol.pointer = pointer;
  symbol.is_const = type.is_const;
  symbol.structure = type.structure;
  symbol.members = type.members;
  if (at_ > dimensions) symbol.suffix = text_.TextOf(RangeOf(dimensions, at_));
}

// The constants of an enum; `last` is the token before the brace.
void NameScanner::ScanEnumeration(size_t last) {
  const size_t close = std::min(match_[at_], semicolon_[at_]);
  const int scope = open_.back().scope;
  if (code_[last].kind == Kind::kName) {
    Declare(Symbol::Kind::kEnumeration, code_[last], scope,
            {{}, RangeOf(last, std::min(close + 1, code_.size())), last, true});
  }
  ++at_;
  while (at_ < close) {
    if (KindAt(at_) != Kind::kName) {
      ++at_;
      continue;
    }
    const size_t name = at_++;
    std::vector<Token> value;
    if (KindAt(at_) == Kind::kAssign) ScanInitialiser(&value);
    const int index =
        Declare(Symbol::Kind::kConstant, code_[name], scope, {{}, RangeOf(name, at_), name, true});
    Symbol& constant = names_.symbols_[static_cast<size_t>(index)];
    constant.type = "enum";
    constant.value = std::move(value);
  }
  if (at_ < code_.size() && at_ == close && code_[at_].kind == Kind::kCloseBrace) ++at_;
}

void NameScanner::ScanDeclaration() {
  const Type type = ScanType();
  bool first = true;
  while (ScanDeclarator(type, first) && KindAt(at_) == Kind::kComma) {
    ++at_;
    first = false;
  }
}

// One declared name. False if there is none, or if it was a function.
bool NameScanner::ScanDeclarator(const Type& type, bool first) {
  bool pointer = false;
  for (; KindAt(at_) == Kind::kStar; ++at_) pointer = true;
  if (KindAt(at_) != Kind::kName) return false;
  const size_t name = at_++;
  if (first && KindAt(at_) == Kind::kOpenParen) {
    ScanFunction(type, pointer, name);
    return false;
  }
  const int scope = open_.back().scope;
  const Symbol::Kind kind = type.is_typedef ? Symbol::Kind::kType
                            : scope == 0    ? Symbol::Kind::kGlobal
                                            : Symbol::Kind::kLocal;
  const int index = Declare(kind, code_[name], scope, {{}, {}, name, !type.external});
  const size_t dimensions = at_;
  ScanDimensions();
  const size_t head = at_;
  std::vector<Token> value;
  if (KindAt(at_) == Kind::kAssign) ScanInitialiser(&value);
  Symbol& symbol = names_.symbols_[static_cast<size_t>(index)];
  symbol.declarations.back().whole = first ? RangeOf(type.begin, at_) : RangeOf(name, at_);
  symbol.type = type.text;
  symbol.suffix = head > dimensions ? text_.TextOf(RangeOf(dimensions, head)) : std::string_view();
  symbol.pointer = pointer;
  symbol.is_const = type.is_const;
  symbol.structure = type.structure;
  symbol.members = type.members;
  if (!value.empty()) symbol.value = std::move(value);
  return true;
}

void NameScanner::ScanDimensions() {
  while (KindAt(at_) == Kind::kOpenBracket) {
    const size_t close = std::min(match_[at_], semicolon_[at_]);
    for (++at_; at_ < close;) ScanName();
    if (KindAt(at_) == Kind::kCloseBracket) ++at_;
  }
}

// From the `=` to before the `,` or `;`, or to where a statement seems to begin.
void NameScanner::ScanInitialiser(std::vector<Token>* value) {
  const size_t begin = ++at_;
  int depth = 0;
  while (at_ < code_.size()) {
    const Token& token = code_[at_];
    if (token.kind == Kind::kSemicolon) break;
    if (token.kind == Kind::kComma && depth == 0) break;
    const bool closes = token.kind == Kind::kCloseParen || token.kind == Kind::kCloseBrace ||
                        token.kind == Kind::kCloseBracket;
    if (closes && depth-- == 0) break;
    if (token.on_new_line && (IsType(token.kind) || BeginsWithKeyword(token.kind))) break;
    if (Opens(token.kind)) ++depth;
    ScanName();
  }
  calls_.clear();
  value->assign(code_.begin() + static_cast<std::ptrdiff_t>(begin),
                code_.begin() + static_cast<std::ptrdiff_t>(std::max(at_, begin)));
}

void NameScanner::ScanFunction(const Type& type, bool pointer, size_t name) {
  // Functions are not nested: one inside another shows that a `}` is missing before it.
  const size_t open = at_;
  const size_t close = std::min(match_[open], stop_[open]);
  const size_t brace = KindAt(close) == Kind::kOpenBrace ? close : close + 1;
  const bool body = KindAt(brace) == Kind::kOpenBrace;
  if (body) {
    while (open_.size() > 1) CloseScope(type.begin);
  }
  if (open_.size() > 1 && KindAt(close) != Kind::kCloseParen) return;
  const size_t end =
      body ? std::min(match_[brace], code_.size() - 1) : std::min(close, code_.size() - 1);
  const int index = Declare(Symbol::Kind::kFunction, code_[name], 0,
                            {{}, RangeOf(type.begin, end + 1), name, body});
  Symbol& function = names_.symbols_[static_cast<size_t>(index)];
  const bool known = function.declarations.size() > 1;
  ++at_;
  OpenScope(body ? 0 : close, true, index);
  if (body || !known) {
    function.type = type.text;
    function.pointer = pointer;
    function.members = type.members;
    function.has_parameters = true;
    function.parameters.clear();
    const size_t after = KindAt(close) == Kind::kCloseParen ? close + 1 : close;
    function.suffix = text_.TextOf(RangeOf(open, std::max(after, open + 1)));
  }
  ScanParameters(body || !known ? index : -1, close);
  const size_t after = KindAt(close) == Kind::kCloseParen ? close + 1 : close;
  at_ = std::min(body ? brace + 1 : after, code_.size());
}

// The parameters up to `close`; those of `function` if it is not -1.
void NameScanner::ScanParameters(int function, size_t close) {
  while (at_ < close) {
    if (!BeginsType(at_)) {
      ++at_;
      continue;
    }
    const Type type = ScanType();
    bool pointer = false;
    for (; KindAt(at_) == Kind::kStar; ++at_) pointer = true;
    if (at_ >= close || KindAt(at_) != Kind::kName) continue;
    const size_t name = at_++;
    const int index = Declare(Symbol::Kind::kParameter, code_[name], open_.back().scope,
                              {{}, RangeOf(type.begin, name + 1), name, true});
    const size_t dimensions = at_;
    ScanDimensions();
    Symbol& symbol = names_.symbols_[static_cast<size_t>(index)];
    symbol.type = type.text;
    symbol.structure = type.structure;
    symbol.members = type.members;
    symbol.is_const = type.is_const;
    symbol.pointer = pointer;
    if (at_ > dimensions) symbol.suffix = text_.TextOf(RangeOf(dimensions, at_));
    if (function >= 0) {
      names_.symbols_[static_cast<size_t>(function)].parameters.push_back(index);
    }
  }
}

// --- Uses ----------------------------------------------------------------------------------------

void NameScanner::ScanToken() {
  const Token& token = code_[at_];
  switch (token.kind) {
    case Kind::kOpenBrace:
      calls_.clear();
      ++at_;
      OpenScope(0, false, -1);
      return;
    case Kind::kCloseBrace:
      calls_.clear();
      ++at_;
      // With the loops whose body it ends.
      while (open_.size() > 1 && open_.back().end != 0) CloseScope(at_);
      if (open_.size() > 1) CloseScope(at_);
      return;
    case Kind::kSemicolon:
      calls_.clear();
      ++at_;
      return;
    case Kind::kFor: {
      const size_t open = at_ + 1;
      const bool head = KindAt(open) == Kind::kOpenParen && match_[open] < code_.size();
      ++at_;
      if (head && open_.size() > 1) OpenScope(StatementEnd(match_[open] + 1, 0), false, -1);
      return;
    }
    case Kind::kGoto:
      ++at_;
      // Without its name the label of the next line is not meant.
      if (KindAt(at_) != Kind::kName ||
          (code_[at_].on_new_line && KindAt(at_ + 1) == Kind::kColon)) {
        return;
      }
      uses_.push_back({at_, open_.back().scope, Use::Kind::kLabel, Access::kRead});
      ++at_;
      return;
    default:
      break;
  }
  if (BeginsType(at_) && BeginsDeclaration()) {
    calls_.clear();
    ScanDeclaration();
    return;
  }
  if (IsType(token.kind)) {
    ++at_;
    if (token.kind == Kind::kStruct && KindAt(at_) == Kind::kName) {
      const int found = names_.FindStructure(code_[at_].text, open_.back().scope, at_);
      if (found >= 0) AddReference(code_[at_], found, Access::kRead);
      ++at_;
    }
    return;
  }
  const bool label = token.kind == Kind::kName && KindAt(at_ + 1) == Kind::kColon &&
                     open_.size() > 1 && BeginsStatement();
  if (label) {
    const int scope = names_.FunctionScope(open_.back().scope);
    Declare(Symbol::Kind::kLabel, token, scope, {{}, RangeOf(at_, at_ + 2), at_, true});
    at_ += 2;
    return;
  }
  ScanName();
}

// One token of an expression.
void NameScanner::ScanName() {
  const Token& token = code_[at_];
  if (token.kind == Kind::kOpenParen) {
    const bool call = at_ > 0 && code_[at_ - 1].kind == Kind::kName;
    calls_.push_back({call ? text_.catalogue().Find(code_[at_ - 1].text) : nullptr, 0});
  } else if (token.kind == Kind::kCloseParen) {
    if (!calls_.empty()) calls_.pop_back();
  } else if (token.kind == Kind::kComma) {
    if (!calls_.empty()) ++calls_.back().argument;
  } else if (token.kind == Kind::kName) {
    const int before = at_ > 0 ? code_[at_ - 1].kind : static_cast<int>(Kind::kEnd);
    const bool member = before == Kind::kDot || before == Kind::kArrow;
    const Call* call = calls_.empty() ? nullptr : &calls_.back();
    uses_.push_back({at_, open_.back().scope, member ? Use::Kind::kMember : Use::Kind::kPlain,
                     AccessOf(code_, at_, call)});
  }
  ++at_;
}

// The index after an element or member.
size_t NameScanner::SkipPlace(std::span<const Token> tokens, size_t at) const {
  for (++at; at < tokens.size();) {
    const int kind = tokens[at].kind;
    if (kind == Kind::kDot || kind == Kind::kArrow) {
      at += 2;
    } else if (kind == Kind::kOpenBracket) {
      if (tokens.data() == code_.data()) {
        at = match_[at] + 1;
        continue;
      }
      while (at < tokens.size() && tokens[at].kind != Kind::kCloseBracket) ++at;
      ++at;
    } else {
      break;
    }
  }
  return std::min(at, tokens.size());
}

Access NameScanner::AccessOf(std::span<const Token> tokens, size_t at, const Call* call) const {
  const auto kind_at = [tokens](size_t index) {
    return index < tokens.size() ? tokens[index].kind : static_cast<int>(Kind::kEnd);
  };
  if (kind_at(at + 1) == Kind::kOpenParen) return Access::kCall;
  const size_t after = SkipPlace(tokens, at);
  const int before = at > 0 ? tokens[at - 1].kind : static_cast<int>(Kind::kEnd);
  if (kind_at(after) == Kind::kAssign) return Access::kWrite;
  if (kind_at(after) == Kind::kCompoundAssign || kind_at(after) == Kind::kStep ||
      before == Kind::kStep) {
    return Access::kReadWrite;
  }
  const bool address = before == Kind::kAnd && (at < 2 || !EndsOperand(tokens[at - 2].kind));
  if (call != nullptr && call->command != nullptr &&
      call->argument < call->command->parameters.size()) {
    switch (call->command->parameters[call->argument].passing) {
      case gtcalls::Passing::kOutput:
        return Access::kWrite;
      case gtcalls::Passing::kInput:
        return Access::kRead;
      default:
        break;
    }
  }
  return address ? Access::kReadWrite : Access::kRead;
}

// --- Meanings ------------------------------------------------------------------------------------

int NameScanner::CommandOf(std::string_view name) {
  const gtcalls::Command* const command = text_.catalogue().Find(name);
  if (command == nullptr) return -1;
  const auto [entry, added] = commands_.try_emplace(name, static_cast<int>(names_.symbols_.size()));
  if (added) {
    Symbol symbol;
    symbol.kind = Symbol::Kind::kCommand;
    symbol.name = command->name;
    symbol.command = command;
    symbol.has_parameters = true;
    names_.symbols_.push_back(std::move(symbol));
  }
  return entry->second;
}

// The scope of the members of what stands before a `.` or `->`, as in `a[i]`, `f(x)`, `(*p)`; -1 if
// that is no structure of the program.
int NameScanner::MembersBefore(size_t dot) const {
  for (size_t at = dot; at-- > 0;) {
    const int kind = code_[at].kind;
    if (kind == Kind::kName) {
      const auto found = meanings_.find(at);
      return found == meanings_.end() ? -1 : names_.symbol(found->second).members;
    }
    const bool closes = kind == Kind::kCloseBracket || kind == Kind::kCloseParen;
    if (!closes || match_[at] >= at) return -1;
    const size_t open = match_[at];
    const bool inside = kind == Kind::kCloseParen && (open == 0 || KindAt(open - 1) != Kind::kName);
    if (!inside) at = open;
  }
  return -1;
}

void NameScanner::ResolveUses() {
  for (const Use& use : uses_) {
    const Token& token = code_[use.order];
    int symbol = use.kind == Use::Kind::kLabel ? names_.FindLabel(token.text, use.scope)
                 : use.kind == Use::Kind::kMember
                     ? names_.FindMember(token.text, MembersBefore(use.order - 1))
                     : names_.Find(token.text, use.scope, use.order);
    if (symbol < 0 && use.kind == Use::Kind::kPlain) symbol = CommandOf(token.text);
    if (symbol < 0) continue;
    meanings_[use.order] = symbol;
    const Symbol& found = names_.symbol(symbol);
    if (found.kind == Symbol::Kind::kMacro) {
      places_[symbol].try_emplace(use.scope, use.order);
    }
    AddReference(token, symbol, use.access);
  }
}

// A macro hands the places where it is used on to the macros in its body.
void NameScanner::ResolveBodies() {
  constexpr size_t kPlacesMax = 64;
  std::deque<int> changed;
  for (const auto& [macro, places] : places_) changed.push_back(macro);
  while (!changed.empty()) {
    const int macro = changed.front();
    changed.pop_front();
    for (const Token& token : names_.symbol(macro).value) {
      const auto inner = names_.macros_.find(token.text);
      if (token.kind != Kind::kName || inner == names_.macros_.end()) continue;
      auto& places = places_[inner->second];
      const size_t before = places.size();
      for (const auto& [scope, order] : places_[macro]) {
        if (places.size() < kPlacesMax) places.try_emplace(scope, order);
      }
      if (places.size() != before) changed.push_back(inner->second);
    }
  }
  for (const auto& [name, macro] : names_.macros_) ResolveBody(macro);
}

void NameScanner::ResolveBody(int macro) {
  auto places = places_[macro];
  if (places.empty()) places.emplace(0, code_.size());
  const std::vector<Token> body = names_.symbol(macro).value;
  for (size_t i = 0; i < body.size(); ++i) {
    const int before = i > 0 ? body[i - 1].kind : static_cast<int>(Kind::kEnd);
    if (body[i].kind != Kind::kName || before == Kind::kDot || before == Kind::kArrow) continue;
    const Access access = AccessOf(body, i, nullptr);
    const std::vector<int>& parameters = names_.symbol(macro).parameters;
    const auto parameter = std::ranges::find_if(
        parameters, [&](int index) { return names_.symbol(index).name == body[i].text; });
    if (parameter != parameters.end()) {
      AddReference(body[i], *parameter, access);
      continue;
    }
    std::vector<int> meanings;
    for (const auto& [scope, order] : places) {
      int symbol = before == Kind::kGoto ? names_.FindLabel(body[i].text, scope)
                                         : names_.Find(body[i].text, scope, order);
      if (symbol < 0 && before != Kind::kGoto) symbol = CommandOf(body[i].text);
      if (symbol >= 0 && std::ranges::find(meanings, symbol) == meanings.end()) {
        meanings.push_back(symbol);
      }
    }
    for (const int symbol : meanings) AddReference(body[i], symbol, access);
  }
}

// The macros in the conditions of #if and its relatives, and in #undef.
void NameScanner::ResolveConditions() {
  for (const Directive& directive : text_.directives()) {
    const bool asks = directive.word == "if" || directive.word == "ifdef" ||
                      directive.word == "ifndef" || directive.word == "elif" ||
                      directive.word == "undef";
    if (!asks) continue;
    for (const Token& token : directive.tokens.subspan(2)) {
      const auto macro = names_.macros_.find(token.text);
      if (token.kind != Kind::kName || macro == names_.macros_.end()) continue;
      AddReference(token, macro->second, Access::kRead);
    }
  }
}

}  // namespace oncard::editor
