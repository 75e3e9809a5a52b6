// Inputs, outputs and the probe of GE cards for paths. Source: GE manual 7, 9 and 10.4.
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/path_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ges {
namespace {

TEST(GeSxIo, WritesOneOutput) {
  PathTestCard card;
  card.Do("GT_ExOpt", {0x0011});
  card.Do("GT_ExOptBit", {15, 1});
  card.Do("GT_ExOptBit", {4, 0});
  EXPECT_EQ(card.Read("GT_GetExOpt"), 0x8001);
}

TEST(GeSxIo, PutsOutTheVoltageOfTheSpindle) {
  PathTestCard card;
  card.Do("GT_SetSpindleVel", {32767});
  EXPECT_DOUBLE_EQ(card.motion.state().spindle->Volts(), 10);
  card.Do("GT_CloseSpindle");
  EXPECT_EQ(card.motion.state().spindle->Volts(), 0);
}

TEST(GeSxIo, CapturesAllAxesWhenTheProbeFalls) {
  PathTestCard card;
  card.motion.digital_io().SetPin(motion::DiType::kGpi, 0, true);
  card.Do("GT_SetAtlPos", {1, 100});
  card.Do("GT_SetAtlPos", {3, 300});
  card.Do("GT_CaptProb");
  card.Refuses(1, ge::kCaptureBusy, "GT_CaptProb");
  card.Refuses(1, ge::kCaptureBusy, "GT_CaptHome", {2});
  motion::MotionState& state = ChangeState(card.motion);
  state.capture.Edge(motion::DiType::kGpi, 0, false,
                     [&](size_t encoder) { return state.encoders[encoder].position; });
  EXPECT_TRUE(card.StatusBit(1, 3));
  EXPECT_TRUE(card.StatusBit(2, 3));
  EXPECT_EQ(card.Read("GT_GetCapt", {1}), 100);
  EXPECT_EQ(card.Read("GT_GetCapt", {3}), 300);
}

TEST(GeSxIo, ReadsVersions) {
  PathTestCard card;
  EXPECT_GT(card.Read("GT_GetDllVrsn"), 0);
  EXPECT_GT(card.Read("GT_ChkVrsn"), 0);
}

}  // namespace
}  // namespace oncard::gtcalls::ges
