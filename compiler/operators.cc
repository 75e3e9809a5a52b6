#include "compiler/operators.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "compiler/parser.hh"
#include "vm/arithmetic.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;
using vm::Precedence;

// Operators that are tokens of their own in the grammar, because C gives them other meanings too or
// motion programs do not have them.
const std::vector<OperatorToken>& TokensOfC() {
  static const auto& tokens = *new const std::vector<OperatorToken>{
      {"*", Kind::kStar},   {"&", Kind::kAnd},    {"+", Kind::kPlus},
      {"-", Kind::kMinus},  {"++", Kind::kStep},  {"--", Kind::kStep},
      {"=", Kind::kAssign}, {"->", Kind::kArrow}, {"?", Kind::kQuestion}};
  return tokens;
}

int KindOf(Precedence precedence) {
  switch (precedence) {
    case Precedence::kLogicalOr:
      return Kind::kLogicalOr;
    case Precedence::kLogicalAnd:
      return Kind::kLogicalAnd;
    case Precedence::kBitOr:
      return Kind::kBitOr;
    case Precedence::kBitXor:
      return Kind::kBitXor;
    case Precedence::kBitAnd:
      return Kind::kBitAnd;
    case Precedence::kEquality:
      return Kind::kEquality;
    case Precedence::kRelation:
      return Kind::kRelation;
    case Precedence::kShift:
      return Kind::kShift;
    case Precedence::kSum:
      return Kind::kSum;
    case Precedence::kProduct:
      return Kind::kProduct;
    case Precedence::kUnary:
      return Kind::kPrefix;
  }
  return Kind::kInvalid;
}

// `a op= b` exists in C for the operators whose value can be assigned to an operand.
bool HasAssignment(const vm::OperatorInfo& info) {
  return !vm::IsLogical(info) && !vm::IsComparison(info);
}

// Not a name such as `abs`, a cast, or the copy, which has no spelling.
bool IsPrefix(const vm::OperatorInfo& unary) {
  return !unary.spelling.empty() && std::ispunct(static_cast<unsigned char>(unary.spelling[0])) &&
         unary.spelling[0] != '(';
}

// All tokens by their first character, the longest first, those of the grammar before those of a
// class.
using TokensByFirst = std::array<std::vector<OperatorToken>, 256>;

TokensByFirst MakeTokens() {
  std::vector<OperatorToken> tokens = TokensOfC();
  for (const vm::OperatorInfo& info : vm::BinaryOperators()) {
    tokens.push_back({std::string(info.spelling), KindOf(info.precedence)});
    if (HasAssignment(info)) {
      tokens.push_back({std::string(info.spelling) + '=', Kind::kCompoundAssign});
    }
  }
  for (const vm::OperatorInfo& info : vm::UnaryOperators()) {
    if (IsPrefix(info)) tokens.push_back({std::string(info.spelling), KindOf(info.precedence)});
  }
  std::stable_sort(tokens.begin(), tokens.end(),
                   [](const OperatorToken& a, const OperatorToken& b) {
                     return a.spelling.size() > b.spelling.size();
                   });
  TokensByFirst by_first;
  for (OperatorToken& token : tokens) {
    by_first[static_cast<unsigned char>(token.spelling.front())].push_back(std::move(token));
  }
  return by_first;
}

// Whether a comparison is true of (0, 1), (0, 0) and (1, 0), which tells comparisons apart.
std::vector<bool> TruthsOf(const vm::OperatorInfo& comparison) {
  std::vector<bool> truths;
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 0), std::pair(1, 0)}) {
    truths.push_back(vm::EvaluateBinary(static_cast<vm::BinaryOperator>(comparison.number),
                                        vm::DataType::kInt, a, b, 0) == 1);
  }
  return truths;
}

}  // namespace

const OperatorToken* LeadingOperator(std::string_view text) {
  // Never destroyed: a host may compile a program while it exits.
  static const auto& tokens = *new const TokensByFirst(MakeTokens());
  if (text.empty()) return nullptr;
  for (const OperatorToken& token : tokens[static_cast<unsigned char>(text.front())]) {
    if (text.starts_with(token.spelling)) return &token;
  }
  return nullptr;
}

const vm::OperatorInfo* OppositeOf(const vm::OperatorInfo& comparison) {
  std::vector<bool> wanted = TruthsOf(comparison);
  wanted.flip();
  for (const vm::OperatorInfo& other : vm::BinaryOperators()) {
    if (vm::IsComparison(other) && TruthsOf(other) == wanted) return &other;
  }
  return nullptr;
}

bool IgnoresSign(std::string_view spelling) {
  const vm::OperatorInfo* info = vm::FindBinaryOperator(spelling);
  if (info == nullptr) info = vm::FindBinaryOperator(spelling.substr(0, spelling.size() - 1));
  if (info == nullptr) return false;
  switch (static_cast<vm::BinaryOperator>(info->number)) {
    using enum vm::BinaryOperator;
    case kAdd:
    case kSubtract:
    case kMultiply:
    case kLogicalAnd:
    case kLogicalOr:
    case kEqual:
    case kNotEqual:
    case kAnd:
    case kOr:
    case kXor:
    case kShiftLeft:
      return true;
    default:
      return false;
  }
}

}  // namespace oncard::compiler
