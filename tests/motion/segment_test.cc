#include "motion/paths/segment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/common/trigonometry.h"

namespace oncard::motion {
namespace {

void ExpectNear(const Coordinates& a, const Coordinates& b, double tolerance = 1e-9) {
  for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "coordinate " << i;
}

TEST(Segment, LinesUseAllCoordinates) {
  const auto line = MakeLine({0, 0, 0, 0}, {1, 2, 4, 10});
  ASSERT_TRUE(line.has_value());
  EXPECT_EQ(line->length, 11);
  ExpectNear(line->PointAt(5.5), {0.5, 1, 2, 5});
  ExpectNear(line->TangentAt(5.5), {1 / 11.0, 2 / 11.0, 4 / 11.0, 10 / 11.0});
  EXPECT_FALSE(MakeLine({1, 2, 3, 4}, {1, 2, 3, 4}).has_value());
}

TEST(Segment, ArcsOfARadius) {
  struct {
    Coordinates start, end;
    double radius;
    bool counter_clockwise;
    double centre_x, centre_y, sweep, length;
  } const cases[] = {{{0, 0}, {100, 100}, 100, false, 100, 0, 90, 157.079633},
                     {{0, 0}, {100, 100}, 100, true, 0, 100, 90, 157.079633},
                     {{0, 0}, {100, 100}, -100, false, 0, 100, 270, 471.238898},
                     {{0, 0}, {100, 100}, -100, true, 100, 0, 270, 471.238898},
                     {{0, 0}, {200, 0}, 100, false, 100, 0, 180, 314.159265},
                     {{0, 0}, {200, 0}, 100, true, 100, 0, 180, 314.159265},
                     {{6000, 12000}, {14000, 20000}, 8000, false, 14000, 12000, 90, 12566.3706}};
  for (const auto& c : cases) {
    const auto arc = MakeArcWithRadius(c.start, c.end, kXyPlane, c.radius, c.counter_clockwise);
    ASSERT_TRUE(arc.has_value());
    EXPECT_NEAR(arc->centre[0], c.centre_x, 1e-6);
    EXPECT_NEAR(arc->centre[1], c.centre_y, 1e-6);
    EXPECT_NEAR(arc->sweep * 180 / kPi, c.sweep, 1e-6);
    EXPECT_NEAR(arc->length, c.length, 1e-4);
    ExpectNear(arc->PointAt(0), c.start);
    EXPECT_EQ(arc->PointAt(arc->length), c.end);
    ExpectNear(arc->PointAt(arc->length * (1 - 1e-12)), c.end, 1e-6);
    // The initial direction is perpendicular to the radius, to the correct side.
    const Coordinates tangent = arc->TangentAt(0);
    const double turn =
        (c.start[0] - c.centre_x) * tangent[1] - (c.start[1] - c.centre_y) * tangent[0];
    EXPECT_EQ(turn > 0, c.counter_clockwise);
  }
}

TEST(Segment, ARadiusMustReach) {
  EXPECT_TRUE(MakeArcWithRadius({0, 0}, {200, 0}, kXyPlane, 99, true).has_value());
  EXPECT_FALSE(MakeArcWithRadius({0, 0}, {200, 0}, kXyPlane, 98.9, true).has_value());
  EXPECT_FALSE(MakeArcWithRadius({0, 0}, {0, 0}, kXyPlane, 10, true).has_value());
  EXPECT_FALSE(MakeArcWithRadius({0, 0}, {20, 0}, kXyPlane, 0, true).has_value());
}

TEST(Segment, ArcsAroundACentre) {
  const auto quarter = MakeArcAroundCentre({100, 0}, {0, 100}, kXyPlane, -100, 0, true);
  ASSERT_TRUE(quarter.has_value());
  EXPECT_NEAR(quarter->sweep, kPi / 2, 1e-12);
  const auto rest = MakeArcAroundCentre({100, 0}, {0, 100}, kXyPlane, -100, 0, false);
  EXPECT_NEAR(rest->sweep, 3 * kPi / 2, 1e-12);
  const auto full = MakeArcAroundCentre({100, 0}, {100, 0}, kXyPlane, -100, 0, false);
  EXPECT_NEAR(full->length, 200 * kPi, 1e-9);
  ExpectNear(full->PointAt(50 * kPi), {0, -100});
  EXPECT_TRUE(MakeArcAroundCentre({100, 0}, {0, 101}, kXyPlane, -100, 0, true).has_value());
  EXPECT_FALSE(MakeArcAroundCentre({100, 0}, {0, 101.5}, kXyPlane, -100, 0, true).has_value());
  EXPECT_FALSE(MakeArcAroundCentre({100, 0}, {0, 100}, kXyPlane, 0, 0, true).has_value());
}

TEST(Segment, ArcsOfASweepEndWhereItLeads) {
  // By hand: the radius is 10 sqrt(2), and 45 degrees + 123 degrees are 168 degrees.
  const double sweep = 123 * kPi / 180;
  const auto arc = MakeArcWithSweep({10, 10}, kXyPlane, -10, -10, sweep, true);
  ASSERT_TRUE(arc.has_value());
  EXPECT_NEAR(arc->length, 30.359700, 1e-6);
  ExpectNear(arc->end, {-13.833096, 2.940315}, 1e-6);
  const auto clockwise = MakeArcWithSweep({0, 10}, kXyPlane, 0, -10, kPi / 2, false);
  ASSERT_TRUE(clockwise.has_value());
  ExpectNear(clockwise->end, {10, 0});
  const auto circle = MakeArcWithSweep({0, 0, 5}, kZxPlane, 3, 4, 2 * kPi, true);
  ASSERT_TRUE(circle.has_value());
  EXPECT_EQ(circle->end, circle->start);
  EXPECT_NEAR(circle->length, 31.415927, 1e-6);
  EXPECT_FALSE(MakeArcWithSweep({1, 1}, kXyPlane, 0, 0, 1, true).has_value());
}

TEST(Segment, AnArcWhoseLengthADoubleCannotTellFromZeroIsNone) {
  EXPECT_FALSE(MakeArcWithSweep({10, 10}, kXyPlane, -1000, 0, 1e-300, true));
  EXPECT_TRUE(MakeArcWithSweep({10, 10}, kXyPlane, -1000, 0, 1e-100, true));
}

TEST(Segment, PlanesAreTakenInCyclicOrder) {
  // A quarter circle counter-clockwise from the first axis of the plane to the second.
  for (const ArcPlane& plane : {kXyPlane, kYzPlane, kZxPlane}) {
    Coordinates start{};
    Coordinates end{};
    start[plane.first] = 10;
    end[plane.second] = 10;
    const auto arc = MakeArcAroundCentre(start, end, plane, -10, 0, true);
    ASSERT_TRUE(arc.has_value());
    EXPECT_NEAR(arc->sweep, kPi / 2, 1e-12);
    Coordinates middle{};
    middle[plane.first] = middle[plane.second] = 10 / std::sqrt(2.0);
    ExpectNear(arc->PointAt(arc->length / 2), middle);
  }
}

TEST(Segment, HelicesRiseWithTheAngle) {
  const auto helix = MakeArcAroundCentre({100, 0, 0}, {100, 0, 50}, kXyPlane, -100, 0, true);
  ASSERT_TRUE(helix.has_value());
  EXPECT_NEAR(helix->length, std::sqrt(200 * kPi * 200 * kPi + 50 * 50), 1e-9);
  ExpectNear(helix->PointAt(helix->length / 4), {0, 100, 12.5, 0});
  const Coordinates tangent = helix->TangentAt(10);
  EXPECT_NEAR(tangent[0] * tangent[0] + tangent[1] * tangent[1] + tangent[2] * tangent[2], 1,
              1e-12);
}

TEST(Segment, ArcsThroughAPointLieInSpace) {
  // The circle of radius 1 around (1, 0, 0) in the plane y = z.
  const double s = 1 / std::sqrt(2.0);
  const auto arc = MakeArcThroughPoint({0, 0, 0}, {2, 0, 0}, {1, s, s});
  ASSERT_TRUE(arc.has_value());
  EXPECT_NEAR(arc->length, kPi, 1e-12);
  ExpectNear(arc->PointAt(kPi / 2), {1, s, s});
  ExpectNear(arc->TangentAt(0), {0, s, s});
  ExpectNear(arc->CurvatureAt(0), {1, 0, 0});
  EXPECT_FALSE(MakeArcThroughPoint({0, 0, 0}, {2, 0, 0}, {1, 0, 0}).has_value());
}

}  // namespace
}  // namespace oncard::motion
