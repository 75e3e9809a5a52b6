// Servo controllers through their commands.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

using Cells = std::vector<double>;

TEST(CtrlMode, ClosesTheLoopThroughTheOutputOfTheSameNumber) {
  CommandTestCard card;
  Cells value = {1};
  EXPECT_EQ(card.Call("GT_SetDac", {2, &value, 1}), 0);
  EXPECT_EQ(card.Call("GT_CtrlMode", {2, 0}), 0);
  EXPECT_TRUE(card.motion.InClosedLoop(1));
  EXPECT_EQ(card.Call("GT_SetDac", {2, &value, 1}), 1);
  EXPECT_EQ(card.Call("GT_EncOff", {2}), 1);
  EXPECT_EQ(card.Call("GT_StepDir", {2}), 1);
  EXPECT_EQ(card.Call("GT_CtrlMode", {2, 1}), 0);
  EXPECT_FALSE(card.motion.InClosedLoop(1));
  EXPECT_EQ(card.Call("GT_SetDac", {2, &value, 1}), 0);
  EXPECT_EQ(card.Call("GT_EncOff", {2}), 0);
  EXPECT_EQ(card.Call("GT_StepPulse", {2}), 0);
  EXPECT_EQ(card.motion.state().steps[1].mode, 1);
  EXPECT_EQ(card.Call("GT_StepDir", {2}), 0);
  EXPECT_EQ(card.motion.state().steps[1].mode, 0);
}

TEST(CtrlMode, IsRefusedWhileEnabledAndWithoutAnExternalEncoder) {
  CommandTestCard card;
  card.motion.AxisAt(0).ServoOn();
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_CtrlMode", {1, 0}), 1);
  EXPECT_EQ(card.Call("GT_CtrlMode", {1, 1}), 1);
  EXPECT_EQ(card.Hash(), before);
  card.motion.AxisAt(0).ServoOff();
  EXPECT_EQ(card.Call("GT_EncOff", {1}), 0);
  EXPECT_EQ(card.Call("GT_CtrlMode", {1, 0}), 1);
  EXPECT_EQ(card.Call("GT_CtrlMode", {1, 1}), 0);
  EXPECT_EQ(card.Call("GT_EncOn", {1}), 0);
  EXPECT_EQ(card.Call("GT_CtrlMode", {1, 0}), 0);
  for (const auto& [mode, code] : {std::pair{-1, 7}, {2, 7}}) {
    EXPECT_EQ(card.Call("GT_CtrlMode", {1, mode}), code) << mode;
  }
}

TEST(PidCommand, EachOfThreeSetsIsKept) {
  CommandTestCard card;
  for (int set = 1; set <= 3; ++set) {
    Cells pid = {set + 0.5, 2, 3, 4, 5, 60, 70, 80.0 + set};
    EXPECT_EQ(card.Call("GT_SetPid", {1, set, &pid}), 0);
  }
  for (int set = 1; set <= 3; ++set) {
    Cells pid(8);
    EXPECT_EQ(card.Call("GT_GetPid", {1, set, &pid}), 0);
    EXPECT_EQ(pid, (Cells{set + 0.5, 2, 3, 4, 5, 60, 70, 80.0 + set}));
  }
}

TEST(PidCommand, SetsAndMembersAreCheckedAtBothEnds) {
  CommandTestCard card;
  Cells pid = {1, 1, 1, 1, 1, 1, 1, 1};
  for (const auto& [set, code] : {std::pair{0, 7}, {1, 0}, {3, 0}, {4, 7}}) {
    EXPECT_EQ(card.Call("GT_SetPid", {1, set, &pid}), code) << set;
    EXPECT_EQ(card.Call("GT_GetPid", {1, set, &pid}), code) << set;
    EXPECT_EQ(card.Call("GT_SetControlFilter", {1, set}), code) << set;
  }
  const uint64_t before = card.Hash();
  for (size_t member = 0; member < 8; ++member) {
    Cells bad = pid;
    bad[member] = -1;
    EXPECT_EQ(card.Call("GT_SetPid", {1, 1, &bad}), 7) << member;
    bad[member] = 32768;
    if (member < 5) {
      EXPECT_EQ(card.Call("GT_SetPid", {1, 1, &bad}), 7) << member;
    }
  }
  EXPECT_EQ(card.Hash(), before);
}

