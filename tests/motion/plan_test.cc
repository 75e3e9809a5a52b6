// Plans in closed form: their pieces, and the samples between and after them.
#include "motion/profiles/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace oncard::motion {
namespace {

constexpr double kPlanExact = 1e-9;

struct ExpectedPiece {
  double duration;
  double velocity;  ///< at its beginning
  double acceleration;
};

void ExpectPieces(const Plan& plan, const std::vector<ExpectedPiece>& expected) {
  ASSERT_EQ(plan.count, expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(plan.pieces[i].duration, expected[i].duration, 1e-4) << "piece " << i;
    EXPECT_NEAR(plan.pieces[i].velocity, expected[i].velocity, 1e-4) << "piece " << i;
    EXPECT_NEAR(plan.pieces[i].acceleration, expected[i].acceleration, kPlanExact) << "piece " << i;
  }
}

/// The pieces are continuous in position and velocity, except for the first and last velocity.
void ExpectContinuous(const Plan& plan, double position, double target) {
  double p = position;
  for (uint32_t i = 0; i < plan.count; ++i) {
    const Piece& piece = plan.pieces[i];
    EXPECT_GT(piece.duration, 0);
    EXPECT_NEAR(piece.position, p, 1e-6 * (1 + std::fabs(p)));
    p = piece.PositionAt(piece.duration);
    if (i + 1 < plan.count) {
      EXPECT_NEAR(plan.pieces[i + 1].velocity, piece.VelocityAt(piece.duration), 1e-6);
    }
  }
  EXPECT_NEAR(p, target, 1e-6 * (1 + std::fabs(target)));
  EXPECT_EQ(plan.end_position, target);
}

constexpr MoveLimits kExample71 = {.velocity = 50, .acceleration = 0.25, .deceleration = 0.125};

// --- From rest ---------------------------------------------------------------------------------

TEST(PlanToPosition, ATrapezoidRisesCruisesAndFalls) {
  // 50 / 0.25 = 200 ms over 5000 pulses; 50 / 0.125 = 400 ms over 10000; 35000 / 50 = 700 ms.
  const Plan plan = PlanToPosition(0, 0, 50000, kExample71);
  ExpectPieces(plan, {{200, 0, 0.25}, {700, 50, 0}, {400, 50, -0.125}});
  EXPECT_NEAR(plan.duration, 1300, kPlanExact);
  ExpectContinuous(plan, 0, 50000);
}

TEST(PlanToPosition, ANegativeMoveMirrorsAPositiveOne) {
  const Plan plan = PlanToPosition(100, 0, -49900, kExample71);
  ExpectPieces(plan, {{200, 0, -0.25}, {700, -50, 0}, {400, -50, 0.125}});
  ExpectContinuous(plan, 100, -49900);
}

TEST(PlanToPosition, AShortMoveIsATriangle) {
  // v^2 = 2 * 0.25 * 0.125 * 1000 / 0.375 = 500 / 3.
  const double peak = std::sqrt(500.0 / 3);
  const Plan plan = PlanToPosition(0, 0, 1000, kExample71);
  ExpectPieces(plan, {{peak / 0.25, 0, 0.25}, {peak / 0.125, peak, -0.125}});
  ExpectContinuous(plan, 0, 1000);
}

TEST(PlanToPosition, AMoveThatJustReachesItsVelocityDoesNotCruise) {
  const Plan plan = PlanToPosition(0, 0, 15000, kExample71);
  EXPECT_NEAR(plan.duration, 600, kPlanExact);
  EXPECT_NEAR(plan.At(200).velocity, 50, kPlanExact);
}

TEST(PlanToPosition, NothingMovesAtTheTargetOrWithoutVelocity) {
  EXPECT_EQ(PlanToPosition(7, 0, 7, kExample71).count, 0u);
  const Plan still = PlanToPosition(7, 0, 9, {.acceleration = 1, .deceleration = 1});
  EXPECT_EQ(still.count, 0u);
  EXPECT_EQ(still.end_position, 7);
}

// --- Start velocity ----------------------------------------------------------------------------

TEST(PlanToPosition, AStartVelocityIsReachedAndLeftAtOnce) {
  // (50 - 10) / 0.25 = 160 ms over (2500 - 100) / 0.5 = 4800; 320 ms over 9600; 35600 / 50 = 712.
  MoveLimits limits = kExample71;
  limits.start_velocity = 10;
  const Plan plan = PlanToPosition(0, 0, 50000, limits);
  ExpectPieces(plan, {{160, 10, 0.25}, {712, 50, 0}, {320, 50, -0.125}});
  ExpectContinuous(plan, 0, 50000);
}

TEST(PlanToPosition, AStartVelocityAboveTheVelocityIsTheVelocity) {
  MoveLimits limits = kExample71;
  limits.start_velocity = 80;
  ExpectPieces(PlanToPosition(0, 0, 50000, limits), {{1000, 50, 0}});
}

TEST(PlanToPosition, AShortMoveWithAStartVelocityPeaksAboveIt) {
  // v^2 = (2 * 0.25 * 0.125 * 10 + 100 * 0.375) / 0.375 = 100 + 5/3.
  MoveLimits limits = kExample71;
  limits.start_velocity = 10;
  const double peak = std::sqrt(100 + 5.0 / 3);
  const Plan plan = PlanToPosition(0, 0, 10, limits);
  ExpectPieces(plan, {{(peak - 10) / 0.25, 10, 0.25}, {(peak - 10) / 0.125, peak, -0.125}});
  ExpectContinuous(plan, 0, 10);
}

TEST(PlanToPosition, ReplanningTheSameMoveWithAStartVelocityDoesNotTurnBack) {
  // 100 ms before the end: v = 10 + 12.5, distance (506.25 - 100) / 0.25.
  MoveLimits limits = kExample71;
  limits.start_velocity = 10;
  const Plan plan = PlanToPosition(50000 - 1625, 22.5, 50000, limits);
  ExpectPieces(plan, {{100, 22.5, -0.125}});
  ExpectContinuous(plan, 50000 - 1625, 50000);
}

// --- In motion ---------------------------------------------------------------------------------

TEST(PlanToPosition, InMotionItGoesOnAsTheNewRegistersSay) {
  // Example 7-1 at 500 ms: 20000 pulses, 50 pulse/ms.
  MoveLimits slower = kExample71;
  slower.velocity = 25;
  MoveLimits faster = kExample71;
  faster.velocity = 75;
  struct {
    const char* name;
    double target;
    MoveLimits limits;
    std::vector<ExpectedPiece> pieces;
  } const cases[] = {
      {"the same target", 50000, kExample71, {{400, 50, 0}, {400, 50, -0.125}}},
      {"extended", 80000, kExample71, {{1000, 50, 0}, {400, 50, -0.125}}},
      {"shortened", 30010, kExample71, {{0.2, 50, 0}, {400, 50, -0.125}}},
      {"shortened as far as it can be", 30000, kExample71, {{400, 50, -0.125}}},
      // Deceleration 25 / 0.125 = 200 ms over 7500; the last one 200 ms over 2500; 20000 / 25 = 800
      // ms.
      {"slower", 50000, slower, {{200, 50, -0.125}, {800, 25, 0}, {200, 25, -0.125}}},
      // Acceleration 100 ms over 6250; deceleration 600 ms over 22500; 1250 / 75 remain.
      {"faster", 50000, faster, {{100, 50, 0.25}, {1250 / 75.0, 75, 0}, {600, 75, -0.125}}},
      // Stops at 30000, then a triangle over 1000 backwards.
      {"too far already",
       29000,
       kExample71,
       {{400, 50, -0.125},
        {std::sqrt(500.0 / 3) / 0.25, 0, -0.25},
        {std::sqrt(500.0 / 3) / 0.125, -std::sqrt(500.0 / 3), 0.125}}},
      // Stops at 30000, then 30000 backwards: 200, 300 and 400 ms.
      {"reversed",
       0,
       kExample71,
       {{400, 50, -0.125}, {200, 0, -0.25}, {300, -50, 0}, {400, -50, 0.125}}},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.name);
    const Plan plan = PlanToPosition(20000, 50, c.target, c.limits);
    ExpectPieces(plan, c.pieces);
    ExpectContinuous(plan, 20000, c.target);
  }
}

