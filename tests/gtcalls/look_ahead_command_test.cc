// The multi-axis look-ahead: the order of its commands, its settings and their codes.
#include <gtest/gtest.h>

#include <limits>

#include "tests/gtcalls/look_ahead_support.h"

namespace oncard::gtcalls::gts {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// --- Order --------------------------------------------------------------------------------------

TEST(LookAheadOrder, SetupNeedsACoordinateSystem) {
  LookAheadCard card;
  card.Expect(110, "GT_SetupLookAheadCrd", {1, 0});
  card.SetUp();
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
}

TEST(LookAheadOrder, SettingsNeedTheSetup) {
  LookAheadCard card;
  card.SetUp();
  std::vector<double> modes(8);
  std::vector<double> limits(8, 100);
  std::vector<double> parameters = LookAheadCard::Parameters();
  card.Expect(103, "GT_SetAxisLimitModeLa", {1, &modes});
  card.Expect(103, "GT_SetWorkLimitModeLa", {1, 1});
  card.Expect(103, "GT_SetAxisVelValidModeLa", {1, 15});
  card.Expect(103, "GT_SetVelDefineModeLa", {1, 0});
  card.Expect(103, "GT_SetFollowAxisParaLa", {1, &modes, &limits, &limits, &limits});
  card.Expect(103, "GT_InitLookAheadEx", {1, &parameters, 0, 0, nullptr});
  card.Expect(103, "GT_CrdDataEx", {1, nullptr, 0});
}

/// Every command that appends to the look-ahead, with arguments that are possible.
void ExpectOfAppending(LookAheadCard& card, int16_t code) {
  card.Expect(code, "GT_LnXYEx", {1, 1., 2., 50., 500., 0, 0, 0});
  card.Expect(code, "GT_LnXYG0Ex", {1, 1., 2., 50., 500., 0, 0, 0});
  card.Expect(code, "GT_LnXYZEx", {1, 1., 2., 3., 50., 500., 0, 0, 0});
  card.Expect(code, "GT_LnXYZG0Ex", {1, 1., 2., 3., 50., 500., 0, 0, 0});
  card.Expect(code, "GT_LnXYZAEx", {1, 1., 2., 3., 4., 50., 500., 0, 0, 0});
  card.Expect(code, "GT_LnXYZAG0Ex", {1, 1., 2., 3., 4., 50., 500., 0, 0, 0});
  card.Expect(code, "GT_BufDelayEx", {1, 5, 0});
  card.Expect(code, "GT_BufIOEx", {1, 12, 1, 1, 0});
  card.Expect(code, "GT_BufDAEx", {1, 1, 100, 0});
  card.Expect(code, "GT_BufGearEx", {1, 5, 1., 0});
  card.Expect(code, "GT_BufMoveEx", {1, 5, 1., 10., 100., 0, 0});
  card.Expect(code, "GT_SetUserSegNumEx", {1, 7, 0});
}

void ExpectOfArcs(LookAheadCard& card, int16_t code) {
  for (const char* name : {"GT_ArcXYCEx", "GT_ArcYZCEx", "GT_ArcZXCEx"}) {
    card.Expect(code, name, {1, 1., 1., 1., 0., 1, 50., 500., 0, 0, 0});
  }
  for (const char* name : {"GT_ArcXYREx", "GT_ArcYZREx", "GT_ArcZXREx"}) {
    card.Expect(code, name, {1, 1., 1., 1., 1, 50., 500., 0, 0, 0});
  }
  card.Expect(code, "GT_ArcXYZEx", {1, 1., 1., 0., .2, .9, 0., 50., 500., 0, 0, 0});
  card.Expect(code, "GT_HelixXYCZEx", {1, 1., 1., 5., 1., 0., 1, 50., 500., 0, 0, 0});
  card.Expect(code, "GT_HelixXYRZEx", {1, 1., 1., 5., 1., 1, 50., 500., 0, 0, 0});
}

TEST(LookAheadOrder, SegmentsNeedTheSetup) {
  LookAheadCard card;
  card.SetUp(4);
  ExpectOfAppending(card, 103);
  ExpectOfArcs(card, 103);
}

TEST(LookAheadOrder, SegmentsNeedTheInitialisation) {
  LookAheadCard card;
  card.SetUp(4);
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  ExpectOfAppending(card, 104);
  ExpectOfArcs(card, 104);
  card.Expect(104, "GT_CrdDataEx", {1, nullptr, 0});
  std::vector<double> time(1);
  card.Expect(104, "GT_GetMotionTimeEx", {1, &time, 0});
}

TEST(LookAheadOrder, AnInitialisationThatFailsIsNone) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  EXPECT_EQ(card.Init(LookAheadCard::Parameters(0)), 107);
  EXPECT_EQ(card.LineEx(1, 1), 104);
}

