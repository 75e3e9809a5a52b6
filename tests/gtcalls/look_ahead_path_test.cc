// Whole programs through the commands of the multi-axis look-ahead: long ones, their times, and
// what happens to the card while they run.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/gtcalls/look_ahead_support.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

constexpr int kWindow = 200;

// --- Long programs ------------------------------------------------------------------------------

/// A point of a relief: rows of a wavy surface, and an axis that turns with its slope, mm.
std::vector<Argument> Relief(int i) {
  const int row = i / 1000;
  const int column = row % 2 == 0 ? i % 1000 : 999 - i % 1000;
  const double x = column * 0.05;
  const double y = row * 0.2;
  const double z = 0.5 * std::sin(x * 0.8) * std::cos(y * 0.5);
  return {1, x, y, z, 3 * std::cos(x * 0.8), 80., 1500., i, 0, 0};
}

TEST(LookAheadPath, ALongProgramNeedsNoMoreMemoryThanTheBuffers) {
  LookAheadCard card;
  card.SetUp(4);
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 1});
  EXPECT_EQ(card.Init(LookAheadCard::Parameters(kWindow)), 0);
  const Command& line = *GtsCatalogue().Find("GT_LnXYZAEx");
  constexpr int kCount = 100000;
  const size_t largest = 2 * motion::kCrdFifoSize;
  for (int sent = 1; sent <= kCount; ++sent) {
    // The card takes segments as fast as they come: what has left the look-ahead is executed.
    const motion::CrdFifo& fifo = card.fifo();
    while (fifo.space() == 0) ChangeState(card.motion).crds[0].fifos[0].slots.Clear();
    ASSERT_EQ(card.Call(line, Relief(sent)), 0) << sent << card.reason.en;
    ASSERT_LE(fifo.planner->spans.size(), size_t{kWindow});
    ASSERT_LE(fifo.planner->ring.slots.size(), size_t{2 * kWindow + 2});
    ASSERT_LE(fifo.planner->spans.slots.size(), size_t{2 * kWindow + 2});
    ASSERT_LE(fifo.slots.slots.size(), largest);
  }
  EXPECT_EQ(card.Flush(), 0);
}

// The same while it runs, through a full FIFO, as a host sends it.
TEST(LookAheadPath, AProgramLongerThanTheFifoRunsToItsEnd) {
  LookAheadCard card;
  card.SetUp(4);
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 1});
  EXPECT_EQ(card.Init(LookAheadCard::Parameters(kWindow)), 0);
  constexpr int kCount = 6000;
  int sent = 0;
  const auto send = [&] {
    while (sent < kCount && card.Call("GT_LnXYZAEx", Relief(sent + 1)) == 0) ++sent;
  };
  send();
  EXPECT_LT(sent, kCount);
  card.Expect(0, "GT_CrdStart", {1, 0});
  bool flushed = false;
  int cycles = 0;
  for (; card.motion.state().crds[0].run.running && cycles < 30000; ++cycles) {
    card.Cycle();
    if (sent < kCount) send();
    if (sent == kCount && !flushed) flushed = card.Flush() == 0;
  }
  EXPECT_EQ(card.fifo().done, kCount);
  EXPECT_EQ(card.ReadFifo("GT_GetRemainderSegNum"), 0);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(card.Position(i), Relief(kCount)[i + 1].value * 1000, 1e-6);
  }
  EXPECT_LT(cycles, 30000);
}

// --- Estimated times ----------------------------------------------------------------------------

