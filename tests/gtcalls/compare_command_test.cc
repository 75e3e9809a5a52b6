// Position compare through its commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using Cells = std::vector<double>;

/// Axis 1 counts its own pulses and moves at 100 pulse/ms, which it reaches in 100 ms.
void MoveAxis1(CommandTestCard& card, int target) {
  EXPECT_EQ(card.Call("GT_EncOff", {1}), 0);
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  motion::Profile& profile = ChangeState(card.motion).profiles[0];
  profile.trap.target = target;
  profile.trap.velocity = 100;
  profile.trap.parameters.acc = 1;
  card.motion.ProfileAt(0).Start();
}

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
    motion::Profile& profile = ChangeState(card.motion).profiles[0];
    profile.trap.target = 30000;
    profile.trap.velocity = 100;
    profile.trap.parameters.acc = 1;
    card.motion.ProfileAt(0).Start();
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

// The line (10 + 2s, s - 10) is closest to the origin at s = -2, in (6, -12): too far in Y. From s
// = -0.5 to 0.25 the whole pulses are within 10 in both; the closest of these points is (9, -10.5).
TEST(Compare2D, HitsWhereBothErrorsAreSmallEnough) {
  EXPECT_NEAR(motion::FindHit(-90, -60, 110, 40, true, {0, 0}, 10, 0), 0.495, 1e-6);
  EXPECT_EQ(motion::FindHit(-90, -60, 110, 40, true, {0, 0}, 9, 0), -1);
  // For any length of the cycles.
  for (const int ticks : {1, 2, 3, 7, 100}) {
    motion::CompareUnit compare;
    compare.SetParameters(0, {.two_dimensional = true, .x = 0, .y = 1, .max_error = 10});
    compare.Append(0, {{0, 0}});
    compare.Start(0, 0, 0);
    for (int i = 0; i < ticks; ++i) {
      motion::EncoderWay way;
      const double from = -50 + 100.0 * i / ticks;
      const double to = -50 + 100.0 * (i + 1) / ticks;
      way.from = {10 + 2 * from, from - 10};
      way.to = {10 + 2 * to, to - 10};
      compare.Advance(250 * i, 250, way);
    }
    ASSERT_EQ(compare.log().size(), 1u) << ticks;
    EXPECT_EQ(compare.log()[0].x, 9) << ticks;
    EXPECT_EQ(compare.log()[0].y, -10) << ticks;
  }
}

TEST(Compare2D, HitsWhatItTurnsBackFrom) {
  motion::CompareUnit compare;
  compare.SetParameters(0, {.two_dimensional = true, .x = 0, .y = 1, .max_error = 3});
  compare.Append(0, {{100, 0}});
  compare.Start(0, 0, 0);
  motion::EncoderWay way;
  way.to[0] = 98;
  compare.Advance(0, 250, way);
  EXPECT_EQ(compare.log().size(), 0u) << "it still comes nearer";
  way.from[0] = 98;
  way.to[0] = 0;
  compare.Advance(250, 250, way);
  ASSERT_EQ(compare.log().size(), 1u);
  EXPECT_EQ(compare.log()[0].x, 98);
  EXPECT_EQ(compare.log()[0].instant, 250);
}

TEST(HsioOutput, ItsEdgesAreExactWhateverTheCycle) {
  for (const int64_t cycle_us : {125, 250, 1000, 4000}) {
    CommandTestCard card({.cycle_us = cycle_us});
    MoveAxis1(card, 30000);
    Cells points = {10000, 10020, 20000};
    // The second point is reached 200 us after the first and extends its pulse.
    ASSERT_EQ(card.Call("GT_CompareData", {1, 0, 0, 0, 500, &points, 3, nullptr, 0}), 0);
    std::vector<motion::HsioEdge> edges;
    for (int64_t us = 0; us < 400'000; us += cycle_us) {
      card.motion.Tick();
      const auto& last = card.motion.state().compare.edges();
      edges.insert(edges.end(), last.begin(), last.end());
    }
    const double expected[] = {150'000, 150'700, 250'000, 250'500};
    ASSERT_EQ(edges.size(), std::size(expected)) << cycle_us;
    for (size_t i = 0; i < edges.size(); ++i) {
      EXPECT_EQ(edges[i].channel, 0);
      EXPECT_EQ(edges[i].level, i % 2 == 0);
      EXPECT_NEAR(edges[i].instant, expected[i], 1e-6) << cycle_us;
    }
  }
}

