// Drives, inputs, events and positions of GE axes. Source: GE manual chapters 3, 4, 8 and 12.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/gtcalls/ge/ge_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ge {
namespace {

using motion::DiType;
using motion::DoType;

TEST(GeStatus, AfterAReset) {
  const struct {
    const char* card;
    int axis;
    double status;
  } cases[] = {{"GE-800-PG", 1, 0x900}, {"GE-800-PG", 8, 0x70000900}, {"GE-200-PV", 2, 0x10000900}};
  for (const auto& c : cases) {
    GeTestCard card(c.card);
    EXPECT_EQ(card.Status(c.axis), c.status) << c.card;
    card.Do("GT_AxisOn", {static_cast<double>(c.axis)});
    EXPECT_EQ(card.Status(c.axis), c.status + 0x200) << c.card;
  }
}

TEST(GeAxes, AreThoseOfTheCard) {
  GeTestCard card("GE-300-PG");
  for (const double axis : {0.0, 4.0, 9.0}) {
    card.Refuses(7, kIllegal, "GT_ClrSts", {axis});
    card.Refuses(7, kIllegal, "GT_SetPos", {axis, 0});
  }
  EXPECT_EQ(card.Call("GT_GetPrfPos", {1}), 7);  // NULL
  EXPECT_EQ(card.Cause(), kIllegal);
}

TEST(GeCommandRegister, HoldsTheCausesOfTheLastCommand) {
  GeTestCard card;
  card.Refuses(7, kOverflow, "GT_SetKp", {1, 32768});
  EXPECT_EQ(card.Cause(), kOverflow);  // reading does not change it
  card.Do("GT_ClrSts", {1});
  EXPECT_EQ(card.Cause(), 0);
}

TEST(GeDrives, CannotBeEnabledDuringAnAlarm) {
  GeTestCard card("GE-400-PV");
  card.SetInput(DiType::kAlarm, 1, true);
  EXPECT_TRUE(card.StatusBit(2, 1));
  card.Refuses(1, kAlarm, "GT_AxisOn", {2});
  EXPECT_TRUE(card.StatusBit(2, 7));
  card.Do("GT_AlarmOff", {2});
  card.Do("GT_ClrSts", {2});
  card.Do("GT_AxisOn", {2});
  EXPECT_TRUE(card.StatusBit(2, 9));
}

TEST(GeDrives, AreSwitchedOffByAnAlarm) {
  GeTestCard card;
  card.Do("GT_AxisOn", {1});
  card.MoveT(1, 100000, 10, 1);
  card.Run(100);
  card.SetInput(DiType::kAlarm, 0, true);
  EXPECT_TRUE(card.StatusBit(1, 10)) << "a card with pulses does not listen after a reset";
  card.Do("GT_AlarmOn", {1});
  card.Cycle();
  EXPECT_EQ(card.Status(1), 0x902);
  EXPECT_EQ(card.Read("GT_GetPrfVel", {1}), 0);
  card.Refuses(1, kIllegal, "GT_Update", {1});
  card.SetInput(DiType::kAlarm, 0, false);
  card.Refuses(1, kIllegal, "GT_Update", {1});  // until it is cleared
  card.Do("GT_ClrSts", {1});
  card.Do("GT_Update", {1});
  EXPECT_TRUE(card.StatusBit(1, 10));
}

TEST(GeDrives, EndTheMotionWhenTheyAreSwitchedOff) {
  GeTestCard card;
  card.Do("GT_AxisOn", {1});
  card.MoveT(1, 100000, 10, 1);
  card.Run(100);
  card.Do("GT_AxisOff", {1});
  EXPECT_EQ(card.Status(1), 0x900);
  EXPECT_EQ(card.motion.state().io.Register(DoType::kEnable), 0u);
}

TEST(GeDrives, BeginWhereTheAxisIs) {
  GeTestCard card("GE-200-PV");
  card.motion.PlaceMotor(0, 0);
  ChangeState(card.motion).plants[0].hand = 2;
  card.Run(100);
  ChangeState(card.motion).plants[0].hand = 0;
  EXPECT_EQ(card.Read("GT_GetAtlPos", {1}), 200);
  EXPECT_EQ(card.Read("GT_GetAtlErr", {1}), -200);
  card.Do("GT_AxisOn", {1});
  EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 200);
  EXPECT_EQ(card.Read("GT_GetPos", {1}), 200);
  EXPECT_EQ(card.Read("GT_GetAtlErr", {1}), 0);
}

