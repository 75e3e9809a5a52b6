// The scanner. Bytes above 0x7F are only allowed in comments and file names, where GBK and UTF-8
// need not be distinguished: the second byte of a GBK character is never a quote, a star, a slash
// or a line end. It can be a backslash, which structured C would see.
#include "compiler/lexer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>
#include <unordered_set>

#include "base/number.h"
#include "compiler/header_types.h"
#include "compiler/operators.h"
#include "compiler/parser.hh"
#include "compiler/text.h"
#include "vm/limits.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;

// Characters that are tokens by themselves.
constexpr std::string_view kPunctuation = "(){}[];:,=<>+-*/%!&|^~?.";

struct Keyword {
  std::string_view text;
  int kind;
};

// Words that are names in the card's language.
constexpr Keyword kStructuredKeywords[] = {
    {"bool", Kind::kBool},          {"_Bool", Kind::kBool},         {"volatile", Kind::kQualifier},
    {"register", Kind::kQualifier}, {"auto", Kind::kQualifier},     {"inline", Kind::kQualifier},
    {"__volatile", Kind::kQualifier}, {"__volatile__", Kind::kQualifier},
    {"__inline", Kind::kQualifier}, {"__inline__", Kind::kQualifier},
    {"asm", Kind::kReserved},       {"__asm", Kind::kReserved},     {"__asm__", Kind::kReserved},
    {"_Generic", Kind::kReserved},  {"_Atomic", Kind::kReserved},   {"_Complex", Kind::kReserved},
    {"_Alignas", Kind::kReserved},  {"_Alignof", Kind::kReserved},  {"_Noreturn", Kind::kReserved},
    {"restrict", Kind::kReserved},  {"__restrict", Kind::kReserved},
    {"__restrict__", Kind::kReserved}, {"__extension__", Kind::kReserved},
    {"__attribute", Kind::kReserved}, {"__attribute__", Kind::kReserved},
    {"_Static_assert", Kind::kReserved}, {"_Thread_local", Kind::kReserved}};

// The text before the suffix of a C floating-point number; empty for any other text.
std::string_view WithoutSuffix(std::string_view text) {
  const char suffix = static_cast<char>(text.back() | 0x20);
  if (suffix != 'f' && suffix != 'l') return {};
  text.remove_suffix(1);
  const bool fraction = text.find_first_of(".eE") != std::string_view::npos;
  return fraction && ReadNumber(text) ? text : std::string_view();
}

class Lexer {
 public:
  Lexer(const SourceFile& file, int file_index, size_t token_max,
        const gtcalls::Catalogue& catalogue, Reporter& reporter, Dialect dialect)
      : text_(file.text()),
        file_(file_index),
        token_max_(token_max),
        catalogue_(catalogue),
        reporter_(reporter),
        structured_(dialect == Dialect::kStructured),
        utf8_(IsUtf8(file.text())) {}

  std::vector<Token> Run();

 private:
  SourceRange Range(const char* begin, const char* end) const {
    return {file_, static_cast<uint32_t>(begin - text_.data()),
            static_cast<uint32_t>(end - text_.data())};
  }
  void Add(int kind, const char* begin, const char* end, const Literal& literal = {});
  void AddName(const char* begin, const char* end);
  const char* Digraph(int kind, std::string_view text, const char* begin, const char* limit);
  void AddEllipsis(const char* begin, const char* end);
  void AddInteger(const char* begin, const char* end);
  void AddIntegerOfC(const char* begin, const char* end);
  void AddOctal(const char* begin, const char* end);
  void AddOtherNumber(const char* begin, const char* end);
  const char* AddWideCharacter(const char* begin, const char* end);
  void AddCharacter(const char* begin, const char* end);
  void AddFixed(const char* begin, const char* end);
  void AddBadNumber(Code code, const char* begin, const char* end);
  void AddUnsuffixed(std::string_view number, Diagnostic& diagnostic, const char* begin,
                     const char* end);
  void AddString(const char* begin, const char* end);
  const char* EndOfString(const char* begin, const char* end, const char* limit) const;
  const char* SkipComment(const char* begin, const char* limit);
  const char* Continuation(const char* begin, const char* end, const char* limit);
  const char* Operator(const char* begin, const char* limit);
  const char* IllegalCharacters(const char* begin, const char* limit);
  void Scan(const char* cursor, const char* limit);