TEST(LookAheadOrder, EachBufferIsInitialisedByItself) {
  LookAheadCard card;
  card.Prepare();
  card.Expect(104, "GT_LnXYEx", {1, 1., 2., 50., 500., 0, 0, 1});
  EXPECT_EQ(card.Init(LookAheadCard::Parameters(), 0, 1), 0);
  card.Expect(0, "GT_LnXYEx", {1, 1., 2., 50., 500., 0, 0, 1});
}

TEST(LookAheadOrder, ANewCoordinateSystemNeedsANewInitialisation) {
  LookAheadCard card;
  card.Prepare();
  card.SetUp();
  EXPECT_EQ(card.LineEx(1, 1), 104);
  EXPECT_EQ(card.Init(), 0);
  EXPECT_EQ(card.LineEx(1, 1), 0);
}

TEST(LookAheadOrder, NothingChangesWhileTheLookAheadHoldsSegments) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(1, 1), 0);
  card.Expect(110, "GT_SetupLookAheadCrd", {1, 0});
  EXPECT_EQ(card.Init(), 110);
  card.Expect(110, "GT_InitLookAheadPara", {1, 200, 0.1, 0.01, 1000., 0});
  EXPECT_EQ(card.Flush(), 0);
  EXPECT_EQ(card.Init(), 0);
}

TEST(LookAheadOrder, AResetForgetsTheSetup) {
  LookAheadCard card;
  card.Prepare();
  card.state().Reset();
  EXPECT_FALSE(card.state().look_ahead[0].established);
}

TEST(LookAheadOrder, JoinsTheHashOnlyInUse) {
  GtsState state;
  const uint64_t before = motion::StateHash().Add(state).value();
  state.look_ahead[0].length_axes = 1;
  EXPECT_EQ(motion::StateHash().Add(state).value(), before);
  state.look_ahead[0].established = true;
  EXPECT_NE(motion::StateHash().Add(state).value(), before);
}

// Its path begins at rest, whatever end velocity a command without look-ahead has given.
TEST(LookAheadOrder, SegmentsBeforeTheInitialisationEndAtRest) {
  for (const bool moving : {false, true}) {
    LookAheadCard card;
    card.SetUp();
    card.Expect(0, "GT_LnXY", {1, 10000, 0, 50., .5, 50., 0});
    if (moving) {
      card.Expect(0, "GT_CrdStart", {1, 0});
      card.Cycles(50);
    }
    card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
    EXPECT_EQ(card.Init(), 0);
    EXPECT_EQ(card.LineEx(10, 10), 0);
    EXPECT_EQ(card.Flush(), 0);
    if (!moving) card.Expect(0, "GT_CrdStart", {1, 0});
    const motion::Sample& along_y = card.motion.state().profiles[1].now;
    while (card.motion.state().crds[0].run.running) {
      const double before = along_y.velocity;
      card.Cycle();
      EXPECT_LE(std::fabs(along_y.velocity - before), 0.5 + 1e-9);
    }
    EXPECT_EQ(along_y.position, 10000);
  }
}