TEST(GeDrives, MustBeOffForThese) {
  const struct {
    const char* command;
    std::vector<double> values;
    uint16_t cause;
  } cases[] = {
      {"GT_DrvRst", {1}, kDriveOn},   {"GT_EncOn", {1}, kDriveOn},
      {"GT_EncOff", {1}, kDriveOn},   {"GT_CtrlMode", {1, 1}, kModeInUse},
      {"GT_OpenLp", {1}, kModeInUse}, {"GT_CloseLp", {1}, kModeInUse},
  };
  GeTestCard card("GE-800-PV");
  card.Do("GT_AxisOn", {1});
  for (const auto& c : cases) card.Refuses(1, c.cause, c.command, c.values);
  card.Do("GT_AxisOff", {1});
  for (const auto& c : cases) card.Do(c.command, c.values);
}

TEST(GeDrives, AreResetByAPulse) {
  GeTestCard card;
  card.Do("GT_DrvRst", {3});
  EXPECT_EQ(card.motion.state().io.Register(DoType::kClear), 4u);
  card.Run(20);
  EXPECT_EQ(card.motion.state().io.Register(DoType::kClear), 0u);
}

TEST(GeOutputs, OfACardWithPulsesAreNoVoltages) {
  GeTestCard pulses("GE-400-PG");
  pulses.Do("GT_CtrlMode", {1, 1});
  pulses.Refuses(7, kIllegal, "GT_CtrlMode", {1, 0});
  GeTestCard voltages("GE-400-PV");
  voltages.Do("GT_CtrlMode", {1, 0});
  voltages.Refuses(7, kOverflow, "GT_CtrlMode", {1, 2});
  voltages.Do("GT_CtrlMode", {1, 1});
  EXPECT_FALSE(voltages.motion.InClosedLoop(0));
  EXPECT_FALSE(voltages.motion.encoder(0).external);
  EXPECT_TRUE(voltages.motion.InClosedLoop(1));
}

TEST(GeLimits, StopTheMotionTowardsThemAtOnce) {
  for (const bool positive : {true, false}) {
    GeTestCard card;
    const int bit = positive ? 5 : 6;
    const double sign = positive ? 1 : -1;
    card.MoveT(1, sign * 100000, 10, 1);
    card.Run(100);
    card.SetInput(positive ? DiType::kLimitPositive : DiType::kLimitNegative, 0, true);
    EXPECT_TRUE(card.StatusBit(1, bit));
    EXPECT_FALSE(card.StatusBit(1, 10));
    // 10 ms and 50 pulses up, then 90.75 ms at 10: the filter takes three cycles.
    const double stopped = sign * std::round(957.5);
    EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), stopped);
    // Towards it nothing moves, and away from it everything, without GT_ClrSts.
    card.Do("GT_Update", {1});
    card.Run(50);
    EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), stopped);
    card.Do("GT_SetPos", {1, 0});
    card.Do("GT_Update", {1});
    card.RunToRest(1);
    EXPECT_EQ(card.Read("GT_GetPrfPos", {1}), 0);
    EXPECT_TRUE(card.StatusBit(1, bit));
  }
}

