// Axes of GE cards for paths. Source: GE manual chapters 3, 4 and 12, table 2-4.
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/path_test_card.h"

namespace oncard::gtcalls::ges {
namespace {

using ge::kDriveOn;
using ge::kModeInUse;

TEST(GeSxAxis, HasTheStatusWordsOfTheManual) {
  PathTestCard card("GE-400-SG");
  EXPECT_EQ(card.Status(1), 0x0800);
  for (const double axis : {1, 2, 3, 4}) card.Do("GT_AxisOn", {axis});
  EXPECT_EQ(card.Status(1), 0x0A00);
  EXPECT_EQ(card.Status(2), 0x1A00);
  EXPECT_EQ(card.Status(3), 0x2A00);
  EXPECT_EQ(card.Status(4), 0x3A00);
}

TEST(GeSxAxis, NeedsTheDriveOffForItsInputs) {
  PathTestCard card("GE-300-SV");
  card.Do("GT_AxisOn", {1});
  for (const char* command : {"GT_AlarmOn", "GT_AlarmOff", "GT_EncOn", "GT_EncOff", "GT_DrvRst"}) {
    card.Refuses(1, kDriveOn, command, {1});
  }
  card.Do("GT_AxisOff", {1});
  card.Do("GT_AlarmOff", {1});
  card.Do("GT_AlarmOn", {1});
  card.SetInput(motion::DiType::kAlarm, 0, true);
  card.Refuses(1, kDriveOn, "GT_AxisOn", {1});
}

TEST(GeSxAxis, HasAServoControllerOrPulses) {
  PathTestCard card("GE-300-SV");
  card.Do("GT_SetKp", {1, 5});
  card.Refuses(1, kModeInUse, "GT_StepDir", {1});
  card.Do("GT_CtrlMode", {1, 1});
  card.Do("GT_StepDir", {1});
  for (const char* command : {"GT_SetKp", "GT_SetKi", "GT_SetKd", "GT_SetKvff", "GT_SetKaff",
                              "GT_SetILmt", "GT_SetMtrLmt", "GT_SetMtrBias"}) {
    card.Refuses(1, kModeInUse, command, {1, 5});
  }
  card.Do("GT_SetPosErr", {1, 5});
  EXPECT_EQ(card.Read("GT_GetKp", {1}), 5);
}

TEST(GeSxAxis, StopsThePathWhenItIsSwitchedOff) {
  PathTestCard card;
  card.SetRates(10, 1);
  card.Do("GT_AxisOn", {1});
  card.Do("GT_LnXY", {1000, 0});
  card.Run(20);
  card.Do("GT_AxisOff", {1});
  card.RunPath();
  EXPECT_EQ(card.PathStatus(), 0x2093);
  EXPECT_LT(card.Point()[0], 250);
}

TEST(GeSxAxis, IsPlacedAtWholePulses) {
  PathTestCard card;
  card.Do("GT_SetAtlPos", {2, 12.6});
  EXPECT_EQ(card.Point()[1], 13);
  EXPECT_EQ(card.Read("GT_GetAtlPos", {2}), 13);
  card.Do("GT_ZeroPos", {2});
  EXPECT_EQ(card.Point()[1], 0);
}

TEST(GeSxAxis, UpdatesItsServoRegisters) {
  PathTestCard card("GE-300-SV");
  card.Do("GT_SetKp", {2, 7});
  EXPECT_EQ(card.motion.state().controls[1].sets[0].kp, 0);
  card.Refuses(1, ge::kEmptyMask, "GT_MltiUpdt", {0});
  card.Do("GT_MltiUpdt", {2});
  EXPECT_EQ(card.motion.state().controls[1].sets[0].kp, 7);
}

}  // namespace
}  // namespace oncard::gtcalls::ges
