// Position/velocity/time motion through its commands.
#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <utility>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using Values = std::vector<double>;

/// 100 pulses in 100 ms at constant velocity, times `factor`.
int16_t FillEven(CommandTestCard& card, int table, double factor = 1) {
  Values times = {0, 100};
  Values positions = {0, 100 * factor};
  Values velocities = {factor, factor};
  return card.Call("GT_PvtTable", {table, 2, &times, &positions, &velocities});
}

double Position(const CommandTestCard& card, size_t profile = 0) {
  return card.motion.state().profiles[profile].now.position;
}

TEST(PvtCommand, RunsTheSelectedTable) {
  CommandTestCard card;
  Values times = {0, 1200, 2000, 3000, 3800, 5000};
  Values positions = {0, 9750, 24483, 44483, 59216, 68966};
  Values velocities = {1, 15.25, 20, 20, 15.25, 1};
  EXPECT_EQ(card.Call("GT_PvtTable", {32, 6, &times, &positions, &velocities}), 0);
  EXPECT_EQ(card.Call("GT_PrfPvt", {1}), 0);
  EXPECT_EQ(card.Call("GT_PvtStart", {1}), 1);  // table 1 is selected, and empty
  EXPECT_EQ(card.Call("GT_PvtTableSelect", {1, 32}), 0);
  EXPECT_EQ(card.Call("GT_PvtStart", {1}), 0);
  card.Cycles(4 * 1200);
  EXPECT_NEAR(Position(card), 9750, 1e-9);
  Values table(1);
  Values time(1);
  EXPECT_EQ(card.Call("GT_PvtStatus", {1, &table, &time, 1}), 0);
  EXPECT_EQ(table[0], 32);
  EXPECT_EQ(time[0], 1200);
  card.Cycles(4 * 3800);
  EXPECT_EQ(card.motion.state().profiles[0].now, motion::AtRest(68966));
}

TEST(PvtCommand, MotionCommandsNeedModePvt) {
  CommandTestCard card;
  Values cell(1);
  FillEven(card, 1);
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_SetPvtLoop", {1, 1}), 1);
  EXPECT_EQ(card.Call("GT_GetPvtLoop", {1, &cell, &cell}), 1);
  EXPECT_EQ(card.Call("GT_PvtTableSelect", {1, 1}), 1);
  EXPECT_EQ(card.Call("GT_PvtStart", {1}), 1);
  EXPECT_EQ(card.Call("GT_PvtStatus", {1, &cell, &cell, 1}), 1);
  EXPECT_EQ(card.Hash(), before);
}

TEST(PvtCommand, NumbersAreCheckedAtBothEnds) {
  CommandTestCard card;
  card.Call("GT_PrfPvt", {1});
  for (const auto& [table, code] : {std::pair{0, 7}, {1, 0}, {32, 0}, {33, 7}}) {
    EXPECT_EQ(card.Call("GT_PvtTableSelect", {1, table}), code) << table;
    EXPECT_EQ(FillEven(card, table), code) << table;
  }
  EXPECT_EQ(card.Call("GT_SetPvtLoop", {1, -1}), 7);
  EXPECT_EQ(card.Call("GT_SetPvtLoop", {1, 0}), 0);
  EXPECT_EQ(card.Call("GT_PrfPvt", {9}), 7);
}

TEST(PvtCommand, LoopsAreCounted) {
  CommandTestCard card;
  FillEven(card, 1);
  card.Call("GT_PrfPvt", {1});
  EXPECT_EQ(card.Call("GT_SetPvtLoop", {1, 3}), 0);
  card.Call("GT_PvtStart", {1});
  card.Cycles(4 * 250);
  Values done(1);
  Values target(1);
  EXPECT_EQ(card.Call("GT_GetPvtLoop", {1, &done, &target}), 0);
  EXPECT_EQ(done[0], 2);
  EXPECT_EQ(target[0], 3);
  EXPECT_EQ(Position(card), 250);
  card.Cycles(4 * 50);
  EXPECT_EQ(card.motion.state().profiles[0].now, motion::AtRest(300));
}

