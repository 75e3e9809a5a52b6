// The mode HandWheel of a profile: moves whose target follows a master.
#include "motion/profiles/wheel_mode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "motion/common/state_hash.h"
#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/constraint_checker.h"
#include "tests/motion/core_run.h"

namespace oncard::motion {
namespace {

constexpr double kWheelCycle = 0.25;

/// A wheel beside a profile at `position`, turned by hand.
class Wheel {
 public:
  explicit Wheel(double ratio, const MoveLimits& limits, double position = 0)
      : now_(AtRest(position)) {
    mode_.master.chosen = true;
    mode_.ratio = ratio;
    mode_.limits = limits;
    mode_.cycle = kWheelCycle;
    mode_.Start(now_, {counts_, 0, 0});
  }

  const Sample& Turn(double counts) {
    counts_ += counts;
    now_ = mode_.At(now_, {counts_, counts / kWheelCycle, 0});
    return now_;
  }
  const Sample& Wait(int cycles) {
    for (int i = 0; i < cycles; ++i) Turn(0);
    return now_;
  }

 private:
  WheelMode mode_;
  Sample now_;
  double counts_ = 500;
};

constexpr MoveLimits kLimits = {
    .velocity = 20, .acceleration = 0.5, .deceleration = 0.5, .start_velocity = 0};

void ExpectRestsAt(const Sample& sample, double position) {
  EXPECT_EQ(sample, (Sample{position, 0, 0, true}));
}

TEST(HandWheel, ATurnIsAMoveToWhereTheWheelPoints) {
  // 1000 counts to 2500 pulses: 40 ms over 400 up and down, 1700 / 20 = 85 ms between them.
  Wheel wheel(2.5, kLimits, 7);
  wheel.Turn(1000);
  Sample sample = wheel.Wait(4 * 40 - 1);
  EXPECT_NEAR(sample.position, 407, 1e-9);
  EXPECT_NEAR(sample.velocity, 20, 1e-9);
  sample = wheel.Wait(4 * 85);
  EXPECT_NEAR(sample.position, 2107, 1e-9);
  sample = wheel.Wait(4 * 40 - 1);
  EXPECT_NEAR(sample.velocity, 0.125, 1e-9);
  ExpectRestsAt(wheel.Wait(1), 2507);
  ExpectRestsAt(wheel.Wait(100), 2507);
}

TEST(HandWheel, FollowsAWheelThatIsTurnedSlowly) {
  // 1 count every 2 ms at a ratio of -2 is 1 pulse/ms; each step of 2 takes 2 sqrt(2 / 0.5) = 4 ms.
  Wheel wheel(-2, kLimits);
  for (int i = 0; i < 1000; ++i) {
    wheel.Turn(1);
    const Sample& sample = wheel.Wait(7);
    EXPECT_NEAR(sample.position, -2 * (i + 1), 8) << i;
  }
  ExpectRestsAt(wheel.Wait(40), -2000);
}

TEST(HandWheel, CatchesUpWithAWheelThatIsTurnedTooFast) {
  // 100 counts in 25 ms, 4 pulse/ms, at a ratio of 10: 1000 pulses at 20 pulse/ms take 90 ms.
  Wheel wheel(10, kLimits);
  for (int i = 0; i < 100; ++i) {
    EXPECT_LE(wheel.Turn(1).velocity, 20) << i;
  }
  EXPECT_NE(wheel.Wait(4 * 64).velocity, 0);
  ExpectRestsAt(wheel.Wait(4 * 5), 1000);
}

TEST(HandWheel, TurnedBackItReturns) {
  Wheel wheel(1, kLimits);
  wheel.Turn(1000);
  wheel.Wait(4 * 40 - 1);
  // At 400 pulses and 20 pulse/ms: 40 ms to rest at 800.
  wheel.Turn(-700);
  const Sample& turning = wheel.Wait(4 * 40 - 1);
  EXPECT_NEAR(turning.position, 800, 1e-9);
  EXPECT_NEAR(turning.velocity, 0, 1e-9);
  ExpectRestsAt(wheel.Wait(4 * 70), 300);
}

TEST(HandWheel, BeginsAndEndsAtTheStartVelocity) {
  MoveLimits limits = kLimits;
  limits.start_velocity = 2;
  Wheel wheel(1, limits);
  EXPECT_NEAR(wheel.Turn(1000).velocity, 2.125, 1e-9);
  // 36 ms over 396 up and down, 208 / 20 = 10.4 ms between them: 82.4 ms.
  EXPECT_NEAR(wheel.Wait(4 * 82).velocity, 2 + 0.5 * 0.15, 1e-6);
  ExpectRestsAt(wheel.Wait(1), 1000);
}

TEST(HandWheel, WithoutAVelocityNothingMoves) {
  Wheel wheel(1, {.velocity = 0, .acceleration = 1, .deceleration = 1, .start_velocity = 0});
  wheel.Turn(1000);
  ExpectRestsAt(wheel.Wait(100), 0);
}

TEST(HandWheel, RandomTurnsStayWithinTheLimitsAndEndExactly) {
  for (unsigned seed = 1; seed <= 300 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double acceleration = draw(0.05, 3);
    const MoveLimits limits = {draw(1, 50), acceleration, acceleration, 0};
    const double ratio = std::round(draw(-40, 40)) / 8;
    Wheel wheel(ratio, limits);
    ConstraintChecker checker({.velocity = limits.velocity, .acceleration = acceleration},
                              kWheelCycle, AtRest(0));
    double counts = 0;
    for (int turn = 0; turn < 20; ++turn) {
      const double each = std::round(draw(-6, 6));
      for (int cycle = static_cast<int>(draw(1, 200)); cycle > 0; --cycle) {
        counts += each;
        ASSERT_TRUE(checker.Next(wheel.Turn(each)));
      }
    }
    Sample sample = wheel.Turn(0);
    while (sample.velocity != 0 || std::fabs(sample.position - ratio * counts) > 0.5) {
      ASSERT_TRUE(checker.Next(sample));
      sample = wheel.Turn(0);
    }
    ExpectRestsAt(sample, ratio * counts);
  }
}

TEST(HandWheel, OnACardTheAuxiliaryEncoderTurnsAnAxisUntilItIsStopped) {
  constexpr size_t kWheelEncoder = kAuxiliaryFirst;
  MotionCore core({});
  // 5 pulse/ms from 10 to 110 ms.
  Happen(core, {{10'000, WorldEventKind::kHand, kWheelEncoder, 0, 5},
                {110'000, WorldEventKind::kHand, kWheelEncoder, 0, 0}});
  Profile& profile = ChangeState(core).profiles[1];
  profile.mode = ProfileMode::kWheel;
  profile.wheel.master = {true, MasterType::kEncoder, kWheelEncoder, false};
  profile.wheel.ratio = -3;
  profile.wheel.limits = kLimits;
  profile.wheel.cycle = kWheelCycle;
  core.ProfileAt(1).Start();
  Ticks(core, 4 * 60);
  EXPECT_LT(core.profile(1).now.position, 0);
  Ticks(core, 4 * 100);
  const double counted = core.encoder(kWheelEncoder).position;
  EXPECT_NEAR(counted, 500, 1.5);
  ExpectRestsAt(core.profile(1).now, -3 * counted);
  core.EncoderAt(kWheelEncoder).SetPosition(0);
  Ticks(core, 10);
  ExpectRestsAt(core.profile(1).now, -3 * counted);
  core.ProfileAt(1).Stop(true);
  EXPECT_EQ(core.profile(1).now, AtRest(-3 * counted));
}

TEST(HandWheel, IsNotInTheHashOfACardWithoutOne) {
  EXPECT_EQ(StateHash().Add(WheelMode{}).value(), StateHash().value());
  WheelMode chosen;
  chosen.master.chosen = true;
  EXPECT_NE(StateHash().Add(chosen).value(), StateHash().value());
}

}  // namespace
}  // namespace oncard::motion
