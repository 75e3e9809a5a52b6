// Sources and senses of encoders through their commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(EncoderCommand, EncOffCountsPulsesAndEncOnTheEncoder) {
  CommandTestCard card;
  EXPECT_TRUE(card.motion.state().encoders[2].external);
  EXPECT_EQ(card.Call("GT_EncOff", {3}), 0);
  EXPECT_FALSE(card.motion.state().encoders[2].external);
  EXPECT_TRUE(card.motion.state().encoders[1].external);
  EXPECT_EQ(card.Call("GT_EncOn", {3}), 0);
  EXPECT_TRUE(card.motion.state().encoders[2].external);
}

TEST(EncoderCommand, EncSnsSetsTheSenseOfEach) {
  CommandTestCard card;
  for (size_t i = 0; i < 8; ++i) EXPECT_TRUE(card.motion.state().encoders[i].reversed) << i;
  EXPECT_EQ(card.Call("GT_EncSns", {0x81}), 0);
  for (size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(card.motion.state().encoders[i].reversed, i == 0 || i == 7) << i;
  }
}

/// The shaft of encoder `number` is turned by hand at 2 pulse/ms.
void Turn(CommandTestCard& card, int number) {
  card.motion.PowerOn(std::make_shared<const motion::WorldEvents>(
      motion::WorldEvents{{.kind = motion::WorldEventKind::kHand,
                           .item = static_cast<uint8_t>(number - 1),
                           .value = 2}}));
}

TEST(AuxiliaryEncoder, IsReadSetAndReversedAsTheOthers) {
  CommandTestCard card;
  Turn(card, 9);
  card.Cycles(40);
  std::vector<double> value(1);
  ASSERT_EQ(card.Call("GT_GetEncPos", {9, &value, 1, nullptr}), 0);
  EXPECT_EQ(value[0], 20);
  ASSERT_EQ(card.Call("GT_GetEncVel", {9, &value, 1, nullptr}), 0);
  EXPECT_NEAR(value[0], 2, 2);  // whole pulses in a cycle of 250 us
  ASSERT_EQ(card.Call("GT_SetEncPos", {9, 1000}), 0);
  ASSERT_EQ(card.Call("GT_EncSns", {0xff}), 0);
  card.Cycles(40);
  ASSERT_EQ(card.Call("GT_GetEncPos", {9, &value, 1, nullptr}), 0);
  EXPECT_EQ(value[0], 980);
}

TEST(AuxiliaryEncoder, RestsWithoutAHandAndCountsWhatSlips) {
  CommandTestCard card;
  using enum motion::WorldEventKind;
  card.motion.PowerOn(std::make_shared<const motion::WorldEvents>(
      motion::WorldEvents{{.at = 10'000, .kind = kHand, .item = 8, .value = 2},
                          {.at = 20'000, .kind = kHand, .item = 8, .value = 0},
                          {.at = 50'000, .kind = kEncoderDrift, .item = 8, .value = -1},
                          {.at = 60'000, .kind = kEncoderDrift, .item = 8, .value = 0}}));
  const motion::Encoder& encoder = card.motion.state().encoders[8];
  card.Cycles(40);
  EXPECT_EQ(encoder.position, 0);
  card.Cycles(42);  // the hand stopped two cycles ago
  EXPECT_EQ(encoder.position, 20);
  EXPECT_TRUE(encoder.resting());
  card.Cycles(240);
  EXPECT_EQ(encoder.position, 10);
  EXPECT_TRUE(encoder.resting());
}

TEST(AuxiliaryEncoder, LeadsAGear) {
  CommandTestCard card;
  Turn(card, 11);
  ASSERT_EQ(card.Call("GT_PrfGear", {1, 0}), 0);
  ASSERT_EQ(card.Call("GT_SetGearMaster", {1, 11, 1, 0}), 0);
  ASSERT_EQ(card.Call("GT_SetGearRatio", {1, 1, 10, 0}), 0);
  ASSERT_EQ(card.Call("GT_GearStart", {1}), 0);
  card.Cycles(41);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 200);
  EXPECT_EQ(card.Call("GT_SetGearMaster", {1, 11, 2, 0}), 7) << "there is no profile 11";
}

TEST(AuxiliaryEncoder, ExistsWhereTheCardHasOne) {
  struct {
    int axes, first, count, code;
  } const cases[] = {{4, 4, 1, 0},  {4, 5, 1, 7},  {4, 9, 1, 0},   {4, 11, 1, 0}, {4, 12, 1, 7},
                     {4, 1, 5, 7},  {4, 9, 3, 0},  {8, 8, 2, 0},   {8, 9, 3, 0},  {8, 9, 4, 7},
                     {8, 11, 1, 0}, {8, 12, 1, 7}, {12, 12, 1, 0}, {12, 12, 2, 7}};
  for (const auto& c : cases) {
    CommandTestCard card({.axis_count = c.axes});
    std::vector<double> values(8);
    EXPECT_EQ(card.Call("GT_GetEncPos", {c.first, &values, c.count, nullptr}), c.code)
        << c.axes << " " << c.first << " " << c.count << " " << card.reason.en;
  }
}

TEST(EncoderCommand, NumbersAreCheckedAtBothEnds) {
  for (const auto& [axes, encoder, code] :
       {std::tuple{8, 0, 7}, {8, 1, 0}, {8, 8, 0}, {8, 9, 7}, {12, 12, 0}, {12, 13, 7}}) {
    CommandTestCard card({.axis_count = axes});
    EXPECT_EQ(card.Call("GT_EncOn", {encoder}), code) << axes << " " << encoder;
    EXPECT_EQ(card.Call("GT_EncOff", {encoder}), code) << axes << " " << encoder;
  }
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_EncSns", {65535}), 0);
  EXPECT_EQ(card.Call("GT_EncSns", {65536}), 7);
  EXPECT_EQ(card.Call("GT_EncSns", {-1}), 7);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
