// Time at several cycle lengths, reset, and the hash of the state.
#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/motion/core_run.h"

namespace oncard::motion {
namespace {

void TickTimes(MotionCore& core, int times) {
  for (int i = 0; i < times; ++i) core.Tick();
}

TEST(MotionClock, CountsMillisecondsRoundedDownAndMicrosecondsExactly) {
  struct {
    int64_t cycle_us;
    int ticks;
    int64_t ms;
    int64_t us;
  } const cases[] = {
      {250, 0, 0, 0},    {250, 3, 0, 750},   {250, 4, 1, 1000},          {250, 4001, 1000, 1000250},
      {125, 7, 0, 875},  {125, 8, 1, 1000},  {1000, 5, 5, 5000},         {375, 2, 0, 750},
      {375, 3, 1, 1125}, {4000, 2, 8, 8000}, {4000, 250, 1000, 1000000},
  };
  for (const auto& c : cases) {
    MotionCore core({.cycle_us = c.cycle_us});
    TickTimes(core, c.ticks);
    EXPECT_EQ(core.ClockMs(), c.ms) << c.cycle_us << " us, " << c.ticks;
    EXPECT_EQ(core.ClockUs(), c.us) << c.cycle_us << " us, " << c.ticks;
  }
}

TEST(MotionReset, ZeroesTheClockButNotTheCycleCounter) {
  MotionCore core({});
  TickTimes(core, 40);
  core.Reset();
  TickTimes(core, 4);
  EXPECT_EQ(core.ClockMs(), 1);
  EXPECT_EQ(core.state().cycle, 44);
}

TEST(MotionReset, ClearsOutputsAndKeepsPins) {
  MotionCore core({});
  core.digital_io().Write(DoType::kGpo, 1, 1);
  core.digital_io().SetPin(DiType::kHome, 2, true);
  core.Reset();
  EXPECT_EQ(core.state().io.Register(DoType::kGpo), 0u);
  EXPECT_EQ(core.state().io.Pins(DiType::kHome), 4u);
}

TEST(MotionReset, SetsWhatTheConfigurationSays) {
  const MotionCore core({.axis_count = 4,
                         .defaults = {.smooth_stop = 2,
                                      .abrupt_stop = 50,
                                      .filter_ticks = 1,
                                      .alarm_on = false,
                                      .limits_on = false,
                                      .encoders_external = false,
                                      .encoders_reversed = true,
                                      .following_error_limit = 7}});
  const MotionState& state = core.state();
  EXPECT_EQ(state.profiles[3].smooth_stop, 2);
  EXPECT_EQ(state.profiles[3].abrupt_stop, 50);
  EXPECT_EQ(state.crds[1].smooth_stop, 2);
  EXPECT_EQ(state.crds[1].abrupt_stop, 50);
  EXPECT_FALSE(state.axes[3].alarm_on);
  EXPECT_FALSE(state.axes[3].positive_limit_on);
  EXPECT_FALSE(state.axes[3].negative_limit_on);
  EXPECT_FALSE(state.encoders[3].external);
  EXPECT_TRUE(state.encoders[3].reversed);
  EXPECT_EQ(state.controls[3].error_limit, 7);
  EXPECT_FALSE(core.InClosedLoop(3));
}

TEST(MotionReset, SetsTheFiltersOfTheConfiguration) {
  MotionCore core({.defaults = {.filter_ticks = 1}});
  core.digital_io().SetPin(DiType::kGpi, 0, true);
  TickTimes(core, 1);
  EXPECT_EQ(core.state().io.Read(DiType::kGpi), 1u);
}

TEST(MotionReset, ClosesTheLoopsOfTheCardsThatHaveIt) {
  MotionCore core({.axis_count = 4, .defaults = {.closed_loop = true}});
  for (size_t axis = 0; axis < 4; ++axis) EXPECT_TRUE(core.InClosedLoop(axis)) << axis;
  core.AxisAt(2).SetClosedLoop(false);
  EXPECT_FALSE(core.InClosedLoop(2));
  core.Reset();
  EXPECT_TRUE(core.InClosedLoop(2));
}

TEST(MotionDrive, ThatIsEnabledContinuesFromTheAxisOrMovesToThePlan) {
  for (const bool aligns : {true, false}) {
    MotionCore core({.defaults = {.closed_loop = true, .enabling_aligns = aligns}});
    ChangeState(core).plants[0].hand = 2;
    TickTimes(core, 40);  // 10 ms
    core.AxisAt(0).ServoOn();
    EXPECT_EQ(core.profile(0).now.position, aligns ? 20 : 0);
  }
}

TEST(MotionEncoders, ThatBelongToNoAxisAreOnSomeCards) {
  const struct {
    int axis_count;
    bool default_has;
    bool has;
  } cases[] = {{8, true, true}, {8, false, false}, {12, true, false}};
  for (const auto& c : cases) {
    const MotionCore core(
        {.axis_count = c.axis_count, .defaults = {.auxiliary_encoders = c.default_has}});
    EXPECT_EQ(core.has_auxiliary(), c.has) << c.axis_count;
  }
}

TEST(MotionReset, KeepsTheDecelerationsOfACoordinateSystemThatIsSetUpAgain) {
  MotionCore core({.defaults = {.smooth_stop = 2, .abrupt_stop = 50}});
  CrdParameters parameters;
  parameters.dimension = 2;
  parameters.coordinates = {1, 2};
  core.CrdAt(0).SetUp(parameters);
  EXPECT_EQ(core.state().crds[0].smooth_stop, 2);
  EXPECT_EQ(core.state().crds[0].abrupt_stop, 50);
}

TEST(MotionReset, LeavesAuxiliaryEncodersToTheirShafts) {
  const MotionCore core({.axis_count = 3, .defaults = {.encoders_external = false}});
  EXPECT_FALSE(core.state().encoders[0].external);
  for (size_t i = 0; i < kAuxiliaryCount; ++i) {
    EXPECT_TRUE(core.state().encoders[kAuxiliaryFirst + i].external);
  }
}

TEST(MotionReset, TakesTheVoltageFromTheSpindleOfACardThatHasOne) {
  EXPECT_FALSE(MotionCore({}).state().spindle);
  MotionCore core({.defaults = {.spindle = true}});
  ASSERT_TRUE(core.state().spindle);
  core.SetSpindle(32767);
  EXPECT_DOUBLE_EQ(core.state().spindle->Volts(), 10);
  TickTimes(core, 4);
  EXPECT_DOUBLE_EQ(core.state().spindle->Volts(), 10);
  core.Reset();
  ASSERT_TRUE(core.state().spindle);
  EXPECT_EQ(core.state().spindle->Volts(), 0);
}

TEST(MotionTick, SamplesInputsAndAdvancesTimedOutputs) {
  MotionCore core({.cycle_us = 1000});
  core.digital_io().SetPin(DiType::kGpi, 0, true);
  ChangeState(core).io.WriteForAWhile(DoType::kGpo, 0, true, 2000);
  TickTimes(core, 1);
  EXPECT_EQ(core.state().io.Register(DoType::kGpo), 1u);
  TickTimes(core, 2);
  EXPECT_EQ(core.state().io.Register(DoType::kGpo), 0u);
  EXPECT_EQ(core.state().io.Read(DiType::kGpi), 1u);
}

TEST(MotionTick, AStopAtALimitWithAnInfiniteDecelerationRestsInTheSameCycle) {
  MotionCore core({.defaults = {.abrupt_stop = std::numeric_limits<double>::infinity()}});
  Jog(core, 10);
  core.AxisAt(0).SetSoftLimits(1000, kNoNegativeLimit);
  while (core.axis(0).latched == 0) core.Tick();
  EXPECT_EQ(core.profile(0).now.velocity, 0);
  EXPECT_FALSE(core.profile(0).now.moving);
  EXPECT_GT(core.profile(0).now.position, 1000);
  EXPECT_LE(core.profile(0).now.position, 1002.5) << "what it moves in a cycle";
}

TEST(MotionHash, IsEqualForEqualStatesAndForACopyPutBack) {
  MotionCore a({});
  MotionCore b({});
  EXPECT_EQ(a.Hash(), b.Hash());
  TickTimes(a, 3);
  const MotionState kept = a.state();
  const uint64_t hash = a.Hash();
  TickTimes(a, 9);
  EXPECT_NE(a.Hash(), hash);
  ChangeState(a) = kept;
  EXPECT_EQ(a.Hash(), hash);
}

TEST(MotionHash, SeesEveryPartOfTheState) {
  const auto changed = [](auto change) {
    MotionCore core({});
    const uint64_t before = core.Hash();
    change(ChangeState(core));
    return core.Hash() != before;
  };
  EXPECT_TRUE(changed([](MotionState& s) { s.cycle = 1; }));
  EXPECT_TRUE(changed([](MotionState& s) { s.clock_cycle = 1; }));
  EXPECT_TRUE(changed([](MotionState& s) { s.reached.resize(1); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.spindle.Emplace(); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetPin(DiType::kMpg, 6, false); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetPin(DiType::kMpg, 6, true); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetInverted(DiType::kGpi, 1); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetFilterTicks(DiType::kGpi, 1, 4); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetEdges(DiType::kGpi, 1, 4); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.Write(DoType::kClear, 1, 1); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.SetOutputInverted(DoType::kClear, 1); }));
  EXPECT_TRUE(changed([](MotionState& s) { s.io.WriteForAWhile(DoType::kGpo, 0, false, 1); }));
}

}  // namespace
}  // namespace oncard::motion
