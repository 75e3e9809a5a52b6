#include "tests/base/random_cases.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace oncard {
namespace {

class RandomCasesTest : public testing::Test {
 protected:
  RandomCasesTest() {
    const char* given = std::getenv(kName);
    if (given != nullptr) before_ = given;
    unsetenv(kName);
  }
  ~RandomCasesTest() override {
    if (before_.empty()) {
      unsetenv(kName);
    } else {
      setenv(kName, before_.c_str(), 1);
    }
  }
  static constexpr const char* kName = "ONCARD_RANDOM_CASES";

 private:
  std::string before_;
};

TEST_F(RandomCasesTest, AreATenthUnderASanitizer) {
  EXPECT_EQ(RandomCases(250), kSanitized ? 25 : 250);
}

TEST_F(RandomCasesTest, AreThePercentageThatIsAskedFor) {
  setenv(kName, "20", 1);
  EXPECT_EQ(RandomCases(250), 50);
  EXPECT_EQ(RandomCases(uint32_t{100'000}), 20'000u);
  setenv(kName, "1000", 1);
  EXPECT_EQ(RandomCases(uint64_t{250}), 2500u);
  EXPECT_EQ(RandomPart(250), 250u);
}

TEST_F(RandomCasesTest, OfFewOnlyHalfTheShareIsExpected) {
  setenv(kName, "100", 1);
  EXPECT_EQ(LeastOfCases(60), 60);
  setenv(kName, "10", 1);
  EXPECT_EQ(LeastOfCases(60), 3);
  setenv(kName, "1000", 1);
  EXPECT_EQ(LeastOfCases(60), 600);
}

TEST_F(RandomCasesTest, AreThreeAtLeast) {
  setenv(kName, "10", 1);
  EXPECT_EQ(RandomCases(12), 3);
  EXPECT_EQ(RandomCases(2), 2);
}

}  // namespace
}  // namespace oncard
