// Coordinate systems: set-up, start, status, stops, look-ahead.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gtcalls/crd_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

using ::testing::HasSubstr;

TEST(SetCrdPrm, EveryMemberIsChecked) {
  struct {
    size_t cell;
    double value;
    int code;
  } const cases[] = {{0, 0, 7},          {0, 5, 7},      {1, 2, 7},       {1, 3, 7},
                     {8, 1, 7},          {9, 0, 7},      {9, 32766.9, 0}, {9, 32767, 7},
                     {10, 0, 7},         {10, 32767, 7}, {11, -1, 7},     {11, 32766, 0},
                     {11, 32767, 7},     {12, 1, 0},     {12, 2, 7},      {13, 1073741823, 0},
                     {13, 1073741824, 7}};
  for (const auto& c : cases) {
    CrdCommandCard card;
    std::vector<double> cells = CrdCommandCard::Parameters(2);
    cells[c.cell] = c.value;
    EXPECT_EQ(card.Call("GT_SetCrdPrm", {1, &cells}), c.code) << c.cell << ' ' << c.value;
  }
}

TEST(SetCrdPrm, TakesProfilesAtRestThatAreFree) {
  CrdCommandCard card;
  std::vector<double> cells = CrdCommandCard::Parameters(2);
  card.MoveTo(2, 100, 10);
  card.ExpectRefused(1, "GT_SetCrdPrm", {1, &cells});
  card.CyclesToRest(2);
  card.SetUp();
  EXPECT_EQ(card.Read("GT_GetPrfMode", 1), 5);
  card.ExpectRefused(1, "GT_SetCrdPrm", {2, &cells});
  EXPECT_EQ(card.reason.en,
            "profile 1 belongs to coordinate system 1, call GT_PrfTrap to remove it");
  std::vector<double> read(21);
  EXPECT_EQ(card.Call("GT_GetCrdPrm", {1, &read}), 0);
  EXPECT_EQ(read, cells);
  card.ExpectRefused(1, "GT_GetCrdPrm", {2, &read});
  EXPECT_EQ(card.reason.en, "coordinate system 2 has not been set up, call GT_SetCrdPrm");
}

TEST(CrdStart, NeedsSegmentsAndAxesAtTheirBegin) {
  CrdCommandCard card;
  card.ExpectRefused(1, "GT_CrdStart", {1, 0});
  card.SetUp();
  card.ExpectRefused(1, "GT_CrdStart", {0, 0});
  card.ExpectRefused(1, "GT_CrdStart", {1, 0});
  EXPECT_EQ(card.Line(100, 0), 0);
  EXPECT_EQ(card.Call("GT_SetPrfPos", {1, 5}), 0);
  card.ExpectRefused(1, "GT_CrdStart", {1, 0});
  EXPECT_EQ(card.reason.en,
            "coordinate 1 is at 5, the path goes on at 0: move the axes back, or call GT_CrdClear");
  EXPECT_EQ(card.Call("GT_SetPrfPos", {1, 0}), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.ExpectRefused(1, "GT_CrdStart", {1, 0});
  card.CyclesToEnd();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 100);
}

TEST(CrdStart, GoesOnWithAModalMoveThatWasStoppedShort) {
  CrdCommandCard card;
  card.SetUp();
  ASSERT_EQ(card.Call("GT_BufMove", {1, 3, 1000, 10, 1, 1, 0}), 0);
  ASSERT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(20);
  ASSERT_EQ(card.Call("GT_Stop", {4, 0}), 0);
  card.CyclesToEnd();
  ASSERT_EQ(card.Call("GT_PrfJog", {3}), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 1);
  EXPECT_THAT(card.reason.en, HasSubstr("needs mode Trap"));
  ASSERT_EQ(card.Call("GT_PrfTrap", {3}), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.CyclesToEnd();
  EXPECT_EQ(card.motion.state().profiles[2].now.position, 1000);
  // There is nothing left to wait for.
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 1);
}

