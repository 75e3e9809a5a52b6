#include <gtest/gtest.h>

#include "compiler/display_text.h"

namespace oncard::compiler {
namespace {

TEST(DisplayLine, ExpandsTabsToTheNextMultipleOfEight) {
  const DisplayLine line("a\tb\t\tc");
  EXPECT_EQ(line.text(), "a       b               c");
  EXPECT_EQ(line.ColumnOf(2), 8);
  EXPECT_EQ(line.ColumnOf(5), 24);
}

TEST(DisplayLine, CountsWideCharactersAsTwoColumns) {
  const DisplayLine line("轴x");
  EXPECT_EQ(line.text(), "轴x");
  EXPECT_EQ(line.ColumnOf(3), 2);
  EXPECT_EQ(line.ColumnOf(4), 3);
}

TEST(DisplayLine, GivesEveryByteOfACharacterItsColumn) {
  const DisplayLine line("x轴");
  EXPECT_EQ(line.ColumnOf(1), 1);
  EXPECT_EQ(line.ColumnOf(2), 1);
  EXPECT_EQ(line.ColumnOf(3), 1);
}

TEST(DisplayLine, TakesCombiningMarksAsNoColumn) {
  EXPECT_EQ(DisplayLine("e\xCC\x81x").ColumnOf(3), 1);
}

TEST(DisplayLine, ConvertsGbk) {
  // 0xD6E1 is U+8F74 in GBK.
  const DisplayLine line("\xD6\xE1 = 1;");
  EXPECT_EQ(line.text(), "轴 = 1;");
  EXPECT_EQ(line.ColumnOf(2), 2);
}

TEST(DisplayLine, ShowsBytesThatAreNeitherUtf8NorGbk) {
  const DisplayLine line("a\xFF");
  EXPECT_EQ(line.text(), "a<FF>");
  EXPECT_EQ(line.ColumnOf(2), 5);
}

TEST(DisplayLine, NeverSendsControlCharactersToTheTerminal) {
  EXPECT_EQ(DisplayLine("\x1b[31m\x7F").text(), "<1B>[31m<7F>");
  EXPECT_EQ(DisplayLine("\xE2\x80\xAE").text(), "<E2><80><AE>");
}

TEST(DisplayLine, EndsAtItsWidth) {
  const DisplayLine line("ab");
  EXPECT_EQ(line.ColumnOf(2), 2);
  EXPECT_EQ(line.ColumnOf(100), 2);
  EXPECT_EQ(DisplayLine("").ColumnOf(0), 0);
}

TEST(DisplayText, KeepsUtf8AndEscapesTheRest) {
  EXPECT_EQ(DisplayText("轴 \xD6\xE1\n"), "轴 <D6><E1><0A>");
}

}  // namespace
}  // namespace oncard::compiler
