// Point-to-point motion: example 7-1 of the GTS manual with and without smoothing, changes during
// motion.
#include "motion/profiles/trap_mode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/motion/constraint_checker.h"
#include "tests/motion/profile_run.h"

namespace oncard::motion {
namespace {

constexpr double kTrapExact = 1e-7;

/// The mean of an unsmoothed motion over the last `smooth` ms by brute force: 4000 midpoints.
template <typename Raw>
double BruteMean(const Raw& raw, double t, double smooth) {
  constexpr int kPoints = 4000;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) sum += raw(t - smooth * (i + 0.5) / kPoints);
  return sum / kPoints;
}

void ExpectSample(const Sample& sample, double position, double velocity, double acceleration) {
  EXPECT_NEAR(sample.position, position, kTrapExact);
  EXPECT_NEAR(sample.velocity, velocity, kTrapExact);
  EXPECT_NEAR(sample.acceleration, acceleration, kTrapExact);
  EXPECT_TRUE(sample.moving);
}

// --- Raw ---------------------------------------------------------------------------------------

TEST(Trap, Example71WithoutSmoothingTakes1300Ms) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, 50);
  ExpectSample(run.At(100), 1250, 25, 0.25);
  ExpectSample(run.At(200), 5000, 50, 0);
  ExpectSample(run.At(550), 22500, 50, 0);
  ExpectSample(run.At(900), 40000, 50, -0.125);
  ExpectSample(run.At(1100), 47500, 25, -0.125);
  ExpectSample(run.At(1299.75), 50000 - 0.125 * 0.0625 / 2, 0.03125, -0.125);
  EXPECT_EQ(run.At(1300), AtRest(50000));
}

TEST(Trap, ANegativeMoveMirrorsAPositiveOne) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(-50000, 50);
  ExpectSample(run.At(1100), -47500, -25, 0.125);
  EXPECT_EQ(run.At(1300), AtRest(-50000));
}

TEST(Trap, TheSignOfTheVelocityDoesNotMatter) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, -50);
  ExpectSample(run.At(100), 1250, 25, 0.25);
}

TEST(Trap, AShortMoveIsATriangle) {
  // Peak sqrt(500/3) after peak/0.25 ms; 1000 pulses in 3 * peak / 0.25 = 154.919 ms.
  const double peak = std::sqrt(500.0 / 3);
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(1000, 50);
  ExpectSample(run.At(50), 312.5, 12.5, 0.25);
  const double left = 12 * peak - 100;
  ExpectSample(run.At(100), 1000 - left * left / 16, left / 8, -0.125);
  EXPECT_TRUE(run.At(154.75).moving);
  EXPECT_EQ(run.At(155), AtRest(1000));
}

TEST(Trap, AStartVelocityIsThereAtOnce) {
  ProfileRun run;
  run.SetTrap({.acc = 0.25, .dec = 0.125, .vel_start = 10});
  run.MoveTo(50000, 50);
  ExpectSample(run.At(0.25), 2.5 + 0.25 * 0.0625 / 2, 10.0625, 0.25);
  // 160 + 712 + 320 ms.
  ExpectSample(run.At(1191.75), 50000 - 2.5 - 0.125 * 0.0625 / 2, 10.03125, -0.125);
  EXPECT_EQ(run.At(1192), AtRest(50000));
}

TEST(Trap, NothingMovesAtTheTargetOrWithoutVelocity) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(0, 50);
  EXPECT_EQ(run.profile.now, AtRest(0));
  run.MoveTo(100, 0);
  EXPECT_EQ(run.At(10), AtRest(0));
}

TEST(Trap, ARunIsMarkedAsMovingBeforeItsFirstCycle) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(100, 50);
  EXPECT_TRUE(run.profile.now.moving);
  EXPECT_EQ(run.profile.now.position, 0);
}

TEST(Trap, ASecondUpdateInTheSameCycleReplacesTheFirst) {
  ProfileRun once;
  ProfileRun twice;
  for (ProfileRun* run : {&once, &twice}) {
    run->SetTrap({.acc = 0.25, .dec = 0.125, .vel_start = 10, .smooth_time = 20});
  }
  once.MoveTo(-5000, 50);
  twice.MoveTo(5000, 50);
  twice.MoveTo(-5000, 50);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(once.Tick(), twice.Tick());
}

// --- Smoothing ---------------------------------------------------------------------------------

TEST(TrapSmoothing, Example71TakesItsSmoothingTimeLonger) {
  ProfileRun run;
  run.SetTrap({.acc = 0.25, .dec = 0.125, .smooth_time = 25});
  run.MoveTo(50000, 50);
  // In the first 25 ms the acceleration rises by 0.01 pulse/ms^3: v = 0.005 t^2, p = t^3 / 600.
  ExpectSample(run.At(12.5), 3.2552083333, 0.78125, 0.125);
  ExpectSample(run.At(25), 26.0416666667, 3.125, 0.25);
  // Then the unsmoothed motion 12.5 ms earlier, and 0.25 * 25^2 / 24 for the curvature.
  ExpectSample(run.At(100), 0.125 * 87.5 * 87.5 + 6.5104166667, 21.875, 0.25);
  ExpectSample(run.At(225), 5625, 50, 0);
  ExpectSample(run.At(900), 39375, 50, 0);
  // The last 25 ms: 0.005 pulse/ms^3.
  ExpectSample(run.At(1300), 50000 - 13.0208333333, 1.5625, -0.125);
  ExpectSample(run.At(1312), 50000 - 13.0 * 13 * 13 / 1200, 0.0025 * 169, -0.065);
  EXPECT_EQ(run.At(1325), AtRest(50000));
}