TEST(CrdStart, StatusAndCounters) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace"), 4096);
  EXPECT_EQ(card.Call("GT_SetUserSegNum", {1, 77, 0}), 0);
  EXPECT_EQ(card.Call("GT_LnXYWN", {1, 1000, 0, 10, 1, 0, 5, 0}), 0);
  EXPECT_EQ(card.Line(1000, 1000), 0);
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace"), 4094);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(20);
  EXPECT_TRUE(card.Running());
  EXPECT_EQ(card.Status(1) & kMoving, kMoving);
  EXPECT_EQ(card.Status(2) & kMoving, kMoving);
  EXPECT_EQ(card.ReadFifo("GT_GetUserSegNum"), 77);
  EXPECT_EQ(card.ReadFifo("GT_GetUserSegNumWN"), 5);
  EXPECT_EQ(card.ReadFifo("GT_GetRemainderSegNum"), 2);
  EXPECT_EQ(card.ReadCrd("GT_GetCrdVel"), 10);
  EXPECT_EQ(card.ReadCrd("GT_GetUserTargetVel"), 10);
  std::vector<double> pos(2);
  EXPECT_EQ(card.Call("GT_GetCrdPos", {1, &pos}), 0);
  EXPECT_EQ(pos, (std::vector<double>{150, 0}));
  EXPECT_EQ(card.Call("GT_GetSegTargetPos", {1, &pos}), 0);
  EXPECT_EQ(pos, (std::vector<double>{1000, 0}));
  card.CyclesToEnd();
  EXPECT_FALSE(card.Running());
  EXPECT_EQ(card.motion.state().crds[0].fifos[0].done, 2);
  EXPECT_EQ(card.Status(1) & kMoving, 0);
}

/// A card with a bit of GT_Stop that is coordinate system 1 there.
struct CrdBit {
  int axes;
  int bit;
};

TEST(Stop, Bits12And13AndOnSmallCards8And9AreCoordinateSystems) {
  for (const auto& [axes, bit] : {CrdBit{4, 12}, {8, 12}, {12, 12}, {4, 8}, {8, 8}}) {
    for (const bool abrupt : {false, true}) {
      SCOPED_TRACE(testing::Message() << axes << " axes, bit " << bit << ", abrupt " << abrupt);
      CrdCommandCard card({.axis_count = axes, .cycle_us = 1000});
      card.SetUp();
      EXPECT_EQ(card.Call("GT_SetCrdStopDec", {1, 1, 10}), 0);
      EXPECT_EQ(card.Line(1000, 0), 0);
      EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
      card.Cycles(20);
      // 150 pulses in 20 ms: 50 while accelerating. From 10 pulse/ms: v^2 / (2 dec) more.
      EXPECT_EQ(card.Call("GT_Stop", {1 << (bit + 1), 1 << (bit + 1)}), 0);
      EXPECT_EQ(card.Call("GT_Stop", {1 << bit, abrupt ? 1 << bit : 0}), 0);
      card.CyclesToEnd();
      EXPECT_EQ(card.Read("GT_GetPrfPos"), abrupt ? 155 : 200);
      EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
      card.CyclesToEnd();
      EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000);
    }
  }
}

TEST(Stop, WithBothBitsOfACoordinateSystemIsAbruptIfOneIs) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Call("GT_SetCrdStopDec", {1, 1, 10}), 0);
  EXPECT_EQ(card.Line(1000, 0), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(20);
  EXPECT_EQ(card.Call("GT_Stop", {1 << 12 | 1 << 8, 1 << 12}), 0);
  card.CyclesToEnd();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 155);
}

TEST(Stop, OfACoordinateSystemAtRestMovesNoProfile) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Call("GT_SetPrfPos", {1, 5}), 0);
  EXPECT_EQ(card.Call("GT_Stop", {1 << 8, 0}), 0);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 5);
  // A profile that has left it.
  card.MoveTo(2, 100, 1);
  card.Cycles(20);
  EXPECT_EQ(card.Call("GT_Stop", {1 << 8, 0}), 0);
  EXPECT_EQ(card.Status(2) & kMoving, kMoving);
  card.CyclesToRest(2);
  EXPECT_EQ(card.Read("GT_GetPrfPos", 2), 100);
}

