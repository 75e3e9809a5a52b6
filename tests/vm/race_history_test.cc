// Which accesses can still race (vm/race_history.h).
#include "vm/race_history.h"

#include <gtest/gtest.h>

#include "base/random.h"

namespace oncard::vm {
namespace {

constexpr int kThreads = 3;
constexpr uint32_t kSyncCells = 2;
constexpr uint32_t kCells = 3;

std::vector<int64_t> NumbersOf(const RaceHistory& history) {
  std::vector<int64_t> numbers;
  history.ForEachNumber([&](int64_t number) { numbers.push_back(number); });
  return numbers;
}

// Up to the first race, in which both see one.
TEST(RaceHistoryTest, AgreesWithClocks) {
  uint64_t random = 1;
  int races = 0;
  int later = 0;  // that come after an order by a synchronising cell
  for (int run = 0; run < 20'000; ++run) {
    RaceClocks clocks(kThreads);
    RaceHistory history(kThreads, kSyncCells);
    bool raced = false;
    for (int step = 0; step < 40 && !raced; ++step) {
      const auto thread = static_cast<int>(RandomBelow(random, kThreads));
      const auto sync = static_cast<uint32_t>(RandomBelow(random, kSyncCells));
      // Each cell mostly belongs to one thread, so that runs become long.
      const auto cell = RandomBelow(random, 4) == 0
                            ? static_cast<uint32_t>(RandomBelow(random, kCells))
                            : static_cast<uint32_t>(thread);
      switch (RandomBelow(random, 5)) {
        case 0:
          clocks.Acquire(thread, kCells + sync);
          history.Acquire(thread, sync);
          break;
        case 1:
          clocks.Release(thread, kCells + sync);
          history.Release(thread, sync);
          break;
        case 2: {
          raced = clocks.Write(thread, step, cell).has_value();
          ASSERT_EQ(history.Write(thread, step, cell).has_value(), raced) << run << ' ' << step;
          break;
        }
        default:
          raced = clocks.Read(thread, step, cell).has_value();
          ASSERT_EQ(history.Read(thread, step, cell).has_value(), raced) << run << ' ' << step;
          break;
      }
      if (raced && step > 10) ++later;
    }
    if (raced) ++races;
  }
  EXPECT_GT(races, 1000);
  EXPECT_LT(races, 20'000);
  EXPECT_GT(later, 1000);
}

TEST(RaceHistoryTest, TheOtherStatementIsNamed) {
  RaceHistory history(kThreads, 0);
  EXPECT_FALSE(history.Write(2, 7, 1));
  const auto other = history.Read(0, 9, 1);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->thread, 2);
  EXPECT_EQ(other->position, 7);
  EXPECT_TRUE(other->writes);
}

TEST(RaceHistoryTest, AnAccessOfWhichAllThreadsKnowIsForgotten) {
  RaceHistory history(2, 1);
  history.Write(0, 1, 5);
  EXPECT_FALSE(NumbersOf(history).empty());
  history.Release(0, 0);
  history.Acquire(1, 0);
  EXPECT_TRUE(NumbersOf(history).empty());
}

// A loop that takes an axis over and over comes back to the same history.
TEST(RaceHistoryTest, RepetitionLeavesTheSame) {
  RaceHistory history(2, 1);
  const auto pass = [&] {
    for (const int thread : {0, 1}) {
      history.Acquire(thread, 0);
      EXPECT_FALSE(history.Write(thread, 3, 4));
      history.Release(thread, 0);
    }
    return NumbersOf(history);
  };
  const auto once = pass();
  EXPECT_FALSE(once.empty());
  EXPECT_EQ(pass(), once);
}

TEST(RaceHistoryTest, OneThreadKeepsNothing) {
  RaceHistory history(1, 0);
  EXPECT_FALSE(history.Write(0, 1, 5));
  EXPECT_TRUE(NumbersOf(history).empty());
}

}  // namespace
}  // namespace oncard::vm