// --- Ranges and modes ---------------------------------------------------------------------------

TEST(LookAheadRanges, NumbersOfCoordinateSystemsAndBuffers) {
  LookAheadCard card;
  card.Prepare();
  for (const int crd : {-1, 0, 3}) {
    card.Expect(107, "GT_SetupLookAheadCrd", {crd, 0});
    card.Expect(107, "GT_SetWorkLimitModeLa", {crd, 0});
    card.Expect(107, "GT_LnXYEx", {crd, 1., 2., 50., 500., 0, 0, 0});
    card.Expect(107, "GT_BufDelayEx", {crd, 1, 0});
    card.Expect(107, "GT_CrdDataEx", {crd, nullptr, 0});
    card.Expect(107, "GT_InitLookAheadPara", {crd, 200, 0.1, 0.01, 1000., 0});
  }
  card.Expect(107, "GT_LnXYEx", {1, 1., 2., 50., 500., 0, 0, 2});
  card.Expect(107, "GT_CrdDataEx", {1, nullptr, -1});
}

TEST(LookAheadRanges, Settings) {
  LookAheadCard card;
  card.Prepare();
  std::vector<double> modes(8);
  modes[7] = 8;
  card.Expect(107, "GT_SetAxisLimitModeLa", {1, &modes});
  card.Expect(107, "GT_SetWorkLimitModeLa", {1, 2});
  card.Expect(107, "GT_SetAxisVelValidModeLa", {1, 0});
  card.Expect(107, "GT_SetAxisVelValidModeLa", {1, 256});
  card.Expect(107, "GT_SetVelDefineModeLa", {1, 3});
  card.Expect(107, "GT_SetupLookAheadCrd", {1, 4});
}

TEST(LookAheadRanges, Parameters) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 1});
  const auto init = [&](size_t cell, double value) {
    std::vector<double> cells = LookAheadCard::Parameters();
    cells[cell] = value;
    return card.Init(cells);
  };
  EXPECT_EQ(init(0, 0), 107);  // lookAheadNum
  EXPECT_EQ(init(0, -5), 107);
  EXPECT_EQ(init(1, 0), 107);     // time
  EXPECT_EQ(init(2, kNan), 107);  // radiusRatio
  EXPECT_EQ(init(3, 0), 107);     // vMax of an axis whose velocity is limited
  EXPECT_EQ(init(12, -1), 107);   // aMax
  EXPECT_EQ(init(19, 0), 107);    // DVMax
  EXPECT_EQ(init(27, 0), 107);    // scale
  EXPECT_EQ(init(28, 0), 0);      // only its first element counts
  EXPECT_EQ(init(10, 0), 0);      // an axis that the coordinate system does not have
  EXPECT_EQ(card.Init(LookAheadCard::Parameters(), 2), 107);
}

// What is left in a host's structure must not slow down or break the path.
TEST(LookAheadRanges, LimitsOfAxesThatTheCoordinateSystemDoesNotHave) {
  LookAheadCard card;
  card.SetUp(2);
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 1});
  std::vector<double> cells = LookAheadCard::Parameters();
  for (const size_t limit : {3u, 11u, 19u}) cells[limit + 2] = -1e6;
  EXPECT_EQ(card.Init(cells), 0);
  EXPECT_EQ(card.LineEx(10, 0), 0);
  EXPECT_EQ(card.fifo().planner->ring.back().acceleration, 0.5);
  EXPECT_EQ(card.fifo().planner->ring.back().velocity_limit, 50);
}

TEST(LookAheadRanges, WhereAVirtualRunBegins) {
  LookAheadCard card;
  card.Prepare();
  std::vector<double> cells = LookAheadCard::Parameters();
  std::vector<double> position(8);
  position[2] = kNan;  // an axis that the coordinate system does not have
  card.Expect(0, "GT_InitLookAheadEx", {1, &cells, 0, 1, &position});
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e300, 1.1e6}) {
    position[1] = bad;
    card.Expect(107, "GT_InitLookAheadEx", {1, &cells, 0, 1, &position});
  }
  card.Expect(0, "GT_InitLookAheadEx", {1, &cells, 0, 0, &position});  // not used
}

