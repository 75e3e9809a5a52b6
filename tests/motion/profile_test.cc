// Changes between modes: stops that follow a run, runs that follow a stop.
#include "motion/profiles/profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "tests/motion/constraint_checker.h"
#include "tests/motion/profile_run.h"

namespace oncard::motion {
namespace {

TEST(ProfileStop, ASmoothStopOfExample71Takes50MsAnd1250Pulses) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, 50);
  run.At(500);
  run.Stop(run.profile.smooth_stop);
  EXPECT_TRUE(run.profile.now.moving);
  EXPECT_EQ(run.At(525).position, 20937.5);
  EXPECT_EQ(run.At(525).velocity, 25);
  EXPECT_EQ(run.At(525).acceleration, -1);
  EXPECT_TRUE(run.At(549.75).moving);
  EXPECT_EQ(run.At(550), AtRest(21250));
}

TEST(ProfileStop, AnAbruptStopIsOverInTheNextCycle) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(-50000, 50);
  run.At(500);
  run.Stop(run.profile.abrupt_stop);
  EXPECT_EQ(run.Tick(), AtRest(-20001.25));
}

TEST(ProfileStop, WithAnInfiniteDecelerationItRestsInTheSameCycle) {
  for (const bool begun : {false, true}) {
    ProfileRun run;
    run.SetTrap();
    run.MoveTo(50000, 50);
    run.At(500);
    // Also during a softer stop, which is at 20000 + 450 pulses after 10 ms.
    if (begun) run.Stop(1);
    if (begun) run.At(510);
    const double position = begun ? 20450 : 20000;
    run.Stop(std::numeric_limits<double>::infinity());
    EXPECT_EQ(run.profile.now, AtRest(position));
    EXPECT_FALSE(run.profile.stopping);
    EXPECT_EQ(run.Tick(), AtRest(position));
    run.profile.Start(run.now);
    EXPECT_EQ(run.Tick().velocity, 0.0625) << "from rest";
  }
}

TEST(ProfileAtRest, GoesOnTheSameWithoutWhatIsLeftOfItsRuns) {
  for (const int16_t smooth : {int16_t{0}, int16_t{20}}) {
    ProfileRun run;
    run.SetTrap({.acc = 0.25, .dec = 0.125, .smooth_time = smooth});
    run.MoveTo(500, 5);
    run.At(100);
    run.Stop(1);
    run.At(500);
    run.MoveTo(900, 5);
    run.At(2000);
    ProfileRun forgetful = run;
    forgetful.profile.ForgetRuns();
    EXPECT_NE(forgetful.profile.trap.begin, run.profile.trap.begin);
    EXPECT_NE(forgetful.profile.stop_begin, run.profile.stop_begin);
    for (ProfileRun* each : {&run, &forgetful}) each->MoveTo(-300, 3);
    for (int tick = 0; tick < 2000; ++tick) {
      if (tick == 200) {
        run.Stop(0.5);
        forgetful.Stop(0.5);
      }
      if (tick == 800) {
        run.MoveTo(100, 7);
        forgetful.MoveTo(100, 7);
      }
      ASSERT_EQ(run.Tick(), forgetful.Tick()) << tick;
    }
  }
}

TEST(ProfileAtRest, ForgetsNothingWhileItMoves) {
  ProfileRun run;
  run.SetTrap({.acc = 0.25, .dec = 0.125, .smooth_time = 20});
  run.MoveTo(50000, 50);
  run.At(100);
  for (const bool stops : {false, true}) {
    if (stops) run.Stop(1);
    ProfileRun forgetful = run;
    forgetful.profile.ForgetRuns();
    for (int tick = 0; tick < 100; ++tick) ASSERT_EQ(run.Tick(), forgetful.Tick()) << tick;
  }
}

TEST(ProfileStop, BeginsAtTheVelocityThatCameOut) {
  // After 100 ms the plan's velocity is 25; that of the smoothed output is 21.875.
  ProfileRun run;
  run.SetTrap({.acc = 0.25, .dec = 0.125, .smooth_time = 25});
  run.MoveTo(50000, 50);
  const Sample before = run.At(100);
  run.Stop(1);
  EXPECT_EQ(run.At(110).velocity, before.velocity - 10);
  EXPECT_EQ(run.At(130), AtRest(before.position + before.velocity * before.velocity / 2));
}

TEST(ProfileStop, AFasterStopReplacesASlowerOneButNotTheOtherWay) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, 50);
  run.At(500);
  run.Stop(1);
  run.At(510);
  run.Stop(4);
  run.At(515);
  EXPECT_EQ(run.profile.now.velocity, 20);
  run.Stop(1);
  run.Stop(4);
  EXPECT_EQ(run.At(520), AtRest(20000 + 450 + 200));
}

