#include "base/trim.h"

#include <gtest/gtest.h>

namespace oncard {
namespace {

TEST(TrimTest, TakesBlanksFromBothEnds) {
  EXPECT_EQ(Trim(" \t a b\t "), "a b");
  EXPECT_EQ(Trim("a"), "a");
  EXPECT_EQ(Trim("a line\r"), "a line");
  EXPECT_EQ(Trim("\n a"), "\n a");
  EXPECT_EQ(Trim(" \t"), "");
  EXPECT_EQ(Trim(""), "");
}

}  // namespace
}  // namespace oncard
