#include "runtime/conditions/condition_reader.h"

#include <algorithm>

#include "base/milliseconds.h"
#include "base/number.h"
#include "base/trim.h"

namespace oncard::runtime {
namespace {

using Token = ConditionParser::token;
using Symbol = ConditionParser::symbol_kind;

/// The part of a text that a message quotes: of a long text the beginning, cut between characters.
std::string Shortened(std::string_view text) {
  constexpr size_t kQuoted = 80;
  if (text.size() <= kQuoted) return std::string(text);
  size_t end = kQuoted;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end)) + "...";
}

/// Eleven days of virtual time; in a double the microseconds remain exact.
constexpr double kInstantMaxMs = 1e9;

}  // namespace

std::optional<int64_t> ParseTime(std::string_view text) {
  double scale = 1;
  if (text.ends_with("ms")) {
    text.remove_suffix(2);
  } else if (text.ends_with('s')) {
    text.remove_suffix(1);
    scale = 1000;
  } else {
    return std::nullopt;
  }
  const auto value = ReadNumber(Trim(text));
  if (!value || *value < 0 || *value * scale > kInstantMaxMs) return std::nullopt;
  return FromMs(*value * scale);
}

Result<TimedCondition> ConditionReader::Read() {
  cursor_ = condition_.text_.c_str();
  if (ConditionParser(*this).parse() != 0) return *std::move(error_);
  return TimedCondition{std::move(condition_), at_us_};
}

int ConditionReader::Next(ConditionParser::semantic_type* value) {
  previous_ = last_;
  last_ = NextConditionToken(&cursor_, condition_.text_.c_str() + condition_.text_.size());
  const bool has_value = last_.kind == Token::kName || last_.kind == Token::kMember ||
                         last_.kind == Token::kNumber || last_.kind == Token::kInstant;
  if (has_value) value->emplace<std::string_view>(last_.text);
  return last_.kind;
}

std::string ConditionReader::Quoted() const { return Shortened(condition_.text_); }

bool ConditionReader::Fail(Message reason) {
  if (!error_) error_ = Error{1, std::move(reason)};
  return false;
}

bool ConditionReader::Add(const Condition::Element& element) {
  if (condition_.elements_.size() == Condition::kElementMax) {
    return Fail(MakeMessage("'{0}' is too long: at most {1} names, numbers and operators",
                            "“{0}”过长：名称、数字和运算符最多 {1} 个", Quoted(),
                            Condition::kElementMax));
  }
  condition_.elements_.push_back(element);
  return true;
}

bool ConditionReader::Read(std::string_view digits, double* number) {
  const auto value = ReadNumber(digits);
  *number = value.value_or(0);
  if (value) return true;
  return Fail(MakeMessage("'{0}' in '{1}' is not a number: write it as in 12, 1.5, 2e3 or 0x1F",
                          "“{1}”中的“{0}”不是数字：应写成 12、1.5、2e3 或 0x1F 的形式",
                          Shortened(digits), Quoted()));
}

bool ConditionReader::AddNumber(std::string_view digits) {
  double number = 0;
  return Read(digits, &number) && Add({.kind = Kind::kNumber, .number = number});
}

bool ConditionReader::AddName(const std::string& name) {
  std::vector<std::string>& names = condition_.names_;
  const auto found = std::ranges::find(names, name);
  const auto which = static_cast<uint8_t>(found - names.begin());
  if (!Add({.kind = Kind::kName, .name = which})) return false;
  if (found == names.end()) names.push_back(name);
  return true;
}

bool ConditionReader::AddOperator(Kind kind, double tolerance) {
  return Add({.kind = kind, .number = tolerance});
}

bool ConditionReader::AddNegation() {
  // If the last element is a number, it is the whole operand.
  Condition::Element& last = condition_.elements_.back();
  if (last.kind != Kind::kNumber) return AddOperator(Kind::kNegate);
  last.number = -last.number;
  return true;
}

bool ConditionReader::ReadIndex(std::string_view digits, int* index) {
  const auto number = ReadWhole<int>(digits);
  *index = number.value_or(0);
  return number || FailAtIndex();
}

