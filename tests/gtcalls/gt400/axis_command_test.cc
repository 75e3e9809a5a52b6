// Setup and state of axes. Source: GT manual chapters 3, 4.4, 4.5 and 7.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DiType;
using motion::DoType;

TEST(Gt400Axis, OneIsTheCurrentOne) {
  Gt400TestCard card;
  EXPECT_EQ(card.Status(), 0x0900u);
  for (const double axis : {4.0, 2.0, 3.0, 1.0}) {
    card.Do("GT_Axis", {axis});
    EXPECT_EQ(card.Status(), 0x0900u | static_cast<uint32_t>(axis - 1) << 12);
  }
  card.Do("GT_Axis", {2});
  for (const double axis : {0.0, 5.0}) {
    card.RefusesParameter("GT_Axis", {axis});
    EXPECT_EQ(card.Status(), 0x1900u) << "the current axis stays";
  }
}

TEST(Gt400Axis, RegistersAreThoseOfTheCurrentOne) {
  Gt400TestCard card;
  card.Do("GT_Axis", {3});
  card.Do("GT_SetPos", {77});
  card.Do("GT_Axis", {4});
  EXPECT_EQ(card.Read("GT_GetPos"), 0);
  card.Do("GT_Axis", {3});
  EXPECT_EQ(card.Read("GT_GetPos"), 77);
}

// --- Drives ----------------------------------------------------------------------------------

TEST(Gt400Drive, IsEnabledWithAnEventAndDisabled) {
  Gt400TestCard card;
  card.Do("GT_AxisOn");
  EXPECT_EQ(card.Status(), 0x0B01u);
  EXPECT_EQ(card.motion.state().io.Register(DoType::kEnable), 1u);
  card.Do("GT_ClrSts");
  card.Do("GT_AxisOff");
  EXPECT_EQ(card.Status(), 0x0900u);
  EXPECT_EQ(card.motion.state().io.Register(DoType::kEnable), 0u);
}

TEST(Gt400Drive, EndsTheMotionWhenItIsDisabled) {
  Gt400TestCard card;
  card.Enable(1);
  card.MoveT(1000, 1, 0.1);
  card.Run(100);
  card.Do("GT_AxisOff");
  EXPECT_EQ(card.Status(), 0x0901u);
  EXPECT_EQ(card.Read("GT_GetPrfVel"), 0);
}

TEST(Gt400Drive, DoesNotChangeThePlanWhenItIsEnabled) {
  Gt400TestCard card;  // in closed loop
  card.motion.PlaceMotor(0, 0);
  ChangeState(card.motion).plants[0].hand = 2;
  card.Run(100);
  ChangeState(card.motion).plants[0].hand = 0;
  card.Do("GT_AxisOn");
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 0);
  EXPECT_EQ(card.Read("GT_GetAtlErr"), -200);
}

TEST(Gt400Drive, CannotBeEnabledAfterAnAlarm) {
  Gt400TestCard card;
  card.SetInput(DiType::kAlarm, 0, true);
  EXPECT_TRUE(card.StatusBit(1));
  card.Refuses(kAlarm, "GT_AxisOn");
  card.SetInput(DiType::kAlarm, 0, false);
  card.Refuses(kAlarm, "GT_AxisOn");
  card.Do("GT_ClrSts");
  card.Do("GT_AxisOn");
}

TEST(Gt400Drive, DoesNotListenToItsAlarmWhenItIsOff) {
  Gt400TestCard card;
  card.Do("GT_AlarmOff");
  card.SetInput(DiType::kAlarm, 0, true);
  EXPECT_FALSE(card.StatusBit(1));
  card.Do("GT_AlarmOn");
  card.Cycle();
  EXPECT_TRUE(card.StatusBit(1));
}

TEST(Gt400Drive, IsResetByAPulseWhileItIsDisabled) {
  Gt400TestCard card;
  card.Do("GT_Axis", {3});
  card.Do("GT_DrvRst");
  EXPECT_EQ(card.motion.state().io.Register(DoType::kClear), 4u);
  card.Run(99);
  EXPECT_EQ(card.motion.state().io.Register(DoType::kClear), 4u);
  card.Run(1);
  EXPECT_EQ(card.motion.state().io.Register(DoType::kClear), 0u);
  card.Do("GT_AxisOn");
  card.Refuses(kDriveOn, "GT_DrvRst");
}

// --- Outputs ---------------------------------------------------------------------------------

TEST(Gt400Output, IsAVoltageOrPulses) {
  Gt400TestCard card;
  EXPECT_TRUE(card.motion.InClosedLoop(0));
  card.Do("GT_CtrlMode", {1});
  EXPECT_FALSE(card.motion.InClosedLoop(0));
  EXPECT_TRUE(card.motion.InClosedLoop(1));
  EXPECT_EQ(card.Status(), 0x0900u) << "the bit of the loop stays";
  card.Do("GT_CtrlMode", {0});
  EXPECT_TRUE(card.motion.InClosedLoop(0));
  for (const double mode : {-1.0, 2.0}) card.RefusesParameter("GT_CtrlMode", {mode});
}

