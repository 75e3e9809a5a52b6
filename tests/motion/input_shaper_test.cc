// The input shaper: its two impulses, what an axis with one does, and the vibration that is left of
// a mechanism which this file simulates.
#include "motion/input_shaper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "motion/motion_core.h"
#include "tests/motion/bus/bus_card.h"
#include "tests/motion/change_state.h"

namespace oncard::motion {
namespace {

constexpr double kCycleMs = 1;

/// A shaper that is given positions, one in each cycle.
class ShaperRun {
 public:
  ShaperRun(size_t count, double k) { shaper_.Set(count, k, {}); }
  /// The shaped position.
  double Next(double position) {
    shaper_.Advance(++cycle_, {position, 0, 0});
    return position + shaper_.addition.position;
  }
  const InputShaper& shaper() const { return shaper_; }
  InputShaper& shaper() { return shaper_; }

 private:
  InputShaper shaper_;
  int64_t cycle_ = 17;
};

TEST(InputShaper, PassesAStepInTwoPartsCountCyclesApart) {
  for (const size_t count : {size_t{1}, size_t{2}, size_t{7}, size_t{1000}}) {
    for (const double k : {1.0, 0.5, 0.25, 0.9, 1e-9}) {
      ShaperRun run(count, k);
      for (size_t i = 0; i < count; ++i) EXPECT_NEAR(run.Next(100), 100 / (1 + k), 1e-10);
      for (size_t i = 0; i < count; ++i) EXPECT_EQ(run.Next(100), 100) << count << " " << k;
    }
  }
}

TEST(InputShaper, AddsThePresentAndTheDelayedCommand) {
  constexpr int kCount = 5;
  constexpr double kRatio = 0.6;
  ShaperRun run(kCount, kRatio);
  std::vector<double> given;
  for (int i = 0; i < 40; ++i) {
    given.push_back(1000.0 * i / (i + 3) - 7.0 * i);
    const double delayed = i < kCount ? 0 : given[static_cast<size_t>(i - kCount)];
    const double expected = (given.back() + kRatio * delayed) / (1 + kRatio);
    EXPECT_NEAR(run.Next(given.back()), expected, 1e-10) << i;
  }
}

TEST(InputShaper, ShapesVelocityAndAccelerationToo) {
  InputShaper shaper;
  shaper.Set(1, 1, {});
  shaper.Advance(1, {1, 2, 4});
  EXPECT_EQ(shaper.addition, (CommandedMotion{-0.5, -1, -2}));
  shaper.Advance(2, {1, 0, 0});
  EXPECT_EQ(shaper.addition, (CommandedMotion{0, 1, 2}));
  shaper.Advance(3, {1, 0, 0});
  EXPECT_EQ(shaper.addition, (CommandedMotion{}));
}

TEST(InputShaper, SettlesCountCyclesAfterTheLastChangeWithoutARoundingError) {
  ShaperRun run(3, 0.7);
  EXPECT_TRUE(run.shaper().settled());
  run.Next(0.1);
  run.Next(1e9 / 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(run.shaper().settled()) << i;
    run.Next(1e9 / 3);
  }
  EXPECT_TRUE(run.shaper().settled());
  EXPECT_EQ(run.shaper().addition, CommandedMotion{});
}

TEST(InputShaper, ForgetsThePastWhenItRestarts) {
  ShaperRun run(4, 1);
  run.Next(10);
  run.Next(20);
  run.shaper().Restart({30, 5, 0});
  EXPECT_TRUE(run.shaper().settled());
  EXPECT_EQ(run.Next(40), 35);
}

TEST(InputShaper, GoesOnFromARenamedPosition) {
  for (const double shift : {-500.0, 0.1}) {
    ShaperRun run(4, 0.8);
    ShaperRun renamed(4, 0.8);
    for (const double position : {3.0, 7.0, 7.0}) {
      run.Next(position);
      renamed.Next(position);
    }
    renamed.shaper().Rename(7 + shift);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(renamed.Next(7 + shift), run.Next(7) + shift, 1e-12);
    EXPECT_TRUE(renamed.shaper().settled());
  }
}

// --- A mechanism behind the shaper
// ----------------------------------------------------------------

/// A mass on a spring with a damper, which is moved at the other end of the spring. Between two
/// samples the end rests: the exact solution of x'' + 2 z w x' + w^2 x = w^2 u.
class Mechanism {
 public:
  Mechanism(double half_period_ms, double zeta)
      : damped_(std::numbers::pi / half_period_ms),
        decay_(damped_ * zeta / std::sqrt(1 - zeta * zeta)) {}