bool ConditionReader::FailAtIndex() {
  return Fail(MakeMessage("an index in '{0}' is not a number", "“{0}”中的下标不是数字", Quoted()));
}

bool ConditionReader::ReadInstant(std::string_view time) {
  at_us_ = ParseTime(Trim(time.substr(1)));
  if (at_us_) return true;
  return Fail(MakeMessage("in '{0}' a time in ms or s is missing after '@', as in '@ 12.5ms'",
                          "“{0}”中“@”后应为以 ms 或 s 计的时间，如“@ 12.5ms”", Quoted()));
}

bool ConditionReader::Enter() {
  if (++nesting_ <= Condition::kNestingMax) return true;
  return Fail(MakeMessage(
      "'{0}' is nested too deeply: at most {1} parentheses, '!' and '-' inside each other",
      "“{0}”嵌套过深：括号、“!”和“-”最多 {1} 层", Quoted(), Condition::kNestingMax));
}

void ConditionReader::SyntaxError(std::span<const ConditionParser::symbol_kind_type> expected) {
  const auto wanted = [&](ConditionParser::symbol_kind_type kind) {
    return std::ranges::find(expected, kind) != expected.end();
  };
  const bool ends = last_.kind == Token::kEnd || last_.kind == Token::kInstant;
  const bool operand = wanted(Symbol::S_Name);
  if (operand && last_.kind != Token::kInvalid) {
    FailAtOperand(ends || last_.kind == Token::kCloseParen);
  } else if (previous_.kind == Token::kOpenBracket) {
    FailAtIndex();
  } else if (!operand && wanted(Symbol::S_Number)) {
    Fail(MakeMessage("in '{0}' a positive number is missing after '+-', as in 'x == 1.5 +- 0.001'",
                     "“{0}”中“+-”后应为正数，如“x == 1.5 +- 0.001”", Quoted()));
  } else if (wanted(Symbol::S_CloseBracket)) {
    Fail(MakeMessage("']' is missing in '{0}'", "“{0}”中缺少“]”", Quoted()));
  } else if (ends) {
    Fail(MakeMessage("')' is missing in '{0}'", "“{0}”中缺少“)”", Quoted()));
  } else if (last_.kind == Token::kTolerance) {
    Fail(MakeMessage(
        "in '{0}' the tolerance '+-' does not belong to '==' or '!='; a sum with a "
        "negative number is written with a blank: '+ -'",
        "“{0}”中的容差“+-”不属于“==”或“!=”；与负数相加时应加空格，写成“+ -”", Quoted()));
  } else {
    FailAtToken();
  }
}

void ConditionReader::FailAtOperand(bool at_end) {
  if (at_end) {
    Fail(MakeMessage("a variable or a number is missing in '{0}'", "“{0}”中缺少变量或数字",
                     Quoted()));
  } else {
    Fail(MakeMessage("a variable or a number is missing before '{0}' in '{1}'",
                     "“{1}”中“{0}”之前缺少变量或数字", last_.text, Quoted()));
  }
}

void ConditionReader::FailAtToken() {
  if (last_.text == "=") {
    Fail(MakeMessage("'=' is not expected in '{0}'; a comparison is written '=='",
                     "“{0}”中不应出现“=”；比较应写成“==”", Quoted()));
  } else {
    Fail(MakeMessage("'{0}' is not expected in '{1}'", "“{1}”中不应出现“{0}”",
                     Shortened(last_.text), Quoted()));
  }
}

Result<TimedCondition> ParseTimedCondition(std::string_view text) {
  return ConditionReader(Trim(text)).Read();
}

Result<Condition> ParseCondition(std::string_view text) {
  auto timed = ConditionReader(text).Read();
  if (!timed.ok()) return timed.error();
  if (timed.value().at_us) {
    return MakeError(1,
                     "'{0}' has an instant, which only 'expect' can have: leave out '@' and what "
                     "follows it",
                     "“{0}”带有时刻，只有“expect”可以带时刻：应去掉“@”及其后的内容",
                     Shortened(timed.value().condition.text()));
  }
  return std::move(timed).value().condition;
}

}  // namespace oncard::runtime