TEST(HsioOutput, ResetLowersIt) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_2DComparePulse", {1, 1, 1, 0}), 0);
  card.motion.Tick();
  ASSERT_EQ(card.motion.state().compare.edges().size(), 1u);
  card.motion.Reset();
  card.motion.Tick();
  ASSERT_EQ(card.motion.state().compare.edges().size(), 1u);
  EXPECT_FALSE(card.motion.state().compare.edges()[0].level);
  card.motion.Tick();
  EXPECT_TRUE(card.motion.state().compare.edges().empty());
}

TEST(Compare2D, MembersAndSourcesAreChecked) {
  struct {
    size_t cell;
    double value;
    int code;
  } const cases[] = {{0, 0, 7},   {0, 12, 7},  {1, 0, 7}, {2, 2, 7}, {2, 0, 7},
                     {3, 2, 7},   {4, 2, 7},   {5, 0, 7}, {5, 1, 0}, {6, -1, 7},
                     {6, 511, 0}, {6, 512, 7}, {7, 1, 7}, {0, 8, 0}};
  for (const auto& c : cases) {
    CommandTestCard card;
    Cells prm = {1, 1, 1, 0, 0, 500, 3, 0};
    prm[c.cell] = c.value;
    EXPECT_EQ(card.Call("GT_2DCompareSetPrm", {0, &prm}), c.code) << c.cell << " " << c.value;
  }
}