  void Advance(double end) {
    const double e = std::exp(-decay_ * kCycleMs);
    const double c = std::cos(damped_ * kCycleMs);
    const double s = std::sin(damped_ * kCycleMs);
    const double away = position_ - end;
    const double b = (velocity_ + decay_ * away) / damped_;
    position_ = end + e * (away * c + b * s);
    velocity_ = e * ((b * damped_ - decay_ * away) * c - (away * damped_ + decay_ * b) * s);
  }
  /// How far it swings about `end`, without its further decay.
  double Amplitude(double end) const {
    const double away = position_ - end;
    return std::hypot(away, (velocity_ + decay_ * away) / damped_);
  }

 private:
  double damped_;
  double decay_;
  double position_ = 0;
  double velocity_ = 0;
};

/// A trapezoidal move of the first axis of a card, its drive followed by the mechanism.
struct Move {
  Move(size_t count, double k) {
    core.AxisAt(0).SetInputShaper(count, k);
    core.AxisAt(0).ServoOn();
    Profile& profile = ChangeState(core).profiles[0];
    profile.mode = ProfileMode::kTrap;
    profile.trap.parameters = {2, 2, 0, 0};
    profile.trap.velocity = 20;
    profile.trap.target = 1003;
    core.ProfileAt(0).Start();
  }
  double motor() const { return core.state().plants[0].position; }
  bool moving() const { return core.state().profiles[0].now.moving; }
  void Ticks(int count) {
    for (int i = 0; i < count; ++i) core.Tick();
  }

