// Axes: mapping and scales, position values, limits, alarm, stop inputs, conditions, the
// in-position band, the drive and the ideal motor connected to it.
#include "motion/axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

namespace oncard::motion {
namespace {

constexpr uint16_t kFilterTicks = CardDefaults{}.filter_ticks;

/// A card with the commands that these tests need; axes and profiles are numbered from 0.
class AxisCard {
 public:
  explicit AxisCard(Micros cycle_us = 1000, int axis_count = 8)
      : core({.axis_count = axis_count, .cycle_us = cycle_us}) {}

  Axis& axis(size_t i = 0) { return ChangeState(core).axes[i]; }
  Profile& profile(size_t i = 0) { return ChangeState(core).profiles[i]; }
  Encoder& encoder(size_t i = 0) { return ChangeState(core).encoders[i]; }

  void SetTrap(const TrapParameters& parameters, size_t i = 0) {
    profile(i).trap.parameters = parameters;
  }
  void MoveTo(int32_t target, double velocity, size_t i = 0) {
    profile(i).trap.target = target;
    profile(i).trap.velocity = velocity;
    core.ProfileAt(i).Start();
  }
  void Ticks(int count) {
    for (int i = 0; i < count; ++i) core.Tick();
  }
  /// Ticks until an axis rests, at most ten seconds.
  void TicksToRest(size_t i = 0) {
    for (int n = 0; n < 10000 && core.AxisMoving(axis(i)); ++n) core.Tick();
  }
  void RunToMs(double ms) {
    while (MsBetween(0, core.now()) < ms) core.Tick();
  }
  /// Sets a pin and runs the ticks of its filter.
  void Drive(DiType type, int bit, bool level) {
    core.digital_io().SetPin(type, bit, level);
    Ticks(kFilterTicks);
  }
  uint32_t conditions(size_t i = 0) const { return core.Conditions(i); }

