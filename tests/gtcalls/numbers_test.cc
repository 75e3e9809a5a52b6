// The numbers of the header's constants, and what they stand for in the motion core.
#include "gtcalls/gts/numbers.h"

#include <gtest/gtest.h>

namespace oncard::gtcalls {
namespace {

using motion::DiType;
using motion::DoType;
using motion::HomeError;
using motion::HomeMode;
using motion::HomeStage;

TEST(Numbers, NameTheInputWords) {
  EXPECT_EQ(DiTypeOf(0), DiType::kLimitPositive);
  EXPECT_EQ(DiTypeOf(1), DiType::kLimitNegative);
  EXPECT_EQ(DiTypeOf(2), DiType::kAlarm);
  EXPECT_EQ(DiTypeOf(3), DiType::kHome);
  EXPECT_EQ(DiTypeOf(4), DiType::kGpi);
  EXPECT_EQ(DiTypeOf(5), DiType::kArrive);
  EXPECT_EQ(DiTypeOf(6), DiType::kMpg);
  EXPECT_EQ(DiTypeOf(-1), std::nullopt);
  EXPECT_EQ(DiTypeOf(7), std::nullopt);
}

TEST(Numbers, NameTheOutputWords) {
  EXPECT_EQ(DoTypeOf(10), DoType::kEnable);
  EXPECT_EQ(DoTypeOf(11), DoType::kClear);
  EXPECT_EQ(DoTypeOf(12), DoType::kGpo);
  for (const int number : {0, 9, 13}) EXPECT_EQ(DoTypeOf(number), std::nullopt) << number;
}

TEST(Numbers, NameTheModesOfHoming) {
  for (const int number : {0, 10, 11, 12, 13, 20, 22, 30, 40, 41}) {
    EXPECT_EQ(HomeNumber(HomeModeOf(number)), number);
    EXPECT_EQ(HomeModeOf(number) == HomeMode::kNone, number == 0) << number;
  }
  EXPECT_EQ(HomeModeOf(13), HomeMode::kLimitHomeIndex);
  EXPECT_EQ(HomeModeOf(22), HomeMode::kHomeIndex);
  EXPECT_EQ(HomeModeOf(40), HomeMode::kForcedHome);
  for (const int number : {-1, 1, 21, 31, 42}) {
    EXPECT_EQ(HomeModeOf(number), HomeMode::kNone) << number;
  }
}

TEST(Numbers, NameTheStagesAndErrorsOfHoming) {
  EXPECT_EQ(HomeNumber(HomeStage::kIdle), 0);
  EXPECT_EQ(HomeNumber(HomeStage::kEscape), 2);
  EXPECT_EQ(HomeNumber(HomeStage::kLimitReturnStop), 16);
  EXPECT_EQ(HomeNumber(HomeStage::kSearchHomeStop), 22);
  EXPECT_EQ(HomeNumber(HomeStage::kSearchIndex), 30);
  EXPECT_EQ(HomeNumber(HomeStage::kGoHome), 80);
  EXPECT_EQ(HomeNumber(HomeStage::kEnd), 100);
  EXPECT_EQ(HomeNumber(HomeError::kNone), 0);
  EXPECT_EQ(HomeNumber(HomeError::kMode), 6);
  EXPECT_EQ(HomeNumber(HomeError::kNoIndex), 10);
}

}  // namespace
}  // namespace oncard::gtcalls
