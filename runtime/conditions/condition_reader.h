// Between the scanner (condition_lexer.re) and the grammar (condition_parser.yy) of conditions:
// passes tokens to the parser, builds the condition in postfix order, and writes the error
// messages. Internal to this folder; the interface is condition.h.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "runtime/conditions/condition.h"
#include "runtime/conditions/condition_parser.hh"

namespace oncard::runtime {

struct ConditionToken {
  int kind = ConditionParser::token::kEnd;
  std::string_view text;
};

/// Reads the next token and moves `*cursor` to its end. `limit` points to a zero byte.
ConditionToken NextConditionToken(const char** cursor, const char* limit);

class ConditionReader {
 public:
  using Kind = Condition::Kind;

  explicit ConditionReader(std::string_view text) { condition_.text_ = text; }

  Result<TimedCondition> Read();

  // Functions for the parser. Those that return a bool return false if parsing must end.
  int Next(ConditionParser::semantic_type* value);
  bool AddNumber(std::string_view digits);
  bool AddName(const std::string& name);
  bool AddOperator(Kind kind, double tolerance = 0);
  bool AddNegation();
  /// The digits in brackets.
  bool ReadIndex(std::string_view digits, int* index);
  /// The number of a tolerance.
  bool Read(std::string_view digits, double* number);
  bool ReadInstant(std::string_view time);
  /// Called at the beginning and at the end of parentheses, or of the operand of a prefix operator.
  bool Enter();
  void Leave() { --nesting_; }
  void SyntaxError(std::span<const ConditionParser::symbol_kind_type> expected);

 private:
  bool Add(const Condition::Element& element);
  /// Stores the error; returns false.
  bool Fail(Message reason);
  bool FailAtIndex();
  void FailAtOperand(bool at_end);
  void FailAtToken();
  /// The text as quoted in messages: of a long one only the beginning.
  std::string Quoted() const;

  Condition condition_;
  std::optional<int64_t> at_us_;
  const char* cursor_ = nullptr;
  ConditionToken last_;
  ConditionToken previous_;
  int nesting_ = 0;
  std::optional<Error> error_;
};

}  // namespace oncard::runtime
