// Segments and buffered commands of the multi-axis look-ahead, and their runs.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/gtcalls/look_ahead_support.h"

namespace oncard::gtcalls::gts {
namespace {

// --- Lines --------------------------------------------------------------------------------------

TEST(LookAheadLine, IsInMillimetres) {
  LookAheadCard card;
  card.Prepare(4, 1);
  card.Expect(0, "GT_LnXYZAEx", {1, 1., 2., 3., 4.5, 50., 500., 12, 1, 0});
  EXPECT_EQ(card.Flush(), 0);
  const motion::PathSlot& slot = card.fifo().slots.front();
  EXPECT_EQ(slot.segment.end, (motion::Coordinates{1000, 2000, 3000, 4500}));
  EXPECT_DOUBLE_EQ(slot.velocity, 50);
  EXPECT_DOUBLE_EQ(slot.acceleration, 0.5);
  EXPECT_TRUE(slot.second_override);
  EXPECT_EQ(slot.given_number, 12);
  card.Run();
  EXPECT_EQ(card.Position(3), 4500);
}

TEST(LookAheadLine, KeepsTheCoordinatesThatItDoesNotName) {
  LookAheadCard card;
  card.Prepare(4);
  card.Expect(0, "GT_LnXYZEx", {1, 1., 2., 3., 50., 500., 0, 0, 0});
  EXPECT_EQ(card.LineEx(5, 5), 0);
  EXPECT_EQ(card.fifo().tail, (motion::Coordinates{5000, 5000, 3000, 0}));
}

TEST(LookAheadLine, ToTheSamePointIsRefused) {
  LookAheadCard card;
  card.Prepare(4);
  EXPECT_EQ(card.LineEx(0, 0), 102);
  EXPECT_EQ(card.LineEx(1, 2), 0);
  EXPECT_EQ(card.LineEx(1, 2), 102);
  // Only the fourth coordinate changes.
  card.Expect(102, "GT_LnXYZAEx", {1, 1., 2., 0., 5., 50., 500., 0, 0, 0});
  card.Expect(0, "GT_LnXYZAEx", {1, 1., 2., .5, 5., 50., 500., 0, 0, 0});
}

TEST(LookAheadLine, NeedsAsManyAxesAsItHasCoordinates) {
  LookAheadCard card;
  card.Prepare(2);
  card.Expect(110, "GT_LnXYZEx", {1, 1., 2., 3., 50., 500., 0, 0, 0});
  card.Expect(110, "GT_LnXYZAEx", {1, 1., 2., 3., 4., 50., 500., 0, 0, 0});
  card.Expect(110, "GT_ArcYZREx", {1, 1., 1., 1., 1, 50., 500., 0, 0, 0});
}

// Positions of axes are rounded when the coordinate system has an origin.
TEST(LookAheadLine, ToTheSamePointIsRefusedAtAnyOrigin) {
  for (int i = 1; i <= 20; ++i) {
    LookAheadCard card;
    std::vector<double> cells = CrdCommandCard::Parameters(2);
    cells[12] = 1;  // setOriginFlag
    cells[13] = -12345;
    card.Expect(0, "GT_SetCrdPrm", {1, &cells});
    card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
    EXPECT_EQ(card.Init(), 0);
    const double x = 1.0 / 3 + i;
    EXPECT_EQ(card.LineEx(x, 0), 0);
    EXPECT_EQ(card.Flush(), 0);
    card.Run();
    EXPECT_EQ(card.Init(), 0);
    EXPECT_EQ(card.LineEx(x, 0), 102) << x;
    EXPECT_EQ(card.Call("GT_ArcXYCEx", {1, x, 0., 10., 0., 1, 50., 500., 0, 0, 0}), 0);
    EXPECT_NEAR(card.fifo().planner->ring.back().segment.length, 20000 * M_PI, 1e-6) << x;
  }
}

TEST(LookAheadLine, ArgumentsOutOfRange) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(107, "GT_LnXYEx", {1, 2e6, 0., 50., 500., 0, 0, 0});
  card.Expect(7, "GT_LnXYEx", {1, std::nan(""), 0., 50., 500., 0, 0, 0});  // as everywhere
  card.Expect(107, "GT_LnXYEx", {1, 1., 0., 0., 500., 0, 0, 0});
  card.Expect(107, "GT_LnXYEx", {1, 1., 0., 50., -1., 0, 0, 0});
  card.Expect(107, "GT_LnXYEx", {1, 1., 0., 50., 500., 0, 2, 0});
}

TEST(LookAheadLine, G0EndsAtRest) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(0, "GT_LnXYG0Ex", {1, 10., 0., 50., 500., 0, 0, 0});
  EXPECT_EQ(card.LineEx(20, 0), 0);
  EXPECT_EQ(card.LineEx(30, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.fifo().slots.At(0).end_velocity, 0);
  EXPECT_NEAR(card.fifo().slots.At(1).end_velocity, 50, 1e-9);
}

TEST(LookAheadLine, AFullFifoRefusesItUntilThereIsSpace) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  EXPECT_EQ(card.Init(LookAheadCard::Parameters(10)), 0);
  int sent = 0;
  while (card.LineEx(sent + 1, 0) == 0) ++sent;
  EXPECT_EQ(sent, 4096 + 10);
  EXPECT_NE(card.reason.en.find("GT_CrdSpace"), std::string::npos);
  EXPECT_EQ(card.Flush(), 1);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  while (card.ReadFifo("GT_CrdSpace") == 0) card.Cycle();
  EXPECT_EQ(card.LineEx(sent + 1, 0), 0);
}

