// 2-D position compare through its commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls {
namespace {

using Cells = std::vector<double>;

// Example 4 of the application notes: two pulses of 500 us at +10000 and +20000 of axis 1.
TEST(Compare2D, TheExampleGivesTwoPulsesWhateverTheCycle) {
  for (const int64_t cycle_us : {125, 250, 1000, 4000}) {
    CommandTestCard card({.cycle_us = cycle_us});
    ASSERT_EQ(card.Call("GT_EncOff", {1}), 0);
    ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
    ASSERT_EQ(card.Call("GT_2DCompareMode", {0, 0}), 0);
    Cells prm = {1, 1, 0, 0, 0, 500, 3, 0};
    ASSERT_EQ(card.Call("GT_2DCompareSetPrm", {0, &prm}), 0);
    Cells points = {0, 10000, 0, 20000};
    ASSERT_EQ(card.Call("GT_2DCompareData", {0, 2, &points, 0}), 0);
    ASSERT_EQ(card.Call("GT_2DCompareStart", {0}), 0);
    motion::Profile& profile = card.motion.state().profiles[0];
    profile.trap.target = 30000;
    profile.trap.velocity = 100;
    profile.trap.parameters.acc = 1;
    card.motion.StartProfile(0);
    for (int64_t us = 0; us < 600000; us += cycle_us) card.motion.Tick();
    Cells status(1), count(1), fifo(1), space(1), hardware(1);
    ASSERT_EQ(card.Call("GT_2DCompareStatus", {0, &status, &count, &fifo, &space, &hardware}), 0);
    EXPECT_EQ(status[0], 1);
    EXPECT_EQ(count[0], 2);
    EXPECT_EQ(hardware[0], 512);
    const auto& log = card.motion.state().compare.log();
    ASSERT_EQ(log.size(), 2u);
    EXPECT_EQ(log[0].y, 10000);
    EXPECT_EQ(log[1].y, 20000);
    // 5000 pulses in 100 ms, then 100 pulse/ms.
    EXPECT_NEAR(log[0].instant, 150000, 1e-6) << cycle_us;
    EXPECT_NEAR(log[1].instant, 250000, 1e-6) << cycle_us;
  }
}

TEST(Compare2D, MembersAndSourcesAreChecked) {
  struct {
    size_t cell;
    double value;
    int code;
  } const cases[] = {{0, 0, 7},   {0, 9, 7},   {1, 0, 7}, {2, 2, 7}, {2, 0, 7},
                     {3, 2, 7},   {4, 2, 7},   {5, 0, 7}, {5, 1, 0}, {6, -1, 7},
                     {6, 511, 0}, {6, 512, 7}, {7, 1, 7}, {0, 8, 0}};
  for (const auto& c : cases) {
    CommandTestCard card;
    Cells prm = {1, 1, 1, 0, 0, 500, 3, 0};
    prm[c.cell] = c.value;
    EXPECT_EQ(card.Call("GT_2DCompareSetPrm", {0, &prm}), c.code) << c.cell << " " << c.value;
  }
}

TEST(Compare2D, StateIsChecked) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_2DCompareStart", {0}), 1);
  Cells points = {0, 100};
  ASSERT_EQ(card.Call("GT_2DCompareData", {0, 1, &points, 0}), 0);
  ASSERT_EQ(card.Call("GT_2DCompareStart", {0}), 0);
  EXPECT_EQ(card.Call("GT_2DCompareStart", {0}), 1);
  EXPECT_EQ(card.Call("GT_2DCompareMode", {0, 1}), 1);
  EXPECT_EQ(card.Call("GT_2DCompareClear", {0}), 1);
  EXPECT_EQ(card.Call("GT_2DCompareStop", {0}), 0);
  EXPECT_EQ(card.Call("GT_2DCompareClear", {0}), 0);
  EXPECT_EQ(card.Call("GT_2DCompareStart", {0}), 1);
  Cells many(2 * 4609, 1);
  EXPECT_EQ(card.Call("GT_2DCompareData", {0, 4609, &many, 0}), 1);
  EXPECT_EQ(card.Call("GT_2DCompareData", {0, 4608, &many, 0}), 0);
}

TEST(Compare2D, SinglePulsesAndLevels) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_2DComparePulse", {1, 0, 0, 500}), 7);
  EXPECT_EQ(card.Call("GT_2DComparePulse", {1, 1, 0, 0}), 7);
  ASSERT_EQ(card.Call("GT_2DComparePulse", {1, 1, 0, 500}), 0);
  const auto level = [&] { return card.motion.state().compare.output(1).Level(card.motion.now()); };
  EXPECT_TRUE(level());
  card.Cycles(2);
  EXPECT_FALSE(level());
  ASSERT_EQ(card.Call("GT_2DComparePulse", {1, 1, 1, 0}), 0);
  EXPECT_TRUE(level());
  ASSERT_EQ(card.Call("GT_2DComparePulse", {1, 0, 1, 0}), 0);
  EXPECT_FALSE(level());
}

TEST(ComparePulse, PutsOutOnBothOutputs) {
  CommandTestCard card;
  card.Expect(7, "GT_ComparePulse", {2, 0, 100});
  card.Expect(7, "GT_ComparePulse", {1, 2, 100});
  card.Expect(7, "GT_ComparePulse", {1, 0, 0});
  const uint64_t before = card.Hash();
  card.Expect(0, "GT_ComparePulse", {1, 0, 100});
  EXPECT_NE(card.Hash(), before);
}

}  // namespace
}  // namespace oncard::gtcalls
