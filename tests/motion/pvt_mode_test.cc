// PVT tables and their runs: examples 6-17 to 6-19, the curves of all descriptions, loops.
#include "motion/profiles/pvt_mode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "tests/motion/profile_run.h"

namespace oncard::motion {
namespace {

using Values = std::vector<double>;

constexpr double kPvtExact = 1e-8;

const Values kTimes617 = {0, 1200, 2000, 3000, 3800, 5000};
const Values kPositions617 = {0, 9750, 24483, 44483, 59216, 68966};
const Values kVelocities617 = {1, 15.25, 20, 20, 15.25, 1};

PvtTablePointer Share(PvtTable table) { return std::make_shared<const PvtTable>(std::move(table)); }

PvtTablePointer Example617() {
  return Share(PvtFromVelocities(kTimes617, kPositions617, kVelocities617, kVelocities617));
}

/// The axis of example 6-19 that begins after 2 s: accelerates to 10, runs, stops, waits.
PvtTablePointer Raster() {
  return Share(PvtFromPercents(Values{2000, 2500, 3500, 4000, 5000},
                               Values{0, 2500, 12500, 15000, 15000}, Values{60, 0, 60, 0, 0}, 0));
}

struct PvtRun : ProfileRun {
  explicit PvtRun(Micros cycle_us = 250) : ProfileRun(cycle_us) {
    profile.mode = ProfileMode::kPvt;
  }
  void Start(PvtTablePointer table) {
    profile.pvt.next = std::move(table);
    profile.Start(now);
  }
};

void ExpectSample(const Sample& sample, double position, double velocity, double acceleration) {
  EXPECT_NEAR(sample.position, position, kPvtExact);
  EXPECT_NEAR(sample.velocity, velocity, kPvtExact);
  EXPECT_NEAR(sample.acceleration, acceleration, kPvtExact);
}

/// Integrates the table's own velocity to positions, with 100 midpoints per ms: position and
/// velocity of At() must agree, and neither may jump.
void ExpectSmooth(const PvtTable& table, double acceleration_max) {
  double position = 0;
  Sample before = table.At(table.begin);
  constexpr double kStep = 0.01;
  const auto steps = static_cast<int>(table.period() / kStep);
  for (int i = 0; i < steps; ++i) {
    const double t = table.begin + i * kStep;
    position += table.At(t + kStep / 2).velocity * kStep;
    const Sample sample = table.At(t + kStep);
    ASSERT_LE(std::fabs(sample.velocity - before.velocity), acceleration_max * kStep + 1e-9) << t;
    ASSERT_NEAR(sample.position, position, 1e-2) << t;
    before = sample;
  }
}

// --- Velocities --------------------------------------------------------------------------------

TEST(PvtTable, Example617IsCubicBetweenItsPoints) {
  for (const Micros cycle_us : {125, 250, 500, 1000, 2000, 4000}) {
    PvtRun run(cycle_us);
    run.Start(Example617());
    // The cubic term of the first interval is 0: p = t + 0.0059375 t^2.
    ExpectSample(run.At(600), 600 + 0.0059375 * 360000, 1 + 0.011875 * 600, 0.011875);
    ExpectSample(run.At(1200), 9750, 15.25, 2 * (3 * 14733.0 / 800 - 2 * 15.25 - 20) / 800);
    ExpectSample(run.At(2500), 34483, 20, 0);
    ExpectSample(run.At(3800), 59216, 15.25, -0.011875);
    EXPECT_EQ(run.At(5000), AtRest(68966));
  }
}

TEST(PvtTable, ExtendedPointsHaveAVelocityOnEachSide) {
  const PvtTable table = PvtFromVelocities(Values{0, 100, 200}, Values{0, 100, 300},
                                           Values{1, 2, 99}, Values{99, 1, 2});
  ExpectSample(table.At(50), 50, 1, 0);
  ExpectSample(table.At(99), 99, 1, 0);
  ExpectSample(table.At(100), 100, 2, 0);
  ExpectSample(table.At(150), 200, 2, 0);
}

// --- Spline ------------------------------------------------------------------------------------

TEST(PvtSpline, Example618HasItsSlopesAndCoefficients) {
  // By symmetry the slope in the middle is 0; the others are the solutions of 4 v = 3 * 40000 /
  // 500.
  const Values times = {0, 500, 1000, 1500, 2000};
  const Values positions = {0, 20000, 40000, 20000, 0};
  const auto cubics = SplineCoefficients(times, positions, 0, 0);
  const double slopes[] = {0, 60, 0, -60, 0};
  for (size_t i = 0; i < 5; ++i) EXPECT_NEAR(cubics[i].c, slopes[i], kPvtExact) << i;
  EXPECT_NEAR(cubics[0].b, 0.12, kPvtExact);
  EXPECT_NEAR(cubics[0].a, -8e-5, 1e-15);
  EXPECT_NEAR(cubics[4].b, 0.12, kPvtExact);
  const PvtTable table = PvtFromCubics(times, positions, cubics);
  ExpectSample(table.At(250), 6250, 45, 0.12);
  ExpectSample(table.At(1250), 33750, -45, -0.12);
}

TEST(PvtSpline, UnequalIntervalsHaveContinuousAcceleration) {
  const Values times = {10, 30, 100, 105, 300};
  const Values positions = {5, 25, -40, 60, 61};
  const auto cubics = SplineCoefficients(times, positions, 0.5, -0.25);
  EXPECT_EQ(cubics[0].c, 0.5);
  EXPECT_EQ(cubics[4].c, -0.25);
  for (size_t i = 0; i < 4; ++i) {
    const double t = times[i + 1] - times[i];
    const auto [a, b, c] = cubics[i];
    EXPECT_NEAR(positions[i] + t * (c + t * (b + t * a)), positions[i + 1], 1e-9) << i;
    EXPECT_NEAR(c + t * (2 * b + t * 3 * a), cubics[i + 1].c, 1e-9) << i;
    EXPECT_NEAR(b + t * 3 * a, cubics[i + 1].b, 1e-9) << i;
  }
}

// --- Percent -----------------------------------------------------------------------------------

TEST(PvtPercent, VelocitiesFollowFromMeanVelocities) {
  EXPECT_EQ(PercentVelocities(Values{2000, 2500, 3500, 4000, 5000},
                              Values{0, 2500, 12500, 15000, 15000}, 0),
            (Values{0, 10, 10, 0, 0}));
}

TEST(PvtPercent, AccelerationIsATrapezoidOfTheRightArea) {
  // 60 percent of 500 ms: 150 ms up, 200 ms constant, 150 ms down; peak 10 / 350.
  const PvtTablePointer table = Raster();
  constexpr double kPeak = 10.0 / 350;
  constexpr double kJerk = kPeak / 150;
  EXPECT_EQ(table->pieces.size(), 8U);
  ExpectSample(table->At(2075), kJerk * 75 * 75 * 75 / 6, kJerk * 75 * 75 / 2, kPeak / 2);
  // To the middle: 150 ms up (150^2 / 6, then at 75), 100 ms constant.
  constexpr double kHalf = kPeak * (150 * 150 / 6 + 75 * 100 + 100 * 100 / 2);
  ExpectSample(table->At(2250), kHalf, 5, kPeak);
  ExpectSample(table->At(2500), 2500, 10, 0);
  ExpectSample(table->At(3000), 7500, 10, 0);
  ExpectSample(table->At(3750), 15000 - kHalf, 5, -kPeak);
  ExpectSample(table->At(4500), 15000, 0, 0);
  ExpectSmooth(*table, kPeak);
}

TEST(PvtPercent, BothEndsOfTheRangeDropParts) {
  const auto pieces = [](double percent) {
    return PvtFromPercents(Values{0, 100}, Values{0, 100}, Values{percent, 0}, 0).pieces;
  };
  EXPECT_EQ(pieces(0).size(), 1U);
  EXPECT_EQ(pieces(0)[0].acceleration, 0.02);
  EXPECT_EQ(pieces(100).size(), 2U);
  EXPECT_EQ(pieces(50).size(), 3U);
}

// --- Limits ------------------------------------------------------------------------------------

TEST(PvtContinuous, ReachesTheMaximumWhenThereIsRoom) {
  // Peak 0.1 and 60 percent: 10 takes 10 / (0.1 * 0.7) ms; both ramps together 10/0.07 * 10 pulses.
  const std::vector<ContinuousRow> rows = {{0, 0, 60, 10, 0.1, 0.1}, {10000, 0}};
  constexpr double kRamp = 10 / 0.07;
  EXPECT_NEAR(ContinuousTimes(rows)[1], 2 * kRamp + (10000 - 10 * kRamp) / 10, kPvtExact);
  const PvtTable table = PvtFromLimits(rows, 0);
  EXPECT_EQ(table.pieces.size(), 7U);
  ExpectSample(table.At(kRamp / 2), table.At(kRamp / 2).position, 5, 0.1);
  ExpectSample(table.At(kRamp + 10), 5 * kRamp + 100, 10, 0);
  ExpectSample(table.At(table.end), 10000, 0, 0);
  ExpectSmooth(table, 0.1);
}

TEST(PvtContinuous, AShortDistanceReachesLess) {
  // acc 0.1, dec 0.05, no smoothing, 1500 pulses: v^2 (5 + 10) = 1500, 10 in 100 and 200 ms.
  const std::vector<ContinuousRow> rows = {{0, 0, 0, 50, 0.1, 0.05}, {-1500, 0}};
  EXPECT_NEAR(ContinuousTimes(rows)[1], 300, kPvtExact);
  const PvtTable table = PvtFromLimits(rows, 20);
  EXPECT_EQ(table.begin, 20);
  EXPECT_NEAR(table.end, 320, kPvtExact);
  ExpectSample(table.At(70), -125, -5, -0.1);
  ExpectSample(table.At(220), -1250, -5, 0.05);
  EXPECT_EQ(table.travel, -1500);
}

TEST(PvtContinuous, IntervalsJoinAtTheirVelocities) {
  const std::vector<ContinuousRow> rows = {
      {100, 0, 40, 8, 0.02, 0.03}, {5000, 5, 100, 5, 1, 1}, {6000, 5, 0, 9, 0.1, 0.05}, {9000, 1}};
  const Values times = ContinuousTimes(rows);
  const PvtTable table = PvtFromLimits(rows, 0);
  EXPECT_NEAR(times[2] - times[1], 200, kPvtExact);
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(table.At(times[i]).position, rows[i].position - 100, 1e-6) << i;
    EXPECT_NEAR(table.At(times[i]).velocity, rows[i].velocity, 1e-6) << i;
  }
  ExpectSmooth(table, 0.1);
}

TEST(PvtContinuous, FindsWhatCannotBeRun) {
  const ContinuousRow base = {0, 2, 0, 5, 0.1, 0.1};
  EXPECT_EQ(FirstImpossibleInterval(std::vector<ContinuousRow>{base, {100, 2}}), 1U);
  EXPECT_EQ(FirstImpossibleInterval(std::vector<ContinuousRow>{base, {0, 2}}), 0U);
  EXPECT_EQ(FirstImpossibleInterval(std::vector<ContinuousRow>{base, {-100, 2}}), 0U);
  EXPECT_EQ(FirstImpossibleInterval(std::vector<ContinuousRow>{base, {100, -2}}), 0U);
  EXPECT_EQ(FirstImpossibleInterval(std::vector<ContinuousRow>{base, {100, 5.1}}), 0U);
  // From 2 to 0 with 0.1 takes 20 pulses.
  EXPECT_EQ(FirstImpossibleInterval(std::vector<ContinuousRow>{base, {20, 0}}), 1U);
  EXPECT_EQ(FirstImpossibleInterval(std::vector<ContinuousRow>{base, {19.9, 0}}), 0U);
}

// --- Runs --------------------------------------------------------------------------------------

TEST(PvtRun, TheFirstTimeDelaysOnceAndLoopsAddUp) {
  for (const Micros cycle_us : {250, 4000}) {
    PvtRun run(cycle_us);
    run.profile.SetPosition(50);
    run.profile.pvt.loop_target = 3;
    run.Start(Raster());
    const Sample waiting = run.At(1996);
    EXPECT_EQ(waiting.position, 50);
    EXPECT_EQ(waiting.velocity, 0);
    EXPECT_TRUE(waiting.moving);
    for (int pass = 0; pass < 3; ++pass) {
      ExpectSample(run.At(3000 + 3000 * pass), 50 + 7500 + 15000 * pass, 10, 0);
      EXPECT_EQ(run.profile.pvt.loop_count, pass);
      EXPECT_NEAR(run.profile.pvt.time, 3000, kPvtExact);
    }
    EXPECT_TRUE(run.At(10996).moving);
    EXPECT_EQ(run.At(11000), AtRest(45050));
    EXPECT_EQ(run.profile.pvt.loop_count, 3);
  }
}

TEST(PvtRun, AnotherTableIsTakenAtTheEndOfThePass) {
  PvtRun run;
  run.profile.pvt.loop_target = 0;
  run.profile.pvt.Select(3, nullptr);
  run.Start(Share(PvtFromVelocities(Values{0, 100}, Values{0, 100}, Values{1, 1}, Values{1, 1})));
  run.At(150);
  run.profile.pvt.Select(
      7, Share(PvtFromVelocities(Values{40, 140}, Values{0, 200}, Values{2, 2}, Values{2, 2})));
  ExpectSample(run.At(199), 199, 1, 0);
  EXPECT_EQ(run.profile.pvt.current, 3);
  ExpectSample(run.At(200), 200, 2, 0);
  EXPECT_EQ(run.profile.pvt.current, 7);
  ExpectSample(run.At(250), 300, 2, 0);
  EXPECT_NEAR(run.profile.pvt.time, 90, kPvtExact);
  ExpectSample(run.At(400), 600, 2, 0);
}

TEST(PvtRun, ProfilesShareATableAndKeepIt) {
  PvtTablePointer table = Example617();
  PvtRun first;
  PvtRun second;
  first.Start(table);
  second.At(1000);
  second.Start(table);
  table.reset();
  EXPECT_EQ(first.At(1200).position, 9750);
  EXPECT_EQ(second.At(2200).position, 9750);
}

TEST(PvtRun, StopDeceleratesFromTheOutput) {
  PvtRun run;
  run.Start(Example617());
  run.At(2500);
  run.Stop(0.1);  // 20 pulse/ms: 200 ms, 2000 pulses
  EXPECT_EQ(run.At(2700), AtRest(36483));
  EXPECT_EQ(run.profile.pvt.table, nullptr);
}

TEST(PvtRun, APointAloneOnlyWaits) {
  PvtRun run;
  run.profile.pvt.loop_target = 0;
  run.Start(Share(PvtFromVelocities(Values{10}, Values{5}, Values{1}, Values{1})));
  EXPECT_TRUE(run.At(9.75).moving);
  EXPECT_EQ(run.At(10), AtRest(0));
}

TEST(PvtRun, PassesShorterThanACycleAreCounted) {
  PvtRun run(4000);
  run.profile.pvt.loop_target = 1000;
  run.Start(Share(PvtFromVelocities(Values{0, 0.25}, Values{0, 1}, Values{4, 4}, Values{4, 4})));
  ExpectSample(run.At(100), 400, 4, 0);
  EXPECT_EQ(run.At(252), AtRest(1000));
}

}  // namespace
}  // namespace oncard::motion