// --- Arcs ---------------------------------------------------------------------------------------

int16_t ArcAround(LookAheadCard& card, double x, double y, double i, double j) {
  return card.Call("GT_ArcXYCEx", {1, x, y, i, j, 1, 50., 500., 0, 0, 0});
}

TEST(LookAheadArc, RadiiMayDifferByAHundredth) {
  for (const double error : {0.0, 0.0009, 0.0099, -0.0099}) {
    LookAheadCard card;
    card.Prepare();
    EXPECT_EQ(ArcAround(card, 10, 10 + error, 0, 10), 0) << error;
    EXPECT_EQ(card.Flush(), 0);
    // It is corrected: it ends where it was commanded to end.
    card.Run();
    EXPECT_DOUBLE_EQ(card.Position(1), (10 + error) * 1000);
  }
  for (const double error : {0.011, -0.02}) {
    LookAheadCard card;
    card.Prepare();
    EXPECT_EQ(ArcAround(card, 10 + error, 10, 0, 10), 107) << error;
  }
}

// A hundredth may differ, whatever the decimal fractions become as binary ones.
TEST(LookAheadArc, ExactlyAHundredthIsAllowed) {
  for (double radius = 0.5; radius < 100; radius += 0.37) {
    for (const double error : {0.01, -0.01}) {
      LookAheadCard card;
      card.Prepare();
      EXPECT_EQ(ArcAround(card, radius, radius + error, 0, radius), 0) << radius;
    }
    LookAheadCard card;
    card.Prepare();
    card.Expect(0, "GT_ArcXYREx", {1, 2 * radius + 0.01, 0., radius, 1, 50., 500., 0, 0, 0});
  }
}

TEST(LookAheadArc, ACentreMakesAFullCircle) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(ArcAround(card, 0, 0, 10, 0), 0);
  EXPECT_NEAR(card.fifo().planner->ring.back().segment.length, 20000 * M_PI, 1e-6);
  EXPECT_EQ(ArcAround(card, 0, 0, 0, 0), 107);
}

TEST(LookAheadArc, AChordMayExceedTheDiameterByAHundredth) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(107, "GT_ArcXYREx", {1, 20.011, 0., 10., 1, 50., 500., 0, 0, 0});
  card.Expect(107, "GT_ArcXYREx", {1, 0., 0., 10., 1, 50., 500., 0, 0, 0});  // a full circle
  card.Expect(0, "GT_ArcXYREx", {1, 20.009, 0., 10., 1, 50., 500., 0, 0, 0});
}

