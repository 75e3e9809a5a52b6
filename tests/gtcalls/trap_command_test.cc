// Trap, Jog and GT_Update through their commands.
#include <gtest/gtest.h>

#include <limits>

#include "tests/gtcalls/axis_command_support.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::DiType;
using motion::ProfileMode;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> Parameters(AxisCommandCard& card, const char* command, size_t size) {
  std::vector<double> values(size, -1);
  EXPECT_EQ(card.Call(command, {1, &values}), 0) << command;
  return values;
}

// --- Modes -------------------------------------------------------------------------------------

TEST(PrfTrap, ChoosesItsModeAtRest) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_PrfJog", {1}), 0);
  EXPECT_EQ(card.Read("GT_GetPrfMode"), 1);
  EXPECT_EQ(card.Call("GT_PrfTrap", {1}), 0);
  EXPECT_EQ(card.Read("GT_GetPrfMode"), 0);
  card.MoveTo(1, 1000, 10);
  for (const char* command : {"GT_PrfTrap", "GT_PrfJog"}) {
    card.ExpectRefused(1, command, {1});
    EXPECT_EQ(card.Call(command, {2}), 0);
    EXPECT_EQ(card.Call(command, {9}), 7);
  }
}

TEST(PrfTrap, KeepsTheParameters) {
  AxisCommandCard card;
  card.PrepareTrap(1, 1234, 5);
  EXPECT_EQ(card.Call("GT_PrfJog", {1}), 0);
  EXPECT_EQ(card.Call("GT_PrfTrap", {1}), 0);
  EXPECT_EQ(Parameters(card, "GT_GetPos", 1)[0], 1234);
  EXPECT_EQ(Parameters(card, "GT_GetVel", 1)[0], 5);
}

// --- Parameters --------------------------------------------------------------------------------

TEST(TrapPrm, IsReadBack) {
  AxisCommandCard card;
  std::vector<double> values = {0.25, 0.125, 3, 25};
  EXPECT_EQ(card.Call("GT_SetTrapPrm", {1, &values}), 0);
  EXPECT_EQ(Parameters(card, "GT_GetTrapPrm", 4), values);
}

TEST(TrapPrm, EveryMemberIsChecked) {
  struct {
    std::vector<double> values;
    int code;
  } const cases[] = {
      {{1, 1, 0, 0}, 0},      {{0, 1, 0, 0}, 7},         {{-1, 1, 0, 0}, 7},
      {{kNan, 1, 0, 0}, 7},   {{kInfinity, 1, 0, 0}, 7}, {{1, -1, 0, 0}, 7},
      {{1, kNan, 0, 0}, 7},   {{1, 0, 0, 0}, 0},         {{1, 1, -0.5, 0}, 7},
      {{1, 1, kNan, 0}, 7},   {{1, 1, 32767, 0}, 0},     {{1, 1, 32768, 0}, 7},
      {{1, 1, 0, -1}, 7},     {{1, 1, 0, 50}, 0},        {{1, 1, 0, 51}, 7},
      {{1e-9, 1e9, 0, 0}, 0}, {{1e-10, 1, 0, 0}, 7},     {{1, 2e9, 0, 0}, 7},
  };
  for (auto c : cases) {
    AxisCommandCard card;
    const uint64_t before = card.Hash();
    EXPECT_EQ(card.Call("GT_SetTrapPrm", {1, &c.values}), c.code)
        << testing::PrintToString(c.values);
    if (c.code != 0) {
      EXPECT_EQ(card.Hash(), before);
    }
  }
}

