#include "runtime/scenario/file/toml_keys.h"

#include <gtest/gtest.h>

#include <string>

namespace oncard::runtime {
namespace {

TEST(ColumnFinderTest, CountsCharactersNotBytes) {
  const std::string line = "a = \"\xE4\xB8\xAD\xE6\x96\x87\" # \xC3\xA9!";
  ColumnFinder finder;
  EXPECT_EQ(finder.OffsetOf(line, 1), 0u);
  EXPECT_EQ(finder.OffsetOf(line, 7), 8u);    // the second Chinese character
  EXPECT_EQ(finder.OffsetOf(line, 8), 11u);   // the quote after it
  EXPECT_EQ(finder.OffsetOf(line, 6), 5u);    // back to the first one
  EXPECT_EQ(finder.OffsetOf(line, 13), 17u);  // the exclamation mark
  EXPECT_EQ(finder.OffsetOf(line, 99), line.size());
}

TEST(ColumnFinderTest, BeginsAgainInAnotherLine) {
  const std::string one = "abcdef";
  const std::string other = "\xC3\xA9z";
  ColumnFinder finder;
  EXPECT_EQ(finder.OffsetOf(one, 2), 1u);
  EXPECT_EQ(finder.OffsetOf(other, 2), 2u);
}

TEST(ColumnFinderTest, WalksALineOnceForManyPlaces) {
  const std::string line(100'000, 'x');
  ColumnFinder finder;
  for (toml::source_index column = 1; column <= 100'000; column += 10) {
    EXPECT_EQ(finder.OffsetOf(line, column), column - 1);
  }
  EXPECT_LE(finder.walked(), line.size());
}

}  // namespace
}  // namespace oncard::runtime