TEST(Gt400Output, LoopsAreClosedOrOpen) {
  Gt400TestCard card;
  card.Do("GT_OpenLp");
  EXPECT_EQ(card.Status(), 0x0800u);
  EXPECT_FALSE(card.motion.InClosedLoop(0));
  card.Do("GT_CloseLp");
  EXPECT_EQ(card.Status(), 0x0900u);
  EXPECT_TRUE(card.motion.InClosedLoop(0));
}

TEST(Gt400Output, PulsesHaveTwoForms) {
  Gt400TestCard card;
  card.Do("GT_Axis", {2});
  card.Do("GT_StepPulse");
  EXPECT_EQ(card.motion.state().steps[1].mode, 1);
  card.Do("GT_StepDir");
  EXPECT_EQ(card.motion.state().steps[1].mode, 0);
}

TEST(Gt400Output, OnlySvCardsHaveVoltages) {
  const struct {
    const char* command;
    std::vector<double> values;
  } cases[] = {{"GT_CtrlMode", {1}},
               {"GT_OpenLp", {}},
               {"GT_CloseLp", {}},
               {"GT_EncSns", {0}},
               {"GT_GetAtlErr", {}}};
  for (const char* name : {"GT-400-SG", "GT-400-SE", "GT-400-SD", "GT-400-SP"}) {
    Gt400TestCard card(name);
    EXPECT_EQ(card.Status(), 0x0900u) << name;
    EXPECT_FALSE(card.motion.InClosedLoop(0)) << name;
    for (const auto& c : cases) card.Refuses(kIllegal, c.command, c.values);
  }
}

TEST(Gt400Output, OfPulseCardsMovesItsMotorFromPowerOn) {
  Gt400TestCard card("GT-400-SG");
  card.Enable(1);
  card.MoveT(500, 1, 0.1);
  card.RunToRest();
  EXPECT_EQ(card.Read("GT_GetAtlPos"), 500);
}

// --- Inputs ----------------------------------------------------------------------------------

TEST(Gt400Input, LimitsAreOperatedByTheLevelOfTheirSense) {
  const struct {
    DiType type;
    int sense_bit;
    int status_bit;
  } cases[] = {{DiType::kLimitPositive, 4, 5}, {DiType::kLimitNegative, 5, 6}};
  for (const auto& c : cases) {
    Gt400TestCard card;
    card.Do("GT_Axis", {3});
    card.SetInput(c.type, 2, true);
    EXPECT_EQ(card.Status(), 0x2900u | 1u << c.status_bit);
    card.Do("GT_LmtSns", {static_cast<double>(1 << c.sense_bit)});
    card.Cycle();
    card.Do("GT_ClrSts");
    EXPECT_EQ(card.Status(), 0x2900u);
    card.SetInput(c.type, 2, false);
    EXPECT_EQ(card.Status(), 0x2900u | 1u << c.status_bit);
  }
}

TEST(Gt400Input, LimitsAreEventsOnce) {
  Gt400TestCard card;
  card.SetInput(DiType::kLimitPositive, 0, true);
  EXPECT_TRUE(card.StatusBit(5));
  card.Do("GT_ClrSts");
  card.Run(3);
  EXPECT_FALSE(card.StatusBit(5)) << "a cleared event does not return while the switch is active";
  card.SetInput(DiType::kLimitPositive, 0, false);
  EXPECT_FALSE(card.StatusBit(5));
  card.SetInput(DiType::kLimitPositive, 0, true);
  EXPECT_TRUE(card.StatusBit(5));
  card.SetInput(DiType::kLimitPositive, 0, false);
  EXPECT_TRUE(card.StatusBit(5)) << "it stays until it is cleared";
}

TEST(Gt400Input, LimitsAreOnlyReadWhenTheyAreOff) {
  Gt400TestCard card;
  card.Do("GT_LmtsOff");
  EXPECT_EQ(card.Status(), 0x0100u);
  card.SetInput(DiType::kLimitPositive, 0, true);
  EXPECT_EQ(card.Status(), 0x0100u);
  card.Do("GT_LmtsOn");
  card.Cycle();
  EXPECT_EQ(card.Status(), 0x0920u);
}

TEST(Gt400Input, EncodersCountInTheirSense) {
  Gt400TestCard card;
  card.Do("GT_EncSns", {0x2A});
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(card.motion.encoder(i).reversed, i % 2 == 1) << i;
  EXPECT_FALSE(card.motion.encoder(motion::kAuxiliaryFirst).reversed);
  EXPECT_TRUE(card.motion.encoder(motion::kAuxiliaryFirst + 1).reversed);
}

