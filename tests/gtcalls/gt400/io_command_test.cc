// Inputs, outputs and auxiliary encoders of GT400 cards. Source: GT manual chapters 9 and 11;
// public header.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DiType;
using motion::DoType;
using motion::kAuxiliaryFirst;

TEST(Gt400Inputs, AreLevels) {
  Gt400TestCard card;
  card.SetInput(DiType::kGpi, 15, true);
  EXPECT_EQ(card.Read("GT_ExInpt"), 0x8000);
  card.SetInput(DiType::kHome, 2, true);
  EXPECT_EQ(card.Read("GT_GetHomeSwt"), 4);
  card.SetInput(DiType::kLimitPositive, 3, true);
  card.SetInput(DiType::kLimitNegative, 0, true);
  EXPECT_EQ(card.Read("GT_GetLmtSwt"), 0x42);
}

// Assumption: a pin that nothing drives has the level that does not trigger.
TEST(Gt400Inputs, OfLimitsDoNotDependOnTheirSense) {
  Gt400TestCard card;
  card.SetInput(DiType::kLimitPositive, 0, true);
  card.SetInput(DiType::kLimitNegative, 0, false);
  EXPECT_EQ(card.Read("GT_GetLmtSwt"), 1);
  card.Do("GT_LmtSns", {0x3});
  card.Cycle();
  EXPECT_EQ(card.Read("GT_GetLmtSwt"), 1);
  card.Do("GT_LmtSns", {0x7});
  card.Cycle();
  EXPECT_EQ(card.Read("GT_GetLmtSwt"), 5) << "nothing drives the positive one of axis 2";
}

// --- Outputs ---------------------------------------------------------------------------------

TEST(Gt400Outputs, AreWrittenTogetherOrOneByOne) {
  Gt400TestCard card;
  EXPECT_EQ(card.Read("GT_GetExOpt"), 0);
  card.Do("GT_ExOpt", {0xFFFF});
  card.Do("GT_ExOpt", {0x0102});
  EXPECT_EQ(card.motion.state().io.Register(DoType::kGpo), 0x0102u);
  card.Do("GT_ExOptBit", {15, 1});
  card.Do("GT_ExOptBit", {1, 0});
  EXPECT_EQ(card.motion.state().io.Register(DoType::kGpo), 0x8100u);
  EXPECT_EQ(card.Read("GT_GetExOpt"), 0x8100);
}

TEST(Gt400Outputs, HaveNumbersAndTwoLevels) {
  Gt400TestCard card;
  card.RefusesParameter("GT_ExOptBit", {16, 1});
  card.RefusesParameter("GT_ExOptBit", {0, 2});
}

// --- Analogue inputs -------------------------------------------------------------------------

// The manual: 0 to 2047 are 0 V to 10 V, 2048 to 4095 are 0 V to -10 V.
TEST(Gt400Adc, HasASignAndElevenBits) {
  const struct {
    double volts;
    double value;
  } cases[] = {{0, 0},     {5, 1024},   {10, 2047},    {12, 2047},
               {-5, 3072}, {-10, 4095}, {-0.01, 2050}, {0.01, 2}};
  Gt400TestCard card;
  for (const auto& c : cases) {
    ChangeState(card.motion).adcs[7].volts = c.volts;
    EXPECT_EQ(card.Read("GT_GetAdc", {8}), c.value) << c.volts;
  }
  for (const double channel : {0.0, 9.0}) card.RefusesParameter("GT_GetAdc", {channel});
}

TEST(Gt400Adc, ConvertsAsManyChannelsAsTheHostSays) {
  Gt400TestCard card;
  for (auto& adc : ChangeState(card.motion).adcs) adc.volts = 5;
  EXPECT_EQ(card.Read("GT_GetAdc", {8}), 1024);
  card.Do("GT_SetAdcChn", {2});
  EXPECT_EQ(card.Read("GT_GetAdc", {2}), 1024);
  EXPECT_EQ(card.Read("GT_GetAdc", {3}), 0);
  for (const double count : {0.0, 9.0}) card.RefusesParameter("GT_SetAdcChn", {count});
}

// --- Auxiliary encoders ----------------------------------------------------------------------

TEST(Gt400AuxiliaryEncoder, CountsWhatAHandTurns) {
  Gt400TestCard card;
  ChangeState(card.motion).plants[kAuxiliaryFirst + 1].hand = -3;
  card.Run(10);
  EXPECT_EQ(card.Read("GT_EncPos", {2}), -30);
  EXPECT_EQ(card.Read("GT_EncVel", {2}), -3);
  EXPECT_EQ(card.Read("GT_EncPos", {1}), 0);
  card.Do("GT_ClrEncPos", {2});
  EXPECT_EQ(card.Read("GT_EncPos", {2}), 0);
  card.Cycle();
  EXPECT_EQ(card.Read("GT_EncPos", {2}), -3);
}

TEST(Gt400AuxiliaryEncoder, HasANumber) {
  Gt400TestCard card;
  for (const char* name : {"GT_EncPos", "GT_EncVel", "GT_ClrEncPos"}) {
    for (const double encoder : {0.0, 3.0}) card.RefusesParameter(name, {encoder});
  }
}

TEST(Gt400AuxiliaryEncoder, IsNotOnAllCards) {
  for (const char* type : {"GT-400-SG", "GT-400-SP"}) {
    Gt400TestCard card(type);
    EXPECT_EQ(card.Read("GT_EncPos", {1}), 0) << type;
    EXPECT_EQ(card.Read("GT_EncVel", {1}), 0) << type;
  }
  for (const char* type : {"GT-400-SE", "GT-400-SD"}) {
    Gt400TestCard card(type);
    card.Refuses(kIllegal, "GT_EncPos", {1});
    card.Refuses(kIllegal, "GT_EncVel", {1});
  }
}

TEST(Gt400AuxiliaryEncoder, IsLatchedAtItsIndexPulse) {
  Gt400TestCard card;
  for (size_t i = 0; i < kAuxiliaryMax; ++i) {
    card.motion.SetIndexMarks(kAuxiliaryFirst + i, {.offset = 25, .period = 1000});
    ChangeState(card.motion).plants[kAuxiliaryFirst + i].hand = 10;
  }
  EXPECT_EQ(card.Read("GT_GetEncSts"), 0);
  card.Do("GT_SetEncCapt");
  card.Run(2);
  EXPECT_EQ(card.Read("GT_GetEncSts"), 0);
  card.Run(2);
  EXPECT_EQ(card.Read("GT_GetEncSts"), 8);
  EXPECT_EQ(card.Read("GT_GetEncStsEx"), 8);
  EXPECT_EQ(card.Read("GT_GetEncCapt"), 25);
  card.Do("GT_SetEncCapt");
  EXPECT_EQ(card.Read("GT_GetEncSts"), 0);
  EXPECT_EQ(card.Read("GT_GetEncCapt"), 25) << "until it is latched again";
  card.motion.capture().Arm(kAuxiliaryFirst + 1, motion::CaptureSource::kIndex);
  card.Run(100);
  EXPECT_EQ(card.Read("GT_GetEncCapt"), 1025);
  EXPECT_EQ(card.Read("GT_GetEncStsEx"), 0x80008);
}

// --- What is not simulated -------------------------------------------------------------------

TEST(Gt400Laser, IsNotSimulated) {
  Gt400TestCard card("GT-400-SE");
  const uint64_t before = card.motion.Hash();
  EXPECT_EQ(card.Call("GT_SetTime", {100}), 8);
  EXPECT_EQ(card.motion.Hash(), before);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