TEST(PvtCommand, ARunKeepsItsTableAndTakesAnotherAtTheEndOfThePass) {
  CommandTestCard card;
  FillEven(card, 1);
  card.Call("GT_PrfPvt", {1});
  card.Call("GT_SetPvtLoop", {1, 0});
  card.Call("GT_PvtStart", {1});
  card.Cycles(4 * 50);
  EXPECT_EQ(card.Call("GT_PvtStart", {1}), 1);
  EXPECT_EQ(card.Call("GT_PrfPvt", {1}), 1);
  EXPECT_EQ(card.Call("GT_PvtTableSelect", {1, 2}), 1);  // empty
  FillEven(card, 1, 5);
  FillEven(card, 2, 3);
  EXPECT_EQ(card.Call("GT_PvtTableSelect", {1, 2}), 0);
  Values table(1);
  Values time(1);
  card.Cycles(4 * 49);
  EXPECT_EQ(Position(card), 99);
  card.Call("GT_PvtStatus", {1, &table, &time, 1});
  EXPECT_EQ(table[0], 1);
  card.Cycles(4 * 51);
  EXPECT_EQ(Position(card), 250);
  card.Call("GT_PvtStatus", {1, &table, &time, 1});
  EXPECT_EQ(table[0], 2);
  EXPECT_EQ(time[0], 50);
}

TEST(PvtStart, AllProfilesOfTheMaskOrNone) {
  CommandTestCard card;
  FillEven(card, 1);
  card.Call("GT_PrfPvt", {1});
  card.Call("GT_PrfPvt", {2});
  card.Call("GT_PvtTableSelect", {2, 5});
  EXPECT_EQ(card.Call("GT_PvtStart", {3}), 1);
  EXPECT_FALSE(card.motion.state().profiles[0].now.moving);
  card.Call("GT_PvtTableSelect", {2, 1});
  EXPECT_EQ(card.Call("GT_PvtStart", {3}), 0);
  card.Cycles(4 * 50);
  EXPECT_EQ(Position(card, 0), 50);
  EXPECT_EQ(Position(card, 1), 50);
  Values tables(2);
  Values times(2);
  EXPECT_EQ(card.Call("GT_PvtStatus", {1, &tables, &times, 2}), 0);
  EXPECT_EQ(tables, (Values{1, 1}));
  EXPECT_EQ(times, (Values{50, 50}));
  EXPECT_EQ(card.Call("GT_PvtStart", {0}), 1);
}

TEST(PvtStart, IsRefusedWhileAnAlarmIsLatched) {
  CommandTestCard card;
  FillEven(card, 1);
  card.Call("GT_PrfPvt", {1});
  ChangeState(card.motion).axes[0].latched = motion::kAlarmBit;
  EXPECT_EQ(card.Call("GT_PvtStart", {1}), 1);
}

TEST(PvtTable, ArraysAreChecked) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct {
    Values times, positions, velocities;
    int code;
  } const cases[] = {{{0, 1}, {0, 1073741823}, {-32767, 32767}, 0},
                     {{0, 1}, {0, 1073741824}, {0, 0}, 7},
                     {{0, 1}, {-1073741824, 0}, {0, 0}, 7},
                     {{-1, 1}, {0, 0}, {0, 0}, 7},
                     {{1, 1}, {0, 0}, {0, 0}, 7},
                     {{1, 0.5}, {0, 0}, {0, 0}, 7},
                     {{0, nan}, {0, 0}, {0, 0}, 7},
                     {{0, 1}, {nan, 0}, {0, 0}, 7},
                     {{0, 1}, {0, 0}, {0, nan}, 7},
                     {{0, 1}, {0, 0}, {32768, 0}, 7},
                     {{5}, {7}, {0}, 0}};
  for (size_t i = 0; i < std::size(cases); ++i) {
    CommandTestCard card;
    Values times = cases[i].times;
    Values positions = cases[i].positions;
    Values velocities = cases[i].velocities;
    const uint64_t before = card.Hash();
    const double count = static_cast<double>(times.size());
    EXPECT_EQ(card.Call("GT_PvtTable", {1, count, &times, &positions, &velocities}), cases[i].code)
        << i;
    EXPECT_EQ(card.Hash() == before, cases[i].code != 0) << i;
    EXPECT_EQ(card.Call("GT_PvtTableEx", {1, count, &times, &positions, &velocities, &velocities}),
              cases[i].code)
        << i;
  }
}

