#include "compiler/parser_driver.h"

#include <algorithm>

#include "compiler/lexer.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;
using Symbol = Parser::symbol_kind;

// How far back to search for the names in a skipped statement and for the head of a `for`.
constexpr size_t kLookBack = 64;

bool IsTypeWord(int kind) {
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
    case Kind::kStatic:
    case Kind::kConst:
    case Kind::kExtern:
    case Kind::kQualifier:
    case Kind::kStructureName:
      return true;
    default:
      return false;
  }
}

// The reason for a reserved word of structured C.
Message WhyNotForTheCard(std::string_view word) {
  if (word == "struct" || word == "union") {
    return MakeMessage(
        "the only structures are TTrapPrm, TJogPrm and TPid; declare a variable or an array for "
        "each member",
        "只有 TTrapPrm、TJogPrm 和 TPid 三种结构；请为每个成员声明一个变量或数组");
  }
  if (word == "typedef") return MakeMessage("write the type itself", "请直接写出类型");
  if (word.find("asm") != std::string_view::npos) {
    return MakeMessage("the card does not run machine code", "控制卡不能运行机器码");
  }
  return MakeMessage("leave it out", "请去掉它");
}

int DepthOf(const ExpressionPtr& expression) { return expression ? expression->depth : 0; }
int DepthOf(const StatementPtr& statement) { return statement ? statement->depth : 0; }

int DepthOf(const TypeName& type) {
  int depth = 0;
  for (const ExpressionPtr& size : type.sizes) depth = std::max(depth, DepthOf(size));
  if (type.specifiers.enumeration == nullptr) return depth;
  for (const Enumerator& constant : type.specifiers.enumeration->enumerators) {
    depth = std::max(depth, DepthOf(constant.value));
  }
  return depth;
}

SourceRange EndOf(SourceRange range) {
  range.begin = range.end;
  return range;
}

}  // namespace

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
      braces_.push_back({token->range, BeginsValues()});
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
  if (last_->kind == Kind::kAssign || last_->kind == Kind::kEnum || AfterEnumName()) return true;
  return !braces_.empty() && braces_.back().initialiser &&
         (last_->kind == Kind::kComma || last_->kind == Kind::kOpenBrace);
}

bool ParserDriver::AfterEnumName() const {
  return previous_ != nullptr && previous_->kind == Kind::kEnum && last_->kind == Kind::kName;
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
    case Kind::kOpenBracket:
      return last_ != nullptr && (IsTypeWord(last_->kind) || AfterEnumName()) ? Kind::kOpenAbstract
                                                                              : token.kind;
    default:
      return token.kind;
  }
}

bool ParserDriver::OpenMissingBrace() {
  // `int f(a) int a; {`: the types of the parameters are skipped.
  if (dialect_ == Dialect::kStructured && AfterUntypedParameters()) {
    const auto brace =
        std::find_if(tokens_.begin() + static_cast<std::ptrdiff_t>(next_), tokens_.end(),
                     [](const Token& token) {
                       return token.kind == Kind::kOpenBrace || token.kind == Kind::kCloseBrace;
                     });
    if (brace != tokens_.end() && brace->kind == Kind::kOpenBrace) {
      next_ = static_cast<size_t>(brace - tokens_.begin()) + 1;
      braces_.push_back({brace->range, false});
      resume_ = false;
      return true;
    }
  }
  braces_.push_back({last_->range, false});
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
    if (tokens_[i].kind == Kind::kName) skipped_names_.insert(tokens_[i].text);
  }
}

