// Time at several cycle lengths, reset, and the hash of the state.
#include "motion/motion_core.h"

#include <gtest/gtest.h>

namespace oncard::motion {
namespace {

void TickTimes(MotionCore& core, int times) {
  for (int i = 0; i < times; ++i) core.Tick();
}

TEST(MotionClock, CountsMillisecondsRoundedDownAndEighthsExactly) {
  struct {
    int64_t cycle_us;
    int ticks;
    int64_t ms;
    int64_t eighths;
  } const cases[] = {
      {250, 0, 0, 0}, {250, 3, 0, 6},   {250, 4, 1, 8},          {250, 4001, 1000, 8002},
      {125, 7, 0, 7}, {125, 8, 1, 8},   {1000, 5, 5, 40},        {375, 2, 0, 6},
      {375, 3, 1, 9}, {4000, 2, 8, 64}, {4000, 250, 1000, 8000},
  };
  for (const auto& c : cases) {
    MotionCore core({.cycle_us = c.cycle_us});
    TickTimes(core, c.ticks);
    EXPECT_EQ(core.ClockMs(), c.ms) << c.cycle_us << " us, " << c.ticks;
    EXPECT_EQ(core.Clock125us(), c.eighths) << c.cycle_us << " us, " << c.ticks;
  }
}

TEST(MotionReset, ZeroesTheClockButNotTheCycleCounter) {
  MotionCore core({});
  TickTimes(core, 40);
  core.Reset();
  TickTimes(core, 4);
  EXPECT_EQ(core.ClockMs(), 1);
  EXPECT_EQ(core.state().cycle, 44);
}

TEST(MotionReset, ClearsOutputsAndKeepsPins) {
  MotionCore core({});
  core.state().io.Write(DoType::kGpo, 1, 1);
  core.state().io.SetPin(DiType::kHome, 2, true);
  core.Reset();
  EXPECT_EQ(core.state().io.Register(DoType::kGpo), 0u);
  EXPECT_EQ(core.state().io.Pins(DiType::kHome), 4u);
}

TEST(MotionTick, SamplesInputsAndAdvancesTimedOutputs) {
  MotionCore core({.cycle_us = 1000});
  core.state().io.SetPin(DiType::kGpi, 0, true);
  core.state().io.WriteForAWhile(DoType::kGpo, 0, true, 2000);
  TickTimes(core, 1);
  EXPECT_EQ(core.state().io.Register(DoType::kGpo), 1u);
  TickTimes(core, 2);
  EXPECT_EQ(core.state().io.Register(DoType::kGpo), 0u);
  EXPECT_EQ(core.state().io.Read(DiType::kGpi), 1u);
}

TEST(MotionHash, IsEqualForEqualStatesAndForACopyPutBack) {
  MotionCore a({});
  MotionCore b({});
  EXPECT_EQ(a.Hash(), b.Hash());
  TickTimes(a, 3);
  const MotionState kept = a.state();
  const uint64_t hash = a.Hash();
  TickTimes(a, 9);
  EXPECT_NE(a.Hash(), hash);
  a.state() = kept;
  EXPECT_EQ(a.Hash(), hash);
}

TEST(MotionHash, SeesEveryPartOfTheState) {
  const auto changed = [](auto change) {
    MotionCore core({});
    const uint64_t before = core.Hash();
    change(core.state());
    return core.Hash() != before;
  };
  EXPECT_TRUE(changed([](MotionState& s) { s.cycle = 1; }));
  EXPECT_TRUE(changed([](MotionState& s) { s.clock_cycle = 1; }));
  EXPECT_TRUE(changed([](MotionState& s) { s.reached.resize(1); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetPin(DiType::kMpg, 6, false); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetPin(DiType::kMpg, 6, true); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetInverted(DiType::kGpi, 1); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetFilterTicks(DiType::kGpi, 1, 4); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetEdges(DiType::kGpi, 1, 4); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.Write(DoType::kClear, 1, 1); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetOutputInverted(DoType::kClear, 1); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.WriteForAWhile(DoType::kGpo, 0, false, 1); }));
}

}  // namespace
}  // namespace oncard::motion
