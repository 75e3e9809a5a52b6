// The operators that follow from vm/opcodes.def: their tokens, and what the rewriter asks of them.
#include "compiler/operators.h"

#include <gtest/gtest.h>

#include <utility>

namespace oncard::compiler {
namespace {

std::string_view SpellingOf(std::string_view text) {
  const OperatorToken* token = LeadingOperator(text);
  return token == nullptr ? std::string_view() : std::string_view(token->spelling);
}

TEST(OperatorsTest, TheLongestSpellingIsTaken) {
  for (const auto& [text, spelling] : {
           std::pair{"<<=1", "<<="},
           {"<<1", "<<"},
           {"<=1", "<="},
           {"<1", "<"},
           {"==1", "=="},
           {"=-1", "="},
           {"++i", "++"},
           {"+1", "+"},
           {"->x", "->"},
           {"-1", "-"},
           {"&&a", "&&"},
           {"&=a", "&="},
           {"&a", "&"},
           {"!a", "!"},
           {"!=a", "!="},
           {"~~a", "~"},
           {"=/*", "="},
           {"*/ 2", "*"},
           {"?1:2", "?"},
           {"", ""},
           {"@", ""},
           {"\xEF", ""},
           {"a+b", ""},
       }) {
    EXPECT_EQ(SpellingOf(text), spelling) << text;
  }
}

TEST(OperatorsTest, EveryBinaryOperatorIsAToken) {
  for (const vm::OperatorInfo& info : vm::BinaryOperators()) {
    EXPECT_EQ(SpellingOf(info.spelling), info.spelling);
  }
}

int KindOf(std::string_view text) { return LeadingOperator(text)->kind; }

TEST(OperatorsTest, OperatorsOfOnePrecedenceAreOneToken) {
  EXPECT_EQ(KindOf("/"), KindOf("%"));
  EXPECT_EQ(KindOf("<<"), KindOf(">>"));
  EXPECT_EQ(KindOf("=="), KindOf("!="));
  EXPECT_EQ(KindOf("!"), KindOf("~"));
  EXPECT_NE(KindOf("<"), KindOf("=="));
  EXPECT_NE(KindOf("<"), KindOf("<<"));
}

// C gives these other meanings too, which the grammar must know.
TEST(OperatorsTest, OperatorsWithAnotherMeaningAreTheirOwnTokens) {
  EXPECT_NE(KindOf("*"), KindOf("/"));
  EXPECT_NE(KindOf("+"), KindOf("-"));
  EXPECT_NE(KindOf("&"), KindOf("|"));
}

TEST(OperatorsTest, OppositeComparisons) {
  for (const auto& [comparison, opposite] : {std::pair{"==", "!="}, {"<", ">="}, {">", "<="}}) {
    EXPECT_EQ(OppositeOf(*vm::FindBinaryOperator(comparison))->spelling, opposite);
    EXPECT_EQ(OppositeOf(*vm::FindBinaryOperator(opposite))->spelling, comparison);
  }
}

TEST(OperatorsTest, WhereTheSignOfOperandsMatters) {
  for (const char* spelling : {"/", "%", ">>", "<", ">", "<=", ">=", "/=", "%=", ">>="}) {
    EXPECT_FALSE(IgnoresSign(spelling)) << spelling;
  }
  for (const char* spelling : {"+", "-", "*", "&", "|", "^", "==", "!=", "<<", "&&", "||",
                               "+=", "-=", "*=", "&=", "|=", "^=", "<<="}) {
    EXPECT_TRUE(IgnoresSign(spelling)) << spelling;
  }
}

}  // namespace
}  // namespace oncard::compiler