TEST(PlanToPosition, AFasterMoveThatIsTooShortPeaksBelowItsVelocity) {
  // v^2 = (2 * 0.25 * 0.125 * 12000 + 0.125 * 2500) / 0.375.
  MoveLimits faster = kExample71;
  faster.velocity = 75;
  const double peak = std::sqrt((0.0625 * 12000 + 312.5) / 0.375);
  const Plan plan = PlanToPosition(20000, 50, 32000, faster);
  ExpectPieces(plan, {{(peak - 50) / 0.25, 50, 0.25}, {peak / 0.125, peak, -0.125}});
  ExpectContinuous(plan, 20000, 32000);
}

TEST(PlanToPosition, AVelocityOfZeroInMotionStops) {
  const Plan plan = PlanToPosition(0, 10, 5000, {.acceleration = 1, .deceleration = 0.5});
  ExpectPieces(plan, {{20, 10, -0.5}});
  EXPECT_NEAR(plan.end_position, 100, kPlanExact);
}

TEST(PlanToPosition, RandomMovesUseTheirLimitsAndNothingElse) {
  // Conditions for the fastest plan: it only accelerates at acc, only decelerates at dec, and
  // cruises only at the velocity limit.
  constexpr unsigned kSeed = 20240611;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int run = 0; run < 20000; ++run) {
    const MoveLimits limits = {draw(0.5, 100), draw(0.01, 2), draw(0.01, 2), 0};
    const double position = std::round(draw(-1e6, 1e6));
    const double velocity = run % 3 == 0 ? 0 : draw(-120, 120);
    const double target = position + std::round(run % 2 == 0 ? draw(-2e5, 2e5) : draw(-300, 300));
    const Plan plan = PlanToPosition(position, velocity, target, limits);
    ExpectContinuous(plan, position, target);
    if (plan.count > 0) {
      EXPECT_NEAR(plan.pieces[0].velocity, velocity, 1e-12);
      const Piece& last = plan.pieces[plan.count - 1];
      EXPECT_NEAR(last.VelocityAt(last.duration), 0, 1e-6);
    }
    for (uint32_t i = 0; i < plan.count; ++i) {
      const Piece& piece = plan.pieces[i];
      const double middle = piece.VelocityAt(piece.duration / 2);
      if (piece.acceleration == 0) {
        EXPECT_NEAR(std::fabs(middle), limits.velocity, 1e-9);
      } else if (piece.acceleration * middle > 0) {
        EXPECT_NEAR(std::fabs(piece.acceleration), limits.acceleration, 1e-12);
        EXPECT_LE(std::fabs(piece.VelocityAt(piece.duration)), limits.velocity + 1e-6);
      } else {
        EXPECT_NEAR(std::fabs(piece.acceleration), limits.deceleration, 1e-12);
      }
    }
    if (HasFailure()) {
      ADD_FAILURE() << "run " << run << ": p " << position << " v " << velocity << " to " << target;
      return;
    }
  }
}

