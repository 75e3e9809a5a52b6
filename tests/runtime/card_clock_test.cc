#include "runtime/sim/card_clock.h"

#include <gtest/gtest.h>

namespace oncard::runtime {
namespace {

TEST(CardClock, OfACardThatCountsMillisecondsIsThatOutside) {
  const CardClock clock(250, 250'000);
  EXPECT_EQ(clock.cycle_us(), 250);
  EXPECT_EQ(clock.UsOf(4), 1000);
  EXPECT_EQ(clock.CycleAt(0), 0);
  EXPECT_EQ(clock.CycleAt(1), 1);
  EXPECT_EQ(clock.CycleAt(250), 1);
  EXPECT_EQ(clock.CycleAt(251), 2);
  EXPECT_EQ(clock.CyclesIn(0), 0);
  EXPECT_EQ(clock.CyclesIn(1001), 5);
  EXPECT_EQ(clock.CoreUs(777), 777);
  EXPECT_EQ(clock.FromCoreUs(777.25), 777.25);
  EXPECT_EQ(clock.MsPerCoreMs(), 1);
}

// 1601 steps of 30 ns.
constexpr int64_t kOddNs = 48'030;

TEST(CardClock, PartsOfMicrosecondsAreNotLost) {
  const CardClock clock(1000, kOddNs);
  EXPECT_EQ(clock.cycle_us(), 49);
  EXPECT_EQ(clock.UsOf(1), 48);
  EXPECT_EQ(clock.UsAfter(1), 49);
  EXPECT_EQ(clock.CycleAt(48), 1);
  EXPECT_EQ(clock.CycleAt(49), 2);
  EXPECT_EQ(clock.CycleAt(96), 2);
  EXPECT_EQ(clock.CycleAt(97), 3);
  // 13 hours.
  EXPECT_EQ(clock.UsOf(1'000'000'000), 48'030'000'000);
  EXPECT_EQ(clock.CycleAt(48'030'000'000), 1'000'000'000);
  EXPECT_EQ(clock.CycleAt(48'030'000'001), 1'000'000'001);
}

TEST(CardClock, ACycleThatHasBegunKeepsItsLength) {
  CardClock clock(1000, 1'000'000);
  clock.ChangeAfter(3, kOddNs);
  EXPECT_EQ(clock.NsOf(2), 2'000'000);
  EXPECT_EQ(clock.NsOf(3), 3'000'000);
  EXPECT_EQ(clock.NsOf(5), 3'096'060);
  EXPECT_EQ(clock.CycleAt(2000), 2);
  EXPECT_EQ(clock.CycleAt(2001), 3);
  EXPECT_EQ(clock.CycleAt(3000), 3);
  EXPECT_EQ(clock.CycleAt(3001), 4);
  EXPECT_EQ(clock.CycleAt(3049), 5);
  EXPECT_EQ(clock.LastEnded(2'999'999), 2);
  EXPECT_EQ(clock.LastEnded(3'048'029), 3);
  EXPECT_EQ(clock.LastEnded(3'048'030), 4);
}

TEST(CardClock, TheCoreCountsCyclesOfOneLength) {
  CardClock clock(1000, 1'000'000);
  clock.ChangeAfter(3, kOddNs);
  EXPECT_EQ(clock.CoreUsOf(5), 5000);
  EXPECT_EQ(clock.CoreUs(2500), 2500);
  EXPECT_EQ(clock.CoreUs(3000), 3000);
  // 24 us of 48.03 us are 499.69 thousandths of the cycle.
  EXPECT_EQ(clock.CoreUs(3024), 3500);
  EXPECT_EQ(clock.FromCoreUs(2500), 2500);
  EXPECT_DOUBLE_EQ(clock.FromCoreUs(3500), 3024.015);
  EXPECT_DOUBLE_EQ(clock.MsPerCoreMs(), 0.04803);
}

TEST(CardClock, TheSecondChangeInACycleReplacesTheFirst) {
  CardClock clock(1000, 1'000'000);
  clock.ChangeAfter(3, kOddNs);
  clock.ChangeAfter(3, 60'000);
  EXPECT_EQ(clock.NsOf(2), 2'000'000);
  EXPECT_EQ(clock.NsOf(4), 3'060'000);
}

TEST(CardClock, ManyChangesAddUpExactly) {
  CardClock clock(1000, 48'000);
  constexpr int64_t kChanges = 1000;
  for (int64_t i = 1; i < kChanges; ++i) clock.ChangeAfter(10 * i, 48'000 + 30 * i);
  // Ten cycles of each length.
  EXPECT_EQ(clock.NsOf(10 * kChanges),
            10 * (48'000 * kChanges + 30 * kChanges * (kChanges - 1) / 2));
}

TEST(CardClock, OnlyAChangeIsKept) {
  CardClock clock(1000, 1'000'000);
  EXPECT_FALSE(clock.changed());
  clock.ChangeAfter(3, kOddNs);
  const auto change = clock.changed();
  ASSERT_TRUE(change);
  CardClock other(1000, 1'000'000);
  other.Restore(change);
  EXPECT_EQ(other, clock);
  other.Restore(std::nullopt);
  EXPECT_EQ(other, CardClock(1000, 1'000'000));
}

TEST(CardClock, LaterThanAnyRunIsStillAnInstant) {
  const CardClock clock(250, 250'000);
  EXPECT_GT(clock.CycleAt(INT64_MAX), int64_t{1} << 40);
}

}  // namespace
}  // namespace oncard::runtime