TEST(TrapSmoothing, LongerThanTheAccelerationItLimitsThePeak) {
  // 10 pulse/ms at 1 pulse/ms^2: 10 ms, smoothed over 40: the acceleration peaks at 10/40.
  ProfileRun run;
  run.SetTrap({.acc = 1, .dec = 1, .smooth_time = 40});
  run.MoveTo(1000, 10);
  double peak = 0;
  while (run.Tick().moving) peak = std::max(peak, run.profile.now.acceleration);
  EXPECT_NEAR(peak, 0.25, kTrapExact);
  // 10 + 90 + 10 ms and 40.
  EXPECT_EQ(run.now, 150000);
  EXPECT_EQ(run.profile.now, AtRest(1000));
}

TEST(TrapSmoothing, IsTheMeanOfTheRawMotionAlsoAcrossAChange) {
  // At 500 ms to 28000 at 25 pulse/ms: without smoothing it stops at 30000 and returns.
  const MoveLimits before = {.velocity = 50, .acceleration = 0.25, .deceleration = 0.125};
  const MoveLimits after = {.velocity = 25, .acceleration = 0.25, .deceleration = 0.125};
  const Plan first = PlanToPosition(0, 0, 50000, before);
  const Plan second = PlanToPosition(20000, 50, 28000, after);
  const auto raw = [&](double t) {
    if (t < 0) return 0.0;
    return t < 500 ? first.At(t).position : second.At(t - 500).position;
  };
  ProfileRun run;
  run.SetTrap({.acc = 0.25, .dec = 0.125, .smooth_time = 50});
  run.MoveTo(50000, 50);
  for (const double t : {10.0, 60.0, 220.0, 500.0}) {
    EXPECT_NEAR(run.At(t).position, BruteMean(raw, t, 50), 1e-3) << t;
  }
  run.MoveTo(28000, 25);
  for (const double t : {500.25, 520.0, 550.0, 600.0, 890.0, 900.0, 930.0, 1000.0, 1100.0}) {
    EXPECT_NEAR(run.At(t).position, BruteMean(raw, t, 50), 1e-3) << t;
  }
  while (run.Tick().moving) {
  }
  EXPECT_EQ(run.profile.now, AtRest(28000));
  EXPECT_NEAR(run.now_ms(), 500 + second.duration + 50, 0.25);
}

TEST(TrapSmoothing, AChangeWhileTheMeanFlushesIsSmoothToo) {
  ProfileRun run;
  run.SetTrap({.acc = 1, .dec = 1, .smooth_time = 50});
  run.MoveTo(1000, 20);
  run.At(95);  // the unsmoothed motion ends at 70 ms
  ConstraintChecker checker({.velocity = 20, .acceleration = 1}, 0.25, run.profile.now);
  run.MoveTo(0, 20);
  while (run.Tick().moving) ASSERT_TRUE(checker.Next(run.profile.now));
  EXPECT_EQ(run.profile.now, AtRest(0));
}

TEST(TrapSmoothing, OutOfAStopItStartsWithTheVelocityThatIsThere) {
  ProfileRun run;
  run.SetTrap({.acc = 0.25, .dec = 0.125, .smooth_time = 25});
  run.MoveTo(50000, 50);
  run.At(500);
  run.Stop(1);
  run.At(510);
  EXPECT_NEAR(run.profile.now.velocity, 40, kTrapExact);
  ConstraintChecker checker({.velocity = 50, .acceleration = 0.25}, 0.25, run.profile.now);
  run.MoveTo(50000, 50);
  while (run.Tick().moving) ASSERT_TRUE(checker.Next(run.profile.now));
  EXPECT_EQ(run.profile.now, AtRest(50000));
}

// --- On the fly --------------------------------------------------------------------------------

struct Fly {
  const char* name;
  int32_t target;
  double velocity;
  double end_ms;  ///< with changes at 500 ms
  double probe_ms;
  double probe_position;
  double probe_velocity;
};

class TrapOnTheFly : public testing::TestWithParam<Fly> {};

TEST_P(TrapOnTheFly, Example71At500Ms) {
  const Fly& fly = GetParam();
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, 50);
  run.At(500);
  run.MoveTo(fly.target, fly.velocity);
  ConstraintChecker checker({.velocity = std::max(50.0, fly.velocity), .acceleration = 0.25}, 0.25,
                            run.profile.now);
  while (run.profile.now.moving) {
    ASSERT_TRUE(checker.Next(run.Tick()));
    if (run.now == static_cast<Micros>(fly.probe_ms * 1000)) {
      EXPECT_NEAR(run.profile.now.position, fly.probe_position, 1e-6);
      EXPECT_NEAR(run.profile.now.velocity, fly.probe_velocity, 1e-6);
    }
  }
  EXPECT_NEAR(run.now_ms(), fly.end_ms, 0.25);
  EXPECT_EQ(run.profile.now, AtRest(fly.target));
}