/// Random segments of all kinds with all kinds of commands between them.
void SendRandom(LookAheadCard& card, unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  double x = 0;
  double y = 0;
  for (int i = 0; i < 40; ++i) {
    const double speed = draw(20, 120);
    const double rise = draw(200, 2000);
    const auto kind = static_cast<int>(draw(0, 9));
    const double z = draw(-5, 5);
    if (kind < 4) {
      x += draw(-20, 20);
      y += draw(-20, 20);
      const char* name = kind == 0 ? "GT_LnXYG0Ex" : "GT_LnXYEx";
      card.Expect(0, name, {1, x, y, speed, rise, i, i % 2, 0});
    } else if (kind < 6) {
      card.Expect(0, "GT_ArcXYCEx", {1, x, y, draw(1, 9), draw(1, 9), i % 2, speed, rise, i, 0, 0});
    } else if (kind < 7) {
      card.Expect(0, "GT_HelixXYCZEx",
                  {1, x, y, z, draw(1, 9), draw(1, 9), i % 2, speed, rise, i, 0, 0});
    } else {
      x += draw(1, 9);
      card.Expect(0, "GT_LnXYZAEx", {1, x, y, z, draw(-5, 5), speed, rise, i, 0, 0});
    }
    switch (static_cast<int>(draw(0, 8))) {
      case 0:
        card.Expect(0, "GT_BufDelayEx", {1, static_cast<int>(draw(0, 50)), 0});
        break;
      case 1:
        card.Expect(0, "GT_BufMoveEx", {1, 5, draw(-5, 5), 30., 800., 1, 0});
        break;
      case 2:
        card.Expect(0, "GT_BufMoveEx", {1, 6, draw(-5, 5), 30., 800., 0, 0});
        break;
      case 3:
        card.Expect(0, "GT_BufGearEx", {1, 7, draw(-9, 9), 0});
        break;
      case 4:
        card.Expect(0, "GT_BufIOEx", {1, 12, 1, i % 2, 0});
        break;
      default:
        break;
    }
  }
  EXPECT_EQ(card.Flush(), 0);
}

TEST(LookAheadPath, TakesTheTimeThatWasEstimatedWithinACycle) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const int mode = seed % 2 == 0 ? 1 : 0;
    double estimate = 0;
    for (const int virtually : {1, 0}) {
      LookAheadCard card;
      card.SetUp(4);
      card.Expect(0, "GT_SetupLookAheadCrd", {1, mode});
      if (mode == 0) {
        std::vector<double> follows = {0, 0, 0, 0, 0, 0, 1, 0};
        std::vector<double> limits(8, 40);
        std::vector<double> accelerations(8, 400);
        card.Expect(0, "GT_SetFollowAxisParaLa",
                    {1, &follows, &limits, &accelerations, &accelerations});
        std::vector<double> modes(8, seed % 3 == 0 ? 7 : 0);
        card.Expect(0, "GT_SetAxisLimitModeLa", {1, &modes});
      }
      EXPECT_EQ(card.Init(LookAheadCard::Parameters(seed < 6 ? 5 : 100), virtually), 0);
      SendRandom(card, seed);
      if (virtually != 0) {
        estimate = card.ReadFifo("GT_GetMotionTimeEx");
      } else {
        EXPECT_NEAR(card.Run(), estimate, 1);
        EXPECT_EQ(card.fifo().done, 40);
      }
    }
  }
}

// --- While it runs ------------------------------------------------------------------------------

/// A card in the middle of a planned path of short lines along X and Y.
class RunningPath : public LookAheadCard {
 public:
  RunningPath() {
    for (int axis = 1; axis <= 4; ++axis) Expect(0, "GT_AxisOn", {axis});
    Prepare(2);
    for (int i = 1; i <= 100; ++i) EXPECT_EQ(LineEx(i, i % 2 * 0.05, i), 0);
    EXPECT_EQ(Flush(), 0);
    Expect(0, "GT_CrdStart", {1, 0});
    Cycles(700);
    EXPECT_GT(Speed(), 10);
  }
  double Speed() { return motion.state().crds[0].run.velocity; }
};

