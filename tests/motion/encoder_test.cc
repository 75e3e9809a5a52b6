// Encoders: source, sense, counting, and their faults.
#include "motion/encoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/core_run.h"

namespace oncard::motion {
namespace {

constexpr size_t kX = 0;

/// Axis 1, enabled; its profile jogs at 10 pulse/ms, which it reaches within one tick.
void StartJog(MotionCore& core, double velocity = 10) {
  core.AxisAt(kX).ServoOn();
  Profile& profile = ChangeState(core).profiles[kX];
  profile.mode = ProfileMode::kJog;
  profile.jog.velocity = velocity;
  profile.jog.parameters = {.acc = 1e6, .dec = 1e6};
  profile.Start(core.now());
}

double Position(const MotionCore& core) { return core.state().encoders[kX].position; }
double Planned(const MotionCore& core) { return core.state().profiles[kX].now.position; }

TEST(Encoder, CountsTheMotorWhenEnabledOnly) {
  MotionCore core({});
  StartJog(core);
  Ticks(core, 40);
  EXPECT_EQ(Position(core), std::round(Planned(core)));
  EXPECT_NEAR(Position(core), 100, 1);
  MotionCore off({});
  StartJog(off);
  ChangeState(off).axes[kX].servo_on = false;
  Ticks(off, 40);
  EXPECT_EQ(Position(off), 0);
  EXPECT_NEAR(Planned(off), 100, 1);
}

TEST(Encoder, AChangeOfSenseReversesTheCountAndKeepsThePosition) {
  MotionCore core({});
  StartJog(core);
  Ticks(core, 40);
  const double before = Position(core);
  core.EncoderAt(kX).SetSense(true);
  EXPECT_EQ(Position(core), before);
  Ticks(core, 1);
  EXPECT_NEAR(Position(core), before - 2.5, 1);
  EXPECT_NEAR(core.state().encoders[kX].velocity, -10, 2.1);
  Ticks(core, 39);
  EXPECT_NEAR(Position(core), before - 100, 1);
  core.EncoderAt(kX).SetSense(false);
  Ticks(core, 40);
  EXPECT_NEAR(Position(core), before, 1);
}

TEST(Encoder, AChangeOfSourceKeepsThePosition) {
  MotionCore core({});
  StartJog(core);
  ChangeState(core).axes[kX].servo_on = false;  // pulses are output, but the motor does not move
  Ticks(core, 40);
  EXPECT_EQ(Position(core), 0);
  core.EncoderAt(kX).SetExternal(false);
  EXPECT_EQ(Position(core), 0);
  Ticks(core, 40);
  EXPECT_NEAR(Position(core), 100, 1);
  core.EncoderAt(kX).SetExternal(true);
  const double counted = Position(core);
  Ticks(core, 40);
  EXPECT_EQ(Position(core), counted);
}

TEST(Encoder, AnInactiveOneCountsNothing) {
  MotionCore core({});
  StartJog(core);
  ChangeState(core).encoders[kX].active = false;
  Ticks(core, 40);
  EXPECT_EQ(Position(core), 0);
  EXPECT_EQ(core.state().encoders[kX].velocity, 0);
  ChangeState(core).encoders[kX].active = true;
  Ticks(core, 40);
  EXPECT_NEAR(Position(core), 100, 1);
}

TEST(EncoderFault, AHeldEncoderLosesWhatTheMotorDoes) {
  MotionCore core({});
  Happen(core, {{.at = 10'000, .kind = WorldEventKind::kEncoderHeld, .value = 1},
                {.at = 20'000, .kind = WorldEventKind::kEncoderHeld, .value = 0}});
  StartJog(core);
  Ticks(core, 40);
  const double before = Position(core);
  Ticks(core, 40);
  EXPECT_EQ(Position(core), before);
  EXPECT_EQ(core.state().encoders[kX].velocity, 0);
  Ticks(core, 40);
  EXPECT_NEAR(Position(core), before + 100, 1);
}

TEST(EncoderFault, DriftAddsUp) {
  MotionCore core({});
  Happen(core, {{.kind = WorldEventKind::kEncoderDrift, .value = -2.5},
                {.at = 100'000, .kind = WorldEventKind::kEncoderDrift, .value = 0}});
  Ticks(core, 800);
  EXPECT_EQ(Position(core), -250);
}

TEST(EncoderFault, NoiseStaysWithinItsBoundsAndEndsWithoutATrace) {
  const auto run = [](uint16_t seed) {
    MotionCore core({});
    Happen(core, {{.kind = WorldEventKind::kEncoderNoise, .index = seed, .value = 3},
                  {.at = 250'000, .kind = WorldEventKind::kEncoderNoise, .value = 0}});
    std::vector<double> readings;
    for (int i = 0; i < 1000; ++i) {
      core.Tick();
      readings.push_back(Position(core));
    }
    core.Tick();
    EXPECT_EQ(Position(core), 0);
    return readings;
  };
  const std::vector<double> readings = run(7);
  EXPECT_EQ(std::set<double>(readings.begin(), readings.end()),
            (std::set<double>{-3, -2, -1, 0, 1, 2, 3}));
  EXPECT_EQ(run(7), readings);
  EXPECT_NE(run(8), readings);
}

TEST(EncoderFault, TheNoiseIsSplitMix64) {
  // The first outputs of splitmix64 from state 0 are E220A8397B1DCDAF and 6E789E6AA1B965F4; their
  // upper halves as fractions of 2^32, 0.8833 and 0.4315, select from 5 values.
  EncoderFault fault;
  fault.noise = 2;
  EXPECT_EQ(fault.NextError(), 2);
  EXPECT_EQ(fault.NextError(), 0);
}

}  // namespace
}  // namespace oncard::motion
