// The ferroelectric memory: transfers, their time, what GT_Reset keeps.
#include "gtcalls/gts/mram.h"

#include <gtest/gtest.h>

namespace oncard::gtcalls::gts {
namespace {

TEST(Mram, WordsArriveWhenTheTimeIsOver) {
  Mram mram;
  mram.SetWord(5, 1234);
  mram.Start(1000, 4, 3, MramAccess::kWrite);
  mram.Advance(1000 + 3 * kMramWordUs - 1);
  EXPECT_TRUE(mram.busy());
  mram.Advance(1000 + 3 * kMramWordUs);
  EXPECT_FALSE(mram.busy());
  mram.SetWord(5, 0);
  mram.Start(2000, 5, 1, MramAccess::kRead);
  EXPECT_EQ(mram.Word(5), 0);
  mram.Advance(3000);
  EXPECT_EQ(mram.Word(5), 1234);
}

TEST(Mram, KnowsTheCycleThatCompletesATransfer) {
  Mram mram;
  mram.Start(1000, 0, 100, MramAccess::kWrite);  // until 2000 us
  EXPECT_EQ(mram.CyclesBeforeEnd(1000, 250), 3);
  EXPECT_EQ(mram.CyclesBeforeEnd(1000, 300), 3);
  EXPECT_EQ(mram.CyclesBeforeEnd(1000, 400), 2);
  EXPECT_EQ(mram.CyclesBeforeEnd(1750, 250), 0);
  EXPECT_EQ(mram.CyclesBeforeEnd(1999, 250), 0);
  EXPECT_EQ(mram.CyclesBeforeEnd(2000, 250), 0);
}

TEST(Mram, OnlyTheNamedWordsAreCopied) {
  Mram mram;
  for (int i = 0; i < 4; ++i) mram.SetWord(i, 7);
  mram.Start(0, 1, 2, MramAccess::kWrite);
  mram.Advance(1000000);
  mram.Start(0, 0, kMramWords, MramAccess::kRead);
  mram.Advance(1000000);
  EXPECT_EQ(mram.Word(0), 0);
  EXPECT_EQ(mram.Word(1), 7);
  EXPECT_EQ(mram.Word(2), 7);
  EXPECT_EQ(mram.Word(3), 0);
}

TEST(Mram, AStoppedTransferNeverArrives) {
  Mram mram;
  mram.SetWord(0, 7);
  mram.Start(0, 0, 1, MramAccess::kWrite);
  mram.Stop();
  EXPECT_FALSE(mram.busy());
  mram.Advance(1000000);
  mram.Start(0, 0, 1, MramAccess::kRead);
  mram.Advance(1000000);
  EXPECT_EQ(mram.Word(0), 0);
}

TEST(Mram, ResetKeepsTheMemoryAndClearsTheBuffer) {
  Mram mram;
  mram.SetWord(4095, -7);
  mram.Start(0, 4095, 1, MramAccess::kWrite);
  mram.Advance(1000000);
  mram.Reset();
  EXPECT_EQ(mram.Word(4095), 0);
  mram.Start(0, 4095, 1, MramAccess::kRead);
  mram.Advance(1000000);
  EXPECT_EQ(mram.Word(4095), -7);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