// 100 pulses with two ramps of a pulse/ms^2, not limited by the velocity: 2 sqrt(100 / a) ms.
TEST(TrapPrm, ADecelerationThatWasNeverSetReads0AndFollowsTheAcceleration) {
  AxisCommandCard card;
  EXPECT_EQ(Parameters(card, "GT_GetTrapPrm", 4), (std::vector<double>{1, 0, 0, 0}));
  int target = 0;
  for (const auto& [acc, cycles] : {std::pair{1, 20}, {4, 10}, {16, 5}}) {
    std::vector<double> values = Parameters(card, "GT_GetTrapPrm", 4);
    values[0] = acc;
    EXPECT_EQ(card.Call("GT_SetTrapPrm", {1, &values}), 0);
    EXPECT_EQ(Parameters(card, "GT_GetTrapPrm", 4)[1], 0);
    EXPECT_EQ(card.Call("GT_SetPos", {1, target += 100}), 0);
    EXPECT_EQ(card.Call("GT_SetVel", {1, 1000}), 0);
    EXPECT_EQ(card.Update(1), 0);
    card.Cycles(cycles - 1);
    EXPECT_LT(card.Read("GT_GetPrfPos"), target) << acc;
    card.Cycle();
    EXPECT_EQ(card.Read("GT_GetPrfPos"), target) << acc;
    card.CyclesToRest();
  }
}

TEST(TrapPrm, ADecelerationOf0IsAgainThatOfTheAcceleration) {
  AxisCommandCard card;
  std::vector<double> values = {0.25, 0.5, 0, 0};
  EXPECT_EQ(card.Call("GT_SetTrapPrm", {1, &values}), 0);
  values[1] = 0;
  EXPECT_EQ(card.Call("GT_SetTrapPrm", {1, &values}), 0);
  EXPECT_EQ(Parameters(card, "GT_GetTrapPrm", 4), values);
}

TEST(TrapPrm, IsSetAtRestInModeTrapAndReadInModeTrap) {
  AxisCommandCard card;
  std::vector<double> values = {1, 1, 0, 0};
  card.MoveTo(1, 1000, 10);
  card.ExpectRefused(1, "GT_SetTrapPrm", {1, &values});
  EXPECT_EQ(card.Call("GT_GetTrapPrm", {1, &values}), 0);
  card.CyclesToRest();
  EXPECT_EQ(card.Call("GT_PrfJog", {1}), 0);
  card.ExpectRefused(1, "GT_SetTrapPrm", {1, &values});
  EXPECT_EQ(card.reason.en, "profile 1 is in mode Jog; this needs mode Trap");
  card.ExpectRefused(1, "GT_GetTrapPrm", {1, &values});
}

TEST(JogPrm, IsReadBackAtRestOnly) {
  AxisCommandCard card;
  std::vector<double> values = {0.25, 0, 0.5};
  card.ExpectRefused(1, "GT_SetJogPrm", {1, &values});
  EXPECT_EQ(card.reason.en, "profile 1 is in mode Trap; this needs mode Jog");
  card.ExpectRefused(1, "GT_GetJogPrm", {1, &values});
  EXPECT_EQ(card.Call("GT_PrfJog", {1}), 0);
  EXPECT_EQ(card.Call("GT_SetJogPrm", {1, &values}), 0);
  EXPECT_EQ(Parameters(card, "GT_GetJogPrm", 3), values);
  EXPECT_EQ(card.Call("GT_SetVel", {1, 10}), 0);
  EXPECT_EQ(card.Update(1), 0);
  card.ExpectRefused(1, "GT_SetJogPrm", {1, &values});
  card.ExpectRefused(1, "GT_GetJogPrm", {1, &values});
}

TEST(JogPrm, ADecelerationThatWasNeverSetReads0AndFollowsTheAcceleration) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_PrfJog", {1}), 0);
  EXPECT_EQ(Parameters(card, "GT_GetJogPrm", 3), (std::vector<double>{1, 0, 0}));
  for (const int acc : {2, 5}) {
    std::vector<double> values = Parameters(card, "GT_GetJogPrm", 3);
    values[0] = acc;
    EXPECT_EQ(card.Call("GT_SetJogPrm", {1, &values}), 0);
    EXPECT_EQ(Parameters(card, "GT_GetJogPrm", 3)[1], 0);
    for (const int velocity : {20, 0}) {
      EXPECT_EQ(card.Call("GT_SetVel", {1, velocity}), 0);
      EXPECT_EQ(card.Update(1), 0);
      card.Cycle();
      EXPECT_EQ(card.Read("GT_GetPrfVel"), velocity == 0 ? 20 - acc : acc);
      card.Cycles(20);
    }
  }
}