TEST(Compare2D, EncodersAreThoseOfTheCardsAxes) {
  for (const int axes : {4, 8, 12}) {
    CommandTestCard card({.axis_count = axes});
    for (const size_t cell : {0u, 1u}) {
      for (const auto& [number, code] : {std::pair{0, 7},
                                         {1, 0},
                                         {axes, 0},
                                         {axes + 1, 7},
                                         {9, axes < 9 ? 7 : 0},
                                         {11, axes < 11 ? 7 : 0}}) {
        Cells prm = {1, 1, 1, 0, 0, 500, 3, 0};
        prm[cell] = number;
        EXPECT_EQ(card.Call("GT_2DCompareSetPrm", {0, &prm}), code) << axes << " axes: " << number;
      }
    }
    Cells prm = {1, 13, 1, 0, 0, 500, 3, 0};
    EXPECT_EQ(card.Call("GT_2DCompareSetPrm", {0, &prm}), 7);
    EXPECT_EQ(card.reason.en,
              "T2DComparePrm.ency is 13; 1 to " + std::to_string(axes) + " is expected");
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

/// GT_CompareStatus: 0 while compare is running, and the count.
Cells LinearStatus(CommandTestCard& card) {
  Cells status(1), count(1);
  EXPECT_EQ(card.Call("GT_CompareStatus", {&status, &count}), 0);
  return {status[0], count[0]};
}

TEST(CompareData, EachListHasItsOutput) {
  CommandTestCard card;
  MoveAxis1(card, 30000);
  Cells first = {10000, 20000};
  Cells second = {15000};
  ASSERT_EQ(card.Call("GT_CompareData", {1, 0, 0, 0, 500, &first, 2, &second, 1}), 0);
  EXPECT_EQ(LinearStatus(card), (Cells{0, 0}));
  card.Cycles(800);  // 200 ms: 15000 pulses are reached
  EXPECT_EQ(LinearStatus(card), (Cells{0, 2}));
  card.Cycles(800);
  EXPECT_EQ(LinearStatus(card), (Cells{1, 3}));
  const auto& log = card.motion.state().compare.log();
  ASSERT_EQ(log.size(), 3u);
  const struct {
    int channel;
    double position, instant;
  } expected[] = {{0, 10000, 150000}, {1, 15000, 200000}, {0, 20000, 250000}};
  for (size_t i = 0; i < log.size(); ++i) {
    EXPECT_EQ(log[i].channel, expected[i].channel);
    EXPECT_EQ(log[i].y, expected[i].position);
    EXPECT_NEAR(log[i].instant, expected[i].instant, 1e-6);
  }
}

TEST(CompareData, TheCountIsThatOfTheLastCommand) {
  CommandTestCard card;
  MoveAxis1(card, 30000);
  Cells points = {10000, 20000};
  ASSERT_EQ(card.Call("GT_CompareData", {1, 0, 0, 0, 500, &points, 2, &points, 2}), 0);
  card.Cycles(1600);
  EXPECT_EQ(LinearStatus(card), (Cells{1, 4}));
  ASSERT_EQ(card.Call("GT_CompareLinear", {1, 0, 0, 1, 0, 5, 0}), 0);
  EXPECT_EQ(LinearStatus(card), (Cells{0, 0}));
}

TEST(CompareData, LevelsChangeAtEachPoint) {
  CommandTestCard card;
  MoveAxis1(card, 30000);
  Cells points = {10000, 20000};
  ASSERT_EQ(card.Call("GT_CompareData", {1, 0, 1, 1, 0, &points, 2, nullptr, 0}), 0);
  const auto level = [&] { return card.motion.state().compare.output(0).Level(card.motion.now()); };
  EXPECT_TRUE(level());
  card.Cycles(640);
  EXPECT_FALSE(level());
  card.Cycles(400);
  EXPECT_TRUE(level());
}

TEST(CompareLinear, PulsesComeAtEqualDistances) {
  CommandTestCard card;
  MoveAxis1(card, 30000);
  ASSERT_EQ(card.Call("GT_CompareLinear", {1, 1, 10000, 1000, 10, 5, 0}), 0);
  card.Cycles(1600);
  EXPECT_EQ(LinearStatus(card), (Cells{1, 1000}));
  const auto& log = card.motion.state().compare.log();
  ASSERT_EQ(log.size(), 1000u);
  for (size_t i = 0; i < log.size(); ++i) {
    EXPECT_EQ(log[i].channel, 1);
    EXPECT_EQ(log[i].y, 10000 + 10 * static_cast<double>(i));
    EXPECT_NEAR(log[i].instant, 150000 + 100 * static_cast<double>(i), 1e-6);
  }
}

TEST(CompareLinear, BackwardsAndStopped) {
  CommandTestCard card;
  MoveAxis1(card, -30000);
  ASSERT_EQ(card.Call("GT_CompareLinear", {1, 0, -10000, 5, -1000, 5, 0}), 0);
  card.Cycles(648);  // 162 ms: -11200 pulses
  EXPECT_EQ(LinearStatus(card), (Cells{0, 2}));
  EXPECT_EQ(card.Call("GT_CompareStop", {}), 0);
  card.Cycles(800);
  EXPECT_EQ(LinearStatus(card), (Cells{1, 2}));
}

TEST(CompareLinear, ParametersAreChecked) {
  constexpr int kLongMax = 2147483647;
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_EncOff", {1}), 0);
  Cells points = {100};
  Cells many(4097, 1);
  const struct {
    const char* name;
    std::vector<Argument> arguments;
    int code;
  } cases[] = {
      {"GT_CompareData", {0, 0, 0, 0, 1, &points, 1, nullptr, 0}, 7},
      {"GT_CompareData", {1, 2, 0, 0, 1, &points, 1, nullptr, 0}, 7},
      {"GT_CompareData", {1, 1, 0, 0, 1, &points, 1, nullptr, 0}, 7},  // a pulse counter
      {"GT_CompareData", {1, 0, 2, 0, 1, &points, 1, nullptr, 0}, 7},
      {"GT_CompareData", {1, 0, 0, 2, 1, &points, 1, nullptr, 0}, 7},
      {"GT_CompareData", {1, 0, 0, 0, 0, &points, 1, nullptr, 0}, 7},
      {"GT_CompareData", {1, 0, 0, 0, 1, nullptr, 0, nullptr, 0}, 7},
      {"GT_CompareData", {1, 0, 0, 0, 1, nullptr, 1, nullptr, 0}, 7},
      {"GT_CompareData", {1, 0, 0, 0, 1, &many, 4097, nullptr, 0}, 7},
      {"GT_CompareData", {1, 0, 0, 0, 1, &many, 4096, nullptr, 0}, 0},
      {"GT_CompareLinear", {12, 0, 0, 1, 1, 1, 0}, 7},
      {"GT_CompareLinear", {1, 2, 0, 1, 1, 1, 0}, 7},
      {"GT_CompareLinear", {1, 0, 0, 0, 1, 1, 0}, 7},
      {"GT_CompareLinear", {1, 0, 0, 2, 0, 1, 0}, 7},
      {"GT_CompareLinear", {1, 0, 0, 1, 1, 0, 0}, 7},
      {"GT_CompareLinear", {1, 0, 0, 1, 1, 1, 2}, 7},
      {"GT_CompareLinear", {1, 0, 1, kLongMax, 1, 1, 0}, 0},
      {"GT_CompareLinear", {1, 0, 2, kLongMax, 1, 1, 0}, 7},
      {"GT_CompareLinear", {1, 1, -1, 1, 0, 1, 0}, 0},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(card.Call("GT_CompareStop", {}), 0);
    EXPECT_EQ(card.Call(c.name, c.arguments), c.code) << c.name;
  }
  // The last one is waiting.
  EXPECT_EQ(card.Call("GT_CompareLinear", {1, 0, 0, 1, 1, 1, 0}), 1);
  EXPECT_EQ(card.Call("GT_CompareData", {1, 0, 0, 0, 1, &points, 1, nullptr, 0}), 1);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
