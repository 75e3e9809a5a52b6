// Cycles as lanes compute the bits of as many ticks: on random cards with random commands, and in
// the cases that end a block.
#include "motion/cycle_block.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "motion/motion_core.h"
#include "tests/motion/random_world.h"

namespace oncard::motion {
namespace {

/// A number from the environment, so that the comparison can be run for longer than in the tests.
int Setting(const char* name, int normal) {
  const char* text = std::getenv(name);
  return text == nullptr ? normal : std::atoi(text);
}

/// Two cards that are given the same commands, one of them advanced by ticks.
class Twins {
 public:
  explicit Twins(uint64_t seed) : Twins(RandomCard(seed), RandomCard(seed)) {}
  Twins(std::unique_ptr<MotionCore> ticks, std::unique_ptr<MotionCore> lanes)
      : ticks_(std::move(ticks)), lanes_(std::move(lanes)) {
    ticks_->Observe(
        [this](const Happening& happening) { happened_[0] += Text(happening, *ticks_); });
    lanes_->Observe(
        [this](const Happening& happening) { happened_[1] += Text(happening, *lanes_); });
  }

  MotionCore& ticks() { return *ticks_; }
  MotionCore& lanes() { return *lanes_; }
  const std::string& happened() const { return happened_[1]; }
  template <typename Change>
  void Both(Change change) {
    change(*ticks_);
    change(*lanes_);
  }
  void Advance(int64_t cycles) {
    for (int64_t i = 0; i < cycles; ++i) ticks_->Tick();
    for (int64_t done = 0; done < cycles;) {
      done += lanes_->Advance(cycles - done);
      lanes_->state().reached.clear();
    }
  }
  void ExpectEqual() {
    EXPECT_EQ(ticks_->Hash(), lanes_->Hash());
    EXPECT_EQ(happened_[0], happened_[1]);
  }

 private:
  static std::string Text(const Happening& happening, const MotionCore& core) {
    return std::to_string(core.state().cycle) + ":" +
           std::to_string(static_cast<int>(happening.kind)) + "/" + std::to_string(happening.item) +
           "=" + std::to_string(happening.value) + " ";
  }

  std::unique_ptr<MotionCore> ticks_;
  std::unique_ptr<MotionCore> lanes_;
  std::array<std::string, 2> happened_;
};

/// A kernel that counts the cycles that lanes have advanced.
int64_t cycles_in_lanes = 0;
LaneKernel counted_kernel = nullptr;
int64_t CountCycles(const LaneConstants& constants, LaneStates& states, int64_t cycles) {
  const int64_t done = counted_kernel(constants, states, cycles);
  cycles_in_lanes += done;
  return done;
}

TEST(CycleBlock, AdvancesRandomCardsAsTicksDo) {
  const int worlds = Setting("ONCARD_WORLDS", 60);
  const int cycles = Setting("ONCARD_WORLD_CYCLES", 6000);
  const int first = Setting("ONCARD_WORLD_FIRST", 1);
  const std::span<const NamedLaneKernel> kernels = LaneKernels();
  for (int world = first; world < first + worlds; ++world) {
    SCOPED_TRACE("world " + std::to_string(world));
    const auto seed = static_cast<uint64_t>(world);
    Twins twins(seed);
    counted_kernel = kernels[seed % kernels.size()].run;
    twins.lanes().UseKernel(CountCycles);
    RandomNumbers random(~seed);
    for (int64_t cycle = 0; cycle < cycles && !testing::Test::HasFailure();) {
      const uint64_t commands = random.Next();
      for (int i = random.Below(4); i > 0; --i) {
        RandomNumbers choices(commands + static_cast<uint64_t>(i));
        RandomNumbers same = choices;
        RandomCommand(twins.ticks(), choices);
        RandomCommand(twins.lanes(), same);
      }
      const int64_t block = 1 + random.Below(random.OneIn(4) ? 1500 : 200);
      twins.Advance(block);
      cycle += block;
      twins.ExpectEqual();
    }
    if (testing::Test::HasFailure()) break;
  }
  // The rest are cards with something that lanes cannot do.
  const double share =
      static_cast<double>(cycles_in_lanes) / (static_cast<double>(worlds) * cycles);
  std::printf("%.0f %% of the cycles in lanes\n", 100 * share);
  EXPECT_GT(share, 0.15);
}

/// Twelve axes under servo control that jog.
std::unique_ptr<MotionCore> ServoCard() {
  auto core = std::make_unique<MotionCore>(MotionConfig{.axis_count = 12});
  for (size_t i = 0; i < core->axis_count(); ++i) {
    core->state().drives[i] = VelocityDrive(100, 2, 0, core->config().ServoMs());
    core->state().controls[i].sets[0] = {.kp = 20, .kvff = 300};
    core->SetClosedLoop(i, true);
    core->ServoOn(i);
    Profile& profile = core->state().profiles[i];
    profile.mode = ProfileMode::kJog;
    profile.jog.velocity = 10 + static_cast<double>(i);
    core->StartProfile(i);
  }
  return core;
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
  twins.Both([](MotionCore& core) { core.state().axes[3].soft_positive = 20'000; });
  twins.Advance(20'000);
  twins.ExpectEqual();
  EXPECT_NE(twins.lanes().state().axes[3].latched & kPositiveLimitBit, 0u);
  EXPECT_NE(twins.happened(), "");
}

TEST(CycleBlock, StopsAtASwitchThatTheMotorReaches) {
  Twins twins(ServoCard(), ServoCard());
  twins.Both([](MotionCore& core) {
    core.state().switches.push_back(
        {.axis = 2, .type = DiType::kLimitPositive, .bit = 2, .first = 10'000, .last = 1e9});
  });
  twins.Advance(20'000);
  twins.ExpectEqual();
  EXPECT_NE(twins.lanes().state().axes[2].latched & kPositiveLimitBit, 0u);
}

TEST(CycleBlock, StopsInTheCycleOfAFollowingError) {
  Twins twins(ServoCard(), ServoCard());
  twins.Both([](MotionCore& core) { core.state().controls[5].error_limit = 15; });
  twins.Advance(4000);
  twins.ExpectEqual();
  EXPECT_NE(twins.lanes().state().axes[5].latched & kFollowingErrorBit, 0u);
}

TEST(CycleBlock, FindsTheCycleOfTheInPositionCondition) {
  auto card = [] {
    auto core = ServoCard();
    for (size_t i = 0; i < core->axis_count(); ++i) {
      core->state().axes[i].band = 5;
      core->state().axes[i].band_time = 3000 + 250 * static_cast<Micros>(i);
      core->state().axes[i].band_set = true;
    }
    return core;
  };
  Twins twins(card(), card());
  twins.Advance(500);
  twins.Both([](MotionCore& core) {
    for (size_t i = 0; i < core.axis_count(); ++i) core.StopProfile(i, false);
  });
  for (int i = 0; i < 200; ++i) {
    twins.Advance(17);
    twins.ExpectEqual();
  }
  for (size_t i = 0; i < 12; ++i) EXPECT_TRUE(twins.lanes().state().axes[i].in_position) << i;
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