TEST(JogPrm, EveryMemberIsChecked) {
  struct {
    std::vector<double> values;
    int code;
  } const cases[] = {{{1, 1, 0}, 0},        {{0, 1, 0}, 7},     {{-1, 1, 0}, 7},
                     {{1, -1, 0}, 7},       {{1, 1, 0.999}, 0}, {{1, 1, 1}, 7},
                     {{1, 1, -0.1}, 7},     {{1, 1, kNan}, 7},  {{kNan, 1, 0}, 7},
                     {{kInfinity, 1, 0}, 7}};
  for (auto c : cases) {
    AxisCommandCard card;
    EXPECT_EQ(card.Call("GT_PrfJog", {1}), 0);
    EXPECT_EQ(card.Call("GT_SetJogPrm", {1, &c.values}), c.code)
        << testing::PrintToString(c.values);
  }
}

TEST(SetPos, IsForModeTrapWithinItsRange) {
  AxisCommandCard card;
  for (const auto& [pos, code] :
       {std::pair{1073741823, 0}, {1073741824, 7}, {-1073741823, 0}, {-1073741824, 7}}) {
    EXPECT_EQ(card.Call("GT_SetPos", {1, pos}), code) << pos;
  }
  EXPECT_EQ(Parameters(card, "GT_GetPos", 1)[0], -1073741823);
  EXPECT_EQ(card.Call("GT_PrfJog", {1}), 0);
  std::vector<double> value(1);
  card.ExpectRefused(1, "GT_SetPos", {1, 5});
  card.ExpectRefused(1, "GT_GetPos", {1, &value});
}

TEST(SetVel, IsForModesTrapAndJogWithinItsRange) {
  AxisCommandCard card;
  for (const char* mode : {"GT_PrfTrap", "GT_PrfJog"}) {
    EXPECT_EQ(card.Call(mode, {1}), 0);
    for (const auto& [vel, code] :
         {std::pair{32766.9, 0}, {32767.0, 7}, {-32767.0, 7}, {-32766.5, 0}, {kNan, 7}}) {
      EXPECT_EQ(card.Call("GT_SetVel", {1, vel}), code) << vel;
    }
    EXPECT_EQ(Parameters(card, "GT_GetVel", 1)[0], -32766.5);
  }
  ChangeState(card.motion).profiles[0].mode = ProfileMode::kGear;
  std::vector<double> value(1);
  card.ExpectRefused(1, "GT_SetVel", {1, 5});
  EXPECT_EQ(card.reason.en,
            "profile 1 is in mode Gear; this needs mode Trap or Jog, call GT_PrfTrap or GT_PrfJog");
  card.ExpectRefused(1, "GT_GetVel", {1, &value});
}

// --- Update ------------------------------------------------------------------------------------

TEST(Update, SettersOnlyWriteRegisters) {
  AxisCommandCard card;
  card.PrepareTrap(1, 1000, 10);
  card.Cycles(10);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 0);
  EXPECT_EQ(card.Update(1), 0);
  card.Cycles(10);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 50);
  // A new target takes effect with the next GT_Update.
  EXPECT_EQ(card.Call("GT_SetPos", {1, 2000}), 0);
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000);
  EXPECT_EQ(card.Update(1), 0);
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 2000);
}

TEST(Update, StartsAllOfItsAxesInTheSameCycle) {
  AxisCommandCard card;
  card.PrepareTrap(1, 1000, 10);
  card.PrepareJog(8, -20);
  EXPECT_EQ(card.Call("GT_Update", {0x81}), 0);
  card.Cycles(10);
  EXPECT_EQ(card.Read("GT_GetPrfPos", 1), 50);
  EXPECT_EQ(card.Read("GT_GetPrfPos", 8), -50);
}

TEST(Update, StartsNoneWhenOneIsInAnotherMode) {
  AxisCommandCard card;
  card.PrepareTrap(1, 1000, 10);
  ChangeState(card.motion).profiles[1].mode = ProfileMode::kPt;
  card.ExpectRefused(1, "GT_Update", {0b11});
  EXPECT_EQ(card.reason.en,
            "profile 2 is in mode PT; this needs mode Trap or Jog, call GT_PrfTrap or GT_PrfJog");
  EXPECT_EQ(card.Call("GT_Update", {0b01}), 0);
}

