// Lanes stay loaded from one call to the next, and nobody can see it: what a card shows after each
// of random short ways, reads, starts and commands is what one advanced by ticks shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "motion/common/state_hash.h"
#include "motion/cycle_block.h"
#include "motion/motion_core.h"
#include "tests/base/random_cases.h"
#include "tests/motion/change_state.h"
#include "tests/motion/cycle_counter.h"
#include "tests/motion/random_bus.h"
#include "tests/motion/random_world.h"
#include "tests/motion/twins.h"

namespace oncard::motion {
namespace {

void ExpectSameBits(double a, double b) {
  EXPECT_EQ(std::bit_cast<uint64_t>(a), std::bit_cast<uint64_t>(b)) << a << ", " << b;
}

void ExpectSameSample(const motion::Sample& a, const motion::Sample& b) {
  ExpectSameBits(a.position, b.position);
  ExpectSameBits(a.velocity, b.velocity);
  ExpectSameBits(a.acceleration, b.acceleration);
  EXPECT_EQ(a.moving, b.moving);
}

void ExpectSameValue(const AxisValue& a, const AxisValue& b) {
  ExpectSameBits(a.position, b.position);
  ExpectSameBits(a.velocity, b.velocity);
  ExpectSameBits(a.acceleration, b.acceleration);
}

std::vector<uint64_t> WordsOf(const auto& state) {
  StateWords words;
  words.Add(state);
  return {words.words().begin(), words.words().end()};
}

void ExpectSameBus(const MotionCore& ticks, const MotionCore& lanes) {
  if (!ticks.state().bus) return;
  const bus::Bus& a = ticks.state().bus->line;
  const bus::Bus& b = lanes.state().bus->line;
  EXPECT_TRUE(std::ranges::equal(a.image().bytes(), b.image().bytes()));
  for (size_t i = 0; i < a.slave_count(); ++i) {
    if (!a.slave(i).drive) continue;
    EXPECT_EQ(WordsOf(a.slave(i).drive->values()), WordsOf(b.slave(i).drive->values())) << i;
  }
}

/// Reads something of an axis as a command would.
void ExpectSameRead(const MotionCore& ticks, const MotionCore& lanes, size_t axis, int what) {
  switch (what) {
    case 0:
      return ExpectSameSample(ticks.profile(axis).now, lanes.profile(axis).now);
    case 1:
      ExpectSameValue(ticks.axis(axis).profile, lanes.axis(axis).profile);
      return ExpectSameValue(ticks.axis(axis).encoder, lanes.axis(axis).encoder);
    case 2:
      ExpectSameBits(ticks.encoder(axis).position, lanes.encoder(axis).position);
      return ExpectSameBits(ticks.encoder(axis).velocity, lanes.encoder(axis).velocity);
    case 3:
      EXPECT_EQ(ticks.Conditions(axis), lanes.Conditions(axis));
      return ExpectSameBits(ticks.CountedPosition(axis), lanes.CountedPosition(axis));
    case 4:
      EXPECT_EQ(ticks.FollowingErrorExceeded(axis), lanes.FollowingErrorExceeded(axis));
      return ExpectSameBits(ticks.state().plants[axis].velocity,
                            lanes.state().plants[axis].velocity);
    case 5:
      return ExpectSameBus(ticks, lanes);
    default:
      return;
  }
}

/// Changes a register of a profile, and perhaps starts it.
void RandomStart(MotionCore& core, size_t axis, RandomNumbers& random) {
  const ProfileMode mode = core.part<&MotionState::profiles, &Profile::mode>(axis);
  if (mode != ProfileMode::kTrap && mode != ProfileMode::kJog) return;
  if (core.part<&MotionState::profiles, &Profile::driven>(axis)) return;
  if (random.OneIn(30)) {
    Profile& changed = ChangeState(core).profiles[axis];
    changed.jog.parameters.smooth = 0;
    changed.trap.parameters.smooth_time = 0;
    changed.jog.velocity = random.Between(-20, 20);
    changed.trap.target = random.Below(20'000) - 10'000;
    changed.trap.velocity = random.Between(0.5, 40);
  }
  if (!random.OneIn(4)) core.ProfileAt(axis).Start();
}

/// What happens to random cards between two ways.
struct Habit {
  const char* name;
  int longest_way;  ///< cycles
  int reads;        ///< at most
  int one_start_in;
  int one_command_in;
};

constexpr Habit kHabits[] = {
    {"single cycles", 1, 0, 40, 200},      {"reads in every cycle", 1, 3, 40, 200},
    {"short ways", 20, 2, 20, 30},         {"starts in every cycle", 2, 1, 1, 100},
    {"commands all the time", 6, 1, 4, 2},
};
constexpr size_t kHabitCount = std::size(kHabits);
constexpr int kWorlds = 12;

/// Random cards, and what hosts do to them.
struct Cards {
  std::unique_ptr<MotionCore> (*card)(uint64_t seed);
  void (*command)(MotionCore& core, RandomNumbers& random);
  /// Of 3000 cycles of each of kWorlds cards with each habit: many cards have something that lanes
  /// cannot do.
  std::array<int64_t, kHabitCount> least_in_lanes;
};

void ShowWhatTicksShow(const Cards& cards) {
  const int worlds = Setting("ONCARD_WORLDS", RandomCases(kWorlds));
  for (size_t number = 0; number < kHabitCount; ++number) {
    const Habit& habit = kHabits[number];
    CycleCounter counter;
    for (int world = 1; world <= worlds && !testing::Test::HasFailure(); ++world) {
      SCOPED_TRACE(std::string(habit.name) + ", world " + std::to_string(world));
      const auto seed = static_cast<uint64_t>(world);
      Twins twins(cards.card(seed), cards.card(seed));
      counter.Count(twins.lanes());
      RandomNumbers random(seed * 77);
      for (int64_t cycle = 0; cycle < 3000 && !testing::Test::HasFailure();) {
        const int64_t way = 1 + random.Below(habit.longest_way);
        twins.Advance(way);
        cycle += way;
        const size_t axis_count = twins.ticks().axis_count();
        for (int i = random.Below(habit.reads + 1); i > 0; --i) {
          const auto axis = static_cast<size_t>(random.Below(static_cast<int>(axis_count)));
          ExpectSameRead(twins.ticks(), twins.lanes(), axis, random.Below(6));
        }
        const auto axis = static_cast<size_t>(random.Below(static_cast<int>(axis_count)));
        const uint64_t choices = random.Next();
        if (random.OneIn(habit.one_start_in)) {
          twins.Both([&](MotionCore& core) {
            RandomNumbers same(choices);
            RandomStart(core, axis, same);
          });
        }
        if (random.OneIn(habit.one_command_in)) {
          twins.Both([&](MotionCore& core) {
            RandomNumbers same(choices);
            cards.command(core, same);
          });
        }
        if (random.OneIn(8)) twins.ExpectEqual();
      }
      twins.ExpectEqual();
    }
    EXPECT_GT(counter.cycles(), cards.least_in_lanes[number] * worlds / kWorlds) << habit.name;
  }
}

TEST(LoadedLanes, ShowWhatTicksShow) {
  ShowWhatTicksShow({RandomCard, RandomCommand, {5000, 5000, 10'000, 4000, 200}});
}

TEST(LoadedLanes, ShowWhatTicksShowOfABus) {
  ShowWhatTicksShow({RandomBusCard, RandomBusCommand, {2500, 2000, 6000, 4000, 100}});
}

/// What changes a card without asking for its state.
struct Change {
  const char* name;
  void (*change)(MotionCore& core);
};

constexpr Change kChanges[] = {
    {"Tick", [](MotionCore& core) { core.Tick(); }},
    {"Reset", [](MotionCore& core) { core.Reset(); }},
    {"ServoOn", [](MotionCore& core) { core.AxisAt(1).ServoOn(); }},
    {"ServoOff", [](MotionCore& core) { core.AxisAt(1).ServoOff(); }},
    {"StartProfile", [](MotionCore& core) { core.ProfileAt(1).Start(); }},
    {"SetVelocity", [](MotionCore& core) { core.ProfileAt(1).SetVelocity(7); }},
    {"SetTarget", [](MotionCore& core) { core.ProfileAt(1).SetTarget(7); }},
    {"ClearStatus", [](MotionCore& core) { core.AxisAt(1).ClearStatus(); }},
    {"StopProfile", [](MotionCore& core) { core.ProfileAt(1).Stop(false); }},
    {"StopCommanded", [](MotionCore& core) { core.AxisAt(1).Stop(true); }},
    {"SetProfilePosition", [](MotionCore& core) { core.ProfileAt(11).SetPosition(7); }},
    {"SetEncoderPosition", [](MotionCore& core) { core.EncoderAt(1).SetPosition(7); }},
    {"SetClosedLoop", [](MotionCore& core) { core.AxisAt(1).SetClosedLoop(false); }},
    {"RestartDrives", [](MotionCore& core) { core.RestartDrives(); }},
    {"RebaseEncoder", [](MotionCore& core) { core.EncoderAt(1).Rebase(); }},
    {"SetEncoderSense", [](MotionCore& core) { core.EncoderAt(1).SetSense(true); }},
    {"SetEncoderExternal", [](MotionCore& core) { core.EncoderAt(1).SetExternal(false); }},
    {"SynchAxis", [](MotionCore& core) { core.AxisAt(1).SynchPosition(); }},
    {"ZeroAxis", [](MotionCore& core) { core.AxisAt(11).ZeroPosition(); }},
    {"SetProfileScale",
     [](MotionCore& core) {
       core.AxisAt(11).SetProfileScale({2, 1});
     }},
    {"SetEncoderScale",
     [](MotionCore& core) {
       core.AxisAt(1).SetEncoderScale({2, 1});
     }},
    {"SetBacklash",
     [](MotionCore& core) { core.AxisAt(1).SetBacklash({.value = 9, .change = 0.5}); }},
    {"SetInputShaper", [](MotionCore& core) { core.AxisAt(11).SetInputShaper(9, 0.5); }},
    {"EnableGantry", [](MotionCore& core) { core.EnableGantry(10, 11, 1, 1); }},
    {"SetUpCrd",
     [](MotionCore& core) {
       core.CrdAt(0).SetUp({.dimension = 2, .coordinates = {1, 2}});
     }},
    {"BeginHoming", [](MotionCore& core) { core.HomingAt(11).Begin({.mode = HomeMode::kLimit}); }},
    {"SetStopDecelerations",
     [](MotionCore& core) {
       core.ProfileAt(1).SetStopDecelerations(0.5, 2);
       core.ProfileAt(1).Stop(false);
     }},
    {"SetParameters",
     [](MotionCore& core) {
       core.ProfileAt(1).SetParameters(JogParameters{.acc = 3});
       core.ProfileAt(1).Start();
     }},
    {"SelectMode", [](MotionCore& core) { core.ProfileAt(11).SelectMode(ProfileMode::kTrap); }},
    {"SwitchPositiveLimit", [](MotionCore& core) { core.AxisAt(1).SwitchPositiveLimit(false); }},
    {"SetSoftLimits", [](MotionCore& core) { core.AxisAt(1).SetSoftLimits(1000, -1000); }},
    {"SetSmoothStopInput",
     [](MotionCore& core) {
       core.AxisAt(1).SetSmoothStopInput({DiType::kGpi, 3});
     }},
    {"SetBand", [](MotionCore& core) { core.AxisAt(1).SetBand(100, 500); }},
    {"SetProfileVelocityFilter",
     [](MotionCore& core) { core.AxisAt(1).SetProfileVelocityFilter(2); }},
    {"SetMaps",
     [](MotionCore& core) { core.AxisAt(11).SetMaps({.profiles = 1, .encoders = 1u << 11}); }},
    {"ControlHandle::Configure",
     [](MotionCore& core) { core.ControlAt(1).Configure(true, 1, -1); }},
    {"SetPidSet",
     [](MotionCore& core) { core.ControlAt(1).SetPidSet(0, {.kp = 25, .kvff = 300}); }},
    {"SelectPidSet", [](MotionCore& core) { core.ControlAt(1).SelectPidSet(1); }},
    {"SetErrorLimit", [](MotionCore& core) { core.ControlAt(1).SetErrorLimit(1); }},
    {"SwitchResponseCheck",
     [](MotionCore& core) {
       core.ControlAt(1).SetResponseCheck(0, 1e6, 500);
       core.ControlAt(1).SwitchResponseCheck(true);
     }},
    {"DacHandle::SetBias", [](MotionCore& core) { core.DacAt(1).SetBias(70); }},
    {"DacHandle::SetLimit", [](MotionCore& core) { core.DacAt(1).SetLimit(700); }},
    {"StepHandle::Configure", [](MotionCore& core) { core.StepAt(1).Configure(true, -1, true); }},
    {"EncoderHandle::Configure",
     [](MotionCore& core) { core.EncoderAt(1).Configure(true, true, true); }},
    {"digital_io",
     [](MotionCore& core) { core.digital_io().SetPin(DiType::kLimitPositive, 1, true); }},
    {"capture", [](MotionCore& core) { core.capture().Arm(1, CaptureSource::kIndex); }},
    {"compare", [](MotionCore& core) { core.compare().Pulse(0, core.now(), 3000); }},
    {"SetEnableAxis",
     [](MotionCore& core) {
       core.SetEnableAxis(3, 1);
       core.AxisAt(1).ServoOff();
     }},
    {"PlaceMotor", [](MotionCore& core) { core.PlaceMotor(1, 7); }},
    {"AddSwitch",
     [](MotionCore& core) {
       core.AddSwitch({.axis = 1, .type = DiType::kLimitPositive, .bit = 1, .last = 1e9});
     }},
    {"ConnectDrive",
     [](MotionCore& core) {
       core.ConnectDrive(1, VelocityDrive(50, 3, 0, core.config().ServoMs()));
     }},
    {"SetEvents",
     [](MotionCore& core) {
       core.SetEvents(std::make_shared<const WorldEvents>(
           WorldEvents{{core.now() + 1000, WorldEventKind::kStall, 1, 0, 1}}));
     }},
    {"Restore",
     [](MotionCore& core) {
       MotionState copy = core.state();
       copy.axes[1].soft_positive = 1000;
       core.Restore(copy);
     }},
    {"WatchLimits",
     [](MotionCore& core) {
       core.WatchLimits(9, {.velocity = 25});
       core.ProfileAt(9).Start();
     }},
};

TEST(LoadedLanes, MakeRoomForWhateverChangesTheCard) {
  const auto card = [] {
    auto core = ServoCard();
    for (const size_t resting : {size_t{10}, size_t{11}}) core->ProfileAt(resting).Stop(true);
    ChangeState(*core).profiles[9].jog.velocity = 30;  // of its next start
    return core;
  };
  for (const Change& change : kChanges) {
    SCOPED_TRACE(change.name);
    Twins twins(card(), card());
    twins.Advance(301);
    twins.Both(change.change);
    twins.ExpectEqual();
    twins.Advance(50);
    twins.ExpectEqual();
  }
}

constexpr Change kBusChanges[] = {
    {"TerminateBus", [](MotionCore& core) { core.TerminateBus(); }},
    {"ServoOff", [](MotionCore& core) { core.AxisAt(1).ServoOff(); }},
    {"ClearStatus", [](MotionCore& core) { core.AxisAt(1).ClearStatus(); }},
    {"Reset", [](MotionCore& core) { core.Reset(); }},
    {"SetMode",
     [](MotionCore& core) { core.bus_axes().SetMode(1, bus::DriveMode::kCyclicVelocity); }},
    {"SetScale", [](MotionCore& core) { core.bus_axes().SetScale(1, 2); }},
    {"SetEncoderPosition", [](MotionCore& core) { core.EncoderAt(1).SetPosition(7); }},
    {"PlaceMotor", [](MotionCore& core) { core.PlaceMotor(1, 7); }},
    {"StopProfile", [](MotionCore& core) { core.ProfileAt(1).Stop(true); }},
    {"StartProfile",
     [](MotionCore& core) {
       core.ProfileAt(1).SetVelocity(-5);
       core.ProfileAt(1).Start();
     }},
};

TEST(LoadedLanes, MakeRoomForWhateverChangesABus) {
  for (const Change& change : kBusChanges) {
    SCOPED_TRACE(change.name);
    Twins twins(JoggingBusCard(DriveKind::kVelocity), JoggingBusCard(DriveKind::kVelocity));
    twins.Advance(301);
    twins.Both(change.change);
    twins.ExpectEqual();
    twins.Advance(50);
    twins.ExpectEqual();
  }
}

// --- What keeps a card in lanes ----------------------------------------------------------------

/// Lets a card with twelve jogging axes pass 1000 single cycles, with something after each; returns
/// the number of those in lanes.
template <typename After>
int64_t CyclesInLanes(After after, std::unique_ptr<MotionCore> core = ServoCard()) {
  CycleCounter counter;
  counter.Count(*core);
  for (int i = 0; i < 1000; ++i) {
    core->Advance(1);
    after(*core, i);
  }
  return counter.cycles();
}

/// The cycles that pass before lanes are loaded first, and those in which a plan's next piece is
/// loaded.
constexpr int64_t kMostCycles = 1000 - 20;

TEST(LoadedLanes, StayLoadedBetweenSingleCycles) {
  EXPECT_GE(CyclesInLanes([](MotionCore&, int) {}), kMostCycles);
}

TEST(LoadedLanes, StayLoadedWhileTheStateIsRead) {
  EXPECT_GE(CyclesInLanes([](const MotionCore& core, int cycle) {
              const size_t axis = static_cast<size_t>(cycle) % core.axis_count();
              EXPECT_NE(core.profile(axis).now.position, 0);
              EXPECT_NE(core.state().profiles[axis].now.position, 0);
              EXPECT_NE(core.Conditions(axis) & kMovingBit, 0u);
            }),
            kMostCycles);
}

TEST(LoadedLanes, StayLoadedWhileTheStateOfABusIsRead) {
  const auto after = [](const MotionCore& core, int cycle) {
    const size_t axis = static_cast<size_t>(cycle) % core.axis_count();
    EXPECT_NE(core.encoder(axis).position, 0);
    EXPECT_TRUE(core.state().bus->line.Input(axis, bus::ObjectId::kPositionActual));
    EXPECT_TRUE(core.BusStarted());
    EXPECT_EQ(core.BusMode(axis), bus::DriveMode::kCyclicPosition);
  };
  for (const DriveKind kind : {DriveKind::kIdeal, DriveKind::kVelocity}) {
    EXPECT_GE(CyclesInLanes(after, JoggingBusCard(kind)), kMostCycles);
  }
}

TEST(LoadedLanes, StayLoadedWhenAProfileIsStarted) {
  EXPECT_GE(CyclesInLanes([](MotionCore& core, int cycle) {
              core.ProfileAt(static_cast<size_t>(cycle) % core.axis_count()).Start();
            }),
            kMostCycles);
}

/// What lanes neither hold nor read.
constexpr Change kUnlanedChanges[] = {
    {"SetVelocity", [](MotionCore& core) { core.ProfileAt(1).SetVelocity(7); }},
    {"SetTarget", [](MotionCore& core) { core.ProfileAt(1).SetTarget(7); }},
    {"SetParameters", [](MotionCore& core) { core.ProfileAt(1).SetParameters(TrapParameters{}); }},
    {"SetParameters, mode Jog",
     [](MotionCore& core) { core.ProfileAt(1).SetParameters(JogParameters{}); }},
    {"SetSCurve", [](MotionCore& core) { core.ProfileAt(1).SetSCurve({}, 7); }},
    {"ReserveReplanning", [](MotionCore& core) { core.ProfileAt(1).ReserveReplanning(); }},
    {"SetStopDecelerations",
     [](MotionCore& core) { core.ProfileAt(1).SetStopDecelerations(1, 2); }},
    {"CrdDriver::SetStopDecelerations",
     [](MotionCore& core) { core.CrdAt(0).SetStopDecelerations(1, 2); }},
    {"SetLimitStop", [](MotionCore& core) { core.CrdAt(0).SetLimitStop(true); }},
    {"SetVelocityMax", [](MotionCore& core) { core.CrdAt(0).SetVelocityMax(0, 5); }},
    {"SetPathVelocityMax", [](MotionCore& core) { core.CrdAt(0).SetPathVelocityMax(5); }},
    {"SetStartVelocity", [](MotionCore& core) { core.CrdAt(0).SetStartVelocity(5); }},
    {"SetOrigin", [](MotionCore& core) { core.CrdAt(0).SetOrigin(0, 5); }},
    {"SetStepMode", [](MotionCore& core) { core.CrdAt(0).SetStepMode(true); }},
    {"SetOverride", [](MotionCore& core) { core.CrdAt(0).SetOverride(0.5); }},
    {"SetSecondOverride", [](MotionCore& core) { core.CrdAt(0).SetSecondOverride(0.5); }},
    {"registers of a map",
     [](MotionCore& core) {
       core.CrdAt(0).BeginMap();
       core.CrdAt(0).SetJump(0, 5);
       core.CrdAt(0).SetStopsTogether(false);
       core.CrdAt(0).ForgetHold();
     }},
    {"what fills a FIFO",
     [](MotionCore& core) {
       core.CrdAt(0).SetJoints(0, JointRule::kFeeds);
       core.CrdAt(0).BeginLookAhead(0, 5, 1, 200);
       core.CrdAt(0).Append(0, {});
       core.CrdAt(0).Flush(0);
       core.CrdAt(0).OpenList(0);
       core.CrdAt(0).RestAfterLast(0);
       core.CrdAt(0).SetTail(0, {5});
       core.CrdAt(0).DropPlanners();
       core.CrdAt(0).Clear(0);
     }},
    {"SetUserNumber", [](MotionCore& core) { core.CrdAt(0).SetUserNumber(0, 5); }},
    {"StepHandle::SetMode", [](MotionCore& core) { core.StepAt(1).SetMode(1); }},
    {"StepHandle::SetParameter", [](MotionCore& core) { core.StepAt(1).SetParameter(1); }},
    {"laser", [](MotionCore& core) { core.laser(0).on = true; }},
    {"module", [](MotionCore& core) { core.module(0).outputs = 3; }},
    {"SetPvtTable", [](MotionCore& core) { core.SetPvtTable(0, nullptr); }},
    {"SetAdcFilter", [](MotionCore& core) { core.SetAdcFilter(0, 4); }},
    {"SetEnableAxis", [](MotionCore& core) { core.SetEnableAxis(0, 1); }},
    {"SetGantryErrorLimit", [](MotionCore& core) { core.SetGantryErrorLimit(9); }},
    {"ReserveReached", [](MotionCore& core) { core.ReserveReached(); }},
    {"ClearReached", [](MotionCore& core) { core.ClearReached(); }},
};

TEST(LoadedLanes, StayLoadedWhileWhatTheyDoNotHoldIsChanged) {
  for (const Change& change : kUnlanedChanges) {
    EXPECT_GE(CyclesInLanes([&](MotionCore& core, int) { change.change(core); }), kMostCycles)
        << change.name;
  }
}

TEST(LoadedLanes, AreNotLoadedAgainAfterEachOfManyChanges) {
  EXPECT_LE(CyclesInLanes([](MotionCore& core, int) { ChangeState(core).axes[0].band = 5; }), 100);
}

TEST(LoadedLanes, AreLoadedSoonAfterTheLastChange) {
  EXPECT_GE(CyclesInLanes([](MotionCore& core, int cycle) {
              if (cycle < 500) ChangeState(core).axes[0].band = 5;
            }),
            400);
}

TEST(LoadedLanes, AreNotSharedWithACopy) {
  const auto core = ServoCard();
  core->Advance(100);
  MotionCore copy = *core;
  EXPECT_EQ(copy.Hash(), core->Hash());
  copy.Advance(50);
  EXPECT_NE(copy.Hash(), core->Hash());
  core->Advance(50);
  EXPECT_EQ(copy.Hash(), core->Hash());
}

}  // namespace
}  // namespace oncard::motion
