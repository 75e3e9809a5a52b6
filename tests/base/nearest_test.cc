#include "base/nearest.h"

#include <gtest/gtest.h>

#include <vector>

namespace oncard {
namespace {

struct NearCase {
  const char* name;
  const char* expected;
};

class NearestNameTest : public testing::TestWithParam<NearCase> {};

TEST_P(NearestNameTest, FindsWhatWasMeant) {
  const std::vector<std::string_view> candidates = {"program", "rate", "cycle_us", "expect"};
  EXPECT_EQ(NearestName(GetParam().name, candidates), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Names, NearestNameTest,
                         testing::Values(NearCase{"programm", "program"}, NearCase{"rat", "rate"},
                                         NearCase{"raet", "rate"}, NearCase{"expects", "expect"},
                                         NearCase{"cycle", ""}, NearCase{"zebra", ""},
                                         NearCase{"", ""}));

TEST(Nearest, TakesTheFirstOfEquallyNearNames) {
  Nearest nearest("axis");
  nearest.Add("axes");
  nearest.Add("axil");
  EXPECT_EQ(nearest.best(), "axes");
}

TEST(Nearest, ForgivesTheCaseOfLetters) {
  const std::vector<std::string_view> candidates = {"GT_SetDac", "GT_SetDo"};
  EXPECT_EQ(NearestName("gt_setdo", candidates), "GT_SetDo");
}

}  // namespace
}  // namespace oncard