TEST(LookAheadWhileRunning, CommandsReadThePath) {
  RunningPath card;
  const double done = card.fifo().done;
  EXPECT_EQ(card.ReadFifo("GT_GetRemainderSegNum"), 100 - done);
  EXPECT_EQ(card.ReadFifo("GT_GetUserSegNum"), done + 1);
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace"), 4096 - 100 + done + 1);
  EXPECT_EQ(card.ReadFifo("GT_GetLookAheadSegCount"), 0);
  EXPECT_NEAR(card.ReadCrd("GT_GetCrdVel"), card.Speed(), 1e-9);
}

TEST(LookAheadWhileRunning, AStopPausesAndTheRestGoesOn) {
  for (const int abrupt : {0, 1}) {
    RunningPath card;
    card.Expect(0, "GT_Stop", {1 << 8, abrupt << 8});
    card.CyclesToEnd();
    EXPECT_LT(card.Position(0), 100000);
    card.Run();
    EXPECT_EQ(card.Position(0), 100000);
    EXPECT_EQ(card.fifo().done, 100);
  }
}

TEST(LookAheadWhileRunning, AClearedRestIsForgotten) {
  RunningPath card;
  card.Expect(1, "GT_CrdClear", {1, 0});  // it runs
  card.Expect(0, "GT_Stop", {1 << 8, 0});
  card.CyclesToEnd();
  card.Expect(0, "GT_CrdClear", {1, 0});
  card.Expect(1, "GT_CrdStart", {1, 0});
  EXPECT_EQ(card.Init(), 0);
  EXPECT_EQ(card.LineEx(0, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  card.Run();
  EXPECT_EQ(card.Position(0), 0);
}

TEST(LookAheadWhileRunning, ALimitStopsThePath) {
  RunningPath card;
  card.Expect(0, "GT_SetSoftLimit", {1, 60000, -1000000});
  card.CyclesToEnd();
  EXPECT_LT(card.Position(0), 70000);
  EXPECT_GT(card.ReadFifo("GT_GetRemainderSegNum"), 0);
}

TEST(LookAheadWhileRunning, ADisabledAxisStopsThePath) {
  RunningPath card;
  card.Expect(0, "GT_AxisOff", {2});
  card.Cycles(2000);
  EXPECT_FALSE(card.motion.state().crds[0].run.running);
  EXPECT_LT(card.Position(0), 100000);
}

TEST(LookAheadWhileRunning, AnOverrideScalesIt) {
  RunningPath card;
  card.Expect(0, "GT_SetOverride", {1, 0.25});
  card.Expect(0, "GT_SetOverride2", {1, 0.1});  // of no segment
  card.Cycles(200);
  for (int i = 0; i < 200; ++i) {
    card.Cycle();
    EXPECT_LE(card.Speed(), 12.5 + 1e-9);
  }
  EXPECT_GT(card.Speed(), 1);
  card.Expect(0, "GT_SetOverride", {1, 1.});
  card.Cycles(200);
  EXPECT_GT(card.Speed(), 12.5);
}

TEST(LookAheadWhileRunning, TheOtherCoordinateSystemAndBufferAreFree) {
  RunningPath card;
  std::vector<double> cells(21);
  cells[0] = 2;
  cells[1 + 2] = 1;
  cells[1 + 3] = 2;
  cells[9] = 500;
  cells[10] = 10;
  card.Expect(0, "GT_SetCrdPrm", {2, &cells});
  card.Expect(103, "GT_LnXYEx", {2, 5., 5., 50., 500., 0, 0, 0});
  card.Expect(0, "GT_SetupLookAheadCrd", {2, 1});
  std::vector<double> parameters = LookAheadCard::Parameters();
  card.Expect(0, "GT_InitLookAheadEx", {2, &parameters, 1, 0, nullptr});
  card.Expect(0, "GT_LnXYEx", {2, 5., 5., 50., 500., 0, 0, 1});
  card.Expect(0, "GT_CrdDataEx", {2, nullptr, 1});
  card.Expect(0, "GT_CrdStart", {2, 2});
  card.Cycles(3000);
  EXPECT_EQ(card.Position(2), 5000);
  EXPECT_EQ(card.Position(0), 100000);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
