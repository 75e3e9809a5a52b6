// Many threads of one host with one card and with several: no call is lost, and there is no
// deadlock. The same test runs in the ThreadSanitizer build.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <vector>

#include "gts_multi.h"

namespace {

constexpr int kHostThreads = 8;
constexpr int kRounds = 500;

/// Runs `body(thread)` on kHostThreads threads at the same time and waits for them.
template <typename Body>
void OnAllThreads(const Body& body) {
  std::vector<std::thread> threads;
  for (int thread = 0; thread < kHostThreads; ++thread) threads.emplace_back(body, thread);
  for (std::thread& thread : threads) thread.join();
}

class HostThreads : public testing::Test {
 protected:
  void SetUp() override { setenv("ONCARD_CLOCK", "virtual", 1); }
  void TearDown() override {
    for (short card = 0; card < 16; ++card) GT_Close(card);
  }
};

TEST_F(HostThreads, OneCardServesThemOneAfterTheOther) {
  ASSERT_EQ(GT_Open(0), 0);
  OnAllThreads([](int thread) {
    const auto index = static_cast<short>(thread);
    for (long round = 1; round <= kRounds; ++round) {
      EXPECT_EQ(GT_SetLongVar(0, index, round), 0);
      long value = 0;
      EXPECT_EQ(GT_GetLongVar(0, index, &value), 0);
      EXPECT_EQ(value, round);
    }
  });
  // Every call took its 50 us, so none was lost.
  unsigned long clock = 0;
  ASSERT_EQ(GT_GetClockHighPrecision(0, &clock), 0);
  EXPECT_EQ(clock, (kHostThreads * kRounds * 2 + 1) * 50UL / 250 * 2);
}

TEST_F(HostThreads, CardsDoNotWaitForEachOther) {
  OnAllThreads([](int thread) {
    const auto card = static_cast<short>(thread);
    EXPECT_EQ(GT_Open(card), 0);
    for (long round = 1; round <= kRounds; ++round) {
      EXPECT_EQ(GT_SetLongVar(card, 0, round), 0);
      long value = 0;
      EXPECT_EQ(GT_GetLongVar(card, 0, &value), 0);
      EXPECT_EQ(value, round);
    }
    EXPECT_EQ(GT_Close(card), 0);
  });
}

TEST_F(HostThreads, EveryThreadOnEveryCard) {
  for (short card = 0; card < 4; ++card) ASSERT_EQ(GT_Open(card), 0);
  OnAllThreads([](int thread) {
    for (int round = 0; round < kRounds; ++round) {
      const auto card = static_cast<short>((thread + round) % 4);
      EXPECT_EQ(GT_SetDoBit(card, MC_GPO, static_cast<short>(thread + 1), 1), 0);
      unsigned long clock = 0;
      EXPECT_EQ(GT_GetClock(card, &clock), 0);
    }
  });
  for (short card = 0; card < 4; ++card) {
    long outputs = 0;
    ASSERT_EQ(GT_GetDo(card, MC_GPO, &outputs), 0);
    EXPECT_EQ(outputs, 0xFF);
  }
}

TEST_F(HostThreads, OnlyOneOfThemOpensACard) {
  std::vector<short> codes(kHostThreads);
  OnAllThreads([&codes](int thread) { codes[static_cast<size_t>(thread)] = GT_Open(5); });
  EXPECT_EQ(std::count(codes.begin(), codes.end(), 0), 1);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), -6), kHostThreads - 1);
}

// Motion commands: each thread moves its own axis on a shared card, and reads those of the others.
TEST_F(HostThreads, EachMovesAnAxisOfTheSameCard) {
  ASSERT_EQ(GT_Open(0), 0);
  ASSERT_EQ(GT_ClrSts(0, 1, kHostThreads), 0);
  OnAllThreads([](int thread) {
    const auto axis = static_cast<short>(thread + 1);
    EXPECT_EQ(GT_AxisOn(0, axis), 0);
    EXPECT_EQ(GT_PrfTrap(0, axis), 0);
    TTrapPrm trap = {1, 1, 0, 0};
    EXPECT_EQ(GT_SetTrapPrm(0, axis, &trap), 0);
    EXPECT_EQ(GT_SetVel(0, axis, 10), 0);
    for (int round = 1; round <= 5; ++round) {
      EXPECT_EQ(GT_SetPos(0, axis, round * 100L * axis), 0);
      EXPECT_EQ(GT_Update(0, 1 << thread), 0);
      long status[kHostThreads] = {};
      double positions[kHostThreads] = {};
      do {
        EXPECT_EQ(GT_GetSts(0, 1, status, kHostThreads), 0);
        EXPECT_EQ(GT_GetPrfPos(0, 1, positions, kHostThreads), 0);
      } while ((status[thread] & 0x400) != 0);
      EXPECT_EQ(GT_GetPrfPos(0, axis, positions), 0);
      EXPECT_EQ(positions[0], round * 100.0 * axis);
    }
    EXPECT_EQ(GT_AxisOff(0, axis), 0);
  });
}

TEST_F(HostThreads, ClosingWhileOthersCallIsSafe) {
  OnAllThreads([](int thread) {
    for (int round = 0; round < kRounds; ++round) {
      unsigned long clock = 0;
      short code = 0;
      switch (thread % 4) {
        case 0:
          code = GT_Open(2);
          EXPECT_TRUE(code == 0 || code == -6) << code;
          break;
        case 1:
          code = GT_Close(2);
          EXPECT_TRUE(code == 0 || code == -1) << code;
          break;
        default:
          code = GT_GetClock(2, &clock);
          EXPECT_TRUE(code == 0 || code == -1) << code;
      }
    }
  });
}

}  // namespace
