// Drives, status, inputs, limits, stops, the in-position band, scales and filters through their
// commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/axis_command_support.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::DiType;
using motion::DoType;

// --- Starts into a latched limit ---------------------------------------------------------------

/// Prepares axis 2 in a mode up to its start; it will move in `direction`. Axis 1 is the master.
void PrepareMode(AxisCommandCard& card, std::string_view mode, int direction) {
  if (mode == "PT") {
    EXPECT_EQ(card.Call("GT_PrfPt", {2, 0}), 0);
    EXPECT_EQ(card.Call("GT_PtData", {2, 0.0, 5, 0, 0}), 0);
    EXPECT_EQ(card.Call("GT_PtData", {2, direction * 100.0, 20, 0, 0}), 0);
  } else if (mode == "PVT") {
    std::vector<double> times = {0, 10, 20};
    std::vector<double> positions = {0, 0, direction * 100.0};
    std::vector<double> velocities = {0, 0, 0};
    EXPECT_EQ(card.Call("GT_PrfPvt", {2}), 0);
    EXPECT_EQ(card.Call("GT_PvtTable", {1, 3, &times, &positions, &velocities}), 0);
    EXPECT_EQ(card.Call("GT_PvtTableSelect", {2, 1}), 0);
  } else if (mode == "Gear") {
    EXPECT_EQ(card.Call("GT_PrfGear", {2, 0}), 0);
    EXPECT_EQ(card.Call("GT_SetGearMaster", {2, 1, 2, 0}), 0);
    EXPECT_EQ(card.Call("GT_SetGearRatio", {2, 1, direction, 0}), 0);
  } else if (mode == "Follow") {
    EXPECT_EQ(card.Call("GT_PrfFollow", {2, 0}), 0);
    EXPECT_EQ(card.Call("GT_SetFollowMaster", {2, 1, 2, 0}), 0);
    EXPECT_EQ(card.Call("GT_FollowData", {2, 100000, direction * 1000.0, 1, 0}), 0);
  } else {
    card.PrepareTrap(2, direction * 1000, 10);
  }
}

int16_t StartMode(AxisCommandCard& card, std::string_view mode) {
  if (mode == "PT") return card.Call("GT_PtStart", {2, 0});
  if (mode == "PVT") return card.Call("GT_PvtStart", {2});
  if (mode == "Gear") return card.Call("GT_GearStart", {2});
  if (mode == "Follow") return card.Call("GT_FollowStart", {2, 0});
  return card.Call("GT_Update", {2});
}

constexpr std::string_view kModes[] = {"Trap", "PT", "PVT", "Gear", "Follow"};

TEST(LatchedLimit, NoModeStartsIntoIt) {
  for (const std::string_view mode : kModes) {
    for (const int direction : {1, -1}) {
      AxisCommandCard card;
      card.PrepareJog(1, 10);
      EXPECT_EQ(card.Update(1), 0);
      const DiType limit = direction > 0 ? DiType::kLimitPositive : DiType::kLimitNegative;
      card.Drive(limit, 1, true);
      PrepareMode(card, mode, direction);
      EXPECT_EQ(StartMode(card, mode), 1) << mode;
      EXPECT_EQ(card.reason.en, direction > 0 ? "axis 2 positive limit latched: move away from it, "
                                                "call GT_ClrSts"
                                              : "axis 2 negative limit latched: move away from it, "
                                                "call GT_ClrSts");
      card.Cycles(30);
      EXPECT_EQ(card.Read("GT_GetPrfPos", 2), 0) << mode;
    }
  }
}

TEST(LatchedLimit, EveryModeStartsAwayFromIt) {
  for (const std::string_view mode : kModes) {
    AxisCommandCard card;
    card.PrepareJog(1, 10);
    EXPECT_EQ(card.Update(1), 0);
    card.Drive(DiType::kLimitNegative, 1, true);
    PrepareMode(card, mode, 1);
    EXPECT_EQ(StartMode(card, mode), 0) << mode;
    card.Cycles(20);
    EXPECT_GT(card.Read("GT_GetPrfPos", 2), 0.1) << mode;
  }
}