TEST(ProfileStop, AtRestItIsNothing) {
  ProfileRun run;
  run.SetTrap();
  run.Stop(1);
  EXPECT_EQ(run.Tick(), AtRest(0));
  EXPECT_FALSE(run.profile.stopping);
}

TEST(ProfileStop, BeforeTheFirstCycleNothingMoves) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, 50);
  run.Stop(1);
  EXPECT_EQ(run.profile.now, AtRest(0));
  EXPECT_EQ(run.Tick(), AtRest(0));
}

TEST(ProfileStop, ATrapMotionKeepsItsTarget) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, 50);
  run.At(500);
  run.Stop(1);
  run.At(600);
  run.profile.Start(run.now);
  // 28750 remain: 200 + 275 + 400 ms.
  EXPECT_TRUE(run.At(1474.75).moving);
  EXPECT_EQ(run.At(1475), AtRest(50000));
}

TEST(ProfileStop, AnUpdateDuringTheStopGoesOnFromTheVelocityThatIsThere) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(50000, 50);
  run.At(500);
  run.Stop(1);
  run.At(520);
  EXPECT_EQ(run.profile.now.velocity, 30);
  run.profile.Start(run.now);
  EXPECT_EQ(run.At(540).velocity, 35);
  while (run.Tick().moving) {
  }
  EXPECT_EQ(run.profile.now, AtRest(50000));
}

TEST(ProfileStop, AJogStopsAndGoesOn) {
  for (const double smooth : {0.0, 0.8}) {
    ProfileRun run;
    run.SetJog({.acc = 1, .dec = 1, .smooth = smooth});
    run.JogAt(-10);
    run.At(100);
    const double velocity = run.profile.now.velocity;
    run.Stop(0.5);
    EXPECT_NEAR(run.At(110).velocity, velocity + 5, 1e-9) << smooth;
    EXPECT_FALSE(run.At(130).moving) << smooth;
    run.JogAt(5);
    EXPECT_NEAR(run.At(250).velocity, 5, 1e-6) << smooth;
  }
}

TEST(Profile, ModesKeepTheirRegisters) {
  ProfileRun run;
  run.SetTrap();
  run.MoveTo(1000, 10);
  while (run.Tick().moving) {
  }
  run.SetJog({.acc = 1, .dec = 1});
  run.JogAt(-10);
  run.At(1000);
  run.Stop(1);
  run.At(1100);
  run.profile.mode = ProfileMode::kTrap;
  run.profile.Start(run.now);
  while (run.Tick().moving) {
  }
  EXPECT_EQ(run.profile.now, AtRest(1000));
}

TEST(Profile, ASetPositionIsWhereTheNextMoveBegins) {
  ProfileRun run;
  run.SetTrap();
  run.profile.SetPosition(49000);
  run.MoveTo(50000, 50);
  EXPECT_EQ(run.Tick().position, 49000 + 0.125 * 0.0625);
  EXPECT_EQ(run.At(155), AtRest(50000));
}

// --- Everything --------------------------------------------------------------------------------

/// Random starts, changes, stops and modes, checked in every cycle.
void Play(unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto one_of = [&](int count) { return static_cast<int>(draw(0, count)); };
  ProfileRun run(1000);
  run.SetTrap({.acc = 1, .dec = 1});
  ConstraintChecker checker({}, run.cycle_ms(), AtRest(0));
  MotionBounds bounds;
  for (int command = 0; command < 12; ++command) {
    Profile& profile = run.profile;
    if (!profile.now.moving) {
      // At rest everything may change, and new limits apply.
      const double acc = draw(0.05, 3);
      const double dec = draw(0.05, 3);
      if (one_of(2) == 0) {
        run.SetTrap({acc, dec, 0, static_cast<int16_t>(one_of(2) == 0 ? 0 : draw(0, 51))});
      } else {
        run.SetJog({acc, dec, one_of(2) == 0 ? 0 : draw(0, 0.95)});
      }
      bounds = {.velocity = 1, .acceleration = std::max(acc, dec)};
    }
    const double velocity = draw(-40, 40);
    if (one_of(3) == 0) {
      const double deceleration = draw(0.2, 30);
      bounds.acceleration = std::max(bounds.acceleration, deceleration);
      run.Stop(deceleration);
    } else if (profile.mode == ProfileMode::kTrap) {
      run.MoveTo(static_cast<int32_t>(draw(-5000, 5000)), velocity);
    } else {
      run.JogAt(velocity);
    }
    bounds.velocity = std::max(bounds.velocity, std::fabs(velocity));
    checker.SetBoundsSmoothed(bounds);
    for (int cycles = one_of(150); cycles > 0; --cycles) {
      ASSERT_TRUE(checker.Next(run.Tick())) << "at " << run.now_ms() << " ms";
    }
  }
}

TEST(Profile, RandomCommandsStayWithinTheirBounds) {
  for (unsigned seed = 1; seed <= 3000 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Play(seed);
  }
}

}  // namespace
}  // namespace oncard::motion
