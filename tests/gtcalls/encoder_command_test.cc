// Sources and senses of encoders through their commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls {
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
}  // namespace oncard::gtcalls