TEST(LookAheadRanges, NullPointers) {
  LookAheadCard card;
  card.Prepare();
  std::vector<double> modes(8);
  card.Expect(7, "GT_InitLookAheadEx", {1, nullptr, 0, 0, nullptr});  // as everywhere
  card.Expect(7, "GT_SetAxisLimitModeLa", {1, nullptr});
  card.Expect(7, "GT_SetFollowAxisParaLa", {1, &modes, nullptr, &modes, &modes});
  card.Expect(7, "GT_GetMotionTimeEx", {1, nullptr, 0});
}

TEST(LookAheadRanges, RelationOfAxes) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  std::vector<double> cells = LookAheadCard::Parameters();
  cells[42] = 9;
  EXPECT_EQ(card.Init(cells), 107);
  cells[42] = 1;  // twice
  EXPECT_EQ(card.Init(cells), 107);
  std::fill(cells.begin() + 35, cells.end(), 0);
  EXPECT_EQ(card.Init(cells), 107);
  cells[35] = 1;
  EXPECT_EQ(card.Init(cells), 0);
}

TEST(LookAheadModes, FiveAxesHaveNoLibrary) {
  for (const int mode : {2, 3}) {
    LookAheadCard card;
    card.SetUp(4);
    card.Expect(0, "GT_SetupLookAheadCrd", {1, mode});
    EXPECT_EQ(card.Init(), 105);
    card.Expect(105, "GT_InitLookAheadPara", {1, 200, 0.1, 0.01, 1000., 0});
    ExpectOfArcs(card, 107);
    EXPECT_EQ(card.LineEx(1, 1), 104);
  }
}

TEST(LookAheadModes, DefinitionsOfVelocity) {
  const auto expect = [](int mode, int definition, int16_t code) {
    LookAheadCard card;
    card.SetUp();
    card.Expect(0, "GT_SetupLookAheadCrd", {1, mode});
    card.Expect(code, "GT_SetVelDefineModeLa", {1, definition});
  };
  expect(0, 0, 0);
  expect(0, 1, 107);
  expect(0, 2, 0);
  expect(1, 0, 0);
  expect(1, 1, 107);
  expect(1, 2, 107);
}

TEST(LookAheadModes, LimitsOfAxesApplyByDefaultWithSeveralAxes) {
  LookAheadCard card;
  card.Prepare(2, 0);
  EXPECT_EQ(card.fifo().planner->limits.axes[0].velocity, motion::kUnlimited);
  EXPECT_TRUE(card.fifo().planner->limits.geometric);
  card.Prepare(2, 1);
  const motion::PathLimits& limits = card.fifo().planner->limits;
  EXPECT_DOUBLE_EQ(limits.axes[0].velocity, 100);      // pulse/ms
  EXPECT_DOUBLE_EQ(limits.axes[0].acceleration, 0.5);  // pulse/ms^2
  EXPECT_DOUBLE_EQ(limits.axes[0].jump, 5);            // 500 mm/s^2 * 0.01 s
  EXPECT_DOUBLE_EQ(limits.corner_time, 10);            // ms
  EXPECT_FALSE(limits.geometric);
}

