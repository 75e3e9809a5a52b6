// Cycles as lanes compute the bits of as many ticks: on random cards with random commands, and in
// the cases that end a block.
#include "motion/cycle_block.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>

#include "motion/motion_core.h"
#include "tests/base/random_cases.h"
#include "tests/motion/change_state.h"
#include "tests/motion/cycle_counter.h"
#include "tests/motion/random_bus.h"
#include "tests/motion/random_world.h"
#include "tests/motion/twins.h"

namespace oncard::motion {
namespace {

/// Random cards, and what hosts do to them.
struct World {
  std::unique_ptr<MotionCore> (*card)(uint64_t seed);
  void (*command)(MotionCore& core, RandomNumbers& random);
  int most_commands;   ///< between two blocks
  double least_share;  ///< of the cycles in lanes; the rest are cards with something else to do
};

void AdvanceAsTicksDo(const World& kind, int worlds, int cycles) {
  worlds = Setting("ONCARD_WORLDS", RandomCases(worlds));
  cycles = Setting("ONCARD_WORLD_CYCLES", cycles);
  const int first = Setting("ONCARD_WORLD_FIRST", 1);
  const std::span<const NamedLaneKernel> kernels = LaneKernels();
  CycleCounter counter;
  for (int world = first; world < first + worlds; ++world) {
    SCOPED_TRACE("world " + std::to_string(world));
    const auto seed = static_cast<uint64_t>(world);
    Twins twins(kind.card(seed), kind.card(seed));
    counter.Count(twins.lanes(), kernels[seed % kernels.size()].run);
    RandomNumbers random(~seed);
    for (int64_t cycle = 0; cycle < cycles && !testing::Test::HasFailure();) {
      const uint64_t commands = random.Next();
      for (int i = random.Below(kind.most_commands + 1); i > 0; --i) {
        RandomNumbers choices(commands + static_cast<uint64_t>(i));
        RandomNumbers same = choices;
        kind.command(twins.ticks(), choices);
        kind.command(twins.lanes(), same);
      }
      const int64_t block = 1 + random.Below(random.OneIn(4) ? 1500 : 200);
      twins.Advance(block);
      cycle += block;
      twins.ExpectEqual();
    }
    if (testing::Test::HasFailure()) break;
  }
  const double share =
      static_cast<double>(counter.cycles()) / (static_cast<double>(worlds) * cycles);
  std::printf("%.0f %% of the cycles in lanes\n", 100 * share);
  EXPECT_GE(share, kind.least_share);
}

TEST(CycleBlock, AdvancesRandomCardsAsTicksDo) {
  AdvanceAsTicksDo({RandomCard, RandomCommand, 3, 0.15}, 60, 6000);
}

TEST(CycleBlock, AdvancesRandomCardsWithABusAsTicksDo) {
  AdvanceAsTicksDo({RandomBusCard, RandomBusCommand, 3, 0.2}, 60, 3000);
}

TEST(CycleBlock, EveryKernelComputesTheSameBits) {
  for (const NamedLaneKernel& kernel : LaneKernels()) {
    SCOPED_TRACE(kernel.name);
    Twins twins(ServoCard(), ServoCard());
    twins.lanes().UseKernel(kernel.run);
    twins.Advance(20'000);
    twins.ExpectEqual();
    EXPECT_GT(twins.lanes().state().encoders[11].position, 100'000);
  }
}

TEST(CycleBlock, StopsInTheCycleOfASoftLimit) {
  Twins twins(ServoCard(), ServoCard());
  twins.Both([](MotionCore& core) { ChangeState(core).axes[3].soft_positive = 20'000; });
  twins.Advance(20'000);
  twins.ExpectEqual();
  EXPECT_NE(twins.lanes().state().axes[3].latched & kPositiveLimitBit, 0u);
  EXPECT_NE(twins.happened(), "");
}

TEST(CycleBlock, StopsAtASwitchThatTheMotorReaches) {
  Twins twins(ServoCard(), ServoCard());
  twins.Both([](MotionCore& core) {
    core.AddSwitch(
        {.axis = 2, .type = DiType::kLimitPositive, .bit = 2, .first = 10'000, .last = 1e9});
  });
  twins.Advance(20'000);
  twins.ExpectEqual();
  EXPECT_NE(twins.lanes().state().axes[2].latched & kPositiveLimitBit, 0u);
}

TEST(CycleBlock, StopsInTheCycleOfAFollowingError) {
  Twins twins(ServoCard(), ServoCard());
  twins.Both([](MotionCore& core) { core.ControlAt(5).SetErrorLimit(15); });
  twins.Advance(4000);
  twins.ExpectEqual();
  EXPECT_NE(twins.lanes().state().axes[5].latched & kFollowingErrorBit, 0u);
}

TEST(CycleBlock, FindsTheCycleOfTheInPositionCondition) {
  auto card = [] {
    auto core = ServoCard();
    for (size_t i = 0; i < core->axis_count(); ++i) {
      ChangeState(*core).axes[i].band = 5;
      ChangeState(*core).axes[i].band_time = 3000 + 250 * static_cast<Micros>(i);
      ChangeState(*core).axes[i].band_set = true;
    }
    return core;
  };
  Twins twins(card(), card());
  twins.Advance(500);
  twins.Both([](MotionCore& core) {
    for (size_t i = 0; i < core.axis_count(); ++i) core.ProfileAt(i).Stop(false);
  });
  for (int i = 0; i < 200; ++i) {
    twins.Advance(17);
    twins.ExpectEqual();
  }
  for (size_t i = 0; i < 12; ++i) EXPECT_TRUE(twins.lanes().state().axes[i].in_position) << i;
}

/// The same tests of cards with a bus, with ideal and with velocity drives.
class BusCycleBlock : public testing::TestWithParam<DriveKind> {};

INSTANTIATE_TEST_SUITE_P(Drives, BusCycleBlock,
                         testing::Values(DriveKind::kIdeal, DriveKind::kVelocity));

TEST_P(BusCycleBlock, EveryKernelComputesTheSameBits) {
  for (const NamedLaneKernel& kernel : LaneKernels()) {
    SCOPED_TRACE(kernel.name);
    Twins twins(JoggingBusCard(GetParam()), JoggingBusCard(GetParam()));
    CycleCounter counter;
    counter.Count(twins.lanes(), kernel.run);
    twins.Advance(20'000);
    twins.ExpectEqual();
    EXPECT_GT(twins.lanes().state().encoders[11].position, 100'000);
    EXPECT_GT(counter.cycles(), 19'900);
  }
}

void ExpectEdgeOfAProbe(DriveKind kind, Micros at, bool rests) {
  const auto card = [&] {
    auto core = JoggingBusCard(kind, {{at, WorldEventKind::kBusProbe, 3, 0, 1}});
    core->bus_line()->SetOutput(3, bus::ObjectId::kProbeFunction, 0x11);
    for (size_t i = 0; i < core->axis_count() && rests; ++i) core->ProfileAt(i).Stop(true);
    return core;
  };
  Twins twins(card(), card());
  // Of a card at rest the first block has shown all.
  for (const int64_t block : {50, 150, 400, 800}) {
    twins.Advance(block);
    twins.ExpectEqual();
  }
  const MotionCore& lanes = twins.lanes();
  const bus::ObjectValues& values = lanes.state().bus->line.slave(3).drive->values();
  EXPECT_NE(values[bus::ObjectId::kProbe1Rising], 0);
}

TEST_P(BusCycleBlock, StopsInTheCycleOfAnEdgeOfAProbe) {
  // Before, at and after the end of a cycle, and in the first one of a block.
  for (const Micros at : {299'999, 300'000, 300'001, 327'001}) {
    SCOPED_TRACE(at);
    ExpectEdgeOfAProbe(GetParam(), at, false);
    ExpectEdgeOfAProbe(GetParam(), at, true);
  }
}

TEST_P(BusCycleBlock, StopsAtASoftwareLimitOfTheDrive) {
  Twins twins(JoggingBusCard(GetParam()), JoggingBusCard(GetParam()));
  twins.Both([](MotionCore& core) {
    bus::ObjectValues& values = ChangeState(core).bus->line.slave(4).drive->values();
    values.Set(bus::ObjectId::kSoftLimitMin, -9000);
    values.Set(bus::ObjectId::kSoftLimitMax, 9000);
  });
  twins.Advance(20'000);
  twins.ExpectEqual();
  EXPECT_NEAR(twins.lanes().state().plants[4].position, 9000, 1e-6);
}

TEST(CycleBlock, StopsWhenTheErrorWindowOfADriveIsLeft) {
  Twins twins(JoggingBusCard(DriveKind::kVelocity), JoggingBusCard(DriveKind::kVelocity));
  // The drive has the lag's error while the velocity changes: 2 ms behind 200 pulse/ms at the most.
  twins.Both([](MotionCore& core) {
    bus::ObjectValues& values = ChangeState(core).bus->line.slave(5).drive->values();
    values.Set(bus::ObjectId::kErrorWindow, 25);
    core.ProfileAt(5).SetVelocity(200);
    core.ProfileAt(5).SetParameters(JogParameters{.acc = 0.5, .dec = 0.5});
    core.ProfileAt(5).Start();
  });
  twins.Advance(4000);
  twins.ExpectEqual();
  EXPECT_EQ(twins.lanes().state().bus->line.slave(5).drive->state(), bus::DriveState::kFault);
  EXPECT_NE(twins.lanes().state().axes[5].latched & kAlarmBit, 0u);
}

TEST(CycleBlock, KeepsTheSetPointOfADriveWhoseMotorFrictionHolds) {
  Twins twins(JoggingBusCard(DriveKind::kVelocity), JoggingBusCard(DriveKind::kVelocity));
  twins.Both([](MotionCore& core) {
    for (size_t i = 0; i < core.axis_count(); ++i) {
      core.ProfileAt(i).Stop(true);
      ChangeState(core).drives[i] = VelocityDrive(100, 0, 20, core.config().ServoMs());
    }
  });
  twins.Advance(1000);
  twins.Both([](MotionCore& core) { ChangeState(core).bus->axes[7].lead += 1; });
  twins.Advance(100);
  twins.ExpectEqual();
  const MotionCore& lanes = twins.lanes();
  EXPECT_EQ(lanes.state().plants[7].velocity, 0);
  EXPECT_EQ(lanes.state().bus->line.slave(7).drive->ramp().velocity, 0);
}

TEST(CycleBlock, AQuietCardOnlyCountsCycles) {
  MotionCore core({.axis_count = 12});
  MotionCore ticked({.axis_count = 12});
  core.Advance(5000);
  for (int i = 0; i < 5000; ++i) ticked.Tick();
  EXPECT_EQ(core.Hash(), ticked.Hash());
  // A thousand days: only possible if nothing is done in each of them.
  EXPECT_EQ(core.Advance(345'600'000'000), 345'600'000'000);
  EXPECT_EQ(core.state().cycle, 345'600'005'000);
}

}  // namespace
}  // namespace oncard::motion
