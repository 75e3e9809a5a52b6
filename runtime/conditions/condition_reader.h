// Between the scanner (condition_lexer.re) and the grammar (condition_parser.yy) of conditions:
// hands tokens to the parser, builds the condition in postfix order, and says in words what is
// wrong. Internal to this folder; condition.h is the way in.
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

/// The next token from `*cursor` on, which moves behind it. `limit` points at a byte 0.
ConditionToken NextConditionToken(const char** cursor, const char* limit);

class ConditionReader {
 public:
  using Kind = Condition::Kind;

  explicit ConditionReader(std::string_view text) { condition_.text_ = text; }

  Result<TimedCondition> Read();

  // Of the parser. What gives a bool is false when the text is to be given up.
  int Next(ConditionParser::semantic_type* value);
  bool AddNumber(std::string_view digits);
  bool AddName(std::string_view base, std::optional<int> index);
  bool AddOperator(Kind kind, double tolerance = 0);
  bool AddNegation();
  /// The digits within brackets.
  bool ReadIndex(std::string_view digits, std::optional<int>* index);
  /// The number of a tolerance.
  bool Read(std::string_view digits, double* number);
  bool ReadInstant(std::string_view time);
  /// A parenthesis or a prefix operator begins, and what it belongs to has been read.
  bool Enter();
  void Leave() { --nesting_; }
  void SyntaxError(std::span<const ConditionParser::symbol_kind_type> expected);

 private:
  bool Add(const Condition::Element& element);
  /// Remembers what is wrong; gives false.
  bool Fail(Message reason);
  bool FailAtIndex();
  void FailAtOperand(bool at_end);
  void FailAtToken();
  /// The text as messages quote it: the beginning of a long one.
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
