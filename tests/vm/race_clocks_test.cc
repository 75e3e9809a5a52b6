// What the vector clocks of a run call unordered (vm/race_clocks.h).
#include "vm/race_clocks.h"

#include <gtest/gtest.h>

namespace oncard::vm {
namespace {

constexpr uint32_t kValue = 3;
constexpr uint32_t kFlag = 7;

TEST(RaceClocksTest, AWriteRacesWithAnEarlierRead) {
  RaceClocks clocks(2);
  EXPECT_FALSE(clocks.Read(0, 4, kValue));
  const auto other = clocks.Write(1, 9, kValue);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->thread, 0);
  EXPECT_EQ(other->position, 4);
  EXPECT_FALSE(other->writes);
}

TEST(RaceClocksTest, TheEarlierWriteIsNamedBeforeARead) {
  RaceClocks clocks(3);
  clocks.Read(0, 1, kValue);
  EXPECT_TRUE(clocks.Write(1, 2, kValue));
  const auto other = clocks.Write(2, 3, kValue);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->thread, 1);
  EXPECT_TRUE(other->writes);
}

TEST(RaceClocksTest, ReadsDoNotRaceWithEachOther) {
  RaceClocks clocks(2);
  EXPECT_FALSE(clocks.Read(0, 1, kValue));
  EXPECT_FALSE(clocks.Read(1, 1, kValue));
}

TEST(RaceClocksTest, AThreadDoesNotRaceWithItself) {
  RaceClocks clocks(2);
  EXPECT_FALSE(clocks.Write(0, 1, kValue));
  EXPECT_FALSE(clocks.Read(0, 2, kValue));
  EXPECT_FALSE(clocks.Write(0, 3, kValue));
}

TEST(RaceClocksTest, AReleaseAndAnAcquireOrder) {
  RaceClocks clocks(2);
  clocks.Write(0, 1, kValue);
  clocks.Release(0, kFlag);
  clocks.Acquire(1, kFlag);
  EXPECT_FALSE(clocks.Read(1, 1, kValue));
}

TEST(RaceClocksTest, WhatComesAfterTheReleaseIsNotOrdered) {
  RaceClocks clocks(2);
  clocks.Release(0, kFlag);
  clocks.Write(0, 2, kValue);
  clocks.Acquire(1, kFlag);
  EXPECT_TRUE(clocks.Read(1, 1, kValue));
}

TEST(RaceClocksTest, AnotherCellDoesNotOrder) {
  RaceClocks clocks(2);
  clocks.Write(0, 1, kValue);
  clocks.Release(0, kFlag);
  clocks.Acquire(1, kFlag + 1);
  EXPECT_TRUE(clocks.Read(1, 1, kValue));
}

// Thread 2 learns from thread 1 what thread 1 has learnt from thread 0.
TEST(RaceClocksTest, OrderIsPassedOn) {
  RaceClocks clocks(3);
  clocks.Write(0, 1, kValue);
  clocks.Release(0, kFlag);
  clocks.Acquire(1, kFlag);
  clocks.Release(1, kFlag + 1);
  clocks.Acquire(2, kFlag + 1);
  EXPECT_FALSE(clocks.Write(2, 1, kValue));
}

}  // namespace
}  // namespace oncard::vm
