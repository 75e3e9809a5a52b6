// The scanner of conditions. Text that begins like a number is one token up to the next character
// that cannot belong to it; ReadNumber() decides whether it is a number. `+-` is always the sign of
// a tolerance. An instant extends to the end of the text.
#include "runtime/conditions/condition_reader.h"

namespace oncard::runtime {

ConditionToken NextConditionToken(const char** text, const char* limit) {
  using Kind = ConditionParser::token;
  const char* cursor = *text;
  const char* marker = cursor;
  for (;;) {
    const char* const begin = cursor;
    const auto token = [&](int kind) {
      *text = cursor;
      return ConditionToken{kind, {begin, static_cast<size_t>(cursor - begin)}};
    };
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

      $                   { return token(Kind::kEnd); }
      [ \t\r\n\f\v]+      { continue; }

      "."? digit (digit | ".")* exponent? (letter | digit | ".")* { return token(Kind::kNumber); }
      letter (letter | digit | ".")* { return token(Kind::kName); }
      "." letter (letter | digit | ".")*   { return token(Kind::kMember); }
      "@" [^]*             { return token(Kind::kInstant); }

      "||"                { return token(Kind::kOrOr); }
      "&&"                { return token(Kind::kAndAnd); }
      "=="                { return token(Kind::kEqual); }
      "!="                { return token(Kind::kNotEqual); }
      "<"                 { return token(Kind::kLess); }
      "<="                { return token(Kind::kLessEqual); }
      ">"                 { return token(Kind::kGreater); }
      ">="                { return token(Kind::kGreaterEqual); }
      "+-"                { return token(Kind::kTolerance); }
      "+"                 { return token(Kind::kPlus); }
      "-"                 { return token(Kind::kMinus); }
      "*"                 { return token(Kind::kStar); }
      "!"                 { return token(Kind::kNot); }
      "("                 { return token(Kind::kOpenParen); }
      ")"                 { return token(Kind::kCloseParen); }
      "["                 { return token(Kind::kOpenBracket); }
      "]"                 { return token(Kind::kCloseBracket); }
      [\x80-\xFF]+        { return token(Kind::kInvalid); }
      *                   { return token(Kind::kInvalid); }
    */
  }
}

}  // namespace oncard::runtime