  MotionCore core{{.axis_count = 4, .cycle_us = 1000}};
};

/// The swing that is left when the drive has stopped.
double Residual(size_t count, double k, double half_period_ms, double zeta) {
  Move move(count, k);
  Mechanism mechanism(half_period_ms, zeta);
  while (move.moving() || !move.core.ShaperSettled(0)) {
    move.core.Tick();
    mechanism.Advance(move.motor());
  }
  EXPECT_EQ(move.motor(), 1003);
  return mechanism.Amplitude(1003);
}

TEST(InputShaper, LeavesAMatchingMechanismAtRest) {
  for (const double zeta : {0.0, 0.02, 0.1, 0.3}) {
    for (const size_t half_period : {size_t{13}, size_t{37}, size_t{60}}) {
      const double k = std::exp(-zeta * std::numbers::pi / std::sqrt(1 - zeta * zeta));
      const auto half = static_cast<double>(half_period);
      const double without = Residual(0, 0, half, zeta);
      EXPECT_GT(without, 1e-3);
      EXPECT_LT(Residual(half_period, k, half, zeta), 1e-3 * without) << zeta << half_period;
    }
  }
}

TEST(InputShaper, LeavesAnotherMechanismSwinging) {
  EXPECT_GT(Residual(20, 1, 37, 0), 0.05 * Residual(0, 0, 37, 0));
  EXPECT_GT(Residual(37, 0.3, 37, 0), 0.05 * Residual(0, 0, 37, 0));
}

// --- An axis with a shaper
// ------------------------------------------------------------------------

TEST(ShapedAxis, PlansAsBeforeAndItsMotorFollowsTheShapedCommand) {
  constexpr int kCount = 12;
  Move plain(0, 0);
  Move shaped(kCount, 0.5);
  std::vector<double> planned(kCount, 0.0);
  for (int i = 0; i < 150; ++i) {
    plain.core.Tick();
    shaped.core.Tick();
    planned.push_back(plain.motor());
    const MotionState& state = shaped.core.state();
    EXPECT_EQ(state.profiles[0].now.position, plain.core.state().profiles[0].now.position);
    EXPECT_EQ(state.axes[0].profile.position, plain.core.state().axes[0].profile.position);
    const double expected = (planned.back() + 0.5 * planned[static_cast<size_t>(i)]) / 1.5;
    EXPECT_NEAR(shaped.motor(), expected, 1e-9) << i;
    EXPECT_EQ(state.steps[0].position, shaped.motor());
  }
  EXPECT_EQ(shaped.motor(), 1003);
  EXPECT_EQ(shaped.core.state().encoders[0].position, 1003);
}

TEST(ShapedAxis, OutputsTheRestOfAnAbruptStop) {
  Move move(20, 1);
  move.Ticks(30);
  move.core.ProfileAt(0).Stop(true);
  move.Ticks(2);
  ASSERT_FALSE(move.moving());
  const double end = move.core.state().profiles[0].now.position;
  EXPECT_LT(move.motor(), end - 10);
  move.Ticks(18);
  EXPECT_FALSE(move.core.ShaperSettled(0));
  move.Ticks(2);
  EXPECT_TRUE(move.core.ShaperSettled(0));
  EXPECT_EQ(move.motor(), end);
}

TEST(ShapedAxis, IsInPositionWhenItHasPassedTheWholeMotion) {
  Move move(20, 1);
  Axis& axis = ChangeState(move.core).axes[0];
  axis.band = 1000;
  axis.band_set = true;
  while (move.moving()) move.core.Tick();
  EXPECT_FALSE(axis.in_position);
  move.Ticks(20);
  EXPECT_TRUE(axis.in_position);
}

TEST(ShapedAxis, HasNoFollowingErrorFromIt) {
  Move move(500, 1);
  move.core.ControlAt(0).SetErrorLimit(5);
  move.Ticks(60);
  EXPECT_LT(move.motor(), move.core.state().profiles[0].now.position - 100);
  EXPECT_FALSE(move.core.FollowingErrorExceeded(0));
  EXPECT_EQ(move.core.Conditions(0) & kFollowingErrorBit, 0u);
}

TEST(ShapedAxis, StaysWhereItIsWhenItIsEnabledAgain) {
  for (const bool closed : {false, true}) {
    Move move(40, 1);
    if (closed) move.core.AxisAt(0).SetClosedLoop(true);
    move.Ticks(30);
    const double motor = move.motor();
    move.core.AxisAt(0).ServoOff();
    EXPECT_TRUE(move.core.ShaperSettled(0));
    move.Ticks(closed ? 5 : 1);
    EXPECT_TRUE(move.core.ShaperSettled(0));
    if (closed) {
      move.core.AxisAt(0).ServoOn();
      move.Ticks(50);
      EXPECT_NEAR(move.motor(), motor, 1);
    } else {
      EXPECT_EQ(move.motor(), motor);
      EXPECT_EQ(move.core.state().steps[0].position, move.core.state().axes[0].profile.position);
    }
  }
}

TEST(ShapedAxis, RenamingItsPositionsMovesNothing) {
  Move move(40, 1);
  MotionCore& core = move.core;
  while (move.moving()) core.Tick();
  move.Ticks(10);
  const double motor = move.motor();
  ASSERT_LT(motor, 1000);
  // The rest of the motion is output, whatever the positions are called.
  core.ProfileAt(0).SetPosition(5);
  core.AxisAt(0).SynchPosition();
  EXPECT_EQ(move.motor(), motor);
  EXPECT_FALSE(core.ShaperSettled(0));
  move.Ticks(30);
  EXPECT_TRUE(core.ShaperSettled(0));
  EXPECT_NEAR(move.motor(), 1003, 1e-9);
  EXPECT_EQ(core.state().axes[0].profile.position, 5);
}

TEST(ShapedAxis, EndsItsMotionWhereItIsCalledZero) {
  for (const bool closed : {false, true}) {
    Move move(40, 1);
    MotionCore& core = move.core;
    if (closed) {
      core.AxisAt(0).SetClosedLoop(true);
      core.AxisAt(0).ServoOn();
    }
    while (move.moving()) core.Tick();
    move.Ticks(10);
    const double motor = move.motor();
    core.AxisAt(0).ZeroPosition();
    EXPECT_TRUE(core.ShaperSettled(0));
    move.Ticks(50);
    EXPECT_NEAR(move.motor(), motor, 1e-9);
    EXPECT_EQ(core.state().axes[0].profile.position, 0);
    EXPECT_EQ(core.state().axes[0].encoder.position, 0);
    EXPECT_TRUE(core.ShaperSettled(0));
  }
}

TEST(ShapedAxis, ShapesBacklashAndSettlesExactly) {
  Move move(16, 0.75);
  move.core.AxisAt(0).SetBacklash({30, 0, true});
  while (move.moving()) move.core.Tick();
  move.Ticks(16);
  EXPECT_TRUE(move.core.ShaperSettled(0));
  EXPECT_EQ(move.motor(), 1033);
}

TEST(ShapedAxis, FeedsTheShapedVelocityForward) {
  // With velocity feed forward alone a velocity drive follows as well as without a shaper.
  const auto worst = [](size_t count) {
    Move move(count, 0.8);
    move.core.ConnectDrive(0, VelocityDrive(100, 0, 0, 0.125));
    ChangeState(move.core).controls[0].sets[0] = {.kp = 2, .kvff = 327.67};
    move.core.AxisAt(0).SetClosedLoop(true);
    move.core.AxisAt(0).ServoOn();
    move.core.ProfileAt(0).Start();
    double error = 0;
    for (int i = 0; i < 200; ++i) {
      move.core.Tick();
      const double commanded = move.core.readings().CommandedPosition(0);
      error = std::max(error, std::fabs(commanded - move.core.state().axes[0].encoder.position));
    }
    return error;
  };
  EXPECT_LE(worst(25), worst(0) + 1);
}

TEST(ShapedAxis, OnABusSendsTheShapedCommandToItsDrive) {
  constexpr int kCount = 40;
  bus::BusCard card({bus::FullDrive(0)}, {.axis_count = 4, .cycle_us = 1000});
  card.Power();
  card.Enable();
  card.core.AxisAt(0).SetInputShaper(kCount, 0.5);
  Profile& profile = ChangeState(card.core).profiles[0];
  profile.mode = ProfileMode::kTrap;
  profile.trap.parameters = {2, 2, 0, 0};
  profile.trap.velocity = 20;
  profile.trap.target = 1003;
  card.core.ProfileAt(0).Start();
  std::vector<double> planned(kCount, 0.0);
  for (int i = 0; i < 150; ++i) {
    card.Ticks(1);
    planned.push_back(profile.now.position);
    // The target is sent in whole counts, and the drive moves to it in the same cycle.
    const double shaped = (planned.back() + 0.5 * planned[static_cast<size_t>(i)]) / 1.5;
    EXPECT_NEAR(card.motor().position, shaped, 0.5 + 1e-9) << i;
  }
  EXPECT_EQ(card.motor().position, 1003);
  EXPECT_EQ(card.encoder(), 1003);
  EXPECT_TRUE(card.core.ShaperSettled(0));
}

TEST(ShapedAxis, OnABusStaysWhereItIsWhenItIsEnabledAgain) {
  bus::BusCard card({bus::FullDrive(0)}, {.axis_count = 4, .cycle_us = 1000});
  card.Power();
  card.Enable();
  card.core.AxisAt(0).SetInputShaper(40, 1);
  Profile& profile = ChangeState(card.core).profiles[0];
  profile.mode = ProfileMode::kJog;
  profile.jog.velocity = 10;
  card.core.ProfileAt(0).Start();
  card.Ticks(30);
  card.core.AxisAt(0).ServoOff();
  card.core.ProfileAt(0).Stop(true);
  card.Ticks(5);
  const double motor = card.motor().position;
  card.core.AxisAt(0).ServoOn();
  card.Ticks(60);
  EXPECT_NEAR(card.motor().position, motor, 1);
}

TEST(ShapedAxis, OfAGantryMovesAsTheOtherIfThatIsShapedLikeIt) {
  Move move(30, 0.7);
  MotionCore& core = move.core;
  move.Ticks(200);
  core.AxisAt(1).SetInputShaper(30, 0.7);
  core.AxisAt(1).ServoOn();
  core.EnableGantry(0, 1, 0, 0);
  const double slave = core.state().plants[1].position;
  ChangeState(core).profiles[0].trap.target = -500;
  core.ProfileAt(0).Start();
  for (int i = 0; i < 200; ++i) {
    core.Tick();
    ASSERT_NEAR(core.state().plants[1].position - slave, move.motor() - 1003, 1e-9) << i;
  }
  EXPECT_EQ(move.motor(), -500);
  EXPECT_EQ(core.GantrySkew(), 0);
}

TEST(ShapedAxis, ForgetsEverythingAtReset) {
  Move move(40, 1);
  move.Ticks(30);
  const double motor = move.motor();
  move.core.Reset();
  EXPECT_FALSE(move.core.state().shapers);
  move.Ticks(100);
  EXPECT_EQ(move.motor(), motor);
}

// --- The state
// ------------------------------------------------------------------------------------

TEST(ShapedAxis, IsPartOfTheHashOnlyWhileItIsOn) {
  MotionCore core({.axis_count = 4});
  const uint64_t plain = core.Hash();
  core.AxisAt(1).SetInputShaper(0, 0);
  EXPECT_EQ(core.Hash(), plain);
  std::vector<uint64_t> hashes = {plain};
  const struct {
    size_t axis, count;
    double k;
  } cases[] = {{0, 2, 1}, {1, 2, 1}, {1, 3, 1}, {1, 3, 0.5}};
  for (const auto& c : cases) {
    for (size_t axis = 0; axis < 2; ++axis) core.AxisAt(axis).SetInputShaper(0, 0);
    core.AxisAt(c.axis).SetInputShaper(c.count, c.k);
    for (const uint64_t other : hashes) EXPECT_NE(core.Hash(), other);
    hashes.push_back(core.Hash());
  }
  core.AxisAt(1).SetInputShaper(0, 0);
  EXPECT_EQ(core.Hash(), plain);
}

TEST(ShapedAxis, GoesOnFromASnapshot) {
  Move move(40, 0.9);
  move.Ticks(30);
  const MotionState snapshot = move.core.state();
  move.Ticks(45);
  const uint64_t hash = move.core.Hash();
  move.Ticks(100);
  ChangeState(move.core) = snapshot;
  move.Ticks(45);
  EXPECT_EQ(move.core.Hash(), hash);
}

TEST(ShapedAxis, IsTheSameInManyCyclesAtOnce) {
  Move ticks(40, 0.9);
  Move cycles(40, 0.9);
  ticks.Ticks(150);
  cycles.core.Advance(150);
  EXPECT_EQ(ticks.core.Hash(), cycles.core.Hash());
}

}  // namespace
}  // namespace oncard::motion