TEST(Stop, IgnoresTheOptionOfABitThatTheMaskDoesNotHave) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Line(1000, 0), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(20);
  EXPECT_EQ(card.Call("GT_Stop", {1 << 12, 1 << 8}), 0);
  card.CyclesToEnd();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 200);
}

TEST(Stop, OfACardWith12AxesTakesBits8And9AsAxes) {
  CrdCommandCard card({.axis_count = 12, .cycle_us = 1000});
  card.SetUp();
  EXPECT_EQ(card.Line(1000, 0), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(20);
  EXPECT_EQ(card.Call("GT_Stop", {3 << 8, 0}), 0);
  EXPECT_TRUE(card.Running());
  card.CyclesToEnd();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000);
}

TEST(CrdClear, ForgetsTheBreakpoint) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Line(1000, 0), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(20);
  card.ExpectRefused(1, "GT_CrdClear", {1, 0});
  EXPECT_EQ(card.Call("GT_Stop", {0x100, 0x100}), 0);
  card.CyclesToEnd();
  EXPECT_EQ(card.Call("GT_CrdClear", {1, 0}), 0);
  card.ExpectRefused(1, "GT_CrdStart", {1, 0});
}

TEST(SetOverride, ScalesTheVelocity) {
  CrdCommandCard card;
  card.ExpectRefused(1, "GT_SetOverride", {1, 0.5});
  card.SetUp();
  EXPECT_EQ(card.Call("GT_SetOverride", {1, 0}), 7);
  EXPECT_EQ(card.Call("GT_SetOverride", {1, 1.01}), 7);
  EXPECT_EQ(card.Call("GT_SetOverride2", {1, 0.2}), 0);
  EXPECT_EQ(card.Call("GT_SetOverride", {1, 0.5}), 0);
  EXPECT_EQ(card.Line(1000, 0), 0);
  EXPECT_EQ(card.Call("GT_LnXYOverride2", {1, 2000, 0, 10, 1, 0, 0}), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(100);
  EXPECT_EQ(card.ReadCrd("GT_GetCrdVel"), 5);
  card.Cycles(200);
  EXPECT_EQ(card.ReadCrd("GT_GetCrdVel"), 2);
}

TEST(SetOverride, ChangesTheVelocityOfARunningSegment) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Line(1000, 0), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(5);
  EXPECT_EQ(card.ReadCrd("GT_GetCrdVel"), 5);
  EXPECT_EQ(card.Call("GT_SetOverride", {1, 0.2}), 0);
  // From 5 pulse/ms at 12.5 pulses to 2 pulse/ms with 1 pulse/ms^2.
  card.Cycles(3);
  EXPECT_EQ(card.ReadCrd("GT_GetCrdVel"), 2);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 12.5 + 3 * 3.5);
  EXPECT_EQ(card.Call("GT_SetOverride", {1, 1}), 0);
  card.Cycles(8);
  EXPECT_EQ(card.ReadCrd("GT_GetCrdVel"), 10);
  card.CyclesToEnd();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000);
}

TEST(CrdStatus, PositionAndVelocityWhileItMoves) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Line(60, 80), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  // 100 pulses at 10 pulse/ms and 1 pulse/ms^2 from rest to rest: 20 ms.
  const struct {
    int cycles;
    double path, velocity;
  } cases[] = {{5, 12.5, 5}, {5, 50, 10}, {5, 87.5, 5}, {5, 100, 0}};
  for (const auto& c : cases) {
    card.Cycles(c.cycles);
    std::vector<double> position(2);
    EXPECT_EQ(card.Call("GT_GetCrdPos", {1, &position}), 0);
    EXPECT_DOUBLE_EQ(position[0], 0.6 * c.path);
    EXPECT_DOUBLE_EQ(position[1], 0.8 * c.path);
    EXPECT_DOUBLE_EQ(card.ReadCrd("GT_GetCrdVel"), c.velocity);
  }
}