  MotionCore core;
};

// --- Mapping and scales ------------------------------------------------------------------------

TEST(AxisScale, TheAxisIsTheProfileTimesBetaOverAlpha) {
  struct {
    int16_t alpha, beta;
    double factor;
  } const scales[] = {{1, 1, 1},     {2, 1, 0.5},   {3, 2, 2.0 / 3},
                      {-2, 1, -0.5}, {2, -1, -0.5}, {1000, 7, 0.007}};
  for (const auto& scale : scales) {
    for (const int32_t target : {100, 1000, -5000}) {
      AxisCard card;
      card.core.AxisAt(0).SetProfileScale({scale.alpha, scale.beta});
      card.core.AxisAt(0).SetEncoderScale({scale.alpha, scale.beta});
      card.SetTrap({.acc = 1, .dec = 1});
      card.MoveTo(target, 10);
      card.Ticks(5);
      EXPECT_NEAR(card.axis().profile.velocity, card.profile().now.velocity * scale.factor, 1e-12);
      EXPECT_NEAR(card.axis().profile.acceleration, card.profile().now.acceleration * scale.factor,
                  1e-12);
      card.TicksToRest();
      EXPECT_EQ(card.profile().now.position, target);
      EXPECT_NEAR(card.axis().profile.position, target * scale.factor, 1e-9);
    }
  }
}

TEST(AxisScale, AQuotientThatIsWholeIsExact) {
  for (const int16_t alpha : std::initializer_list<int16_t>{3, 7, 49, 32749}) {
    EXPECT_EQ((Scale{alpha, 1}).Apply(alpha * 1001.0), 1001);
    EXPECT_EQ((Scale{alpha, -1}).Apply(alpha * 1001.0), -1001);
  }
}

TEST(AxisScale, AChangeComputesThePositionAnewAndMovesNothing) {
  AxisCard card;
  card.core.AxisAt(0).ServoOn();
  card.SetTrap({.acc = 10, .dec = 10});
  card.MoveTo(3000, 100);
  card.TicksToRest();
  card.core.AxisAt(0).SetProfileScale({3, 1});
  EXPECT_EQ(card.axis().profile.position, 1000);
  card.Ticks(3);
  EXPECT_EQ(card.axis().profile.position, 1000);
  EXPECT_EQ(card.encoder().position, 3000);
  card.core.AxisAt(0).SetEncoderScale({3, 1});
  card.Ticks(1);
  EXPECT_EQ(card.axis().encoder.position, 1000);
  // The motor follows the axis: 3000 profile pulses are 1000 of the axis.
  card.MoveTo(6000, 100);
  card.TicksToRest();
  EXPECT_EQ(card.encoder().position, 4000);
}

TEST(AxisMap, AnAxisAddsTheProfilesOfItsMap) {
  AxisCard card;
  card.axis(0).profile_map = 0b11;
  for (size_t i = 0; i < 2; ++i) card.SetTrap({.acc = 1, .dec = 1}, i);
  card.MoveTo(100, 10, 0);
  card.MoveTo(1000, 20, 1);
  card.Ticks(10);
  EXPECT_EQ(card.axis(0).profile.velocity, 20);
  EXPECT_EQ(card.axis(0).profile.position, 100);
  card.TicksToRest();
  EXPECT_EQ(card.axis(0).profile.position, 1100);
  EXPECT_EQ(card.axis(1).profile.position, 1000);
}

TEST(AxisMap, AnAxisMovesWhileOneOfItsProfilesDoes) {
  AxisCard card;
  card.axis(0).profile_map = 0b11;
  card.SetTrap({.acc = 1, .dec = 1}, 1);
  card.MoveTo(1000, 20, 1);
  EXPECT_EQ(card.conditions(0), kMovingBit);
  card.TicksToRest(1);
  EXPECT_EQ(card.conditions(0), 0u);
}

TEST(AxisMap, AStopOfTheAxisStopsAllOfItsProfiles) {
  AxisCard card;
  card.axis(0).profile_map = 0b11;
  for (size_t i = 0; i < 2; ++i) {
    card.SetTrap({.acc = 1, .dec = 1}, i);
    card.MoveTo(100000, 20, i);
  }
  card.Ticks(50);
  card.Drive(DiType::kLimitPositive, 0, true);
  card.Ticks(1);
  EXPECT_FALSE(card.profile(0).now.moving);
  EXPECT_FALSE(card.profile(1).now.moving);
}

// --- Position bookkeeping ----------------------------------------------------------------------

TEST(AxisPosition, SettingAProfileLeavesTheAxisUntilSynch) {
  AxisCard card;
  card.core.AxisAt(0).ServoOn();
  card.SetTrap({.acc = 10, .dec = 10});
  card.MoveTo(1000, 50);
  card.TicksToRest();
  card.core.ProfileAt(0).SetPosition(5000);
  EXPECT_EQ(card.profile().now.position, 5000);
  card.Ticks(2);
  EXPECT_EQ(card.axis().profile.position, 1000);
  // The motion continues from there.
  card.MoveTo(5500, 50);
  card.TicksToRest();
  EXPECT_EQ(card.axis().profile.position, 1500);
  EXPECT_EQ(card.encoder().position, 1500);
  card.core.AxisAt(0).SynchPosition();
  EXPECT_EQ(card.axis().profile.position, 5500);
  EXPECT_EQ(card.axis().encoder.position, 1500);
  // This has not moved the motor, which follows as before.
  card.Ticks(2);
  EXPECT_EQ(card.encoder().position, 1500);
  card.MoveTo(5600, 50);
  card.TicksToRest();
  EXPECT_EQ(card.encoder().position, 1600);
  EXPECT_EQ(card.axis().profile.position, 5600);
}

TEST(AxisPosition, SettingAnEncoderLeavesTheAxisUntilSynch) {
  AxisCard card;
  card.core.EncoderAt(0).SetPosition(-300);
  EXPECT_EQ(card.encoder().position, -300);
  card.Ticks(2);
  EXPECT_EQ(card.axis().encoder.position, 0);
  EXPECT_EQ(card.encoder().velocity, 0);
  card.core.AxisAt(0).SynchPosition();
  EXPECT_EQ(card.axis().encoder.position, -300);
  EXPECT_EQ(card.axis().profile.position, 0);
}

TEST(AxisPosition, OnlyAxesThatMapTheProfileAreTouched) {
  AxisCard card;
  card.axis(3).profile_map = 0b1;
  card.core.ProfileAt(0).SetPosition(77);
  card.Ticks(1);
  EXPECT_EQ(card.axis(0).profile.offset, -77);
  EXPECT_EQ(card.axis(3).profile.offset, -77);
  EXPECT_EQ(card.axis(1).profile.offset, 0);
}

TEST(AxisPosition, ZeroSetsProfileEncoderAndAxis) {
  AxisCard card;
  card.core.AxisAt(0).ServoOn();
  card.SetTrap({.acc = 10, .dec = 10});
  card.MoveTo(1000, 50);
  card.TicksToRest();
  card.core.ProfileAt(0).SetPosition(5000);
  card.core.AxisAt(0).ZeroPosition();
  card.Ticks(2);
  EXPECT_EQ(card.profile().now.position, 0);
  EXPECT_EQ(card.encoder().position, 0);
  EXPECT_EQ(card.axis().profile.position, 0);
  EXPECT_EQ(card.axis().encoder.position, 0);
  EXPECT_EQ(card.core.state().plants[0].position, 1000);
}

TEST(AxisPosition, ThePulseCounterCountsNoPulsesForASynch) {
  AxisCard card;
  card.encoder().external = false;
  card.core.ProfileAt(0).SetPosition(5000);
  card.core.AxisAt(0).SynchPosition();
  card.Ticks(2);
  EXPECT_EQ(card.encoder().position, 0);
  card.SetTrap({.acc = 10, .dec = 10});
  card.MoveTo(6000, 50);
  card.TicksToRest();
  EXPECT_EQ(card.encoder().position, 1000);
}

// --- Soft limits -------------------------------------------------------------------------------

TEST(SoftLimit, Example91StopsOneCycleBehindTheLimit) {
  // 50 pulse/ms are reached after 425 ms at 10625 pulses; 20025 are passed at 613 ms; then 50 /
  // 1000 ms and 1.25 pulses more.
  AxisCard card(1000);
  card.axis().soft_positive = 20000;
  card.axis().soft_negative = -20000;
  card.SetTrap({.acc = 0.125, .dec = 0.125, .smooth_time = 25});
  card.MoveTo(1000000, 50);
  card.RunToMs(425);
  EXPECT_NEAR(card.axis().profile.position, 10625, 1e-6);
  card.RunToMs(612);
  EXPECT_NEAR(card.axis().profile.position, 19975, 1e-6);
  EXPECT_EQ(card.conditions(), kMovingBit);
  card.RunToMs(613);
  EXPECT_NEAR(card.axis().profile.position, 20025, 1e-6);
  EXPECT_EQ(card.conditions(), kMovingBit | kPositiveLimitBit);
  card.RunToMs(614);
  EXPECT_NEAR(card.axis().profile.position, 20026.25, 1e-6);
  EXPECT_EQ(card.conditions(), kPositiveLimitBit);
}

TEST(SoftLimit, TheOtherDirectionMirrorsIt) {
  AxisCard card(1000);
  card.axis().soft_negative = -20000;
  card.SetTrap({.acc = 0.125, .dec = 0.125, .smooth_time = 25});
  card.MoveTo(-1000000, 50);
  card.RunToMs(614);
  EXPECT_NEAR(card.axis().profile.position, -20026.25, 1e-6);
  EXPECT_EQ(card.conditions(), kNegativeLimitBit);
}

TEST(SoftLimit, TheLimitItselfIsInside) {
  AxisCard card;
  card.axis().soft_positive = 1000;
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(1000, 10);
  card.TicksToRest();
  EXPECT_EQ(card.conditions(), 0u);
}

TEST(SoftLimit, CountsInUnitsOfTheAxis) {
  AxisCard card;
  card.core.AxisAt(0).SetProfileScale({2, 1});
  card.axis().soft_positive = 1000;
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(2000, 10);
  card.TicksToRest();
  EXPECT_EQ(card.conditions(), 0u);
  card.MoveTo(3000, 10);
  card.TicksToRest();
  EXPECT_EQ(card.conditions(), kPositiveLimitBit);
}

TEST(SoftLimit, MotionAwayIsNotStoppedAndTheBitStaysUntilItIsCleared) {
  AxisCard card;
  card.axis().soft_positive = 1000;
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(5000, 10);
  card.TicksToRest();
  card.core.AxisAt(0).ClearStatus();
  EXPECT_EQ(card.conditions(), kPositiveLimitBit) << "still behind the limit";
  card.MoveTo(0, 10);
  card.TicksToRest();
  EXPECT_EQ(card.axis().profile.position, 0);
  EXPECT_EQ(card.conditions(), kPositiveLimitBit);
  card.core.AxisAt(0).ClearStatus();
  EXPECT_EQ(card.conditions(), 0u);
}

// --- Limit switches ----------------------------------------------------------------------------

TEST(LimitSwitch, StopsMotionTowardsItAbruptly) {
  struct {
    DiType type;
    int32_t target;
    uint32_t bit;
    bool stops;
  } const cases[] = {
      {DiType::kLimitPositive, 100000, kPositiveLimitBit, true},
      {DiType::kLimitPositive, -100000, kPositiveLimitBit, false},
      {DiType::kLimitNegative, -100000, kNegativeLimitBit, true},
      {DiType::kLimitNegative, 100000, kNegativeLimitBit, false},
  };
  for (const auto& c : cases) {
    AxisCard card;
    card.SetTrap({.acc = 1, .dec = 1});
    card.MoveTo(c.target, 10);
    card.RunToMs(100);
    card.Drive(c.type, 0, true);
    EXPECT_EQ(card.conditions(), kMovingBit | c.bit);
    card.Ticks(1);
    EXPECT_EQ(card.conditions(), c.stops ? c.bit : kMovingBit | c.bit);
    card.Drive(c.type, 0, false);
    EXPECT_EQ(card.conditions() & c.bit, c.bit);
    card.core.AxisAt(0).ClearStatus();
    EXPECT_EQ(card.conditions() & c.bit, 0u);
  }
}

TEST(LimitSwitch, AReversedScaleReversesTheDirectionOfTheAxis) {
  AxisCard card;
  card.core.AxisAt(0).SetProfileScale({-1, 1});
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(-100000, 10);
  card.RunToMs(100);
  card.Drive(DiType::kLimitPositive, 0, true);
  card.Ticks(1);
  EXPECT_EQ(card.conditions(), kPositiveLimitBit);
}

TEST(LimitSwitch, IsIgnoredWhenSwitchedOffOrNotConfigured) {
  for (const bool configured : {true, false}) {
    AxisCard card;
    if (configured) {
      card.axis().positive_limit_on = false;
    } else {
      card.axis().positive_limit.bit = -1;
    }
    card.SetTrap({.acc = 1, .dec = 1});
    card.MoveTo(100000, 10);
    card.Drive(DiType::kLimitPositive, 0, true);
    card.Ticks(2);
    EXPECT_EQ(card.conditions(), kMovingBit);
  }
}

TEST(LimitSwitch, EachAxisHearsItsOwnInput) {
  AxisCard card;
  card.axis(2).positive_limit = {DiType::kGpi, 15};
  card.Drive(DiType::kGpi, 15, true);
  card.Drive(DiType::kLimitPositive, 5, true);
  for (size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(card.conditions(i), i == 2 || i == 5 ? kPositiveLimitBit : 0u) << i;
  }
}

// --- Alarm and stop inputs ---------------------------------------------------------------------

TEST(Alarm, SwitchesTheDriveOffAndStopsAbruptly) {
  AxisCard card;
  card.core.AxisAt(0).ServoOn();
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(100000, 10);
  card.RunToMs(100);
  EXPECT_EQ(card.conditions(), kServoOnBit | kMovingBit);
  EXPECT_EQ(card.core.state().io.Register(DoType::kEnable), 1u);
  card.Drive(DiType::kAlarm, 0, true);
  EXPECT_EQ(card.conditions() & (kAlarmBit | kServoOnBit), kAlarmBit);
  EXPECT_EQ(card.core.state().io.Register(DoType::kEnable), 0u);
  card.Ticks(1);
  EXPECT_EQ(card.conditions(), kAlarmBit);
}

TEST(Alarm, ALatchedAlarmDoesNotSwitchTheDriveOff) {
  AxisCard card;
  card.Drive(DiType::kAlarm, 0, true);
  card.Drive(DiType::kAlarm, 0, false);
  card.core.AxisAt(0).ServoOn();
  card.Ticks(2);
  EXPECT_EQ(card.conditions(), kAlarmBit | kServoOnBit);
}

TEST(Alarm, IsIgnoredWhenSwitchedOff) {
  AxisCard card;
  card.axis().alarm_on = false;
  card.Drive(DiType::kAlarm, 0, true);
  EXPECT_EQ(card.conditions(), 0u);
}

TEST(StopInput, StopsSmoothlyOrAbruptlyInAnyDirection) {
  struct {
    bool abrupt;
    int32_t target;
    uint32_t bit;
  } const cases[] = {{false, 100000, kSmoothStopBit},
                     {false, -100000, kSmoothStopBit},
                     {true, 100000, kAbruptStopBit},
                     {true, -100000, kAbruptStopBit}};
  for (const auto& c : cases) {
    AxisCard card;
    (c.abrupt ? card.axis().abrupt_stop : card.axis().smooth_stop) = {DiType::kGpi, 3};
    card.profile().smooth_stop = 0.5;
    card.SetTrap({.acc = 1, .dec = 1});
    card.MoveTo(c.target, 10);
    card.RunToMs(100);
    card.Drive(DiType::kGpi, 3, true);  // at 103 ms
    EXPECT_EQ(card.conditions(), c.bit | kMovingBit);
    card.Ticks(10);
    EXPECT_EQ(std::fabs(card.profile().now.velocity), c.abrupt ? 0 : 5);
    card.Ticks(10);
    EXPECT_EQ(card.conditions(), c.bit);
    // 100 pulses in 20 ms, or 0.05 pulses.
    EXPECT_NEAR(std::fabs(card.profile().now.position), 980 + (c.abrupt ? 0.05 : 100), 1e-9);
    card.core.AxisAt(0).ClearStatus();
    EXPECT_EQ(card.conditions(), c.bit) << "the input is still on";
    card.Drive(DiType::kGpi, 3, false);
    EXPECT_EQ(card.conditions(), c.bit) << "latched";
    card.core.AxisAt(0).ClearStatus();
    EXPECT_EQ(card.conditions(), 0u);
  }
}

TEST(StopInput, AnAbruptStopReplacesASmoothOne) {
  AxisCard card;
  card.axis().smooth_stop = {DiType::kGpi, 0};
  card.axis().abrupt_stop = {DiType::kGpi, 1};
  card.profile().smooth_stop = 0.01;
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(100000, 10);
  card.RunToMs(100);
  card.Drive(DiType::kGpi, 0, true);
  card.Ticks(20);
  EXPECT_TRUE(card.profile().now.moving);
  card.Drive(DiType::kGpi, 1, true);
  card.Ticks(1);
  EXPECT_EQ(card.conditions(), kSmoothStopBit | kAbruptStopBit);
}

TEST(StopInput, AStoppedMotionDoesNotComeBack) {
  AxisCard card;
  card.axis().abrupt_stop = {DiType::kGpi, 1};
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(100000, 10);
  card.RunToMs(100);
  card.Drive(DiType::kGpi, 1, true);
  card.Drive(DiType::kGpi, 1, false);
  card.core.AxisAt(0).ClearStatus();
  card.Ticks(100);
  EXPECT_EQ(card.conditions(), 0u);
  EXPECT_NEAR(card.profile().now.position, 980.05, 1e-9);
}

// --- In position -------------------------------------------------------------------------------

TEST(InPosition, Example112ComesTheBandTimeAfterTheEndOfTheMotion) {
  // 10 + 985 + 20 ms, then 5 x 250 us.
  for (const Micros cycle_us : {125, 250, 625, 1250}) {
    AxisCard card(cycle_us);
    card.core.AxisAt(0).ServoOn();
    card.axis().band = 20;
    card.axis().band_time = 1250;
    card.axis().band_set = true;
    card.SetTrap({.acc = 1, .dec = 0.5});
    card.MoveTo(10000, 10);
    card.RunToMs(1015);
    EXPECT_EQ(card.conditions(), kServoOnBit) << cycle_us;
    const Micros end = card.core.now();
    while ((card.conditions() & kInPositionBit) == 0 && card.core.now() < 2'000'000) card.Ticks(1);
    EXPECT_EQ(card.core.now() - end, 1250) << cycle_us;
  }
}

TEST(InPosition, NeedsABandAndAnErrorStrictlyInsideIt) {
  struct {
    bool set;
    int32_t band;
    double error;
    bool in_position;
  } const cases[] = {{false, 100, 0, false},  {true, 100, 99, true},    {true, 100, -99, true},
                     {true, 100, 100, false}, {true, 100, -100, false}, {true, 0, 0, false}};
  for (const auto& c : cases) {
    AxisCard card;
    card.axis().band = c.band;
    card.axis().band_set = c.set;
    card.core.EncoderAt(0).SetPosition(c.error);
    card.core.AxisAt(0).SynchPosition();
    card.Ticks(2);
    EXPECT_EQ(card.conditions() == kInPositionBit, c.in_position) << c.band << " " << c.error;
  }
}

TEST(InPosition, GoesAtOnceWithMotionOrTheErrorAndNeedsTheWholeTimeAgain) {
  AxisCard card;
  card.axis().band = 20;
  card.axis().band_time = 4000;
  card.axis().band_set = true;
  card.core.AxisAt(0).ServoOn();
  card.Ticks(4);
  EXPECT_EQ(card.conditions(), kServoOnBit);
  card.Ticks(1);
  EXPECT_EQ(card.conditions(), kServoOnBit | kInPositionBit);
  card.core.EncoderAt(0).SetPosition(50);
  card.core.AxisAt(0).SynchPosition();
  card.Ticks(1);
  EXPECT_EQ(card.conditions(), kServoOnBit);
  card.core.EncoderAt(0).SetPosition(0);
  card.core.AxisAt(0).SynchPosition();
  card.Ticks(4);
  EXPECT_EQ(card.conditions(), kServoOnBit);
  card.Ticks(1);
  EXPECT_EQ(card.conditions(), kServoOnBit | kInPositionBit);
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(100, 10);
  EXPECT_EQ(card.conditions(), kServoOnBit | kMovingBit);
  card.TicksToRest();
  EXPECT_EQ(card.conditions(), kServoOnBit);
}

// --- Drive and motor -------------------------------------------------------------------------

TEST(Servo, AnIdealMotorFollowsAnEnabledAxisAndRestsBehindADisabledOne) {
  AxisCard card;
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(1000, 10);
  card.TicksToRest();
  EXPECT_EQ(card.axis().profile.position, 1000);
  EXPECT_EQ(card.encoder().position, 0);
  card.core.AxisAt(0).ServoOn();
  EXPECT_EQ(card.core.state().io.Register(DoType::kEnable), 1u);
  card.Ticks(1);
  EXPECT_EQ(card.encoder().position, 0);
  card.MoveTo(1500, 10);
  for (int i = 0; i < 30; ++i) {
    card.Ticks(1);
    EXPECT_EQ(card.encoder().position, std::round(card.axis().profile.position - 1000));
  }
  card.TicksToRest();
  EXPECT_EQ(card.encoder().position, 500);
  EXPECT_EQ(card.axis().encoder.position, 500);
}

TEST(Servo, SwitchingOffStopsTheProfileAbruptly) {
  AxisCard card;
  card.core.AxisAt(2).ServoOn();
  card.SetTrap({.acc = 1, .dec = 1}, 2);
  card.MoveTo(1000, 10, 2);
  card.RunToMs(50);
  card.core.AxisAt(2).ServoOff();
  EXPECT_EQ(card.core.state().io.Register(DoType::kEnable), 0u);
  card.Ticks(1);
  EXPECT_EQ(card.conditions(2), 0u);
  EXPECT_NEAR(card.profile(2).now.position, 450.05, 1e-9);
}

TEST(Servo, EncoderVelocityIsTheCountOfACycle) {
  AxisCard card(250);
  card.core.AxisAt(0).ServoOn();
  card.SetTrap({.acc = 10, .dec = 10});
  card.MoveTo(100000, 40);
  card.RunToMs(50);
  EXPECT_EQ(card.encoder().velocity, 40);
  EXPECT_EQ(card.axis().encoder.velocity, 40);
  EXPECT_EQ(card.axis().encoder.acceleration, 0);
}

// --- Conditions --------------------------------------------------------------------------------

TEST(Conditions, InputsThatAreActiveAtPowerOnShowAfterTheFirstCycle) {
  AxisCard card;
  card.core.digital_io().SetPin(DiType::kLimitNegative, 4, true);
  card.core.Reset();
  card.Ticks(1);
  EXPECT_EQ(card.conditions(4), kNegativeLimitBit);
}

TEST(Conditions, ResetClearsEverythingAndTheMotorStays) {
  AxisCard card;
  card.core.AxisAt(0).ServoOn();
  card.axis().soft_positive = 100;
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(1000, 10);
  card.TicksToRest();
  ASSERT_NE(card.conditions(), 0u);
  const double motor = card.core.state().plants[0].position;
  card.core.Reset();
  card.Ticks(3);
  EXPECT_EQ(card.conditions(), 0u);
  EXPECT_EQ(card.profile().now, AtRest(0));
  EXPECT_EQ(card.encoder().position, 0);
  EXPECT_EQ(card.core.state().plants[0].position, motor);
}

// --- Velocity filter ---------------------------------------------------------------------------

TEST(VelocityFilter, IsTheMeanOfTheLastCycles) {
  VelocityFilter filter;
  EXPECT_EQ(filter.Mean(7), 7);
  filter.Set(2, 4);
  EXPECT_EQ(filter.window.size(), 4u);
  EXPECT_EQ(filter.Mean(100), 4);
  for (const double v : {8.0, 12.0, 16.0}) filter.Add(v);
  EXPECT_EQ(filter.Mean(100), 10);
  for (const double v : {20.0, 24.0}) filter.Add(v);
  EXPECT_EQ(filter.Mean(100), 18);
  filter.Set(0, 5);
  filter.Add(6);
  EXPECT_EQ(filter.Mean(7), 7);
}

TEST(VelocityFilter, DoesNotTouchWhatTheCardDecidesBy) {
  AxisCard card;
  card.axis().profile.filter.Set(8, 0);
  card.SetTrap({.acc = 1, .dec = 1});
  card.MoveTo(100000, 10);
  card.RunToMs(10);
  EXPECT_EQ(card.axis().profile.velocity, 10);
  EXPECT_EQ(card.axis().profile.FilteredVelocity(), 55.0 / 256);
}

}  // namespace
}  // namespace oncard::motion