TEST(LatchedLimit, ASlaveIsHeldWhenItsMasterBeginsToMove) {
  for (const std::string_view mode : {"Gear", "Follow"}) {
    AxisCommandCard card;
    card.Drive(DiType::kLimitPositive, 1, true);
    PrepareMode(card, mode, 1);
    EXPECT_EQ(StartMode(card, mode), 0) << mode;
    card.PrepareJog(1, 10);
    EXPECT_EQ(card.Update(1), 0);
    for (int i = 0; i < 30; ++i) {
      card.Cycle();
      ASSERT_EQ(card.Read("GT_GetPrfPos", 2), 0) << mode;
    }
    EXPECT_EQ(card.Status(2) & kMoving, 0) << mode;
  }
}

// --- Drive -------------------------------------------------------------------------------------

TEST(AxisOn, SetsTheEnableOutputAndBit9) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {3}), 0);
  EXPECT_EQ(card.Status(3), kServoOn);
  EXPECT_EQ(card.Status(1), 0);
  EXPECT_EQ(card.motion.state().io.Register(DoType::kEnable), 4u);
  EXPECT_EQ(card.Call("GT_AxisOff", {3}), 0);
  EXPECT_EQ(card.Status(3), 0);
  EXPECT_EQ(card.motion.state().io.Register(DoType::kEnable), 0u);
}

TEST(AxisOn, IsRefusedWhileTheDriveReportsAnAlarm) {
  AxisCommandCard card;
  card.Drive(DiType::kAlarm, 0, true);
  card.ExpectRefused(1, "GT_AxisOn", {1});
  EXPECT_EQ(card.reason.en,
            "the drive of axis 1 reports an alarm; remove its cause, or call GT_AlarmOff when no "
            "drive is connected");
  EXPECT_EQ(card.Call("GT_AxisOn", {2}), 0);
  EXPECT_EQ(card.Call("GT_AlarmOff", {1}), 0);
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.Cycle();
  EXPECT_EQ(card.Status(1) & kServoOn, kServoOn);
}

TEST(AxisOn, IsRefusedWhileTheProfileMoves) {
  AxisCommandCard card;
  card.MoveTo(1, 1000, 10);
  card.ExpectRefused(1, "GT_AxisOn", {1});
  EXPECT_EQ(card.reason.en,
            "profile 1 is moving, call GT_Stop and wait until bit 10 of GT_GetSts is 0");
  card.CyclesToRest();
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
}

TEST(AxisOff, StopsTheProfileAbruptly) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.MoveTo(1, 1000, 10);
  card.Cycles(50);
  EXPECT_EQ(card.Call("GT_AxisOff", {1}), 0);
  card.Cycle();
  EXPECT_EQ(card.Status(), 0);
  EXPECT_NEAR(card.Read("GT_GetPrfPos"), 450.05, 1e-9);
}

TEST(AxisOn, TheCardsAxesAreItsRange) {
  for (const auto& [axes, axis, code] :
       {std::tuple{4, 0, 7}, {4, 1, 0}, {4, 4, 0}, {4, 5, 7}, {12, 12, 0}, {12, 13, 7}}) {
    AxisCommandCard card({.axis_count = axes});
    EXPECT_EQ(card.Call("GT_AxisOn", {axis}), code) << axes << " " << axis;
    EXPECT_EQ(card.Call("GT_AxisOff", {axis}), code) << axes << " " << axis;
  }
}

// --- Status ------------------------------------------------------------------------------------

TEST(GetSts, ReadsConsecutiveAxesAndTheClock) {
  AxisCommandCard card;
  card.Cycles(7);
  EXPECT_EQ(card.Call("GT_AxisOn", {3}), 0);
  std::vector<double> status(3, 5);
  std::vector<double> clock(1);
  EXPECT_EQ(card.Call("GT_GetSts", {2, &status, 3, &clock}), 0);
  EXPECT_EQ(status, (std::vector<double>{0, kServoOn, 0}));
  EXPECT_EQ(clock[0], 7);
}