TEST(LookAheadModes, LimitsOfAxesAreChosenAxisByAxis) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  std::vector<double> modes = {1, 6, 0, 0, 0, 0, 0, 0};
  card.Expect(0, "GT_SetAxisLimitModeLa", {1, &modes});
  card.Expect(0, "GT_SetWorkLimitModeLa", {1, 0});
  EXPECT_EQ(card.Init(), 0);
  const motion::PathLimits& limits = card.fifo().planner->limits;
  EXPECT_EQ(limits.axes[0].velocity, 100);
  EXPECT_EQ(limits.axes[0].acceleration, motion::kUnlimited);
  EXPECT_EQ(limits.axes[1].velocity, motion::kUnlimited);
  EXPECT_EQ(limits.axes[1].acceleration, 0.5);
  EXPECT_EQ(limits.axes[1].jump, 5);
  EXPECT_FALSE(limits.geometric);
}

TEST(LookAheadModes, AxesThatCountInTheLength) {
  const auto axes = [](int mode, int mask) {
    LookAheadCard card;
    card.SetUp(4);
    card.Expect(0, "GT_SetupLookAheadCrd", {1, mode});
    card.Expect(0, "GT_SetAxisVelValidModeLa", {1, mask});
    EXPECT_EQ(card.Init(), 0);
    return card.fifo().planner->limits.length_axes;
  };
  EXPECT_EQ(axes(0, 0xFF), 0x7u);
  EXPECT_EQ(axes(0, 0xF), 0x7u);
  EXPECT_EQ(axes(0, 0x3), 0x3u);
  EXPECT_EQ(axes(1, 0xFF), 0xFu);
  EXPECT_EQ(axes(1, 0x9), 0x9u);
}

TEST(LookAheadModes, FollowersNeedThreeAxes) {
  LookAheadCard card;
  card.SetUp();
  std::vector<double> modes = {0, 0, 7, 0, 0, 0, 0, 0};
  std::vector<double> limits(8, 100);
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 1});
  card.Expect(107, "GT_SetFollowAxisParaLa", {1, &modes, &limits, &limits, &limits});
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  card.Expect(0, "GT_SetFollowAxisParaLa", {1, &modes, &limits, &limits, &limits});
  EXPECT_EQ(card.Init(), 0);
  EXPECT_EQ(card.fifo().planner->limits.followers[2].velocity, 100);
  EXPECT_EQ(card.fifo().planner->limits.followers[2].jump, 1);
  EXPECT_EQ(card.fifo().planner->limits.followers[3].velocity, motion::kUnlimited);
}

TEST(LookAheadModes, AxesOfTheCoordinateSystemCannotFollow) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  std::vector<double> modes = {0, 1, 0, 0, 0, 0, 0, 0};
  std::vector<double> limits(8, 100);
  card.Expect(107, "GT_SetFollowAxisParaLa", {1, &modes, &limits, &limits, &limits});
  modes = {0, 0, 1, 0, 0, 0, 0, 0};
  limits[2] = 0;
  card.Expect(107, "GT_SetFollowAxisParaLa", {1, &modes, &limits, &limits, &limits});
  limits[2] = 1;
  card.Expect(0, "GT_SetFollowAxisParaLa", {1, &modes, &limits, &limits, &limits});
  std::vector<double> cells = LookAheadCard::Parameters();
  std::swap(cells[36], cells[37]);  // follower 3 would be axis 2 of the planner
  EXPECT_EQ(card.Init(cells), 107);
}

// --- Commands in pulses -------------------------------------------------------------------------

TEST(LookAheadInPulses, UsesThePlanner) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_InitLookAheadPara", {1, 200, 0.1, 0.01, 1000., 0});
  for (int i = 1; i <= 300; ++i) {
    ASSERT_EQ(card.Call("GT_LnXY", {1, 1600 * i, 1852 * i, 100., 0.8, 0., 0}), 0);
  }
  EXPECT_EQ(card.fifo().planner->spans.size(), 200u);
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace"), 4096 - 100);
  EXPECT_EQ(card.ReadFifo("GT_GetLookAheadSegCount"), 200);
  EXPECT_EQ(card.ReadFifo("GT_GetLookAheadSpace"), 0);
  card.Expect(0, "GT_CrdData", {1, nullptr, 0});
  // One trapezoid: 125 ms to 100 pulse/ms, and as long to stop.
  const double length = 300 * std::sqrt(1600.0 * 1600 + 1852.0 * 1852);
  EXPECT_EQ(card.Run(), std::ceil(length / 100 + 125));
  EXPECT_EQ(card.Position(0), 480000);
}

