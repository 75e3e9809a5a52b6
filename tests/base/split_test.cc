#include "base/split.h"

#include <gmock/gmock.h>

namespace oncard {
namespace {

using ::testing::ElementsAre;

TEST(SplitTest, GivesThePartsBetweenSeparators) {
  EXPECT_THAT(Split("a,bc,,d", ','), ElementsAre("a", "bc", "", "d"));
  EXPECT_THAT(Split("a", ','), ElementsAre("a"));
  EXPECT_THAT(Split("", ','), ElementsAre(""));
  EXPECT_THAT(Split(",", ','), ElementsAre("", ""));
}

}  // namespace
}  // namespace oncard