  std::string_view text_;
  int file_;
  size_t token_max_;
  const gtcalls::Catalogue& catalogue_;
  Reporter& reporter_;
  bool structured_;
  bool utf8_;
  bool new_line_ = true;
  std::vector<Token> tokens_;
  std::unordered_set<std::string_view> long_names_;
};

void Lexer::Add(int kind, const char* begin, const char* end, const Literal& literal) {
  Token& token = tokens_.emplace_back();
  token.kind = kind;
  token.range = Range(begin, end);
  token.text = {begin, static_cast<size_t>(end - begin)};
  token.literal = literal;
  token.on_new_line = new_line_;
  new_line_ = false;
}

// Two characters that C reads as one, for keyboards without it; the card's language sees two.
const char* Lexer::Digraph(int kind, std::string_view text, const char* begin, const char* limit) {
  if (structured_) {
    Add(kind, begin, begin + 2);
    tokens_.back().text = text;
    return begin + 2;
  }
  if (*begin != ':') return Operator(begin, limit);
  Add(Kind::kColon, begin, begin + 1);
  return begin + 1;
}

// The card's language has no `...`: it sees three points.
void Lexer::AddEllipsis(const char* begin, const char* end) {
  if (structured_) {
    Add(Kind::kEllipsis, begin, end);
    return;
  }
  for (const char* dot = begin; dot != end; ++dot) Add(Kind::kDot, dot, dot + 1);
}

void Lexer::AddName(const char* begin, const char* end) {
  const std::string_view name(begin, static_cast<size_t>(end - begin));
  if (structured_) {
    // The types of C's headers are read as types, so that there is one message about each.
    if (!TypeForHeaderType(name).empty()) {
      Add(Kind::kInt, begin, end);
      return;
    }
    for (const Keyword& keyword : kStructuredKeywords) {
      if (keyword.text != name) continue;
      Add(keyword.kind, begin, end);
      return;
    }
  }
  if (!structured_ && name.size() > vm::kNameLengthMax && long_names_.insert(name).second) {
    reporter_.Report(Code::kNameTooLong, Range(begin, end), name,
                     static_cast<int64_t>(name.size()), int64_t{vm::kNameLengthMax});
  }
  const gtcalls::Structure* structure =
      name.starts_with('T') ? catalogue_.FindStructure(name) : nullptr;
  Add(structure != nullptr && structure->in_motion_program ? Kind::kStructureName : Kind::kName,
      begin, end);
}

void Lexer::AddInteger(const char* begin, const char* end) {
  if (structured_) {
    AddIntegerOfC(begin, end);
    return;
  }
  const char* digits_end = end;
  while (std::string_view("uUlL").find(digits_end[-1]) != std::string_view::npos) --digits_end;
  Add(Kind::kInteger, begin, end,
      ParseInteger({begin, static_cast<size_t>(digits_end - begin)}));
}

// Also what is no number at all.
void Lexer::AddIntegerOfC(const char* begin, const char* end) {
  const std::string_view text(begin, static_cast<size_t>(end - begin));
  if (const std::optional<Literal> literal = ParseIntegerOfC(text)) {
    Add(Kind::kInteger, begin, end, *literal);
    return;
  }
  const bool decimal = text.find_first_not_of("0123456789") == std::string_view::npos;
  AddBadNumber(decimal ? Code::kOctal : Code::kMalformedLiteral, begin, end);
}

void Lexer::AddOctal(const char* begin, const char* end) {
  if (structured_) {
    AddIntegerOfC(begin, end);
  } else {
    AddBadNumber(Code::kOctal, begin, end);
  }
}