TEST(LookAheadArc, ANegativeRadiusIsTheLongerArc) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(0, "GT_ArcXYREx", {1, 10., 10., -10., 1, 50., 500., 0, 0, 0});
  EXPECT_NEAR(card.fifo().planner->ring.back().segment.sweep, 1.5 * M_PI, 1e-9);
}

TEST(LookAheadArc, InSpaceIsNoHalfAndNoFullCircle) {
  LookAheadCard card;
  card.Prepare(4);
  const auto arc = [&](double x, double y, double z, double a, double b, double c) {
    return card.Call("GT_ArcXYZEx", {1, x, y, z, a, b, c, 50., 500., 0, 0, 0});
  };
  EXPECT_EQ(arc(20, 0, 0, 10, 10, 0), 107);  // half
  EXPECT_EQ(arc(0, 0, 0, 10, 10, 0), 107);   // full
  EXPECT_EQ(arc(20, 0, 0, 10, 0, 0), 107);   // a line
  EXPECT_EQ(arc(20, 0, 0, 10, 5, 5), 0);
}

TEST(LookAheadArc, EveryPlaneRunsToItsEnd) {
  LookAheadCard card;
  card.Prepare(4);
  card.Expect(0, "GT_ArcXYCEx", {1, 10., 10., 0., 10., 1, 50., 500., 0, 0, 0});
  card.Expect(0, "GT_ArcYZREx", {1, 20., 10., 10., 0, 50., 500., 0, 0, 0});
  card.Expect(0, "GT_ArcZXCEx", {1, 20., 20., 10., 0., 1, 50., 500., 0, 0, 0});
  card.Expect(0, "GT_HelixXYCZEx", {1, 20., 20., 25., 5., 0., 1, 50., 500., 0, 0, 0});
  card.Expect(0, "GT_HelixXYRZEx", {1, 30., 20., 30., 6., 0, 50., 500., 0, 0, 0});
  EXPECT_EQ(card.Flush(), 0);
  card.Run();
  EXPECT_EQ(card.Position(0), 30000);
  EXPECT_EQ(card.Position(1), 20000);
  EXPECT_EQ(card.Position(2), 30000);
}

// The manual gives this command alone a range.
TEST(LookAheadArc, AHelixAroundACentreHasBoundedVelocityAndAcceleration) {
  LookAheadCard card;
  card.Prepare(3);
  const auto helix = [&](double velocity, double acceleration) {
    return card.Call("GT_HelixXYCZEx", {1, 1., 1., 5., 1., 0., 1, velocity, acceleration, 0, 0, 0});
  };
  EXPECT_EQ(helix(32767, 500), 107);
  EXPECT_EQ(helix(50, 32767), 107);
  EXPECT_EQ(helix(32766, 32766), 0);
}

TEST(LookAheadArc, Arguments) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(107, "GT_ArcXYREx", {1, 10., 0., 10., 2, 50., 500., 0, 0, 0});
  card.Expect(107, "GT_ArcXYREx", {1, 10., 0., 0., 1, 50., 500., 0, 0, 0});
}

// --- Auxiliary commands -------------------------------------------------------------------------

TEST(LookAheadAuxiliary, ActsBetweenItsSegments) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(0, "GT_BufIOEx", {1, 12, 1, 1, 0});
  EXPECT_EQ(card.LineEx(10, 0), 0);
  card.Expect(0, "GT_BufIOEx", {1, 12, 1, 0, 0});
  card.Expect(0, "GT_BufDAEx", {1, 2, -32768, 0});
  EXPECT_EQ(card.LineEx(20, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.fifo().slots.size(), 5u);
  EXPECT_NEAR(card.fifo().slots.At(1).end_velocity, 50, 1e-9);  // they need no rest
  card.Run();
  EXPECT_EQ(card.motion.state().dacs[1].value, -32767);
}

TEST(LookAheadAuxiliary, DelaysAndModalMovesStopThePath) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(10, 0), 0);
  card.Expect(0, "GT_BufDelayEx", {1, 100, 0});
  EXPECT_EQ(card.LineEx(20, 0), 0);
  card.Expect(0, "GT_BufMoveEx", {1, 5, 2., 20., 500., 1, 0});
  EXPECT_EQ(card.LineEx(30, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.fifo().slots.At(0).end_velocity, 0);
  EXPECT_EQ(card.fifo().slots.At(2).end_velocity, 0);
  card.Run();
  EXPECT_EQ(card.Position(4), 2000);
  EXPECT_EQ(card.Position(0), 30000);
}