TEST(GetSts, CountStaysOnTheCard) {
  struct {
    int axes, axis, count, code;
  } const cases[] = {{8, 1, 8, 0}, {8, 1, 0, 7}, {8, 1, 9, 7},  {8, 8, 1, 0},  {8, 8, 2, 7},
                     {4, 1, 5, 7}, {4, 1, 4, 0}, {12, 5, 8, 0}, {12, 6, 8, 7}, {12, 1, 9, 7}};
  for (const auto& c : cases) {
    AxisCommandCard card({.axis_count = c.axes});
    std::vector<double> status(12);
    EXPECT_EQ(card.Call("GT_GetSts", {c.axis, &status, c.count, nullptr}), c.code)
        << c.axes << " " << c.axis << " " << c.count;
  }
}

TEST(GetSts, Bit10FollowsUpdateWithoutACycle) {
  AxisCommandCard card;
  card.MoveTo(1, 1000, 10);
  EXPECT_EQ(card.Status(), kMoving);
  EXPECT_EQ(card.Call("GT_Stop", {1, 0}), 0);
  EXPECT_EQ(card.Status(), 0) << "nothing has moved yet";
}

TEST(ClrSts, ClearsConsecutiveAxesWhereTheCauseHasGone) {
  AxisCommandCard card;
  for (const int bit : {0, 1, 2}) card.Drive(DiType::kAlarm, bit, true);
  for (const int bit : {0, 2}) card.Drive(DiType::kAlarm, bit, false);
  EXPECT_EQ(card.Status(1), 2);
  EXPECT_EQ(card.Call("GT_ClrSts", {1, 2}), 0);
  EXPECT_EQ(card.Status(1), 0);
  EXPECT_EQ(card.Status(2), 2) << "still active";
  EXPECT_EQ(card.Status(3), 2) << "not asked for";
  EXPECT_EQ(card.Call("GT_ClrSts", {1, 8}), 0);
  EXPECT_EQ(card.Status(3), 0);
  EXPECT_EQ(card.Call("GT_ClrSts", {1, 9}), 7);
  EXPECT_EQ(card.Call("GT_ClrSts", {1, 0}), 7);
}

// --- Inputs ------------------------------------------------------------------------------------

TEST(AlarmOn, SwitchesTheAlarmInput) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AlarmOff", {1}), 0);
  card.Drive(DiType::kAlarm, 0, true);
  EXPECT_EQ(card.Status(), 0);
  EXPECT_EQ(card.Call("GT_AlarmOn", {1}), 0);
  card.Cycle();
  EXPECT_EQ(card.Status(), 2);
}

TEST(AlarmOn, IsRefusedWithoutAnAlarmInput) {
  AxisCommandCard card;
  ChangeState(card.motion).axes[0].alarm.bit = -1;
  card.ExpectRefused(1, "GT_AlarmOn", {1});
  EXPECT_EQ(card.reason.en, "the configuration assigns no alarm input to axis 1");
  card.ExpectRefused(1, "GT_AlarmOff", {1});
  EXPECT_EQ(card.Call("GT_AlarmOff", {2}), 0);
}

TEST(LmtsOn, SwitchesTheLimitsOfItsType) {
  struct {
    int type;
    int off;  ///< status bits that the limit type disables
  } const cases[] = {{-1, 0x60}, {0, 0x20}, {1, 0x40}};
  for (const auto& c : cases) {
    AxisCommandCard card;
    EXPECT_EQ(card.Call("GT_LmtsOff", {1, c.type}), 0);
    card.Drive(DiType::kLimitPositive, 0, true);
    card.Drive(DiType::kLimitNegative, 0, true);
    EXPECT_EQ(card.Status(), 0x60 & ~c.off) << c.type;
    EXPECT_EQ(card.Call("GT_LmtsOn", {1, c.type}), 0);
    card.Cycle();
    EXPECT_EQ(card.Status(), 0x60) << c.type;
    EXPECT_EQ(card.Call("GT_LmtsOff", {1, -2}), 7);
    EXPECT_EQ(card.Call("GT_LmtsOn", {1, 2}), 7);
  }
}

