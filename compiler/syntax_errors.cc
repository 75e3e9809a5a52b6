// The messages of syntax errors: what is missing, or which construct of C cannot be there.
#include <algorithm>
#include <functional>
#include <string>
#include <unordered_map>

#include "compiler/lexer.h"
#include "compiler/parser_driver.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;
using Symbol = Parser::symbol_kind;

// The reason for a reserved word of structured C.
Message WhyNotForTheCard(std::string_view word) {
  if (word == "union") {
    return MakeMessage("on the card each variable has its own storage; declare one for each member",
                       "在控制卡上每个变量都有自己的存储空间；请为每个成员声明一个变量");
  }
  if (word.find("asm") != std::string_view::npos) {
    return MakeMessage("the card does not run machine code", "控制卡不能运行机器码");
  }
  return MakeMessage("leave it out", "请去掉它");
}

}  // namespace

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
  const size_t lowest = next_ > kLookBack ? next_ - kLookBack : 1;
  for (size_t i = next_ - 1; i-- > lowest && tokens_[i - 1].kind != Kind::kOpenParen;) {
    if (tokens_[i - 1].kind != Kind::kName && tokens_[i - 1].kind != Kind::kComma) return false;
    named = true;
  }
  return named;
}

// `(a, b) int a; double b[2];`, whose last `;` is before `end`, as `(int a, double b[2])`. The last
// token is the first one behind the parentheses.
void ParserDriver::ReportOldStyle(size_t end) {
  const size_t begin = next_ - 1;
  size_t open = begin - 1;
  while (tokens_[open].kind != Kind::kOpenParen) --open;
  // The declarations by name.
  std::unordered_map<std::string_view, std::string> declarations;
  std::string type;
  std::string declarator;
  std::string_view name;
  const auto in_type = [&declarator](const Token& token) {
    return declarator.empty() &&
           (IsTypeWord(token.kind) || token.kind == Kind::kEnum || token.kind == Kind::kStruct);
  };
  for (size_t i = begin; i < end; ++i) {
    const Token& token = tokens_[i];
    if (token.kind == Kind::kComma || token.kind == Kind::kSemicolon) {
      declarations.emplace(name, type + declarator);
      declarator.clear();
      if (token.kind == Kind::kSemicolon) type.clear();
    } else if (in_type(token) ||
               ((type.ends_with("enum ") || type.ends_with("struct ")) && declarator.empty())) {
      type += std::string(token.text) + ' ';
    } else {
      if (token.kind == Kind::kName) name = token.text;
      declarator += token.text;
    }
  }
  std::string head = "(";
  for (size_t i = open + 1; i + 1 < begin; ++i) {
    if (tokens_[i].kind != Kind::kName) continue;
    const auto declared = declarations.find(tokens_[i].text);
    if (head.size() > 1) head += ", ";
    // C's old rule: what is not declared is an int.
    head +=
        declared != declarations.end() ? declared->second : "int " + std::string(tokens_[i].text);
  }
  const SourceRange written = Join(tokens_[open].range, tokens_[end - 1].range);
  Diagnostic& diagnostic =
      reporter_.Report(Code::kOldStyle, tokens_[open + 1].range, tokens_[open + 1].text);
  if (tokens_[open].range.file == written.file) Replace(diagnostic, written, head + ')');
}

// Whether the last token follows `int (*name)` or `int *`.
bool ParserDriver::IsAfterPointer() const {
  constexpr size_t kLongest = 6;  // `int (*const name)`
  if (next_ <= kLongest) return false;
  size_t i = next_ - 2;
  if (tokens_[i].kind == Kind::kStar) return IsTypeWord(tokens_[i - 1].kind);
  if (tokens_[i--].kind != Kind::kCloseParen) return false;
  if (tokens_[i].kind == Kind::kName) --i;
  if (tokens_[i].kind == Kind::kConst) --i;
  return tokens_[i].kind == Kind::kStar && tokens_[i - 1].kind == Kind::kOpenParen &&
         IsTypeWord(tokens_[i - 2].kind);
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
  } else if (found.kind == Kind::kOpenParen && (IsTypeWord(before) || IsAfterPointer())) {
    word = "(*)";
    why = MakeMessage("there are no pointers; call functions by name, and name arrays",
                      "没有指针；请用名称调用函数和使用数组");
  } else if (found.kind == Kind::kColon && !braces_.empty() && braces_.back().members) {
    why = MakeMessage("a member has all bits of its type; leave the number of bits out",
                      "成员具有其类型的全部位；请去掉位数");
  } else if (found.kind == Kind::kOpenBrace && operand) {
    why = MakeMessage("a value in braces or a statement inside an expression; use a variable",
                      "表达式中的花括号值或语句；请使用变量");
  } else {
    return false;
  }
  reporter_.Report(Code::kNotForTheCard, found.range, word, why);
  return true;
}