TEST(LookAheadAuxiliary, AtMostSixteenInARow) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(10, 0), 0);
  for (int i = 0; i < 16; ++i) card.Expect(0, "GT_BufIOEx", {1, 12, 1, i % 2, 0});
  card.Expect(107, "GT_BufIOEx", {1, 12, 1, 1, 0});
  card.Expect(107, "GT_BufDelayEx", {1, 1, 0});
  EXPECT_EQ(card.LineEx(20, 0), 0);
  card.Expect(0, "GT_BufIOEx", {1, 12, 1, 1, 0});
}

TEST(LookAheadAuxiliary, SixteenMayFollowAClearedBuffer) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(10, 0), 0);
  for (int i = 0; i < 16; ++i) card.Expect(0, "GT_BufIOEx", {1, 12, 1, i % 2, 0});
  card.Expect(0, "GT_CrdClear", {1, 0});
  for (int i = 0; i < 16; ++i) card.Expect(0, "GT_BufIOEx", {1, 12, 1, i % 2, 0});
  card.Expect(107, "GT_BufIOEx", {1, 12, 1, 1, 0});
}

TEST(LookAheadAuxiliary, Ranges) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(107, "GT_BufIOEx", {1, 9, 1, 1, 0});
  card.Expect(107, "GT_BufIOEx", {1, 13, 1, 1, 0});
  card.Expect(107, "GT_BufDAEx", {1, 0, 1, 0});
  card.Expect(107, "GT_BufDAEx", {1, 9, 1, 0});
  card.Expect(107, "GT_BufGearEx", {1, 0, 1., 0});
  card.Expect(107, "GT_BufGearEx", {1, 1, 1., 0});  // an axis of the coordinate system
  card.Expect(107, "GT_BufGearEx", {1, 5, 1e9, 0});
  card.Expect(107, "GT_BufMoveEx", {1, 2, 1., 10., 100., 0, 0});
  card.Expect(107, "GT_BufMoveEx", {1, 5, 1., 0., 100., 0, 0});
  card.Expect(107, "GT_BufMoveEx", {1, 5, 1., 10., -1., 0, 0});
  card.Expect(107, "GT_BufMoveEx", {1, 5, 1., 10., 100., 2, 0});
  EXPECT_EQ(card.Call("GT_PrfJog", {5}), 0);
  card.Expect(110, "GT_BufMoveEx", {1, 5, 1., 10., 100., 0, 0});
}

TEST(LookAheadAuxiliary, AProfileFollowsASegmentWithinItsLimits) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  std::vector<double> modes = {0, 0, 7, 0, 0, 0, 0, 0};
  std::vector<double> velocity(8, 10);
  std::vector<double> acceleration(8, 100);
  std::vector<double> jump(8, 200);
  card.Expect(0, "GT_SetFollowAxisParaLa", {1, &modes, &velocity, &acceleration, &jump});
  EXPECT_EQ(card.Init(), 0);
  EXPECT_EQ(card.LineEx(20, 0), 0);
  card.Expect(0, "GT_BufGearEx", {1, 3, 20., 0});
  EXPECT_EQ(card.LineEx(40, 0), 0);
  EXPECT_EQ(card.LineEx(60, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  double before = 0;
  while (card.motion.state().crds[0].run.running) {
    card.Cycle();
    const motion::Sample& follower = card.motion.state().profiles[2].now;
    EXPECT_LE(std::fabs(follower.velocity), 10 + 1e-9);
    EXPECT_LE(std::fabs(follower.acceleration), 0.1 + 1e-9);
    // 200 mm/s^2 in 0.01 s, and the acceleration in a cycle.
    EXPECT_LE(std::fabs(follower.velocity - before), 2 + 0.1 + 1e-9);
    before = follower.velocity;
  }
  EXPECT_EQ(card.Position(2), 20000);
}

// --- Start points and numbers -------------------------------------------------------------------

TEST(LookAheadStart, TheInitialisationMakesOne) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(0, "GT_BufIOEx", {1, 12, 1, 1, 0});
  EXPECT_EQ(card.fifo().slots.size(), 1u);
}