TEST(Gt400Input, PositionsComeFromTheEncoderOrFromThePulses) {
  Gt400TestCard card("GT-400-SG");
  EXPECT_TRUE(card.motion.encoder(0).external);
  card.Do("GT_EncOff");
  EXPECT_FALSE(card.motion.encoder(0).external);
  card.Do("GT_EncOn");
  EXPECT_TRUE(card.motion.encoder(0).external);
}

// --- Status ----------------------------------------------------------------------------------

TEST(Gt400Status, EventsAreClearedOneByOneOrAll) {
  Gt400TestCard card;
  card.Enable(1);
  card.Do("GT_AbptStp");
  card.Refuses(kIllegal, "GT_SetVel", {-1});
  card.SetInput(DiType::kLimitNegative, 0, true);
  EXPECT_EQ(card.Status(), 0x0BC1u);
  card.Do("GT_RstSts", {0xFF});
  EXPECT_EQ(card.Status(), 0x0BC1u) << "a 1 keeps its bit";
  card.Do("GT_RstSts", {0xFE});
  EXPECT_EQ(card.Status(), 0x0BC0u);
  card.Do("GT_RstSts", {0x40});
  EXPECT_EQ(card.Status(), 0x0B40u);
  EXPECT_EQ(card.Read("GT_GetStsEx"), 0x0B40u);
  card.Do("GT_ClrSts");
  EXPECT_EQ(card.Status(), 0x0B00u);
}

TEST(Gt400Status, AnAlarmReturnsWhileItIsActive) {
  Gt400TestCard card;
  card.SetInput(DiType::kAlarm, 0, true);
  card.Do("GT_ClrSts");
  card.Cycle();
  EXPECT_TRUE(card.StatusBit(1));
  card.SetInput(DiType::kAlarm, 0, false);
  EXPECT_TRUE(card.StatusBit(1));
  card.Do("GT_ClrSts");
  card.Cycle();
  EXPECT_FALSE(card.StatusBit(1));
}

TEST(Gt400Mode, IsARegisterOfBits) {
  Gt400TestCard card;
  const struct {
    const char* command;
    double mode;
  } cases[] = {{"GT_PrflV", 0x0800}, {"GT_PrflS", 0x1000},   {"GT_PrflT", 0},
               {"GT_AuStpOn", 0x80}, {"GT_AuUpdtOn", 0x480}, {"GT_AuStpOff", 0x400},
               {"GT_AuUpdtOff", 0x0}};
  for (const auto& c : cases) {
    card.Do(c.command);
    EXPECT_EQ(card.Read("GT_GetMode"), c.mode) << c.command;
  }
}

// --- Positions -------------------------------------------------------------------------------

TEST(Gt400Positions, AreSetTogetherAtRest) {
  const struct {
    const char* command;
    std::vector<double> values;
    double position;
  } cases[] = {{"GT_SetAtlPos", {-77}, -77}, {"GT_ZeroPos", {}, 0}};
  for (const auto& c : cases) {
    Gt400TestCard card;
    card.Enable(1);
    card.MoveT(1000, 10, 1);
    card.Refuses(kInMotion, c.command, c.values);
    card.RunToRest();
    EXPECT_EQ(card.Read("GT_GetAtlPos"), 1000);
    const double machine = card.motion.state().plants[0].position;
    card.Do(c.command, c.values);
    card.Run(5);
    for (const char* read : {"GT_GetPrfPos", "GT_GetAtlPos", "GT_GetPos"}) {
      EXPECT_EQ(card.Read(read), c.position) << c.command << ' ' << read;
    }
    EXPECT_EQ(card.motion.state().plants[0].position, machine) << c.command;
  }
}

TEST(Gt400Positions, HaveARange) {
  Gt400TestCard card;
  for (const double position : {-1073741825.0, 1073741824.0}) {
    card.Refuses(kOverflow, "GT_SetAtlPos", {position});
  }
  for (const double position : {-1073741824.0, 1073741823.0}) {
    card.Do("GT_SetAtlPos", {position});
    EXPECT_EQ(card.Read("GT_GetAtlPos"), position);
  }
}

TEST(Gt400Positions, ErrorsAreReadWithin16Bits) {
  Gt400TestCard card;
  const struct {
    double hand;  // of 100 sample times
    double error;
  } cases[] = {{2, -200}, {1000, -32768}, {-1000, 32767}};
  for (const auto& c : cases) {
    card.Do("GT_ZeroPos");
    ChangeState(card.motion).plants[0].hand = c.hand;
    card.Run(100);
    EXPECT_EQ(card.Read("GT_GetAtlVel"), c.hand);
    EXPECT_EQ(card.Read("GT_GetAtlErr"), c.error);
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