TEST(Update, AMaskWithoutAnyAxisIsRefused) {
  AxisCommandCard card;
  card.ExpectRefused(1, "GT_Update", {0});
  card.ExpectRefused(1, "GT_Update", {0x100});
  EXPECT_EQ(card.Call("GT_Update", {0x101}), 0);
}

TEST(Update, GoesOnToTheTargetAfterAStop) {
  AxisCommandCard card;
  card.MoveTo(1, 1000, 10);
  card.Cycles(30);
  EXPECT_EQ(card.Call("GT_Stop", {1, 0}), 0);
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 300);
  EXPECT_EQ(card.Update(1), 0);
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000);
}

TEST(Update, ALatchedLimitOnlyLetsMotionAwayFromIt) {
  for (const int sign : {1, -1}) {
    AxisCommandCard card;
    const DiType limit = sign > 0 ? DiType::kLimitPositive : DiType::kLimitNegative;
    card.Drive(limit, 0, true);
    card.PrepareTrap(1, 1000 * sign, 10);
    card.ExpectRefused(1, "GT_Update", {1});
    EXPECT_EQ(card.reason.en,
              sign > 0 ? "axis 1 positive limit latched: move away from it, call GT_ClrSts"
                       : "axis 1 negative limit latched: move away from it, call "
                         "GT_ClrSts");
    card.PrepareJog(1, 10 * sign);
    card.ExpectRefused(1, "GT_Update", {1});
    // After the switch is released the bit remains, and so does the forbidden direction.
    card.Drive(limit, 0, false);
    card.ExpectRefused(1, "GT_Update", {1});
    card.PrepareTrap(1, -1000 * sign, 10);
    EXPECT_EQ(card.Update(1), 0);
    card.CyclesToRest();
    EXPECT_EQ(card.Read("GT_GetPrfPos"), -1000 * sign);
    EXPECT_EQ(card.Call("GT_ClrSts", {1, 1}), 0);
    card.MoveTo(1, 1000 * sign, 10);
    card.CyclesToRest();
    EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000 * sign);
  }
}

TEST(Update, AReversedScaleTurnsTheLimitsRound) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_ProfileScale", {1, -2, 1}), 0);
  card.Drive(DiType::kLimitPositive, 0, true);
  card.PrepareJog(1, -10);
  card.ExpectRefused(1, "GT_Update", {1});
  card.PrepareJog(1, 10);
  EXPECT_EQ(card.Update(1), 0);
}

TEST(Update, ALatchedAlarmIsRefusedUntilItIsCleared) {
  AxisCommandCard card;
  card.PrepareTrap(1, 1000, 10);
  card.Drive(DiType::kAlarm, 0, true);
  card.Drive(DiType::kAlarm, 0, false);
  card.ExpectRefused(1, "GT_Update", {1});
  EXPECT_EQ(card.reason.en, "axis 1 alarm latched, call GT_ClrSts");
  EXPECT_EQ(card.Call("GT_ClrSts", {1, 1}), 0);
  EXPECT_EQ(card.Update(1), 0);
}

TEST(Update, ADisabledAxisMovesItsProfile) {
  AxisCommandCard card;
  card.MoveTo(1, 1000, 10);
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 1000);
  EXPECT_EQ(card.Read("GT_GetEncPos"), 0);
}

TEST(Update, ChangesAMoveOnTheFly) {
  // Example 7-1 at 500 ms: the target 80000 is reached at 1900 ms.
  AxisCommandCard card;
  std::vector<double> parameters = {0.25, 0.125, 0, 0};
  EXPECT_EQ(card.Call("GT_SetTrapPrm", {1, &parameters}), 0);
  EXPECT_EQ(card.Call("GT_SetPos", {1, 50000}), 0);
  EXPECT_EQ(card.Call("GT_SetVel", {1, 50}), 0);
  EXPECT_EQ(card.Update(1), 0);
  card.Cycles(500);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 20000);
  EXPECT_EQ(card.Call("GT_SetPos", {1, 80000}), 0);
  EXPECT_EQ(card.Update(1), 0);
  card.Cycles(1399);
  EXPECT_EQ(card.Status(), kMoving);
  card.Cycle();
  EXPECT_EQ(card.Status(), 0);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 80000);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