TEST(LmtsOn, IsRefusedWhenAnInputItNamesDoesNotExist) {
  AxisCommandCard card;
  ChangeState(card.motion).axes[0].negative_limit.bit = -1;
  for (const char* command : {"GT_LmtsOn", "GT_LmtsOff"}) {
    card.ExpectRefused(1, command, {1, -1});
    card.ExpectRefused(1, command, {1, 1});
    EXPECT_EQ(card.reason.en, "the configuration assigns no negative limit input to axis 1");
    EXPECT_EQ(card.Call(command, {1, 0}), 0);
  }
}

TEST(SoftLimitCommand, IsReadBackAndNeedsPositiveAboveNegative) {
  AxisCommandCard card;
  std::vector<double> positive(1);
  std::vector<double> negative(1);
  EXPECT_EQ(card.Call("GT_GetSoftLimit", {1, &positive, &negative}), 0);
  EXPECT_EQ(positive[0], 2147483647.0);
  EXPECT_EQ(negative[0], -2147483648.0);
  EXPECT_EQ(card.Call("GT_SetSoftLimit", {1, 20000, -20000}), 0);
  EXPECT_EQ(card.Call("GT_GetSoftLimit", {1, &positive, &negative}), 0);
  EXPECT_EQ(positive[0], 20000);
  EXPECT_EQ(negative[0], -20000);
  EXPECT_EQ(card.Call("GT_SetSoftLimit", {1, -5, -6}), 0);
  card.ExpectRefused(7, "GT_SetSoftLimit", {1, 5, 5});
  card.ExpectRefused(7, "GT_SetSoftLimit", {1, -6, -5});
  EXPECT_EQ(card.Call("GT_SetSoftLimit", {1, 2147483647.0, -2147483648.0}), 0);
  EXPECT_EQ(card.Call("GT_SetSoftLimit", {1, 2147483648.0, 0}), 7);
}

TEST(SetStopIo, Type0StopsAbruptlyAndType1Smoothly) {
  struct {
    int type;
    int bit;
  } const cases[] = {{0, kAbruptStop}, {1, kSmoothStop}};
  for (const auto& c : cases) {
    AxisCommandCard card;
    EXPECT_EQ(card.Call("GT_SetStopIo", {1, c.type, 4, 16}), 0);
    card.MoveTo(1, 100000, 10);
    card.Cycles(50);
    card.Drive(DiType::kGpi, 15, true);
    card.Cycles(11);
    EXPECT_EQ(card.Status(), c.bit) << c.type;
    card.ExpectRefused(1, "GT_Update", {1});
    EXPECT_EQ(card.reason.en, "axis 1 stop input latched, call GT_ClrSts");
    card.Drive(DiType::kGpi, 15, false);
    card.ExpectRefused(1, "GT_Update", {1});
    EXPECT_EQ(card.Call("GT_ClrSts", {1, 1}), 0);
    EXPECT_EQ(card.Update(1), 0);
    // -1 disables the input again.
    EXPECT_EQ(card.Call("GT_SetStopIo", {1, c.type, 4, -1}), 0);
    card.Drive(DiType::kGpi, 15, true);
    EXPECT_EQ(card.Status(), kMoving);
  }
}

TEST(SetStopIo, IndexStaysWithinItsWord) {
  struct {
    int stop, type, index, code;
  } const cases[] = {{0, 4, 1, 0},  {0, 4, 16, 0}, {0, 4, 17, 7}, {0, 4, 0, 7}, {0, 4, -2, 7},
                     {0, 0, 8, 0},  {0, 0, 9, 7},  {1, 6, 7, 0},  {1, 6, 8, 7}, {2, 4, 1, 7},
                     {-1, 4, 1, 7}, {0, 7, 1, 7},  {0, -1, 1, 7}};
  for (const auto& c : cases) {
    AxisCommandCard card;
    EXPECT_EQ(card.Call("GT_SetStopIo", {1, c.stop, c.type, c.index}), c.code)
        << c.stop << " " << c.type << " " << c.index;
  }
}