// A word that begins with a digit.
void Lexer::AddOtherNumber(const char* begin, const char* end) {
  if (structured_ && std::string_view(begin, static_cast<size_t>(end - begin)).find('.') ==
                         std::string_view::npos) {
    AddIntegerOfC(begin, end);
  } else {
    AddBadNumber(Code::kMalformedLiteral, begin, end);
  }
}

void Lexer::AddFixed(const char* begin, const char* end) {
  Add(Kind::kFixed, begin, end, ParseFixed({begin, static_cast<size_t>(end - begin)}));
}

void Lexer::AddBadNumber(Code code, const char* begin, const char* end) {
  const std::string_view text(begin, static_cast<size_t>(end - begin));
  if (code == Code::kOctal) {
    const std::string number = WithoutLeadingZero(text);
    Replace(reporter_.Report(code, Range(begin, end), text, number), Range(begin, end), number);
  } else {
    Diagnostic& diagnostic = reporter_.Report(code, Range(begin, end), text);
    if (const std::string_view number = WithoutSuffix(text); !number.empty()) {
      AddUnsuffixed(number, diagnostic, begin, end);
      return;
    }
  }
  Literal literal;
  literal.invalid = true;
  Add(Kind::kInteger, begin, end, literal);
}

// `12.5f`: a float of C. The fix-it is the number without the suffix, if its value is the same.
void Lexer::AddUnsuffixed(std::string_view number, Diagnostic& diagnostic, const char* begin,
                          const char* end) {
  const Literal literal = ParseFixed(number);
  Add(Kind::kFixed, begin, end, literal);
  const bool is_float = (end[-1] | 0x20) == 'f';
  const double value = ReadLeadingFloat(number);
  // All its digits: a float needs only a few.
  const std::string exact = fmt::format("{:.60f}", value);
  if (!is_float || ParseFixed(exact).magnitude == literal.magnitude) {
    Replace(diagnostic, Range(begin, end), std::string(number));
    return;
  }
  AddNote(diagnostic, MakeMessage("a float of C is {0} here; write that, or {1}",
                                  "C 语言的 float 在此处是 {0}；请写成它，或 {1}", value,
                                  number));
}

void Lexer::AddString(const char* begin, const char* end) {
  if (end - begin < 2 || end[-1] != *begin) {
    Diagnostic& diagnostic = reporter_.Report(Code::kMissingQuote, Range(begin, end));
    InsertAfter(diagnostic, Range(begin, end), std::string(1, *begin));
  }
  Add(Kind::kString, begin, end);
}

// The end of a string that the rules have read up to a quote: in structured C a quote after a
// backslash does not end it, but one after a GBK character whose second byte is 0x5C does.
const char* Lexer::EndOfString(const char* begin, const char* end, const char* limit) const {
  if (!structured_) return end;
  for (end = begin + 1; end < limit && *end != '\n';) {
    if (*end == '"') return end + 1;
    const bool escape = *end == '\\' && end + 1 < limit && end[1] != '\n';
    end += escape ? 2 : CharacterLength({end, static_cast<size_t>(limit - end)}, utf8_);
  }
  return end;
}

// L'x': a character as well, which keeps its value; in the card's language a name before one.
const char* Lexer::AddWideCharacter(const char* begin, const char* end) {
  const char* const quote = std::find(begin, end, '\'');
  if (!structured_) {
    AddName(begin, quote);
    return quote;
  }
  const std::string_view text(begin, static_cast<size_t>(end - begin));
  Replace(reporter_.Report(Code::kNotACharacter, Range(begin, end), text), Range(begin, quote), "");
  Literal literal;
  literal.invalid = true;
  Add(Kind::kInteger, begin, end, literal);
  return end;
}