TEST(ControlFilter, SelectsASet) {
  CommandTestCard card;
  Cells index(1);
  EXPECT_EQ(card.Call("GT_GetControlFilter", {8, &index}), 0);
  EXPECT_EQ(index[0], 1);
  EXPECT_EQ(card.Call("GT_SetControlFilter", {8, 3}), 0);
  EXPECT_EQ(card.Call("GT_GetControlFilter", {8, &index}), 0);
  EXPECT_EQ(index[0], 3);
  EXPECT_EQ(card.motion.state().controls[7].selected, 2);
}

TEST(PosErr, IsKeptAndCheckedAtBothEnds) {
  CommandTestCard card;
  Cells error(1);
  EXPECT_EQ(card.Call("GT_GetPosErr", {1, &error}), 0);
  EXPECT_EQ(error[0], 32767);
  for (const auto& [limit, code] :
       {std::pair{0.0, 7}, {-1.0, 7}, {1.0, 0}, {2147483647.0, 0}, {2147483648.0, 7}}) {
    EXPECT_EQ(card.Call("GT_SetPosErr", {1, limit}), code) << limit;
    if (code == 0) continue;
    EXPECT_EQ(card.reason.en,
              fmt::format("parameter error is {}; the range is [1, 2147483647]", limit));
  }
  EXPECT_EQ(card.Call("GT_GetPosErr", {1, &error}), 0);
  EXPECT_EQ(error[0], 2147483647.0);
}

TEST(KvffFilter, IsKeptPerSetAndCheckedAtBothEnds) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_SetKvffFilter", {1, 2, 3, 4.5}), 0);
  Cells exponent(1);
  Cells limit(1);
  EXPECT_EQ(card.Call("GT_GetKvffFilter", {1, 2, &exponent, &limit}), 0);
  EXPECT_EQ(exponent[0], 3);
  EXPECT_EQ(limit[0], 4.5);
  EXPECT_EQ(card.Call("GT_GetKvffFilter", {1, 1, &exponent, &limit}), 0);
  EXPECT_EQ(exponent[0], 0);
  for (const auto& [value, code] : {std::pair{-1, 7}, {0, 0}, {8, 0}, {9, 7}}) {
    EXPECT_EQ(card.Call("GT_SetKvffFilter", {1, 1, value, 1}), code) << value;
  }
  EXPECT_EQ(card.Call("GT_SetKvffFilter", {1, 1, 0, -0.5}), 7);
}

TEST(EncResponseCheck, IsKeptSwitchedAndCheckedAtBothEnds) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_SetEncResponseCheck", {1, 100, 0.5, 40}), 0);
  Cells threshold(1);
  Cells velocity(1);
  Cells time(1);
  EXPECT_EQ(card.Call("GT_GetEncResponseCheck", {1, &threshold, &velocity, &time}), 0);
  EXPECT_EQ(threshold[0], 100);
  EXPECT_EQ(velocity[0], 0.5);
  EXPECT_EQ(time[0], 40);
  EXPECT_EQ(card.Call("GT_EnableEncResponseCheck", {1}), 0);
  EXPECT_TRUE(card.motion.state().controls[0].check.on);
  EXPECT_EQ(card.Call("GT_DisableEncResponseCheck", {1}), 0);
  EXPECT_FALSE(card.motion.state().controls[0].check.on);
  EXPECT_EQ(card.Call("GT_SetEncResponseCheck", {1, -1, 0.5, 40}), 7);
  EXPECT_EQ(card.Call("GT_SetEncResponseCheck", {1, 1, -0.5, 40}), 7);
  EXPECT_EQ(card.Call("GT_SetEncResponseCheck", {1, 1, 0.5, -1}), 7);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