TEST(CrdSpace, CountsSegmentsAndBufferedCommands) {
  CrdCommandCard card;
  std::vector<double> space(1);
  card.ExpectRefused(1, "GT_CrdSpace", {1, &space, 0});
  card.SetUp();
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace"), 4096);
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace", 1), 4096);
  EXPECT_EQ(card.Line(100, 0), 0);
  EXPECT_EQ(card.Call("GT_BufDelay", {1, 5, 0}), 0);
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace"), 4094);
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace", 1), 4096);
  EXPECT_EQ(card.Call("GT_CrdClear", {1, 0}), 0);
  EXPECT_EQ(card.ReadFifo("GT_CrdSpace"), 4096);
}

TEST(SetCrdStopDec, GivesTheDecelerationOfStops) {
  CrdCommandCard card;
  card.SetUp();
  std::vector<double> smooth(1);
  std::vector<double> abrupt(1);
  EXPECT_EQ(card.Call("GT_GetCrdStopDec", {1, &smooth, &abrupt}), 0);
  EXPECT_EQ(smooth[0], 1);
  EXPECT_EQ(abrupt[0], 1000);
  card.ExpectRefused(7, "GT_SetCrdStopDec", {1, 0, 10});
  card.ExpectRefused(7, "GT_SetCrdStopDec", {1, 10, 32767.5});
  EXPECT_EQ(card.Call("GT_SetCrdStopDec", {1, 2, 32767}), 0);
  EXPECT_EQ(card.Call("GT_GetCrdStopDec", {1, &smooth, &abrupt}), 0);
  EXPECT_EQ(smooth[0], 2);
  EXPECT_EQ(abrupt[0], 32767);
  EXPECT_EQ(card.Line(1000, 0), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(20);
  EXPECT_EQ(card.Call("GT_Stop", {0x100, 0}), 0);
  // 150 pulses are complete; at 10 pulse/ms and 2 pulse/ms^2 the rest takes 25 ms.
  card.CyclesToEnd();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 175);
}

TEST(SetCrdLmtStopMode, ChoosesTheDecelerationOfStopsAtLimits) {
  struct Case {
    int mode;
    double end;
  };
  // At 20 ms the path is at 150, beyond the limit, with 10 pulse/ms; it decelerates with 10 or with
  // 2 pulse/ms^2.
  for (const Case& c : {Case{0, 155}, Case{1, 175}}) {
    CrdCommandCard card;
    card.SetUp();
    EXPECT_EQ(card.Call("GT_SetCrdStopDec", {1, 2, 10}), 0);
    EXPECT_EQ(card.Call("GT_SetSoftLimit", {1, 145, -145}), 0);
    EXPECT_EQ(card.Call("GT_SetCrdLmtStopMode", {1, c.mode}), 0);
    EXPECT_EQ(card.Line(1000, 0), 0);
    EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
    card.CyclesToEnd();
    EXPECT_EQ(card.Read("GT_GetPrfPos"), c.end) << c.mode;
  }
}

TEST(SetCrdLmtStopMode, IsReadBackAndSetBackBySetCrdPrm) {
  CrdCommandCard card;
  card.SetUp();
  std::vector<double> mode(1, -1);
  const auto expect_mode = [&](double expected) {
    EXPECT_EQ(card.Call("GT_GetCrdLmtStopMode", {1, &mode}), 0);
    EXPECT_EQ(mode[0], expected);
  };
  expect_mode(0);
  EXPECT_EQ(card.Call("GT_SetCrdLmtStopMode", {1, 1}), 0);
  expect_mode(1);
  card.SetUp();
  expect_mode(0);
}