// --- Velocity and stop -------------------------------------------------------------------------

TEST(PlanToVelocity, GrowsWithAccelerationAndShrinksWithDeceleration) {
  struct {
    double from;
    double to;
    std::vector<ExpectedPiece> pieces;
  } const cases[] = {
      {0, 10, {{20, 0, 0.5}}},
      {0, -10, {{20, 0, -0.5}}},
      {4, 10, {{12, 4, 0.5}}},
      {10, 4, {{24, 10, -0.25}}},
      {-10, -4, {{24, -10, 0.25}}},
      {10, 0, {{40, 10, -0.25}}},
      {-10, 0, {{40, -10, 0.25}}},
      {10, -10, {{40, 10, -0.25}, {20, 0, -0.5}}},
      {-10, 10, {{40, -10, 0.25}, {20, 0, 0.5}}},
      {10, 10, {}},
      {0, 0, {}},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(std::to_string(c.from) + " to " + std::to_string(c.to));
    const Plan plan = PlanToVelocity(100, c.from, c.to,
                                     {.velocity = 10, .acceleration = 0.5, .deceleration = 0.25});
    ExpectPieces(plan, c.pieces);
    const Sample later = plan.At(plan.duration + 8);
    EXPECT_EQ(later.velocity, c.to);
    EXPECT_NEAR(later.position, plan.At(plan.duration).position + 8 * c.to, kPlanExact);
    EXPECT_EQ(later.moving, c.to != 0);
  }
}

TEST(PlanStop, DeceleratesToRest) {
  const Plan plan = PlanStop(20000, 50, 1);
  EXPECT_EQ(plan.duration, 50);
  EXPECT_EQ(plan.At(25).velocity, 25);
  EXPECT_EQ(plan.At(25).position, 20937.5);
  EXPECT_EQ(plan.At(25).acceleration, -1);
  EXPECT_EQ(plan.At(50), AtRest(21250));
  EXPECT_EQ(PlanStop(0, -50, 1000).end_position, -1.25);
  EXPECT_EQ(PlanStop(5, 0, 1).count, 0u);
}

// --- Sampling ----------------------------------------------------------------------------------

TEST(PlanAt, GivesEveryPieceItsOwnInstants) {
  const Plan plan = PlanToPosition(0, 0, 50000, kExample71);
  struct {
    double t, position, velocity, acceleration;
  } const cases[] = {{0, 0, 0, 0.25},
                     {100, 1250, 25, 0.25},
                     {200, 5000, 50, 0},
                     {550, 22500, 50, 0},
                     {900, 40000, 50, -0.125},
                     {1100, 47500, 25, -0.125},
                     {1299, 49999.9375, 0.125, -0.125}};
  for (const auto& c : cases) {
    const Sample sample = plan.At(c.t);
    EXPECT_NEAR(sample.position, c.position, kPlanExact) << c.t;
    EXPECT_NEAR(sample.velocity, c.velocity, kPlanExact) << c.t;
    EXPECT_EQ(sample.acceleration, c.acceleration) << c.t;
    EXPECT_TRUE(sample.moving) << c.t;
  }
  EXPECT_EQ(plan.At(1300), AtRest(50000));
  EXPECT_EQ(plan.At(1e9), AtRest(50000));
}

TEST(PlanAt, APlanWithoutPiecesRests) { EXPECT_EQ(Plan().At(0), AtRest(0)); }

}  // namespace
}  // namespace oncard::motion
