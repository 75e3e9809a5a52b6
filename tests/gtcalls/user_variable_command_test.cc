// GT_SetLongVar, GT_GetLongVar, GT_SetDoubleVar, GT_GetDoubleVar.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(UserVariable, HoldsWhatWasWrittenFromTheFirstToTheLast) {
  CommandTestCard card;
  std::vector<double> value(1);
  for (const double index : {0.0, 511.0, 1023.0}) {
    EXPECT_EQ(card.Call("GT_SetLongVar", {index, -2147483648.0}), 0);
    EXPECT_EQ(card.Call("GT_GetLongVar", {index, &value}), 0);
    EXPECT_EQ(value[0], -2147483648.0);
    EXPECT_EQ(card.Call("GT_SetDoubleVar", {index, 0.1}), 0);
    EXPECT_EQ(card.Call("GT_GetDoubleVar", {index, &value}), 0);
    EXPECT_EQ(value[0], 0.1);
  }
}

TEST(UserVariable, IndexPastTheEndIsABadParameter) {
  CommandTestCard card;
  std::vector<double> value = {77};
  for (const double index : {-1.0, 1024.0}) {
    EXPECT_EQ(card.Call("GT_SetLongVar", {index, 1}), 7);
    EXPECT_EQ(card.Call("GT_GetLongVar", {index, &value}), 7);
    EXPECT_EQ(card.Call("GT_SetDoubleVar", {index, 1}), 7);
    EXPECT_EQ(card.Call("GT_GetDoubleVar", {index, &value}), 7);
  }
  EXPECT_EQ(value[0], 77);
}

TEST(UserVariable, LongAndDoubleAreSeparate) {
  CommandTestCard card;
  std::vector<double> value(1);
  EXPECT_EQ(card.Call("GT_SetLongVar", {3, 9}), 0);
  EXPECT_EQ(card.Call("GT_GetDoubleVar", {3, &value}), 0);
  EXPECT_EQ(value[0], 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