TEST(LookAheadInPulses, OnlyTheChosenAxesCountInTheLength) {
  LookAheadCard card;
  card.SetUp(4);
  card.Expect(0, "GT_SetupLookAheadCrd", {1, 0});
  card.Expect(0, "GT_SetAxisVelValidModeLa", {1, 0x9});
  card.Expect(0, "GT_InitLookAheadPara", {1, 200, 0.1, 0.01, 1000., 0});
  EXPECT_EQ(card.fifo().planner->limits.length_axes, 0x1u);
}

TEST(LookAheadInPulses, AtMostSixteenAuxiliaryCommandsInARow) {
  LookAheadCard card;
  card.SetUp();
  card.Expect(0, "GT_InitLookAheadPara", {1, 200, 0.1, 0.01, 1000., 0});
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(card.Line(100 * (round + 1), 0), 0);
    for (int i = 0; i < 16; ++i) card.Expect(0, "GT_BufIO", {1, 12, 1, i % 2, 0});
    card.Expect(107, "GT_BufIO", {1, 12, 1, 1, 0});
  }
  card.Expect(0, "GT_CrdData", {1, nullptr, 0});
  card.Expect(0, "GT_BufIO", {1, 12, 1, 1, 0});
}

TEST(LookAheadInPulses, NeedsACoordinateSystemAndRanges) {
  LookAheadCard card;
  card.Expect(103, "GT_InitLookAheadPara", {1, 200, 0.1, 0.01, 1000., 0});
  card.SetUp();
  card.Expect(107, "GT_InitLookAheadPara", {1, 0, 0.1, 0.01, 1000., 0});
  card.Expect(107, "GT_InitLookAheadPara", {1, 200, 0., 0.01, 1000., 0});
  card.Expect(107, "GT_InitLookAheadPara", {1, 200, 0.1, -1., 1000., 0});
  card.Expect(107, "GT_InitLookAheadPara", {1, 200, 0.1, 0.01, 0., 0});
}

TEST(LookAheadInPulses, DoesNotMixWithCommandsInMm) {
  LookAheadCard card;
  card.Prepare(4);
  card.Expect(107, "GT_LnXY", {1, 1000, 0, 10., 1., 0., 0});
  card.Expect(107, "GT_ArcXYC", {1, 1000, 1000, 1000., 0., 1, 10., 1., 0., 0});
  card.Expect(107, "GT_BufDelay", {1, 5, 0});
  card.Expect(107, "GT_CrdData", {1, nullptr, 0});
  EXPECT_NE(card.reason.en.find("GT_InitLookAheadEx"), std::string::npos);
  card.Expect(0, "GT_InitLookAheadPara", {1, 200, 0.1, 0.01, 1000., 0});
  ExpectOfAppending(card, 107);
  card.Expect(107, "GT_CrdDataEx", {1, nullptr, 0});
  card.Expect(0, "GT_LnXY", {1, 1000, 0, 10., 1., 0., 0});
}

TEST(LookAheadInPulses, TheOldLookAheadReplacesThePlanner) {
  LookAheadCard card;
  card.Prepare();
  EXPECT_EQ(card.LineEx(1, 1), 0);
  std::vector<double> buffer(1);
  card.Expect(1, "GT_InitLookAhead", {1, 0, 5., 1., 100, &buffer});
  EXPECT_EQ(card.Flush(), 0);
  card.Expect(0, "GT_InitLookAhead", {1, 0, 5., 1., 100, &buffer});
  card.Expect(0, "GT_LnXY", {1, 2000, 1000, 10., 1., 0., 0});
  EXPECT_EQ(card.LineEx(3, 1), 104);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