TEST(SetCrdLmtStopMode, IsRefusedForOtherModesAndWithoutASystem) {
  CrdCommandCard card;
  std::vector<double> mode(1);
  card.ExpectRefused(1, "GT_SetCrdLmtStopMode", {1, 0});
  card.ExpectRefused(1, "GT_GetCrdLmtStopMode", {1, &mode});
  card.SetUp();
  card.ExpectRefused(7, "GT_SetCrdLmtStopMode", {1, 2});
  card.ExpectRefused(7, "GT_SetCrdLmtStopMode", {1, -1});
}

TEST(SetCrdSingleMaxVel, LimitsThePathByItsAxes) {
  CrdCommandCard card;
  card.SetUp();
  std::vector<double> limits = {5, 5};
  EXPECT_EQ(card.Call("GT_SetCrdSingleMaxVel", {1, &limits}), 0);
  std::vector<double> read(2);
  EXPECT_EQ(card.Call("GT_GetCrdSingleMaxVel", {1, &read}), 0);
  EXPECT_EQ(read, limits);
  EXPECT_EQ(card.Line(600, 800), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(50);
  EXPECT_DOUBLE_EQ(card.ReadCrd("GT_GetCrdVel"), 5 / 0.8);
}

TEST(CrdStartStep, EndsAtRestAfterEachSegment) {
  CrdCommandCard card;
  card.SetUp();
  EXPECT_EQ(card.Call("GT_LnXY", {1, 100, 0, 10, 1, 10, 0}), 0);
  EXPECT_EQ(card.Call("GT_LnXY", {1, 200, 0, 10, 1, 10, 0}), 0);
  for (const double end : {100.0, 200.0}) {
    EXPECT_EQ(card.Call("GT_CrdStartStep", {1, 0}), 0);
    card.CyclesToEnd();
    EXPECT_FALSE(card.Running());
    EXPECT_EQ(card.Read("GT_GetPrfPos"), end);
  }
  card.ExpectRefused(1, "GT_CrdStartStep", {1, 0});
}

TEST(CrdStepMode, EndsEveryRunAfterASegmentUntilItIsSwitchedOff) {
  CrdCommandCard card;
  card.ExpectRefused(1, "GT_CrdStepMode", {1, 1});
  card.SetUp();
  for (int x = 100; x <= 400; x += 100) EXPECT_EQ(card.Line(x, 0), 0);
  EXPECT_EQ(card.Call("GT_CrdStepMode", {1, 1}), 0);
  for (const double end : {100.0, 200.0}) {
    EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
    card.CyclesToEnd();
    EXPECT_EQ(card.Read("GT_GetPrfPos"), end);
  }
  EXPECT_EQ(card.Call("GT_CrdStepMode", {1, 0}), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.CyclesToEnd();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 400);
}

TEST(InitLookAhead, ChecksAndCounts) {
  CrdCommandCard card;
  std::vector<double> buffer(36);
  card.ExpectRefused(1, "GT_InitLookAhead", {1, 0, 5, 1, 10, &buffer});
  card.SetUp();
  EXPECT_EQ(card.Call("GT_InitLookAhead", {1, 0, 0, 1, 10, &buffer}), 7);
  EXPECT_EQ(card.Call("GT_InitLookAhead", {1, 0, 5, 0, 10, &buffer}), 7);
  EXPECT_EQ(card.Call("GT_InitLookAhead", {1, 0, 5, 1, 32767, &buffer}), 7);
  EXPECT_EQ(card.Call("GT_InitLookAhead", {1, 0, 5, 1, 10, &buffer}), 0);
  EXPECT_EQ(card.Line(100, 0), 0);
  EXPECT_EQ(card.ReadFifo("GT_GetLookAheadSpace"), 9);
  EXPECT_EQ(card.ReadFifo("GT_GetLookAheadSegCount"), 1);
  card.ExpectRefused(1, "GT_InitLookAhead", {1, 0, 5, 1, 10, &buffer});
  card.ExpectRefused(1, "GT_CrdStart", {1, 0});
  EXPECT_EQ(card.Call("GT_CrdData", {1, nullptr, 0}), 0);
  EXPECT_EQ(card.ReadFifo("GT_GetLookAheadSegCount"), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