// --- Stops -------------------------------------------------------------------------------------

TEST(StopDec, IsReadBackAndChecked) {
  AxisCommandCard card;
  std::vector<double> smooth(1);
  std::vector<double> abrupt(1);
  EXPECT_EQ(card.Call("GT_GetStopDec", {2, &smooth, &abrupt}), 0);
  EXPECT_EQ(smooth[0], 1);
  EXPECT_EQ(abrupt[0], 1000);
  EXPECT_EQ(card.Call("GT_SetStopDec", {2, 0.5, 32767}), 0);
  EXPECT_EQ(card.Call("GT_GetStopDec", {2, &smooth, &abrupt}), 0);
  EXPECT_EQ(smooth[0], 0.5);
  EXPECT_EQ(abrupt[0], 32767);
  EXPECT_EQ(card.Call("GT_SetStopDec", {2, 0, 1}), 7);
  EXPECT_EQ(card.Call("GT_SetStopDec", {2, 1, 0}), 7);
  EXPECT_EQ(card.Call("GT_SetStopDec", {2, 1, 32767.5}), 7);
  EXPECT_EQ(card.Call("GT_SetStopDec", {2, -1, 1}), 7);
}

TEST(Stop, StopsTheMaskedAxesSmoothlyOrAbruptly) {
  AxisCommandCard card;
  for (const int axis : {1, 2, 3}) card.MoveTo(axis, 100000, 10);
  card.Cycles(50);
  EXPECT_EQ(card.Call("GT_Stop", {0b011, 0b110}), 0);
  card.Cycle();
  EXPECT_EQ(card.Status(1), kMoving);
  EXPECT_EQ(card.Status(2), 0);
  EXPECT_EQ(card.Read("GT_GetPrfVel", 1), 9);
  EXPECT_EQ(card.Read("GT_GetPrfVel", 3), 10);
  card.Cycles(9);
  EXPECT_EQ(card.Status(1), 0);
  EXPECT_EQ(card.Read("GT_GetPrfPos", 1), 500);
  EXPECT_NEAR(card.Read("GT_GetPrfPos", 2), 450.05, 1e-9);
}

TEST(Stop, AMaskWithoutAnyAxisIsRefused) {
  AxisCommandCard card({.axis_count = 4});
  card.ExpectRefused(1, "GT_Stop", {0, 0});
  EXPECT_EQ(card.reason.en, "the mask selects no axis of this card; bit 0 is axis 1");
  card.ExpectRefused(1, "GT_Stop", {0x10, 0});
  EXPECT_EQ(card.Call("GT_Stop", {-1, 0}), 0);
  EXPECT_EQ(card.Call("GT_Stop", {0xFFFFFFFF * 1.0, 0xFFFFFFFF * 1.0}), 0);
}

// --- In position -------------------------------------------------------------------------------

TEST(AxisBand, IsOffUntilItIsSetAndTakesItsTime) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.Cycles(10);
  EXPECT_EQ(card.Status(), kServoOn);
  EXPECT_EQ(card.Call("GT_SetAxisBand", {1, 20, 8}), 0);  // 8 x 250 us
  card.Cycles(2);
  EXPECT_EQ(card.Status(), kServoOn);
  card.Cycle();
  EXPECT_EQ(card.Status(), kServoOn | kInPosition);
  std::vector<double> band(1);
  std::vector<double> time(1);
  EXPECT_EQ(card.Call("GT_GetAxisBand", {1, &band, &time}), 0);
  EXPECT_EQ(band[0], 20);
  EXPECT_EQ(time[0], 8);
}