// 'x': in structured C a number.
void Lexer::AddCharacter(const char* begin, const char* end) {
  const std::string_view text(begin, static_cast<size_t>(end - begin));
  if (!structured_) {
    Add(Kind::kString, begin, end);
    return;
  }
  Literal literal;
  if (const std::optional<int> value = CharacterValue(text)) {
    literal.negative = *value < 0;
    literal.magnitude = static_cast<uint64_t>(std::abs(*value));
  } else {
    literal.invalid = true;
    reporter_.Report(Code::kNotACharacter, Range(begin, end), text);
  }
  Add(Kind::kInteger, begin, end, literal);
}

const char* Lexer::SkipComment(const char* begin, const char* limit) {
  const std::string_view rest(begin, static_cast<size_t>(limit - begin));
  const size_t close = rest.find("*/", 2);
  if (close == std::string_view::npos) {
    InsertAfter(reporter_.Report(Code::kUnclosedComment, Range(begin, begin + 2)),
                Range(begin, limit), "*/");
    return limit;
  }
  // In structured C, as in C, a comment is a blank, also inside a directive.
  const bool lines = rest.substr(0, close).find('\n') != std::string_view::npos;
  if (lines && !structured_) new_line_ = true;
  return begin + close + 2;
}

// A `\` at the end of a line, which continues it in structured C. C would also join two halves of a
// word.
const char* Lexer::Continuation(const char* begin, const char* end, const char* limit) {
  if (!structured_) return Operator(begin, limit);
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  if (begin > text_.data() && end < limit && in_word(begin[-1]) && in_word(*end)) {
    reporter_.Report(Code::kSplitWord, Range(begin, begin + 1));
  }
  return end;
}

const char* Lexer::Operator(const char* begin, const char* limit) {
  const OperatorToken* found = LeadingOperator({begin, static_cast<size_t>(limit - begin)});
  if (found == nullptr) return IllegalCharacters(begin, limit);
  const char* const end = begin + found->spelling.size();
  Add(found->kind, begin, end);
  return end;
}

// Reports a run of characters that the language does not use. The full-width forms of ASCII
// characters, which Chinese input methods produce, are treated like the characters that they
// resemble.
const char* Lexer::IllegalCharacters(const char* begin, const char* limit) {
  const auto byte = [](char c) { return static_cast<unsigned char>(c); };
  const auto length_at = [&](const char* at) {
    return CharacterLength({at, static_cast<size_t>(limit - at)}, utf8_);
  };
  const size_t length = length_at(begin);
  char ascii = 0;
  if (utf8_ && length == 3 && byte(begin[0]) == 0xEF && byte(begin[1]) == 0xBC) {
    ascii = static_cast<char>(byte(begin[2]) - 0x81 + 0x21);
  } else if (utf8_ && length == 3 && byte(begin[0]) == 0xEF && byte(begin[1]) == 0xBD &&
             byte(begin[2]) <= 0x9E) {
    ascii = static_cast<char>(byte(begin[2]) - 0x80 + 0x60);
  } else if (!utf8_ && length == 2 && byte(begin[0]) == 0xA3 && byte(begin[1]) >= 0xA1) {
    ascii = static_cast<char>(byte(begin[1]) - 0x80);
  }
  const char* end = begin + length;
  if (ascii == 0) {
    while (end < limit && (byte(*end) >= 0x80)) end += length_at(end);
  }
  const std::string_view text(begin, static_cast<size_t>(end - begin));
  Message shown;
  if (text.size() == 1 && byte(text[0]) > 0x20 && byte(text[0]) < 0x7F) {
    shown = ToMessage(fmt::format("'{}'", text));
  } else if (ascii != 0) {
    shown = MakeMessage("'{}' (full-width)", "'{}'（全角）", ascii);
  } else if (utf8_ && byte(text[0]) >= 0x80) {
    shown = ToMessage(fmt::format("'{}'", text));
  } else {
    shown = ToMessage(fmt::format("0x{:02X}", byte(text[0])));
  }
  Diagnostic& diagnostic = reporter_.Report(Code::kIllegalCharacter, Range(begin, end), shown);
  const size_t count = tokens_.size();
  if (ascii != 0) {
    Replace(diagnostic, Range(begin, end), std::string(1, ascii));
    // The character that it resembles is scanned separately and gets the position of the original.
    const size_t at = kPunctuation.find(ascii);
    if (at != std::string_view::npos) {
      const std::string substitute(1, ascii);
      Scan(substitute.data(), substitute.data() + 1);
      tokens_.back().text = kPunctuation.substr(at, 1);
    }
  }
  if (tokens_.size() == count) Add(Kind::kInvalid, begin, end);
  tokens_.back().range = Range(begin, end);
  return end;
}

