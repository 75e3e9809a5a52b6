// Several cards in one process, with the interface that has a card number.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "gts_multi.h"

namespace {

constexpr short kCards = 16;

class Cards : public testing::Test {
 protected:
  void SetUp() override {
    setenv("ONCARD_CLOCK", "virtual", 1);
    for (short card = 0; card < kCards; ++card) ASSERT_EQ(GT_Open(card), 0) << card;
  }
  void TearDown() override {
    for (short card = 0; card < kCards; ++card) GT_Close(card);
  }
};

TEST_F(Cards, SixteenCanBeOpenAndNoMore) {
  EXPECT_EQ(GT_Open(15), -6);
  EXPECT_EQ(GT_Open(16), 7);
  EXPECT_EQ(GT_Open(-1), 7);
  EXPECT_EQ(GT_Reset(16), 7);
}

TEST_F(Cards, EachHasItsOwnState) {
  for (short card = 0; card < kCards; ++card) ASSERT_EQ(GT_SetLongVar(card, 0, card * 100L), 0);
  for (short card = 0; card < kCards; ++card) {
    long value = -1;
    ASSERT_EQ(GT_GetLongVar(card, 0, &value), 0);
    EXPECT_EQ(value, card * 100L);
  }
}

TEST_F(Cards, TimePassesForAllOfThemAndEachCountsFromItsReset) {
  unsigned long clock = 0;
  for (int call = 0; call < 100; ++call) ASSERT_EQ(GT_GetClockHighPrecision(3, &clock), 0);
  EXPECT_EQ(clock, 40u);  // 100 * 50 us
  ASSERT_EQ(GT_GetClockHighPrecision(4, &clock), 0);
  EXPECT_EQ(clock, 40u);
  ASSERT_EQ(GT_Reset(5), 0);
  for (int call = 0; call < 5; ++call) ASSERT_EQ(GT_GetClockHighPrecision(5, &clock), 0);
  EXPECT_EQ(clock, 2u);
}

TEST_F(Cards, ClosingAndResettingOneLeavesTheOthers) {
  for (short card = 0; card < kCards; ++card) ASSERT_EQ(GT_SetLongVar(card, 0, 5), 0);
  ASSERT_EQ(GT_Close(7), 0);
  ASSERT_EQ(GT_Reset(8), 0);
  for (short card = 0; card < kCards; ++card) {
    long value = -1;
    EXPECT_EQ(GT_GetLongVar(card, 0, &value), card == 7 ? -1 : 0);
    EXPECT_EQ(value, card == 7 ? -1 : card == 8 ? 0 : 5) << card;
  }
}

TEST_F(Cards, EachHasItsOwnNetworkAddress) {
  for (short card = 0; card < kCards; ++card) {
    std::vector<unsigned char> address(6);
    ASSERT_EQ(GetMacAddress(card, 0, address.data(), 6), 0);
    EXPECT_EQ(address,
              (std::vector<unsigned char>{2, 0, 0, 0, 0, static_cast<unsigned char>(card)}));
  }
}

}  // namespace
