// Ferroelectric memory through its commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

bool Done(CommandTestCard& card) {
  std::vector<double> status(1);
  EXPECT_EQ(card.Call("GT_GetMRAMStatus", {&status}), 0);
  return status[0] == 1;
}

// Examples 11-3 and 11-4 of the GTS manual.
TEST(MramCommand, SixtyFourWordsAreWrittenAndReadBack) {
  CommandTestCard card;
  for (int i = 0; i < 4; ++i) {
    std::vector<double> words(16);
    for (int k = 0; k < 16; ++k) words[static_cast<size_t>(k)] = 12345 + 16 * i + k;
    ASSERT_EQ(card.Call("GT_SetMRAMData", {i * 16, &words, 16}), 0);
  }
  EXPECT_TRUE(Done(card));
  ASSERT_EQ(card.Call("GT_StartAccessMRAM", {0, 64, 1}), 0);
  EXPECT_FALSE(Done(card));
  card.Cycles(2);
  EXPECT_FALSE(Done(card));  // 500 us of 640 us
  card.Cycle();
  EXPECT_TRUE(Done(card));
  card.state().Reset();
  ASSERT_EQ(card.Call("GT_StartAccessMRAM", {0, 64, 0}), 0);
  card.Cycles(3);
  ASSERT_TRUE(Done(card));
  for (int i = 0; i < 4; ++i) {
    std::vector<double> words(16);
    ASSERT_EQ(card.Call("GT_GetMRAMData", {i * 16, &words, 16}), 0);
    for (int k = 0; k < 16; ++k) EXPECT_EQ(words[static_cast<size_t>(k)], 12345 + 16 * i + k);
  }
}

TEST(MramCommand, AddressAndCountAreCheckedAtBothEnds) {
  struct {
    int address, count, code;
  } const transfers[] = {{0, 1, 0},    {0, 24, 0},    {0, 25, 7},   {0, 0, 7}, {4095, 1, 0},
                         {4095, 2, 7}, {4072, 24, 0}, {4096, 1, 7}, {-1, 1, 7}};
  for (const auto& c : transfers) {
    CommandTestCard card;
    std::vector<double> words(32, 1);
    EXPECT_EQ(card.Call("GT_SetMRAMData", {c.address, &words, c.count}), c.code) << c.address;
    EXPECT_EQ(card.Call("GT_GetMRAMData", {c.address, &words, c.count}), c.code) << c.address;
  }
  struct {
    int address, count, mode, code;
  } const starts[] = {{0, 4096, 0, 0}, {0, 4097, 0, 7}, {0, 0, 0, 7}, {1, 4096, 1, 7},
                      {4095, 1, 1, 0}, {-1, 1, 0, 7},   {0, 1, 2, 7}, {0, 1, -1, 7}};
  for (const auto& c : starts) {
    CommandTestCard card;
    EXPECT_EQ(card.Call("GT_StartAccessMRAM", {c.address, c.count, c.mode}), c.code) << c.count;
  }
}

TEST(MramCommand, TheBufferIsRefusedDuringATransfer) {
  CommandTestCard card;
  std::vector<double> words(1, 1);
  ASSERT_EQ(card.Call("GT_StartAccessMRAM", {0, 4096, 1}), 0);
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_SetMRAMData", {0, &words, 1}), 1);
  EXPECT_EQ(card.Call("GT_GetMRAMData", {0, &words, 1}), 1);
  EXPECT_EQ(card.Call("GT_StartAccessMRAM", {0, 1, 0}), 1);
  EXPECT_EQ(card.Hash(), before);
  EXPECT_EQ(card.Call("GT_StopAccessMRAM"), 0);
  EXPECT_TRUE(Done(card));
  EXPECT_EQ(card.Call("GT_SetMRAMData", {0, &words, 1}), 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