TEST(GeLimits, DoNotActWhenTheyAreOff) {
  GeTestCard card;
  card.Do("GT_LmtsOff", {1});
  EXPECT_FALSE(card.StatusBit(1, 11));
  card.SetInput(DiType::kLimitPositive, 0, true);
  EXPECT_FALSE(card.StatusBit(1, 5));
  EXPECT_EQ(card.Read("GT_GetLmtSwt"), 1);
  card.Do("GT_LmtsOn", {1});
  card.Cycle();
  EXPECT_EQ(card.Status(1), 0x920);
}

TEST(GeLimits, AreOperatedByTheLevelOfTheirSense) {
  GeTestCard card("GE-400-PG");
  card.SetInput(DiType::kLimitNegative, 1, true);
  card.Do("GT_ClrSts", {2});
  EXPECT_TRUE(card.StatusBit(2, 6)) << "its cause still acts";
  card.Do("GT_LmtSns", {0xFF});
  card.Run(2);
  card.Do("GT_ClrSts", {2});
  EXPECT_FALSE(card.StatusBit(2, 6));
  // Free inputs rest at the level that does not operate them.
  EXPECT_EQ(card.Read("GT_GetLmtSwt"), 0xFF);
  EXPECT_FALSE(card.StatusBit(1, 5));
}

TEST(GeEvents, AreClearedOneByOneOrAll) {
  GeTestCard card;
  card.MoveT(1, 1000, 1, 0.1);
  card.Refuses(1, kInMotion, "GT_ZeroPos", {1});
  card.Do("GT_AbptStp", {1});
  card.SetInput(DiType::kLimitPositive, 0, true);
  card.SetInput(DiType::kLimitPositive, 0, false);
  EXPECT_EQ(card.Status(1), 0x9A0);
  card.Do("GT_RstSts", {1, 0xFF});  // a 1 keeps its bit
  EXPECT_EQ(card.Status(1), 0x9A0);
  card.Do("GT_RstSts", {1, 0x7F});
  EXPECT_EQ(card.Status(1), 0x920);
  card.Do("GT_RstSts", {1, 0xDF});
  EXPECT_EQ(card.Status(1), 0x900);
  card.Refuses(7, kIllegal, "GT_RstSts", {9, 0});
}

TEST(GePositions, AreSetTogetherAndTheMachineStays) {
  GeTestCard card;
  card.Do("GT_AxisOn", {1});
  card.MoveT(1, 1000, 10, 1);
  card.Refuses(1, kInMotion, "GT_SetAtlPos", {1, 5});
  card.RunToRest(1);
  const double machine = card.motion.state().plants[0].position;
  const struct {
    const char* command;
    std::vector<double> values;
    double position;
  } cases[] = {{"GT_SetAtlPos", {1, -77}, -77}, {"GT_ZeroPos", {1}, 0}};
  for (const auto& c : cases) {
    card.Do(c.command, c.values);
    card.Run(5);
    for (const char* read : {"GT_GetPrfPos", "GT_GetAtlPos", "GT_GetPos"}) {
      EXPECT_EQ(card.Read(read, {1}), c.position) << c.command << ' ' << read;
    }
    EXPECT_EQ(card.motion.state().plants[0].position, machine) << c.command;
  }
}

TEST(GePositions, ComeFromTheEncoderOrFromThePulses) {
  GeTestCard card;
  card.MoveT(1, 1000, 10, 1);  // with the drive off: only pulses are counted
  card.RunToRest(1);
  EXPECT_EQ(card.Read("GT_GetAtlPos", {1}), 1000);
  card.Do("GT_EncOn", {1});
  card.MoveT(1, 2000, 10, 1);
  card.RunToRest(1);
  EXPECT_EQ(card.Read("GT_GetAtlPos", {1}), 1000);
  card.Do("GT_EncOff", {1});
  card.MoveT(1, 2500, 10, 1);
  card.RunToRest(1);
  EXPECT_EQ(card.Read("GT_GetAtlPos", {1}), 1500);
}

}  // namespace
}  // namespace oncard::gtcalls::ge