// Whether a skipped statement with an error continues after a `}`: `struct { int a; } b;` and
// `({ a; })` in structured C.
bool ParserDriver::ContinuesAfterBrace(const Token& error, const Token& next) const {
  if (dialect_ == Dialect::kCard) return false;
  if (error.kind == Kind::kReserved) return next.kind == Kind::kName || next.kind == Kind::kStar;
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

void ParserDriver::ReportReservedWord(const Token& token) {
  Message hint;
  if (token.kind == Kind::kElse) {
    hint = MakeMessage("there is no 'if' before it", "它之前没有 'if'");
  } else if (token.text == "sizeof") {
    hint = MakeMessage("write the number", "请直接写出数值");
  } else if (token.text == "enum") {
    hint = MakeMessage("write a #define for each name", "请为每个名称写一条 #define");
  } else if (token.text == "typedef") {
    hint = MakeMessage("write int or double", "请直接写 int 或 double");
  } else {
    hint = MakeMessage("the only structures are TTrapPrm, TJogPrm and TPid",
                       "只有 TTrapPrm、TJogPrm 和 TPid 三种结构");
  }
  reporter_.Report(Code::kReservedWord, token.range, token.text, hint);
}

// Whether the last token follows the parentheses of `f(a, b)`, in which no parameter has a type.
bool ParserDriver::AfterUntypedParameters() const {
  bool named = false;
  for (size_t i = next_ - 1; i-- > 1 && tokens_[i - 1].kind != Kind::kOpenParen;) {
    if (tokens_[i - 1].kind != Kind::kName && tokens_[i - 1].kind != Kind::kComma) return false;
    named = true;
  }
  return named;
}

// A syntax error that is a construct of C which structured C leaves out: reports the reason.
bool ParserDriver::ReportUntranslatable(bool operand) {
  const Token& found = *last_;
  const int before = previous_ != nullptr ? previous_->kind : Kind::kEnd;
  std::string_view word = found.text;
  Message why;
  if (found.kind == Kind::kReserved) {
    why = WhyNotForTheCard(word);
  } else if (before == Kind::kGoto && found.kind == Kind::kStar) {
    word = "goto *";
    why = MakeMessage("jump to a label, and choose one with 'switch'",
                      "请跳转到标号，并用 'switch' 选择");
  } else if (operand && found.text == "&&") {
    why = MakeMessage("a label has no address; choose one with 'switch'",
                      "标号没有地址；请用 'switch' 选择");
  } else if (found.kind == Kind::kEllipsis && !operand) {
    why = MakeMessage("a function has a fixed number of parameters", "函数的参数个数是固定的");
  } else if (found.kind == Kind::kOpenParen && IsTypeWord(before)) {
    word = "(*)";
    why = MakeMessage("there are no pointers to functions; call them by name",
                      "没有函数指针；请用名称调用函数");
  } else if ((found.kind == Kind::kOpenBracket || found.kind == Kind::kDot) && operand &&
             !braces_.empty() && braces_.back().initialiser) {
    why = MakeMessage("write all values in order, without the places that they are for",
                      "请按顺序写出所有的值，不要写明位置");
  } else if (found.kind == Kind::kOpenBrace && operand) {
    why = MakeMessage("a value in braces or a statement inside an expression; use a variable",
                      "表达式中的花括号值或语句；请使用变量");
  } else {
    return false;
  }
  reporter_.Report(Code::kNotForTheCard, found.range, word, why);
  return true;
}

void ParserDriver::SyntaxError(std::span<const Parser::symbol_kind_type> expected) {
  const auto has = [expected](Parser::symbol_kind_type kind) {
    return std::find(expected.begin(), expected.end(), kind) != expected.end();
  };
  const Token& found = *last_;
  const int before = previous_ != nullptr ? previous_->kind : Kind::kEnd;
  const SourceRange after_previous = previous_ != nullptr ? EndOf(previous_->range) : found.range;
  const Message what = DescribeToken(found);
  resume_ = false;
  errors_here_ = last_ == error_at_ ? errors_here_ + 1 : 0;
  error_at_ = last_;
  if (errors_here_ > 0) return;

  // The lexer has reported these; consequential errors are not reported.
  if (found.kind == Kind::kInvalid || found.literal.invalid) return;
  if (previous_ != nullptr && previous_->literal.invalid && !found.on_new_line) return;
  if (found.kind == Kind::kHash) {
    reporter_.Report(Code::kIllegalCharacter, found.range, std::string_view("'#'"));
    return;
  }
  const bool statement_start = has(Symbol::S_If);
  const bool operand = has(Symbol::S_Integer) && !statement_start;
  if (dialect_ == Dialect::kStructured && ReportUntranslatable(operand)) return;
  if (before == Kind::kGoto) {
    reporter_.Report(Code::kMissingLabel, found.range, what);
    return;
  }
  if (dialect_ == Dialect::kStructured && found.kind == Kind::kElse && statement_start) {
    AddNote(reporter_.Report(Code::kCannotStart, found.range, what),
            MakeMessage("there is no 'if' before it", "它之前没有 'if'"));
    return;
  }
  if (found.kind == Kind::kReserved || (found.kind == Kind::kElse && statement_start)) {
    ReportReservedWord(found);
    return;
  }
  const Token* following = next_ < tokens_.size() ? &tokens_[next_] : nullptr;
  if (!operand && !statement_start && (found.kind == Kind::kInteger || found.kind == Kind::kName) &&
      following != nullptr && following->kind == Kind::kCloseBracket) {
    InsertBefore(reporter_.Report(Code::kMissingOpenBracket, found.range, what), found.range, "[");
    return;
  }
  if (has(Symbol::S_OpenBrace) && before == Kind::kCloseParen && !statement_start) {
    if (dialect_ == Dialect::kStructured && AfterUntypedParameters()) return;  // reported later
    Diagnostic& diagnostic = reporter_.Report(Code::kMissingOpenBrace, found.range, what);
    InsertAfter(diagnostic, after_previous, " {");
    return;
  }
  if (found.kind == Kind::kEnd) {
    const char* wanted = has(Symbol::S_Semicolon) && !statement_start ? "';'"
                         : has(Symbol::S_CloseParen)                  ? "')'"
                         : has(Symbol::S_CloseBracket)                ? "']'"
                                                                      : nullptr;
    reporter_.Report(Code::kUnexpectedEnd, EndOf(found.range),
                     wanted != nullptr
                         ? ToMessage(std::string_view(wanted))
                         : MakeMessage("the rest of the statement", "语句的其余部分"));
    return;
  }
  const bool other_than_name = has(Symbol::S_Semicolon) || has(Symbol::S_Int) ||
                               has(Symbol::S_CloseParen) || has(Symbol::S_CloseBracket);
  if (statement_start) {
    reporter_.Report(Code::kCannotStart, found.range, what);
  } else if (operand) {
    reporter_.Report(Code::kExpectedOperand, found.range, what);
  } else if (has(Symbol::S_Name) && (IsTypeWord(before) || !other_than_name)) {
    reporter_.Report(Code::kExpectedName, found.range, what);
  } else if (has(Symbol::S_Semicolon)) {
    Diagnostic& diagnostic = reporter_.Report(Code::kMissingSemicolon, after_previous, what);
    InsertAfter(diagnostic, after_previous, ";");
    resume_ = found.on_new_line || found.kind == Kind::kCloseBrace;
  } else if (has(Symbol::S_Int) && before != Kind::kStar) {
    reporter_.Report(Code::kNotAType, found.range, what,
                     std::string_view("int, double, long, short"));
  } else if (dialect_ == Dialect::kStructured &&
             (has(Symbol::S_Colon) || has(Symbol::S_LabelColon))) {
    reporter_.Report(Code::kUnexpected, found.range, what, std::string_view("':'"));
  } else if (has(Symbol::S_CloseParen)) {
    reporter_.Report(Code::kMissingCloseParen, found.range, what);
  } else if (has(Symbol::S_CloseBracket)) {
    reporter_.Report(Code::kMissingCloseBracket, found.range, what);
  } else if (has(Symbol::S_OpenParen)) {
    reporter_.Report(Code::kMissingOpenParen, found.range, what);
  } else {
    reporter_.Report(Code::kUnexpected, found.range, what,
                     std::string_view(has(Symbol::S_Colon)   ? "':'"
                                      : has(Symbol::S_While) ? "'while (...);'"
                                                             : "'}'"));
  }
}

void ParserDriver::LimitDepth(Expression& expression) {
  int depth = 0;
  for (const ExpressionPtr& operand : expression.operands) {
    depth = std::max(depth, DepthOf(operand));
  }
  if (expression.type != nullptr) depth = std::max(depth, DepthOf(*expression.type));
  expression.depth = depth + 1;
  if (expression.depth <= kDepthMax) return;
  if (!too_deep_reported_) {
    reporter_.Report(Code::kTooDeep, expression.range, int64_t{kDepthMax});
    too_deep_reported_ = true;
  }
  expression.kind = Expression::Kind::kError;
  expression.operands.clear();
  expression.type.reset();
  expression.depth = 1;
}

StatementPtr ParserDriver::LimitDepth(StatementPtr statement) {
  int depth = std::max(
      {DepthOf(statement->initial), DepthOf(statement->body), DepthOf(statement->else_body)});
  for (const StatementPtr& item : statement->items) depth = std::max(depth, DepthOf(item));
  if (statement->function != nullptr) {
    for (const StatementPtr& item : statement->function->body) {
      depth = std::max(depth, DepthOf(item));
    }
  }
  statement->depth = depth + 1;
  if (statement->depth <= kDepthMax) return statement;
  if (!too_deep_reported_) {
    reporter_.Report(Code::kTooDeep, statement->keyword, int64_t{kDepthMax});
    too_deep_reported_ = true;
  }
  return MakeStatement(Statement::Kind::kError, statement->range);
}

ExpressionPtr ParserDriver::Binary(Expression::Kind kind, ExpressionPtr left, const Token* op,
                                   ExpressionPtr right, SourceRange range) {
  ExpressionPtr result = MakeExpression(kind, range);
  result->op = op->text;
  result->op_range = op->range;
  result->operands.push_back(std::move(left));
  result->operands.push_back(std::move(right));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::Unary(Expression::Kind kind, const Token* op, ExpressionPtr operand,
                                  SourceRange range) {
  ExpressionPtr result = MakeExpression(kind, range);
  result->op = op->text;
  result->op_range = op->range;
  result->operands.push_back(std::move(operand));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::Conditional(ExpressionPtr condition, const Token* op, ExpressionPtr yes,
                                        ExpressionPtr no, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kConditional, range);
  result->op = op->text;
  result->op_range = op->range;
  result->operands.push_back(std::move(condition));
  result->operands.push_back(std::move(yes));
  result->operands.push_back(std::move(no));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::Cast(TypeNamePtr type, ExpressionPtr operand, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kCast, range);
  // Only a single word can be the type of a cast.
  const std::vector<const Token*>& words = type->specifiers.words;
  if (words.size() == 1 && !type->pointer) result->text = words[0]->text;
  result->op_range = type->specifiers.range;
  result->type = std::move(type);
  result->operands.push_back(std::move(operand));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::SizeOf(ExpressionPtr operand, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kSizeof, range);
  result->operands.push_back(std::move(operand));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::SizeOfType(TypeNamePtr type, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kSizeof, range);
  result->type = std::move(type);
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::Index(ExpressionPtr array, ExpressionPtr index, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kIndex, range);
  result->operands.push_back(std::move(array));
  result->operands.push_back(std::move(index));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::Call(ExpressionPtr callee, std::vector<ExpressionPtr> arguments,
                                 SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kCall, range);
  result->operands.push_back(std::move(callee));
  for (ExpressionPtr& argument : arguments) result->operands.push_back(std::move(argument));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::Member(ExpressionPtr structure, const Token* op, const Token* name,
                                   SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kMember, range);
  result->op = op->text;
  result->op_range = name->range;
  result->text = name->text;
  result->operands.push_back(std::move(structure));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::Paren(ExpressionPtr inner, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kParen, range);
  result->operands.push_back(std::move(inner));
  LimitDepth(*result);
  return result;
}

ExpressionPtr ParserDriver::Braces(std::vector<ExpressionPtr> values, SourceRange range) {
  ExpressionPtr result = MakeExpression(Expression::Kind::kBraces, range);
  result->operands = std::move(values);
  LimitDepth(*result);
  return result;
}

StatementPtr ParserDriver::ExpressionStatement(ExpressionPtr value, SourceRange range) {
  too_deep_reported_ = false;
  StatementPtr statement = MakeStatement(
      value == nullptr ? Statement::Kind::kEmpty : Statement::Kind::kExpression, range);
  statement->value = std::move(value);
  return statement;
}

StatementPtr ParserDriver::BrokenStatement(ExpressionPtr value, SourceRange range) {
  if (resume_) return ExpressionStatement(std::move(value), range);
  return MakeStatement(Statement::Kind::kError, range);
}

StatementPtr ParserDriver::If(SourceRange keyword, ExpressionPtr condition, StatementPtr body,
                              SourceRange else_keyword, StatementPtr else_body, SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kIf, range);
  statement->keyword = keyword;
  statement->value = std::move(condition);
  statement->body = std::move(body);
  statement->other = else_keyword;
  statement->else_body = std::move(else_body);
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::Loop(Statement::Kind kind, SourceRange keyword, ExpressionPtr condition,
                                StatementPtr body, SourceRange range) {
  StatementPtr statement = MakeStatement(kind, range);
  statement->keyword = keyword;
  statement->value = std::move(condition);
  statement->body = std::move(body);
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::For(SourceRange keyword, StatementPtr initial, ExpressionPtr condition,
                               ExpressionPtr step, StatementPtr body, SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kFor, range);
  statement->keyword = keyword;
  statement->initial = std::move(initial);
  statement->value = std::move(condition);
  statement->step = std::move(step);
  statement->body = std::move(body);
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::Return(SourceRange keyword, ExpressionPtr value, SourceRange range) {
  too_deep_reported_ = false;
  StatementPtr statement = MakeStatement(Statement::Kind::kReturn, range);
  statement->keyword = keyword;
  statement->value = std::move(value);
  return statement;
}

StatementPtr ParserDriver::FunctionItem(std::unique_ptr<Function> function, SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kFunction, range);
  statement->keyword = function->header;
  statement->function = std::move(function);
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::Block(std::vector<StatementPtr> items, SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kBlock, range);
  statement->items = std::move(items);
  statement->keyword = range;
  statement->keyword.end = range.begin + 1;
  return LimitDepth(std::move(statement));
}

StatementPtr ParserDriver::Labelled(std::vector<StatementPtr> labels, StatementPtr statement,
                                    SourceRange range) {
  StatementPtr block = MakeStatement(Statement::Kind::kBlock, range);
  block->keyword = labels.front()->range;
  block->items = std::move(labels);
  block->items.push_back(std::move(statement));
  return LimitDepth(std::move(block));
}

SourceRange Join(SourceRange first, SourceRange last) {
  if (first.file != last.file || last.end < first.begin) return last;
  return {first.file, first.begin, last.end};
}

void Append(std::vector<StatementPtr>& items, StatementPtr item) {
  items.push_back(std::move(item));
}

StatementPtr MakeStatement(Statement::Kind kind, SourceRange range) {
  StatementPtr statement = std::make_unique<Statement>();
  statement->kind = kind;
  statement->range = statement->keyword = range;
  return statement;
}

StatementPtr MakeNamed(Statement::Kind kind, const Token* name, SourceRange name_range,
                       SourceRange range) {
  StatementPtr statement = MakeStatement(kind, range);
  statement->name = name->text;
  statement->name_range = name_range;
  return statement;
}

StatementPtr MakeDeclaration(Specifiers specifiers, std::vector<Declarator> declarators,
                             SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kDeclaration, range);
  statement->keyword = specifiers.range;
  statement->specifiers = std::move(specifiers);
  statement->declarators = std::move(declarators);
  return statement;
}

std::unique_ptr<Enumeration> MakeEnumeration(const Token* name, SourceRange range) {
  auto enumeration = std::make_unique<Enumeration>();
  enumeration->range = range;
  if (name != nullptr) {
    enumeration->name = name->text;
    enumeration->name_range = name->range;
  }
  return enumeration;
}

StatementPtr MakeEnumDeclaration(std::unique_ptr<Enumeration> enumeration, SourceRange range) {
  Specifiers specifiers;
  specifiers.range = enumeration->range;
  specifiers.enumeration = std::move(enumeration);
  return MakeDeclaration(std::move(specifiers), {}, range);
}

StatementPtr MakeCase(SourceRange keyword, ExpressionPtr value, ExpressionPtr last,
                      SourceRange range) {
  StatementPtr statement = MakeStatement(Statement::Kind::kCase, range);
  statement->keyword = keyword;
  statement->value = std::move(value);
  statement->last = std::move(last);
  return statement;
}

TypeNamePtr MakeTypeName(Specifiers specifiers, bool pointer, std::vector<ExpressionPtr> sizes,
                         SourceRange range) {
  auto type = std::make_unique<TypeName>();
  type->range = range;
  type->specifiers = std::move(specifiers);
  type->pointer = pointer;
  type->sizes = std::move(sizes);
  return type;
}

std::vector<ExpressionPtr> PutFirst(ExpressionPtr first, std::vector<ExpressionPtr> others) {
  others.insert(others.begin(), std::move(first));
  return others;
}

ExpressionPtr MakeExpression(Expression::Kind kind, SourceRange range) {
  ExpressionPtr expression = std::make_unique<Expression>();
  expression->kind = kind;
  expression->range = range;
  return expression;
}

ExpressionPtr MakeLiteral(const Token* token, SourceRange range) {
  ExpressionPtr expression = MakeExpression(Expression::Kind::kLiteral, range);
  expression->literal = token->literal;
  expression->text = token->text;
  return expression;
}

std::unique_ptr<Function> MakeFunction(Specifiers specifiers, bool pointer, const Token* name,
                                       std::vector<ParameterDeclaration> parameters,
                                       SourceRange range) {
  auto function = std::make_unique<Function>();
  function->header = range;
  function->name = name->text;
  function->name_range = name->range;
  function->specifiers = std::move(specifiers);
  function->pointer = pointer;
  function->parameters = std::move(parameters);
  return function;
}

void CloseFunction(Function& function, SourceRange open_brace, std::vector<StatementPtr> body,
                   SourceRange close_brace) {
  function.open_brace = open_brace;
  function.close_brace = close_brace;
  function.body = std::move(body);
}

}  // namespace oncard::compiler