TEST(LookAheadStart, AfterAFlushTheFirstSegmentMakesOne) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(10, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.LineEx(10, 0), 0);
  EXPECT_EQ(card.fifo().planner->ring.size(), 0u);
  card.Expect(0, "GT_BufIOEx", {1, 12, 1, 1, 0});
  EXPECT_EQ(card.LineEx(20, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.fifo().slots.size(), 3u);
  card.Run();
  EXPECT_EQ(card.Position(0), 20000);
}

TEST(LookAheadStart, AfterAFlushTheFirstAuxiliaryCommandIsSwallowed) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(10, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  card.Expect(0, "GT_BufIOEx", {1, 12, 1, 1, 0});
  EXPECT_EQ(card.fifo().slots.size(), 1u);
  EXPECT_EQ(card.LineEx(20, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.fifo().slots.size(), 2u);
}

TEST(LookAheadStart, ASegmentBeginsAtTheStartPoint) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.LineEx(5, 5), 0);
  EXPECT_EQ(card.LineEx(5, 5), 102);
  EXPECT_EQ(card.LineEx(10, 5), 0);
  EXPECT_EQ(card.fifo().planner->ring.back().segment.start[0], 5000);
  EXPECT_EQ(card.Flush(), 0);
  // The axes are not there.
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 1);
}

TEST(LookAheadStart, AClearedBufferBeginsWhereTheAxesAre) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.LineEx(5, 5), 0);
  card.Expect(0, "GT_CrdClear", {1, 0});
  EXPECT_EQ(card.LineEx(10, 5), 0);
  EXPECT_EQ(card.fifo().planner->ring.back().segment.start[0], 0);
}

// A start point elsewhere must not make the axes jump.
TEST(LookAheadStart, APathThatIsNotFinishedGoesOnWhereItEnds) {
  for (const bool started : {false, true}) {
    LookAheadCard card;
    card.Prepare();
    EXPECT_EQ(card.LineEx(10, 0), 0);
    EXPECT_EQ(card.Flush(), 0);
    if (started) card.Expect(0, "GT_CrdStart", {1, 0});
    EXPECT_EQ(card.LineEx(50, 50), 0);
    EXPECT_EQ(card.LineEx(60, 50), 0);
    EXPECT_EQ(card.fifo().planner->ring.back().segment.start[0], 10000);
    EXPECT_EQ(card.Flush(), 0);
    if (!started) card.Expect(0, "GT_CrdStart", {1, 0});
    card.CyclesToEnd();
    EXPECT_EQ(card.Position(0), 60000);
  }
}

// Auxiliary commands reach the FIFO at once, the segment after them only later.
TEST(LookAheadStart, ASegmentInTheLookAheadMustBeginWhereTheAxesAre) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.LineEx(50, 50), 0);
  card.Expect(0, "GT_BufIOEx", {1, 12, 1, 1, 0});
  EXPECT_EQ(card.LineEx(60, 50), 0);
  card.Expect(1, "GT_CrdStart", {1, 0});
}

TEST(LookAheadStart, ARunOfAuxiliaryCommandsDoesNotReachAStartPoint) {
  for (const bool again : {false, true}) {
    LookAheadCard card;
    card.Prepare();
    EXPECT_EQ(card.Flush(), 0);
    EXPECT_EQ(card.LineEx(50, 50), 0);
    card.Expect(0, "GT_BufDelayEx", {1, 100, 0});
    EXPECT_EQ(card.Flush(), 0);
    card.Expect(0, "GT_CrdStart", {1, 0});
    if (again) {
      EXPECT_EQ(card.Init(), 0);
    } else {
      EXPECT_EQ(card.LineEx(50, 50), 0);
    }
    EXPECT_EQ(card.LineEx(60, 50), 0);
    EXPECT_EQ(card.fifo().planner->ring.back().segment.start[0], 0);
  }
}

