#include "compiler/parser_driver.h"

#include <algorithm>

namespace oncard::compiler {
namespace {

using Kind = Parser::token;

}  // namespace

bool NamesType(int kind) {
  switch (kind) {
    case Kind::kInt:
    case Kind::kLong:
    case Kind::kShort:
    case Kind::kVoid:
    case Kind::kDouble:
    case Kind::kUnsigned:
    case Kind::kSigned:
    case Kind::kChar:
    case Kind::kFloat:
    case Kind::kBool:
    case Kind::kStructureName:
      return true;
    default:
      return false;
  }
}

bool IsTypeWord(int kind) {
  switch (kind) {
    case Kind::kStatic:
    case Kind::kConst:
    case Kind::kExtern:
    case Kind::kTypedef:
    case Kind::kQualifier:
      return true;
    default:
      return NamesType(kind);
  }
}

SourceRange EndOf(SourceRange range) {
  range.begin = range.end;
  return range;
}

int ParserDriver::Next(Parser::semantic_type* value, SourceRange* location) {
  const Token* token = &tokens_[next_];
  if (token->kind == Kind::kEnd && !braces_.empty()) {
    if (!end_reported_) {
      end_reported_ = true;
      Diagnostic& diagnostic =
          reporter_.Report(Code::kUnexpectedEnd, EndOf(token->range), std::string_view("'}'"));
      AddNote(diagnostic, braces_.back().place,
              MakeMessage("this '{{' is not closed", "此处的 '{{' 没有对应的 '}}'"));
    }
    braces_.pop_back();
    end_brace_.kind = Kind::kCloseBrace;
    end_brace_.range = EndOf(token->range);
    end_brace_.on_new_line = true;
    token = &end_brace_;
  } else if (token->kind != Kind::kEnd) {
    ++next_;
    if (token->kind == Kind::kOpenBrace) {
      braces_.push_back({token->range, BeginsValues(), BeginsMembers()});
    } else if (token->kind == Kind::kCloseBrace && !braces_.empty()) {
      braces_.pop_back();
    }
  }
  const int kind = KindOf(*token);
  previous_ = last_;
  last_ = token;
  *location = token->range;
  if (token->kind != Kind::kEnd) value->emplace<const Token*>(token);
  return kind;
}

// Whether the brace after the last token begins a list of values and not statements.
bool ParserDriver::BeginsValues() const {
  if (last_ == nullptr) return false;
  if (last_->kind == Kind::kAssign || last_->kind == Kind::kEnum || AfterTag(Kind::kEnum)) {
    return true;
  }
  return BeginsValue() || AfterTypeInParens();
}

// Whether the last tokens are a type in parentheses, as in `(struct s){1}`, and not the parameters
// of a function or what a statement begins with.
bool ParserDriver::AfterTypeInParens() const {
  if (dialect_ == Dialect::kCard || last_->kind != Kind::kCloseParen || next_ < 4) return false;
  int closed = 0;
  size_t open = next_ - 2;
  for (const size_t lowest = open > kLookBack ? open - kLookBack : 0; open > lowest; --open) {
    if (tokens_[open].kind == Kind::kCloseParen) ++closed;
    if (tokens_[open].kind == Kind::kOpenParen && --closed == 0) break;
  }
  const int first = tokens_[open + 1].kind;
  const int before = open > 0 ? tokens_[open - 1].kind : Kind::kEnd;
  const bool names_type = IsTypeWord(first) || first == Kind::kEnum || first == Kind::kStruct;
  return closed == 0 && names_type && before != Kind::kName && before != Kind::kFor;
}

// Whether the brace after the last token begins the members of a structure.
bool ParserDriver::BeginsMembers() const {
  return last_ != nullptr && (last_->kind == Kind::kStruct || AfterTag(Kind::kStruct));
}

// Whether the next token is the first one of a value in braces.
bool ParserDriver::BeginsValue() const {
  return last_ != nullptr && !braces_.empty() && braces_.back().initialiser &&
         (last_->kind == Kind::kComma || last_->kind == Kind::kOpenBrace);
}

// Whether the last token is the name of an enum or a structure.
bool ParserDriver::AfterTag(int keyword) const {
  return previous_ != nullptr && previous_->kind == keyword && last_->kind == Kind::kName;
}

// The kind of a token for the grammar: in structured C some depend on what stands before them.
int ParserDriver::KindOf(const Token& token) {
  if (dialect_ == Dialect::kCard) return token.kind;
  switch (token.kind) {
    case Kind::kQuestion:
      ++questions_;
      return token.kind;
    case Kind::kColon:
      if (questions_ == 0) return Kind::kLabelColon;
      --questions_;
      return token.kind;
    case Kind::kOpenBrace:
      questions_ = 0;
      return braces_.back().initialiser ? Kind::kOpenValues : token.kind;
    case Kind::kSemicolon:
    case Kind::kCloseBrace:
      questions_ = 0;
      return token.kind;
    case Kind::kDot:
      return BeginsValue() ? Kind::kDotDesignator : token.kind;
    case Kind::kOpenBracket:
      if (BeginsValue()) return Kind::kOpenDesignator;
      return last_ != nullptr &&
                     (IsTypeWord(last_->kind) || AfterTag(Kind::kEnum) || AfterTag(Kind::kStruct))
                 ? Kind::kOpenAbstract
                 : token.kind;
    default:
      return token.kind;
  }
}

bool ParserDriver::OpenOldStyle() {
  if (dialect_ == Dialect::kCard || !AfterUntypedParameters()) return false;
  const auto brace = std::find_if(
      tokens_.begin() + static_cast<std::ptrdiff_t>(next_), tokens_.end(), [](const Token& token) {
        return token.kind == Kind::kOpenBrace || token.kind == Kind::kCloseBrace;
      });
  if (brace == tokens_.end() || brace->kind != Kind::kOpenBrace) return false;
  const size_t end = static_cast<size_t>(brace - tokens_.begin());
  ReportOldStyle(end);
  next_ = end + 1;
  braces_.push_back({brace->range});
  resume_ = false;
  return true;
}

bool ParserDriver::OpenMissingBrace() {
  braces_.push_back({last_->range});
  // The token after the missing brace has already been counted before it.
  if (last_->kind == Kind::kOpenBrace && braces_.size() >= 2) {
    std::swap(braces_[braces_.size() - 1], braces_[braces_.size() - 2]);
  }
  resume_ = false;
  return last_->kind == Kind::kEnd;
}

bool ParserDriver::InForHeader() const {
  int closed = 0;
  const size_t lowest = next_ > kLookBack ? next_ - kLookBack : 0;
  for (size_t i = next_; i-- > lowest;) {
    const int kind = tokens_[i].kind;
    if (kind == Kind::kCloseParen) ++closed;
    if (kind == Kind::kOpenParen && closed-- == 0) {
      if (i > 0 && tokens_[i - 1].kind == Kind::kFor) return true;
      closed = 0;
    }
    if (kind == Kind::kOpenBrace || kind == Kind::kCloseBrace) return false;
  }
  return false;
}

void ParserDriver::RememberNames(size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    const int kind = tokens_[i].kind;
    if (kind == Kind::kName || kind == Kind::kStructureName) skipped_names_.insert(tokens_[i].text);
  }
}