// A syntax error for which structured C knows better than the expected tokens what is meant.
bool ParserDriver::ReportSlip(const std::function<bool(Parser::symbol_kind_type)>& expects) {
  const Token& found = *last_;
  const Message what = DescribeToken(found);
  const int before = previous_ != nullptr ? previous_->kind : Kind::kEnd;
  const bool statement_start = expects(Symbol::S_If);
  if (found.kind == Kind::kElse && statement_start) {
    AddNote(reporter_.Report(Code::kCannotStart, found.range, what),
            MakeMessage("there is no 'if' before it", "它之前没有 'if'"));
  } else if (const Token* const function = UntypedFunction()) {
    Diagnostic& diagnostic = reporter_.Report(
        Code::kNotAType, function->range, DescribeToken(*function),
        MakeMessage("that of the function's value, or void", "函数返回值的类型，或 void"));
    // As C had it before 1999.
    InsertBefore(diagnostic, function->range, "int ");
  } else if (before == Kind::kStar &&
             (found.kind == Kind::kConst || found.kind == Kind::kQualifier)) {
    reporter_.Report(Code::kNeedsPointer, previous_->range, previous_->text);
  } else if (before == Kind::kSizeof && IsTypeWord(found.kind)) {
    reporter_.Report(Code::kMissingOpenParen, found.range, what);
  } else if (!statement_start && IsTypeWord(before) && expects(Symbol::S_CloseParen) &&
             !expects(Symbol::S_Name)) {
    reporter_.Report(Code::kMissingCloseParen, found.range, what);
  } else if (!statement_start && (expects(Symbol::S_Colon) || expects(Symbol::S_LabelColon))) {
    reporter_.Report(Code::kUnexpected, found.range, what, std::string_view("':'"));
  } else if (expects(Symbol::S_Comma) && !expects(Symbol::S_CloseParen) && !braces_.empty() &&
             braces_.back().initialiser) {
    reporter_.Report(Code::kUnexpected, found.range, what, std::string_view("',' or '}'"));
  } else {
    return false;
  }
  return true;
}

// The name of a function that begins without a type, `f(int a) {` or `f() {`, if the last token is
// the first one that cannot be a call.
const Token* ParserDriver::UntypedFunction() const {
  const Token& found = *last_;
  const bool body = found.kind == Kind::kOpenBrace && braces_.size() == 1;
  if (!body && !(IsTypeWord(found.kind) && braces_.empty())) return nullptr;
  size_t open = next_ - 1;
  if (body && (open == 0 || tokens_[open - 1].kind != Kind::kCloseParen)) return nullptr;
  const size_t lowest = open > kLookBack ? open - kLookBack : 0;
  while (open > lowest && tokens_[open].kind != Kind::kOpenParen) {
    if (tokens_[open].kind == Kind::kSemicolon) return nullptr;
    --open;
  }
  if (open == lowest || tokens_[open - 1].kind != Kind::kName) return nullptr;
  const bool first = open == 1 || tokens_[open - 2].kind == Kind::kSemicolon ||
                     tokens_[open - 2].kind == Kind::kCloseBrace;
  return first ? &tokens_[open - 1] : nullptr;
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
  if (dialect_ == Dialect::kStructured && (ReportUntranslatable(operand) || ReportSlip(has))) {
    return;
  }
  if (before == Kind::kGoto) {
    reporter_.Report(Code::kMissingLabel, found.range, what);
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

}  // namespace oncard::compiler
