// Constant velocity: example 7-2 of the GTS manual, changes during motion, the smoothing filter.
#include "motion/profiles/jog_mode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/motion/constraint_checker.h"
#include "tests/motion/profile_run.h"

namespace oncard::motion {
namespace {

constexpr double kExact = 1e-7;

TEST(Jog, Example72AcceleratesAndSlowsDown) {
  // 100 / 0.0625 = 1600 ms over 80000 pulses; 100000 at 1800 ms; 800 ms over 60000 down to 50.
  ProfileRun run;
  run.SetJog({.acc = 0.0625, .dec = 0.0625});
  run.JogAt(100);
  EXPECT_NEAR(run.At(800).position, 20000, kExact);
  EXPECT_NEAR(run.At(800).velocity, 50, kExact);
  EXPECT_NEAR(run.At(1600).position, 80000, kExact);
  EXPECT_NEAR(run.At(1800).position, 100000, kExact);
  run.JogAt(50);
  EXPECT_NEAR(run.At(2200).position, 135000, kExact);
  EXPECT_NEAR(run.At(2200).velocity, 75, kExact);
  EXPECT_NEAR(run.At(2600).position, 160000, kExact);
  EXPECT_NEAR(run.At(3000).position, 180000, kExact);
  EXPECT_EQ(run.profile.now.velocity, 50);
  EXPECT_EQ(run.profile.now.acceleration, 0);
  EXPECT_TRUE(run.profile.now.moving);
}

TEST(Jog, AccelerationAndDecelerationDiffer) {
  ProfileRun run;
  run.SetJog({.acc = 0.5, .dec = 0.25});
  run.JogAt(-10);
  EXPECT_EQ(run.At(10).velocity, -5);
  EXPECT_EQ(run.At(10).acceleration, -0.5);
  EXPECT_EQ(run.At(20).velocity, -10);
  run.JogAt(-5);
  EXPECT_EQ(run.At(30).velocity, -7.5);
  EXPECT_EQ(run.At(30).acceleration, 0.25);
}

TEST(Jog, AChangeOfSignGoesThroughZero) {
  ProfileRun run;
  run.SetJog({.acc = 0.5, .dec = 0.25});
  run.JogAt(10);
  run.At(20);
  run.JogAt(-10);
  EXPECT_EQ(run.At(40).velocity, 5);
  EXPECT_EQ(run.At(60).velocity, 0);
  EXPECT_TRUE(run.At(60).moving);
  EXPECT_EQ(run.At(70).velocity, -5);
  EXPECT_EQ(run.At(100).velocity, -10);
}

TEST(Jog, AVelocityOfZeroStops) {
  ProfileRun run;
  run.SetJog({.acc = 0.5, .dec = 0.25});
  run.JogAt(0);
  EXPECT_FALSE(run.profile.now.moving);
  run.JogAt(10);
  run.At(20);
  run.JogAt(0);
  EXPECT_TRUE(run.At(59.75).moving);
  EXPECT_EQ(run.At(60), AtRest(300));
}

// --- Smoothing ---------------------------------------------------------------------------------

TEST(JogSmoothing, IsAFirstOrderFilterAtWholeMilliseconds) {
  constexpr double kKeep = 0.75;
  ProfileRun run(250);
  run.SetJog({.acc = 0.5, .dec = 0.5, .smooth = kKeep});
  run.JogAt(10);
  double velocity = 0;
  double position = 0;
  for (int ms = 1; ms <= 60; ++ms) {
    const double next = kKeep * velocity + (1 - kKeep) * std::min(10.0, 0.5 * ms);
    position += (velocity + next) / 2;
    velocity = next;
    EXPECT_NEAR(run.At(ms).velocity, velocity, kExact) << ms;
    EXPECT_NEAR(run.At(ms).position, position, kExact) << ms;
  }
}

TEST(JogSmoothing, BetweenItsStepsVelocityIsLinear) {
  ProfileRun run(125);
  run.SetJog({.acc = 1, .dec = 1, .smooth = 0.5});
  run.JogAt(10);
  // 0.5 after the first millisecond, 0.5 * 0.5 + 0.5 * 2 after the second.
  EXPECT_EQ(run.At(1).velocity, 0.5);
  EXPECT_EQ(run.At(1.25).velocity, 0.6875);
  EXPECT_EQ(run.At(1.25).acceleration, 0.75);
  EXPECT_EQ(run.At(1.25).position, 0.25 + (0.5 + 0.6875) / 2 * 0.25);
  EXPECT_EQ(run.At(2).velocity, 1.25);
}

TEST(JogSmoothing, ReachesTheVelocityExactly) {
  ProfileRun run;
  run.SetJog({.acc = 1, .dec = 1, .smooth = 0.9});
  run.JogAt(10);
  EXPECT_EQ(run.At(400).velocity, 10);
  EXPECT_EQ(run.At(400).acceleration, 0);
  const double position = run.profile.now.position;
  EXPECT_NEAR(run.At(500).position, position + 1000, kExact);
}

TEST(JogSmoothing, ComesToRest) {
  ProfileRun run;
  run.SetJog({.acc = 1, .dec = 1, .smooth = 0.9});
  run.JogAt(10);
  run.At(100);
  run.JogAt(0);
  EXPECT_TRUE(run.At(120).moving);
  run.At(600);
  EXPECT_EQ(run.profile.now, AtRest(run.profile.now.position));
}

// --- Everything --------------------------------------------------------------------------------

/// Random velocity changes at multiples of `raster_us`; returns the samples at these times.
std::vector<Sample> Play(unsigned seed, Micros cycle_us, Micros raster_us = 2000) {
  std::mt19937 random(seed);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const JogParameters parameters = {draw(0.05, 3), draw(0.05, 3),
                                    seed % 2 == 0 ? 0 : draw(0, 0.99)};
  ProfileRun run(cycle_us);
  run.SetJog(parameters);
  const MotionBounds bounds = {60, std::max(parameters.acc, parameters.dec)};
  ConstraintChecker checker(bounds, run.cycle_ms(), AtRest(0));
  std::vector<Sample> shared;
  for (int change = 0; change < 6; ++change) {
    run.JogAt(change % 4 == 3 ? 0 : draw(-60, 60));
    const Micros until = run.now + raster_us * static_cast<Micros>(draw(0, 100));
    while (run.now < until) {
      const testing::AssertionResult ok = checker.Next(run.Tick());
      EXPECT_TRUE(ok) << "at " << run.now;
      if (!ok) return shared;
      if (run.now % raster_us == 0) shared.push_back(run.profile.now);
    }
  }
  return shared;
}

TEST(Jog, RandomChangesStayWithinTheirBounds) {
  for (unsigned seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Play(seed, 1000);
  }
}

TEST(JogSmoothing, ChangesBetweenTheFiltersStepsStayWithinTheirBounds) {
  for (unsigned seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Play(seed, 250, 250);
  }
}

TEST(Jog, TheMotionDoesNotDependOnTheCycle) {
  for (unsigned seed = 1; seed <= 60 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<Sample> expected = Play(seed, 2000);
    for (const Micros cycle_us : {125, 250, 500, 1000}) {
      EXPECT_EQ(Play(seed, cycle_us), expected) << cycle_us << " us";
    }
  }
}

}  // namespace
}  // namespace oncard::motion