// Whether a skipped statement with an error continues after a `}`: `union { int a; } b;` and
// `({ a; })` in structured C.
bool ParserDriver::ContinuesAfterBrace(const Token& error, const Token& next) const {
  if (dialect_ == Dialect::kCard) return false;
  if (error.kind == Kind::kReserved) {
    return next.kind == Kind::kName || next.kind == Kind::kStructureName ||
           next.kind == Kind::kStar;
  }
  return error.kind == Kind::kOpenBrace && next.kind == Kind::kCloseParen;
}

bool ParserDriver::SkipStatement() {
  if (resume_) {
    resume_ = false;
    return false;
  }
  if (last_->kind == Kind::kEnd || last_ == &end_brace_) return false;
  if (stuck_at_ == next_) return true;  // a `}` that closes nothing here: skip it

  size_t begin = next_ - 1;  // the token at which the error was found
  const bool in_for = InForHeader();
  int parens = 0;
  for (size_t lowest = begin > kLookBack ? begin - kLookBack : 0; begin > lowest; --begin) {
    const int kind = tokens_[begin - 1].kind;
    if (kind == Kind::kOpenBrace || kind == Kind::kCloseBrace) break;
    if (kind == Kind::kSemicolon && !in_for) break;
    if (kind == Kind::kOpenParen) ++parens;
    if (kind == Kind::kCloseParen) --parens;
    if (kind == Kind::kFor) {
      --begin;
      break;
    }
  }

  size_t at = next_ - 1;
  const Token& error = tokens_[at];
  if (tokens_[at].kind == Kind::kOpenBrace && !braces_.empty()) braces_.pop_back();
  int depth = 0;
  if (tokens_[at].kind == Kind::kCloseBrace) {
    // It closes a block, unless it belongs to an initialiser, which Next() has already handled.
    const bool of_initialiser =
        std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
                    tokens_.begin() + static_cast<std::ptrdiff_t>(at),
                    [](const Token& token) { return token.kind == Kind::kOpenBrace; });
    if (!of_initialiser) {
      RememberNames(begin, at);
      stuck_at_ = next_;
      return false;
    }
  }
  while (!braces_.empty() && braces_.back().initialiser) {
    braces_.pop_back();
    ++depth;
  }
  bool consumed = true;
  for (;; ++at) {
    const int kind = tokens_[at].kind;
    if (kind == Kind::kEnd) break;
    if (kind == Kind::kOpenParen) ++parens;
    if (kind == Kind::kCloseParen) --parens;
    if (kind == Kind::kOpenBrace) ++depth;
    if (kind == Kind::kCloseBrace) {
      if (depth == 0) {
        consumed = at + 1 != next_;
        break;
      }
      if (--depth == 0) {
        // The text after an initialiser still belongs to the statement.
        if (at + 1 < tokens_.size() &&
            (tokens_[at + 1].kind == Kind::kSemicolon || tokens_[at + 1].kind == Kind::kComma)) {
          continue;
        }
        if (ContinuesAfterBrace(error, tokens_[at + 1])) continue;
        ++at;
        break;
      }
    }
    if (kind == Kind::kSemicolon && depth == 0 && !(in_for && parens > 0)) {
      ++at;
      break;
    }
  }
  RememberNames(begin, at);
  next_ = at;
  questions_ = 0;
  return consumed;
}

}  // namespace oncard::compiler
