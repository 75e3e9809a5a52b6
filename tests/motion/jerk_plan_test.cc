// Plans of constant jerk: tables from exact arithmetic, and properties of random plans.
#include "motion/profiles/jerk_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace oncard::motion {
namespace {

// --- From rest ---------------------------------------------------------------------------------

struct SampleAt {
  double t, position, velocity, acceleration;
};

void ExpectRows(const JerkPlan& plan, double tolerance, const std::vector<SampleAt>& rows) {
  for (const SampleAt& row : rows) {
    const Sample sample = plan.At(row.t);
    EXPECT_NEAR(sample.position, row.position, tolerance * (1 + std::fabs(row.position))) << row.t;
    EXPECT_NEAR(sample.velocity, row.velocity, tolerance * (1 + std::fabs(row.velocity))) << row.t;
    EXPECT_NEAR(sample.acceleration, row.acceleration, tolerance) << row.t;
  }
}

constexpr JerkLimits kSeven = {.velocity = 50, .acceleration = 0.5, .jerk = 0.01};

TEST(JerkPlanToPosition, AMoveHasSevenPhases) {
  // 50 ms for each change of the acceleration and 50 ms with it: a ramp of 150 ms over 3750 pulses.
  const JerkPlan plan = PlanToPosition(AtRest(0), 20000, kSeven);
  EXPECT_EQ(plan.count, 7u);
  EXPECT_DOUBLE_EQ(plan.duration, 550);
  ExpectRows(plan, 1e-12,
             {{0, 0, 0, 0},
              {25, 26 + 1.0 / 24, 3.125, 0.25},
              {50, 208 + 1.0 / 3, 12.5, 0.5},
              {75, 677 + 1.0 / 12, 25, 0.5},
              {100, 1458 + 1.0 / 3, 37.5, 0.5},
              {125, 2526 + 1.0 / 24, 46.875, 0.25},
              {150, 3750, 50, 0},
              {275, 10000, 50, 0},
              {400, 16250, 50, 0},
              {450, 18541 + 2.0 / 3, 37.5, -0.5},
              {525, 19973 + 23.0 / 24, 3.125, -0.25},
              {549, 20000 - 1.0 / 600, 0.005, -0.01}});
  EXPECT_EQ(plan.At(550), AtRest(20000));
  EXPECT_EQ(plan.At(1e9), AtRest(20000));
}

TEST(JerkPlanToPosition, ALowVelocityLeavesNoTimeForTheLargestAcceleration) {
  // Example 5-2 of the GE manual: 166.7 pulse/ms, whose square root over the jerk is 408.29 ms.
  const JerkPlan plan =
      PlanToPosition(AtRest(0), 200000, {.velocity = 166.7, .acceleration = 4, .jerk = 0.001});
  EXPECT_EQ(plan.count, 5u);
  const double rise = std::sqrt(166700.0);
  EXPECT_NEAR(plan.duration, 2 * rise + 200000 / 166.7, 1e-9);
  EXPECT_NEAR(plan.duration, 2016.338, 1e-3);
  ExpectRows(plan, 1e-9,
             {{rise, rise * rise * rise * 0.001 / 6, 166.7 / 2, rise * 0.001},
              {2 * rise, 166.7 * rise, 166.7, 0},
              {1000, 166.7 * (1000 - rise), 166.7, 0}});
}

TEST(JerkPlanToPosition, AMoveThatIsTooShortPeaksBelowItsVelocity) {
  struct {
    const char* name;
    double distance, peak, duration;
    size_t pieces;
  } const cases[] = {
      // v (v / 0.5 + 50) = 5000.
      {"with the largest acceleration", 5000, 0.25 * (std::sqrt(42500.0) - 50),
       std::sqrt(42500.0) + 50, 6},
      // v^3 = 1000^2 * 0.01 / 4.
      {"without", 1000, std::cbrt(2500.0), 4 * std::cbrt(50000.0), 4},
      // 2 * 0.5^3 / 0.01^2: it just reaches the largest acceleration.
      {"between them", 2500, 25, 200, 4},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    const JerkPlan plan = PlanToPosition(AtRest(100), 100 + c.distance, kSeven);
    EXPECT_NEAR(plan.duration, c.duration, 1e-9);
    EXPECT_NEAR(plan.At(plan.duration / 2).velocity, c.peak, 1e-9);
    EXPECT_NEAR(plan.At(plan.duration / 2).position, 100 + c.distance / 2, 1e-9);
    EXPECT_EQ(plan.At(plan.duration), AtRest(100 + c.distance));
  }
}

TEST(JerkPlanToPosition, Example41OfTheGt400ManualDoesNotReachItsVelocity) {
  // In sample times: 4 (80000 / 4e-8)^(1/3), a quarter of which for each phase.
  const JerkPlan plan =
      PlanToPosition(AtRest(0), 80000, {.velocity = 4, .acceleration = 0.004, .jerk = 2e-8});
  const double phase = std::cbrt(2e12);
  EXPECT_NEAR(plan.duration, 4 * phase, 1e-6);
  EXPECT_NEAR(plan.duration, 50396.842, 1e-3);
  ExpectRows(plan, 1e-9,
             {{phase, 80000.0 / 12, 1e-8 * phase * phase, 2e-8 * phase},
              {12599, 2e-8 / 6 * 12599 * 12599 * 12599, 1e-8 * 12599 * 12599, 2e-8 * 12599},
              {2 * phase, 40000, 2e-8 * phase * phase, 0},
              {3 * phase, 80000 - 80000.0 / 12, 1e-8 * phase * phase, -2e-8 * phase}});
}

TEST(JerkPlanToPosition, NothingMovesAtTheTargetOrWithoutVelocity) {
  EXPECT_EQ(PlanToPosition(AtRest(7), 7, kSeven).count, 0u);
  const JerkPlan still = PlanToPosition(AtRest(7), 9, {.acceleration = 1, .jerk = 1});
  EXPECT_EQ(still.count, 0u);
  EXPECT_EQ(still.At(0), AtRest(7));
}

// --- In motion ---------------------------------------------------------------------------------

TEST(JerkPlanToPosition, InTheRampATargetTooNearIsPassedAndComeBackTo) {
  // The smooth stop from (45.5, 0.3): 30 ms over 1455 pulses to 50, 150 ms over 3750 to rest. From
  // 7500 back over 1500: 4 (1500 / 0.02)^(1/3) ms.
  const JerkPlan plan = PlanToPosition({2295, 45.5, 0.3, true}, 6000, kSeven);
  EXPECT_NEAR(plan.At(30).velocity, 50, 1e-12);
  EXPECT_NEAR(plan.At(30).acceleration, 0, 1e-12);
  EXPECT_NEAR(plan.At(180).position, 7500, 1e-9);
  EXPECT_NEAR(plan.duration, 180 + 4 * std::cbrt(75000.0), 1e-9);
  EXPECT_EQ(plan.At(plan.duration), AtRest(6000));
  // Rows of another implementation of the rule.
  ExpectRows(plan, 1e-7,
             {{21.7929083, 3340.56675, 49.6632182, 0.0820709168},
              {108.964542, 6918.10081, 23.0177292, -0.5},
              {152.550358, 7465.52861, 3.76741417, -0.274496418},
              {196.136175, 7492.99754, -1.30188069, -0.161361748},
              {239.721991, 7163.00025, -14.7534306, -0.246212751},
              {326.893625, 6017.25021, -2.37465426, 0.217929083}});
}

TEST(JerkPlanToPosition, InTheCruiseATargetTooNearIsPassedAndComeBackTo) {
  // 150 ms to rest at 10500, and 2500 back in 200 ms.
  const JerkPlan plan = PlanToPosition({6750, 50, 0, true}, 8000, kSeven);
  EXPECT_NEAR(plan.At(150).position, 10500, 1e-9);
  EXPECT_NEAR(plan.At(250).velocity, -25, 1e-9);
  EXPECT_NEAR(plan.duration, 350, 1e-9);
}

TEST(JerkPlanToPosition, InMotionItGoesOnAsTheNewValuesSay) {
  JerkLimits slower = kSeven;
  slower.velocity = 25;
  JerkLimits gentler = kSeven;
  gentler.jerk = 0.005;
  struct {
    const char* name;
    Sample from;
    double target;
    JerkLimits limits;
    double duration;
  } const cases[] = {
      {"the same target", {3750, 50, 0, true}, 20000, kSeven, 400},
      {"further", {3750, 50, 0, true}, 30000, kSeven, 600},
      {"as near as can be", {3750, 50, 0, true}, 7500, kSeven, 150},
      // From 50 to 25: 100 ms over 3750; to rest: 100 ms over 1250.
      {"slower", {0, 50, 0, true}, 6250, slower, 100 + 50 + 100},
      // To rest: 100 + 100 ms over 5000.
      {"with less jerk", {0, 50, 0, true}, 10000, gentler, 300},
      // To rest: 150 ms over 3750; 20000 back: 550 ms.
      {"backwards", {0, 50, 0, true}, -16250, kSeven, 700},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    const JerkPlan plan = PlanToPosition(c.from, c.target, c.limits);
    EXPECT_NEAR(plan.duration, c.duration, 1e-9);
    EXPECT_EQ(plan.At(plan.duration), AtRest(c.target));
  }
}

TEST(JerkPlanToPosition, InTheRampToRestATargetFurtherAwayMakesItSlower) {
  // From (46.875, -0.25) a stop takes 2526.04 pulses, and the velocity that is left when the
  // acceleration goes to 0 leads over 4127.6. Between them: 25 + 50 ms over 2526.04 to 25, and
  // 100 ms over 1250 from there.
  const JerkPlan plan = PlanToPosition({0, 46.875, -0.25, true}, 3776 + 1.0 / 24, kSeven);
  EXPECT_NEAR(plan.At(75).velocity, 25, 1e-5);
  EXPECT_NEAR(plan.At(75).acceleration, 0, 1e-5);
  EXPECT_NEAR(plan.duration, 175, 1e-5);
  EXPECT_EQ(plan.At(plan.duration), AtRest(3776 + 1.0 / 24));
}

TEST(JerkPlanToPosition, ReplanningTheSameMoveChangesNothing) {
  for (const double origin : {0.0, 1e9}) {
    for (const double target : {20000.0, 5000.0, 1000.0, 12.0}) {
      const JerkPlan plan = PlanToPosition(AtRest(origin), origin + target, kSeven);
      for (double t = 0; t < plan.duration; t += 0.25) {
        const JerkPlan again = PlanToPosition(plan.At(t), origin + target, kSeven);
        // Positions near 1e9 are known to 1.2e-7 pulses, which takes the time of a short move.
        ASSERT_NEAR(t + again.duration, plan.duration, origin == 0 ? 1e-4 : 0.1)
            << target << ' ' << t;
        ASSERT_GE(again.At(again.duration / 2).velocity, 0) << target << ' ' << t;
      }
    }
  }
}

TEST(JerkPlanToPosition, AVelocityOfZeroInMotionStops) {
  const JerkPlan plan =
      PlanToPosition({0, 50, 0, true}, 99999, {.acceleration = 0.5, .jerk = 0.01});
  EXPECT_NEAR(plan.duration, 150, 1e-9);
  EXPECT_NEAR(plan.At(150).position, 3750, 1e-9);
}

// --- Velocity and stop -------------------------------------------------------------------------

TEST(JerkPlanToVelocity, TheStopOfAMoveMirrorsItsAcceleration) {
  // In the ramp at 70 ms: 50 ms to an acceleration of 0, at 35 pulse/ms; then 50, 20 and 50 ms.
  const JerkPlan plan = PlanToVelocity({558 + 1.0 / 3, 22.5, 0.5, true}, 0, kSeven);
  EXPECT_NEAR(plan.duration, 170, 1e-9);
  ExpectRows(plan, 1e-9,
             {{50, 2100, 35, 0},
              {100, 3641 + 2.0 / 3, 22.5, -0.5},
              {120, 3991 + 2.0 / 3, 12.5, -0.5},
              {170, 4200, 0, 0}});
}

TEST(JerkPlanToVelocity, TheVelocityIsKept) {
  struct {
    Sample from;
    double to, duration;
  } const cases[] = {
      {{0, 0, 0, false}, 50, 150},
      {{0, 0, 0, false}, -50, 150},
      {{0, 10, 0, true}, 35, 100},
      {{0, -10, 0, true}, 15, 100},
      {{0, 10, 0.5, true}, 22.5, 50},
      {{0, 10, 0, true}, 10, 0},
      {{0, 10, 1, true}, 72.5, 50 + 25 + 50},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(std::to_string(c.from.velocity) + " to " + std::to_string(c.to));
    const JerkPlan plan = PlanToVelocity(c.from, c.to, kSeven);
    EXPECT_NEAR(plan.duration, c.duration, 1e-9);
    const Sample later = plan.At(plan.duration + 8);
    EXPECT_EQ(later.velocity, c.to);
    EXPECT_EQ(later.acceleration, 0);
    EXPECT_NEAR(later.position, plan.At(plan.duration).position + 8 * c.to, 1e-9);
    EXPECT_EQ(later.moving, c.to != 0);
  }
}

/// How far a motion gets until it rests, under the law of shortest time: full jerk against the
/// velocity that would be left if the acceleration went to 0 at once.
long double SimulatedStop(long double velocity, long double acceleration, const JerkLimits& limits,
                          long double step) {
  long double position = 0;
  const long double jerk = limits.jerk;
  const long double largest = limits.acceleration;
  while (std::fabs(velocity) > jerk * step || std::fabs(acceleration) > 2 * jerk * step) {
    const long double left = velocity + acceleration * std::fabs(acceleration) / (2 * jerk);
    const long double next =
        std::clamp(acceleration + (left > 0 ? -jerk : jerk) * step, -largest, largest);
    const long double before = velocity;
    velocity += (acceleration + next) / 2 * step;
    position += (before + velocity) / 2 * step;
    acceleration = next;
  }
  return position;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double Draw(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  JerkLimits Limits() { return {Draw(1, 60), Draw(0.1, 2), std::exp(Draw(-6, 0))}; }

 private:
  std::mt19937 engine_;
};

TEST(JerkPlanToVelocity, StopsAsFarAwayAsASimulationInSmallSteps) {
  Random random(20260711);
  for (int run = 0; run < 200; ++run) {
    const JerkLimits limits = random.Limits();
    const double velocity = random.Draw(-60, 60);
    const double acceleration = limits.acceleration * random.Draw(-1, 1);
    const double stop = PlanToVelocity({0, velocity, acceleration, true}, 0, limits).end_position;
    const auto simulated =
        static_cast<double>(SimulatedStop(velocity, acceleration, limits, 1.0L / 256));
    EXPECT_NEAR(stop, simulated, 0.02 + 1e-3 * std::fabs(stop))
        << "v " << velocity << " a " << acceleration << " limits " << limits.velocity << ' '
        << limits.acceleration << ' ' << limits.jerk;
  }
}

// --- Random plans ------------------------------------------------------------------------------

/// A move to be planned, with what its begin may exceed.
struct Move {
  Sample from;
  double target = 0;
  JerkLimits limits;

  std::string Text() const {
    return "p " + std::to_string(from.position) + " v " + std::to_string(from.velocity) + " a " +
           std::to_string(from.acceleration) + " to " + std::to_string(target) + ", limits " +
           std::to_string(limits.velocity) + ' ' + std::to_string(limits.acceleration) + ' ' +
           std::to_string(limits.jerk);
  }
};

Move DrawMove(Random& random, int run) {
  Move move;
  move.limits = random.Limits();
  move.from.position = std::round(random.Draw(-1e5, 1e5));
  if (run % 4 != 0) {
    const double beyond = run % 4 == 1 ? 1.5 : 1;
    move.from.velocity = move.limits.velocity * random.Draw(-beyond, beyond);
    move.from.acceleration = move.limits.acceleration * random.Draw(-beyond, beyond);
    move.from.moving = true;
  }
  const double range = run % 3 == 0 ? 100 : run % 3 == 1 ? 3000 : 30000;
  move.target = move.from.position + std::round(random.Draw(-range, range));
  return move;
}

/// Follows a plan in cycles. The samples alone show the limits: what changes at most by a rate
/// stays close to the chord between two samples.
testing::AssertionResult StaysWithinLimits(const Move& move, const JerkPlan& plan) {
  constexpr double kCycle = 2;
  constexpr double kTolerance = 1e-6;
  const auto& [velocity, acceleration, jerk] = move.limits;
  const double settled =
      move.from.velocity + move.from.acceleration * std::fabs(move.from.acceleration) / (2 * jerk);
  const double fastest = std::max({velocity, std::fabs(move.from.velocity), std::fabs(settled)});
  double steepest = std::max(acceleration, std::fabs(move.from.acceleration));
  const auto fail = [](const char* what, double t) {
    return testing::AssertionFailure() << what << " exceeds its limit at " << t;
  };
  Sample before = plan.At(0);
  for (double t = kCycle; before.moving; t += kCycle) {
    const Sample now = plan.At(t);
    if (std::fabs(now.velocity) > fastest + kTolerance) return fail("velocity", t);
    if (std::fabs(now.acceleration) > steepest + kTolerance) return fail("acceleration", t);
    steepest = std::max(acceleration, std::fabs(now.acceleration));
    const double bend = now.acceleration - before.acceleration;
    if (std::fabs(bend) > jerk * kCycle + kTolerance) return fail("jerk", t);
    const double gained = (before.acceleration + now.acceleration) / 2 * kCycle;
    if (std::fabs(now.velocity - before.velocity - gained) >
        jerk * kCycle * kCycle / 4 + kTolerance) {
      return fail("jump of velocity", t);
    }
    const double moved =
        (before.velocity + now.velocity) / 2 * kCycle - bend / 12 * kCycle * kCycle;
    if (std::fabs(now.position - before.position - moved) >
        jerk * kCycle * kCycle * kCycle / 12 + kTolerance) {
      return fail("jump of position", t);
    }
    before = now;
  }
  return testing::AssertionSuccess();
}

/// The jerks of the pieces alone, integrated with a longer arithmetic, lead to rest at the target.
void ExpectIntegral(const Move& move, const JerkPlan& plan) {
  long double position = move.from.position;
  long double velocity = move.from.velocity;
  long double acceleration = move.from.acceleration;
  for (uint32_t i = 0; i < plan.count; ++i) {
    const long double t = plan.pieces[i].duration;
    const long double jerk = plan.pieces[i].jerk;
    position += t * velocity + t * t / 2 * acceleration + t * t * t / 6 * jerk;
    velocity += t * acceleration + t * t / 2 * jerk;
    acceleration += t * jerk;
  }
  // An error of the acceleration grows with the square of the time.
  const double error = 1e-7 + 1e-15 * plan.duration * plan.duration;
  ASSERT_NEAR(static_cast<double>(position), move.target, error);
  ASSERT_NEAR(static_cast<double>(velocity), 0, 1e-8);
  ASSERT_NEAR(static_cast<double>(acceleration), 0, 1e-9);
}

/// A move cruises at its largest velocity, or does not cruise; it turns back only when it must.
void ExpectNoWaste(const Move& move, const JerkPlan& plan) {
  const double sign = move.target < move.from.position ? -1 : 1;
  const double stop = PlanToVelocity(move.from, 0, move.limits).end_position;
  const bool must_stop = sign * move.from.velocity < 0 || sign * (move.target - stop) < -1e-6;
  for (uint32_t i = 0; i < plan.count; ++i) {
    const JerkPiece& piece = plan.pieces[i];
    if (piece.jerk == 0 && piece.acceleration == 0 && piece.duration > 0.01) {
      ASSERT_EQ(std::fabs(piece.velocity), move.limits.velocity) << "piece " << i;
    }
    const bool backwards = sign * piece.VelocityAt(piece.duration / 2) < -1e-6;
    // An acceleration away from the target can lead to a short way back by itself.
    if (backwards && sign * move.from.acceleration >= 0) {
      ASSERT_TRUE(must_stop) << "piece " << i;
    }
  }
}

TEST(JerkPlanToPosition, RandomMovesKeepTheirLimitsAndEndExactly) {
  constexpr int kMoves = 100000;
  Random random(20240611);
  for (int run = 0; run < kMoves && !testing::Test::HasFailure(); ++run) {
    const Move move = DrawMove(random, run);
    SCOPED_TRACE("run " + std::to_string(run) + ": " + move.Text());
    const JerkPlan plan = PlanToPosition(move.from, move.target, move.limits);
    EXPECT_TRUE(StaysWithinLimits(move, plan));
    ExpectIntegral(move, plan);
    ExpectNoWaste(move, plan);
    EXPECT_EQ(plan.At(plan.duration), AtRest(move.target));
  }
}

TEST(JerkPlanToPosition, RandomMovesFromRestNeverGoBack) {
  Random random(7);
  for (int run = 0; run < 2000; ++run) {
    Move move = DrawMove(random, 0);
    move.target = move.from.position + std::round(random.Draw(1, 30000));
    const JerkPlan plan = PlanToPosition(move.from, move.target, move.limits);
    double before = move.from.position;
    for (double t = 0; t < plan.duration + 1; t += 0.125) {
      const double position = plan.At(t).position;
      ASSERT_GE(position, before) << t << " of " << plan.duration << ": " << move.Text();
      before = position;
    }
    EXPECT_EQ(before, move.target);
  }
}

TEST(JerkPlanToPosition, AMirroredMotionHasTheMirroredPlan) {
  Random random(11);
  for (int run = 0; run < 5000; ++run) {
    Move move = DrawMove(random, run);
    if (run % 5 == 0) move.target = move.from.position;
    const JerkPlan plan = PlanToPosition(move.from, move.target, move.limits);
    const JerkPlan mirrored = PlanToPosition(
        {-move.from.position, -move.from.velocity, -move.from.acceleration, move.from.moving},
        -move.target, move.limits);
    ASSERT_EQ(mirrored.duration, plan.duration) << move.Text();
    for (double t = 0; t <= plan.duration; t += plan.duration / 16 + 1e-3) {
      const Sample sample = plan.At(t);
      ASSERT_EQ(mirrored.At(t),
                (Sample{-sample.position, -sample.velocity, -sample.acceleration, sample.moving}))
          << t << ": " << move.Text();
    }
  }
}

TEST(JerkPlanToVelocity, AMirroredMotionHasTheMirroredPlan) {
  Random random(13);
  for (int run = 0; run < 5000; ++run) {
    const auto& [from, target, limits] = DrawMove(random, run);
    // Also to the velocity that is left when the acceleration goes to 0.
    const double settled =
        from.velocity + from.acceleration * std::fabs(from.acceleration) / (2 * limits.jerk);
    const double to = run % 2 == 0 ? settled : random.Draw(-60, 60);
    const JerkPlan plan = PlanToVelocity(from, to, limits);
    const JerkPlan mirrored =
        PlanToVelocity({-from.position, -from.velocity, -from.acceleration, true}, -to, limits);
    ASSERT_EQ(mirrored.duration, plan.duration) << run;
    ASSERT_EQ(mirrored.end_position, -plan.end_position) << run;
  }
}

TEST(JerkPlanAt, APlanWithoutPiecesRests) { EXPECT_EQ(JerkPlan().At(0), AtRest(0)); }

}  // namespace
}  // namespace oncard::motion