TEST(LookAheadNumbers, TheUsersNumberIsThatOfTheSegmentUntilAnotherIsSet) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(10, 0, 3), 0);
  card.Expect(0, "GT_SetUserSegNumEx", {1, 77, 0});
  EXPECT_EQ(card.LineEx(20, 0, 4), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.fifo().slots.At(0).user_number, 3);
  EXPECT_EQ(card.fifo().slots.At(1).user_number, 77);
  EXPECT_EQ(card.fifo().slots.At(1).given_number, 4);
}

// --- Virtual runs -------------------------------------------------------------------------------

void SendPath(LookAheadCard& card) {
  EXPECT_EQ(card.LineEx(20, 20), 0);
  EXPECT_EQ(card.LineEx(50, 20), 0);
  card.Expect(0, "GT_BufDelayEx", {1, 30, 0});
  EXPECT_EQ(ArcAround(card, 50, 40, 0, 10), 0);
  card.Expect(0, "GT_BufMoveEx", {1, 5, 2., 20., 500., 1, 0});
  EXPECT_EQ(card.LineEx(20, 40), 0);
  EXPECT_EQ(card.Flush(), 0);
}

TEST(LookAheadVirtual, TakesTheTimeOfTheRealRun) {
  for (const int mode : {0, 1}) {
    LookAheadCard estimated;
    estimated.Prepare(2, mode);
    EXPECT_EQ(estimated.Init(LookAheadCard::Parameters(), 1), 0);
    SendPath(estimated);
    EXPECT_EQ(estimated.ReadFifo("GT_CrdSpace"), 4096);
    EXPECT_EQ(estimated.Call("GT_CrdStart", {1, 0}), 1);
    LookAheadCard real;
    real.Prepare(2, mode);
    SendPath(real);
    EXPECT_NEAR(real.Run(), estimated.ReadFifo("GT_GetMotionTimeEx"), 1);
  }
}

TEST(LookAheadVirtual, BeginsWhereItIsTold) {
  LookAheadCard card;
  card.Prepare();
  std::vector<double> cells = LookAheadCard::Parameters();
  std::vector<double> position = {10, 0, 0, 0, 0, 0, 0, 0};
  card.Expect(0, "GT_InitLookAheadEx", {1, &cells, 0, 1, &position});
  EXPECT_EQ(card.LineEx(10, 0), 102);
  EXPECT_EQ(card.LineEx(60, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  // 50 mm at 50 mm/s and 500 mm/s^2.
  EXPECT_NEAR(card.ReadFifo("GT_GetMotionTimeEx"), 1100, 1e-9);
}

TEST(LookAheadVirtual, LeavesThePathThatWaitsAsItIs) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(10, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.Init(LookAheadCard::Parameters(), 1), 0);
  EXPECT_EQ(card.LineEx(50, 50), 0);
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.Init(), 0);
  EXPECT_EQ(card.LineEx(20, 0), 0);
  EXPECT_EQ(card.fifo().planner->ring.back().segment.start[0], 10000);
}

TEST(LookAheadVirtual, AClearedEstimateBeginsAnew) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.Init(LookAheadCard::Parameters(2), 1), 0);
  for (int i = 1; i <= 10; ++i) EXPECT_EQ(card.LineEx(i * 10, 0), 0);
  card.Expect(0, "GT_CrdClear", {1, 0});
  EXPECT_EQ(card.LineEx(150, 0), 0);
  EXPECT_EQ(card.Flush(), 0);
  // 50 mm at 50 mm/s and 500 mm/s^2.
  EXPECT_NEAR(card.ReadFifo("GT_GetMotionTimeEx"), 1100, 1e-9);
}

TEST(LookAheadVirtual, ARealRunHasNoEstimate) {
  LookAheadCard card;
  card.Prepare();
  std::vector<double> time(1);
  card.Expect(107, "GT_GetMotionTimeEx", {1, &time, 0});
}

TEST(LookAheadVirtual, FlushTakesOnlyNull) {
  LookAheadCard card;
  card.Prepare();
  std::vector<double> data(33);
  card.Expect(107, "GT_CrdDataEx", {1, &data, 0});
}

}  // namespace
}  // namespace oncard::gtcalls::gts