TEST(PvtTable, CompleteGivesItsCoefficients) {
  CommandTestCard card;
  Values times = {0, 500, 1000, 1500, 2000};
  Values positions = {0, 20000, 40000, 20000, 0};
  Values a(5);
  Values b(5);
  Values c(5);
  EXPECT_EQ(card.Call("GT_PvtTableComplete", {1, 5, &times, &positions, &a, &b, &c, 0, 0}), 0);
  EXPECT_NEAR(c[1], 60, 1e-9);
  EXPECT_NEAR(c[3], -60, 1e-9);
  EXPECT_NEAR(b[0], 0.12, 1e-12);
  EXPECT_NEAR(a[0], -8e-5, 1e-15);
  EXPECT_EQ(card.Call("GT_PvtTableComplete", {1, 5, &times, &positions, &a, &b, &c, 32768, 0}), 7);
  EXPECT_EQ(card.Call("GT_PvtTableComplete", {1, 5, &times, &positions, &a, &b, &c, 0, -32768}), 7);
}

TEST(PvtTable, PercentAndItsCalculation) {
  CommandTestCard card;
  Values times = {2000, 2500, 3500, 4000, 5000};
  Values positions = {0, 2500, 12500, 15000, 15000};
  Values percents = {60, 0, 60, 100, 0};
  Values velocities(5);
  EXPECT_EQ(card.Call("GT_PvtPercentCalculate", {5, &times, &positions, &percents, 0, &velocities}),
            0);
  EXPECT_EQ(velocities, (Values{0, 10, 10, 0, 0}));
  EXPECT_EQ(card.Call("GT_PvtTablePercent", {1, 5, &times, &positions, &percents, 0}), 0);
  percents[2] = 100.5;
  EXPECT_EQ(card.Call("GT_PvtTablePercent", {1, 5, &times, &positions, &percents, 0}), 7);
  percents[2] = -0.5;
  EXPECT_EQ(card.Call("GT_PvtPercentCalculate", {5, &times, &positions, &percents, 0, &velocities}),
            7);
}

TEST(PvtTable, StorageIsLimited) {
  // Three pieces per interval and one for the end: 341 intervals fill the table.
  for (const auto& [count, code] : {std::pair{342, 0}, {343, 7}}) {
    CommandTestCard card;
    Values times(static_cast<size_t>(count));
    std::iota(times.begin(), times.end(), 0);
    Values positions(times.size());
    for (size_t i = 0; i < times.size(); ++i) positions[i] = i % 2 == 0 ? 0 : 1;
    positions[0] = 0.5;
    Values percents(times.size(), 50);
    EXPECT_EQ(card.Call("GT_PvtTablePercent", {1, count, &times, &positions, &percents, 0}), code);
  }
}

TEST(PvtTable, ContinuousAndItsCalculation) {
  // Ramps of 100 ms and 500 pulses, 500 ms at 10 pulse/ms.
  CommandTestCard card;
  Values positions = {0, 6000};
  Values velocities = {0, 0};
  Values percents = {0, 0};
  Values maxima = {10, 0};
  Values accelerations = {0.1, 0};
  Values times(2);
  const auto calculate = [&] {
    return card.Call("GT_PvtContinuousCalculate", {2, &positions, &velocities, &percents, &maxima,
                                                   &accelerations, &accelerations, &times});
  };
  const auto fill = [&](double begin) {
    return card.Call("GT_PvtTableContinuous", {1, 2, &positions, &velocities, &percents, &maxima,
                                               &accelerations, &accelerations, begin});
  };
  EXPECT_EQ(calculate(), 0);
  EXPECT_EQ(times[0], 0);
  EXPECT_NEAR(times[1], 700, 1e-9);
  EXPECT_EQ(fill(300), 0);
  card.Call("GT_PrfPvt", {1});
  card.Call("GT_PvtStart", {1});
  card.Cycles(4 * 650);
  EXPECT_NEAR(Position(card), 3000, 1e-6);
  card.Cycles(4 * 351);
  EXPECT_EQ(card.motion.state().profiles[0].now, motion::AtRest(6000));
  EXPECT_EQ(fill(-1), 7);

  const auto refused = [&](double& value, double bad) {
    const double good = std::exchange(value, bad);
    EXPECT_EQ(calculate(), 7) << bad;
    EXPECT_EQ(fill(0), 7) << bad;
    value = good;
  };
  refused(positions[1], 0);
  refused(positions[1], 1073741824);
  refused(velocities[1], -1);
  refused(velocities[0], 10.5);
  refused(percents[0], 101);
  refused(maxima[0], -1);
  refused(maxima[0], 0);
  refused(accelerations[0], 0);
  EXPECT_EQ(calculate(), 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