INSTANTIATE_TEST_SUITE_P(
    Changes, TrapOnTheFly,
    testing::Values(Fly{"extend", 80000, 50, 1900, 1700, 77500, 25},
                    Fly{"shorten", 35000, 50, 1000, 800, 32500, 25},
                    // 200 ms down to 25, 800 ms, 200 ms.
                    Fly{"slower", 50000, 25, 1700, 600, 24375, 37.5},
                    // 100 ms up to 75, 16.67 ms, 600 ms.
                    Fly{"faster", 50000, 75, 1216.6667, 600, 26250, 75},
                    // Stops at 30000 at 900 ms, then 200, 300, 400 ms back to 0.
                    Fly{"reverse", 0, 50, 1800, 1100, 25000, -50}),
    [](const auto& tested) { return tested.param.name; });

TEST(Trap, AVelocityOfZeroOnTheFlyStopsTheMove) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, 50);
  run.At(500);
  run.MoveTo(50000, 0);
  EXPECT_TRUE(run.At(899.75).moving);
  EXPECT_EQ(run.At(900), AtRest(30000));
  run.MoveTo(50000, 50);
  while (run.Tick().moving) {
  }
  EXPECT_EQ(run.profile.now, AtRest(50000));
}

// --- Everything --------------------------------------------------------------------------------

struct Change {
  Micros at = 0;
  int32_t target = 0;
  double velocity = 0;
};

struct Scene {
  TrapParameters parameters;
  std::vector<Change> changes;
};

Scene RandomScene(unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Scene scene;
  scene.parameters = {draw(0.05, 3), draw(0.05, 3), seed % 4 == 0 ? draw(0, 5) : 0,
                      static_cast<int16_t>(seed % 3 == 0 ? 0 : draw(0, 51))};
  Micros at = 0;
  for (int i = 0; i < 6; ++i) {
    scene.changes.push_back({at, static_cast<int32_t>(draw(-8000, 8000)), draw(0.5, 60)});
    at += 2000 * static_cast<Micros>(draw(0, 120));
  }
  return scene;
}

MotionBounds BoundsOf(const Scene& scene) {
  const TrapParameters& parameters = scene.parameters;
  MotionBounds bounds = {.acceleration = std::max(parameters.acc, parameters.dec)};
  for (const Change& change : scene.changes) {
    bounds.velocity = std::max(bounds.velocity, change.velocity);
  }
  // A jump to the start velocity becomes a ramp of the smoothing time; two ramps can overlap.
  if (parameters.smooth_time > 0) {
    bounds.acceleration += 2 * parameters.vel_start / parameters.smooth_time;
  } else {
    bounds.velocity_step = parameters.vel_start;
  }
  return bounds;
}

/// Runs a scene to its end; returns the samples at every 2 ms.
std::vector<Sample> Play(const Scene& scene, Micros cycle_us) {
  ProfileRun run(cycle_us);
  run.SetTrap(scene.parameters);
  ConstraintChecker checker(BoundsOf(scene), run.cycle_ms(), AtRest(0));
  std::vector<Sample> shared;
  size_t next = 0;
  while (next < scene.changes.size() || run.profile.now.moving) {
    while (next < scene.changes.size() && scene.changes[next].at <= run.now) {
      run.MoveTo(scene.changes[next].target, scene.changes[next].velocity);
      ++next;
    }
    const testing::AssertionResult ok = checker.Next(run.Tick());
    EXPECT_TRUE(ok) << "at " << run.now;
    if (!ok || run.now > 20'000'000) break;
    if (run.now % 2000 == 0) shared.push_back(run.profile.now);
  }
  EXPECT_EQ(run.profile.now, AtRest(scene.changes.back().target));
  return shared;
}

TEST(Trap, RandomChangesStayWithinTheirBoundsAndEndAtTheTarget) {
  for (unsigned seed = 1; seed <= 3000 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Play(RandomScene(seed), 1000);
  }
}

TEST(Trap, TheMotionDoesNotDependOnTheCycle) {
  for (unsigned seed = 1; seed <= 60 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = RandomScene(seed);
    const std::vector<Sample> expected = Play(scene, 2000);
    for (const Micros cycle_us : {125, 250, 500, 1000}) {
      SCOPED_TRACE(std::to_string(cycle_us) + " us");
      std::vector<Sample> samples = Play(scene, cycle_us);
      // The end is detected within the last 2 ms.
      ASSERT_GE(samples.size() + 1, expected.size());
      samples.resize(expected.size(), expected.back());
      EXPECT_EQ(samples, expected);
    }
  }
}

}  // namespace
}  // namespace oncard::motion
