// Programs that leave something behind.
#include "tools/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace oncard::tools {
namespace {

TEST(RunChild, ReadsWhatPrintsInTheBackgroundUpToTheLimit) {
  const std::string program = "(timeout 10 yes; echo all) & sleep 0.1; exit 3";
  const auto end = RunChild({{"sh", "-c", program}, {}, {}, /*limit_s=*/1});
  ASSERT_TRUE(end.ok());
  EXPECT_EQ(end.value().status, 3 << 8);
  EXPECT_FALSE(end.value().out_of_time);
  EXPECT_THAT(end.value().output, testing::Not(testing::HasSubstr("all")));
}

}  // namespace
}  // namespace oncard::tools