TEST(AxisBand, RefusesNegativeValues) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_SetAxisBand", {1, -1, 0}), 7);
  EXPECT_EQ(card.Call("GT_SetAxisBand", {1, 0, -1}), 7);
  EXPECT_EQ(card.Call("GT_SetAxisBand", {1, 0, 0}), 0);
  EXPECT_EQ(card.Call("GT_SetAxisBand", {1, 2147483647.0, 2147483647.0}), 0);
}

// --- Scales and filters ------------------------------------------------------------------------

TEST(ScaleCommand, SetsTheUnitsOfTheAxis) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_ProfileScale", {1, 2, -1}), 0);
  EXPECT_EQ(card.Call("GT_EncScale", {1, -4, 1}), 0);
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.MoveTo(1, 1000, 10);
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos"), -500);
  EXPECT_EQ(card.Read("GT_GetEncPos"), -500);
  EXPECT_EQ(card.Read("GT_GetAxisEncPos"), 125);
  EXPECT_EQ(card.Read("GT_GetAxisError"), -625);
}

TEST(ScaleCommand, RangesAndTheirRelationAreChecked) {
  struct {
    int alpha, beta, code;
  } const cases[] = {{1, 1, 0},         {32766, 1, 0},      {-32766, 32766, 0}, {32767, 1, 7},
                     {-32767, 1, 7},    {0, 1, 7},          {1, 0, 7},          {0, 0, 7},
                     {1, 2, 7},         {-2, 3, 7},         {3, -2, 0},         {2, -2, 0},
                     {32766, 32767, 7}, {32766, -32766, 0}, {32766, -32767, 7}};
  for (const char* command : {"GT_ProfileScale", "GT_EncScale"}) {
    for (const auto& c : cases) {
      AxisCommandCard card;
      EXPECT_EQ(card.Call(command, {1, c.alpha, c.beta}), c.code)
          << command << " " << c.alpha << " " << c.beta;
    }
    AxisCommandCard card;
    card.MoveTo(1, 1000, 10);
    card.ExpectRefused(1, command, {1, 2, 1});
    card.ExpectRefused(7, command, {1, 1, 2});
    EXPECT_EQ(card.Call(command, {2, 2, 1}), 0);
  }
}

TEST(VelocityFilterCommand, AveragesTheVelocityThatIsRead) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  EXPECT_EQ(card.Call("GT_SetAxisPrfVelFilter", {1, 2}), 0);
  EXPECT_EQ(card.Call("GT_SetAxisEncVelFilter", {1, 1}), 0);
  card.MoveTo(1, 100000, 100);
  card.Cycles(20);
  EXPECT_EQ(card.Read("GT_GetPrfVel"), 20);
  EXPECT_EQ(card.Read("GT_GetAxisPrfVel"), 18.5);  // 17, 18, 19, 20
  EXPECT_NEAR(card.Read("GT_GetAxisEncVel"), 19, 1);
  std::vector<double> exponent(1);
  EXPECT_EQ(card.Call("GT_GetAxisPrfVelFilter", {1, &exponent}), 0);
  EXPECT_EQ(exponent[0], 2);
  EXPECT_EQ(card.Call("GT_GetAxisEncVelFilter", {1, &exponent}), 0);
  EXPECT_EQ(exponent[0], 1);
  EXPECT_EQ(card.Call("GT_SetAxisPrfVelFilter", {1, 0}), 0);
  EXPECT_EQ(card.Read("GT_GetAxisPrfVel"), 20);
}

TEST(VelocityFilterCommand, ExponentIsCheckedAtBothEnds) {
  AxisCommandCard card;
  for (const char* command : {"GT_SetAxisPrfVelFilter", "GT_SetAxisEncVelFilter"}) {
    for (const auto& [exponent, code] : {std::pair{-1, 7}, {0, 0}, {8, 0}, {9, 7}}) {
      EXPECT_EQ(card.Call(command, {1, exponent}), code) << command << " " << exponent;
    }
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gts