void Lexer::Scan(const char* cursor, const char* limit) {
  const char* marker = cursor;
  while (tokens_.size() < token_max_) {
    const char* const begin = cursor;
    /*!re2c
      re2c:define:YYCTYPE = "unsigned char";
      re2c:define:YYCURSOR = cursor;
      re2c:define:YYMARKER = marker;
      re2c:define:YYLIMIT = limit;
      re2c:yyfill:enable = 0;
      re2c:yych:conversion = 1;
      re2c:eof = 0;

      digit    = [0-9];
      letter   = [A-Za-z_];
      exponent = [eE] [+-]? digit+;
      suffix   = [uU] [lL]? | [lL];
      decimal  = "0" | [1-9] digit*;
      octal    = "0" digit+;
      hex      = "0" [xX] [0-9a-fA-F]+;
      fixed    = (digit* "." digit+ | digit+ ".") exponent? | digit+ exponent;

      $                       { return; }
      [ \t\r\f\v]+            { continue; }
      "\n"                    { new_line_ = true; continue; }
      "//" {
        const size_t comment = static_cast<size_t>(begin - text_.data());
        cursor = text_.data() + EndOfLineComment(text_, comment, structured_, utf8_);
        continue;
      }
      "\\" [ \t\r]* "\n"       { cursor = Continuation(begin, cursor, limit); continue; }
      "/*"                    { cursor = SkipComment(begin, limit); continue; }

      (decimal | hex) suffix? { AddInteger(begin, cursor); continue; }
      fixed                   { AddFixed(begin, cursor); continue; }
      octal suffix?           { AddOctal(begin, cursor); continue; }
      fixed [fFlL]            { AddBadNumber(Code::kMalformedLiteral, begin, cursor); continue; }
      "."? digit (letter | digit | ".")* { AddOtherNumber(begin, cursor); continue; }
      ["] [^"\n]* ["]? {
        cursor = EndOfString(begin, cursor, limit);
        AddString(begin, cursor);
        continue;
      }
      ("L" | "u" | "U" | "u8") ['] ([^'\\\n] | [\\] [^\n])* ['] {
        cursor = AddWideCharacter(begin, cursor);
        continue;
      }
      ['] ([^'\\\n] | [\\] [^\n])* ['] { AddCharacter(begin, cursor); continue; }

      "int"      { Add(Kind::kInt, begin, cursor); continue; }
      "long"     { Add(Kind::kLong, begin, cursor); continue; }
      "short"    { Add(Kind::kShort, begin, cursor); continue; }
      "void"     { Add(Kind::kVoid, begin, cursor); continue; }
      "double"   { Add(Kind::kDouble, begin, cursor); continue; }
      "if"       { Add(Kind::kIf, begin, cursor); continue; }
      "goto"     { Add(Kind::kGoto, begin, cursor); continue; }
      "return"   { Add(Kind::kReturn, begin, cursor); continue; }
      "else"     { Add(Kind::kElse, begin, cursor); continue; }
      "while"    { Add(Kind::kWhile, begin, cursor); continue; }
      "for"      { Add(Kind::kFor, begin, cursor); continue; }
      "do"       { Add(Kind::kDo, begin, cursor); continue; }
      "switch"   { Add(Kind::kSwitch, begin, cursor); continue; }
      "case"     { Add(Kind::kCase, begin, cursor); continue; }
      "default"  { Add(Kind::kDefault, begin, cursor); continue; }
      "break"    { Add(Kind::kBreak, begin, cursor); continue; }
      "continue" { Add(Kind::kContinue, begin, cursor); continue; }
      "unsigned" { Add(Kind::kUnsigned, begin, cursor); continue; }
      "signed"   { Add(Kind::kSigned, begin, cursor); continue; }
      "char"     { Add(Kind::kChar, begin, cursor); continue; }
      "float"    { Add(Kind::kFloat, begin, cursor); continue; }
      "static"   { Add(Kind::kStatic, begin, cursor); continue; }
      "const"    { Add(Kind::kConst, begin, cursor); continue; }
      "extern"   { Add(Kind::kExtern, begin, cursor); continue; }
      "enum"     { Add(structured_ ? Kind::kEnum : Kind::kReserved, begin, cursor); continue; }
      "sizeof"   { Add(structured_ ? Kind::kSizeof : Kind::kReserved, begin, cursor); continue; }
      "typedef"  { Add(structured_ ? Kind::kTypedef : Kind::kReserved, begin, cursor); continue; }
      "struct"   { Add(structured_ ? Kind::kStruct : Kind::kReserved, begin, cursor); continue; }
      "union"    { Add(Kind::kReserved, begin, cursor); continue; }
      "..."      { AddEllipsis(begin, cursor); continue; }
      letter (letter | digit)* { AddName(begin, cursor); continue; }

      ":"   { Add(Kind::kColon, begin, cursor); continue; }
      ";"   { Add(Kind::kSemicolon, begin, cursor); continue; }
      ","   { Add(Kind::kComma, begin, cursor); continue; }
      "."   { Add(Kind::kDot, begin, cursor); continue; }
      "("   { Add(Kind::kOpenParen, begin, cursor); continue; }
      ")"   { Add(Kind::kCloseParen, begin, cursor); continue; }
      "["   { Add(Kind::kOpenBracket, begin, cursor); continue; }
      "]"   { Add(Kind::kCloseBracket, begin, cursor); continue; }
      "<:"  { cursor = Digraph(Kind::kOpenBracket, "[", begin, limit); continue; }
      ":>"  { cursor = Digraph(Kind::kCloseBracket, "]", begin, limit); continue; }
      "<%"  { cursor = Digraph(Kind::kOpenBrace, "{", begin, limit); continue; }
      "%>"  { cursor = Digraph(Kind::kCloseBrace, "}", begin, limit); continue; }
      "%:"  { cursor = Digraph(Kind::kHash, "#", begin, limit); continue; }
      "{"   { Add(Kind::kOpenBrace, begin, cursor); continue; }
      "}"   { Add(Kind::kCloseBrace, begin, cursor); continue; }
      "#"   { Add(Kind::kHash, begin, cursor); continue; }
      *     { cursor = Operator(begin, limit); continue; }
    */
  }
}

std::vector<Token> Lexer::Run() {
  tokens_.reserve(std::min(text_.size() / 3 + 1, token_max_));
  Scan(text_.data(), text_.data() + text_.size());
  return std::move(tokens_);
}

}  // namespace

std::vector<Token> Tokenize(const SourceFile& file, int file_index, size_t token_max,
                            const gtcalls::Catalogue& catalogue, Reporter& reporter,
                            Dialect dialect) {
  return Lexer(file, file_index, token_max, catalogue, reporter, dialect).Run();
}

bool IsWord(const Token& token) {
  return !token.text.empty() &&
         (std::isalpha(static_cast<unsigned char>(token.text[0])) != 0 || token.text[0] == '_');
}

Message DescribeToken(const Token& token) {
  if (token.kind == Kind::kEnd) return MakeMessage("the end of the file", "文件结尾");
  return ToMessage(fmt::format("'{}'", token.text));
}

}  // namespace oncard::compiler
