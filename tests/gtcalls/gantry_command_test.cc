// Gantries through their commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/axis_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

using Cells = std::vector<double>;

TEST(GantryCommand, TheMasterMovesBoth) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {2}), 0);
  EXPECT_EQ(card.Call("GT_AxisOn", {3}), 0);
  EXPECT_EQ(card.Call("GT_EnableGantry", {2, 3, 0, 0}), 0);
  card.MoveTo(2, 1000, 10);
  EXPECT_EQ(card.Status(3) & kMoving, kMoving);
  card.CyclesToRest(2);
  EXPECT_EQ(card.Read("GT_GetEncPos", 2), 1000);
  EXPECT_EQ(card.Read("GT_GetEncPos", 3), 1000);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos", 3), 1000);
  EXPECT_EQ(card.Call("GT_DisableGantry", {}), 0);
  card.MoveTo(2, 0, 10);
  card.CyclesToRest(2);
  EXPECT_EQ(card.Read("GT_GetEncPos", 2), 0);
  EXPECT_EQ(card.Read("GT_GetEncPos", 3), 1000);
}

TEST(GantryCommand, TheSlaveIsNotCommanded) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_EnableGantry", {1, 2, 0, 0}), 0);
  EXPECT_EQ(card.Call("GT_AxisOn", {2}), 0);
  card.PrepareTrap(2, 100, 1);
  card.ExpectRefused(1, "GT_Update", {2});
  EXPECT_EQ(card.Call("GT_DisableGantry", {}), 0);
  EXPECT_EQ(card.Update(2), 0);
}

TEST(GantryCommand, TheSlavesBitStopsBoth) {
  for (const int abrupt : {0, 1}) {
    AxisCommandCard card;
    EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
    EXPECT_EQ(card.Call("GT_AxisOn", {2}), 0);
    EXPECT_EQ(card.Call("GT_EnableGantry", {1, 2, 0, 0}), 0);
    card.MoveTo(1, 100000, 10);
    card.Cycles(50);
    EXPECT_EQ(card.Call("GT_Stop", {2, abrupt << 1}), 0);
    card.Cycles(abrupt != 0 ? 1 : 11);
    EXPECT_EQ(card.Status(1) & kMoving, 0);
    EXPECT_EQ(card.Status(2) & kMoving, 0);
  }
}

TEST(GantryCommand, HomingAndScalesDoNotReachTheSlave) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {2}), 0);
  EXPECT_EQ(card.Call("GT_HomeInit", {}), 0);
  Cells parameters(22);
  EXPECT_EQ(card.Call("GT_GetHomePrm", {2, &parameters}), 0);
  for (const size_t cell : {8u, 9u, 10u, 11u}) parameters[cell] = 1;  // velocities, accelerations
  EXPECT_EQ(card.Call("GT_EnableGantry", {1, 2, 0, 0}), 0);
  card.ExpectRefused(1, "GT_GoHome", {2, &parameters});
  EXPECT_EQ(card.reason.en,
            "axis 2 is the slave of a gantry: command its master, axis 1, or call "
            "GT_DisableGantry");
  card.ExpectRefused(1, "GT_Home", {2, 1000, 10.0, 1.0, 0});
  card.ExpectRefused(1, "GT_ProfileScale", {2, 2, 1});
  EXPECT_EQ(card.Call("GT_DisableGantry", {}), 0);
  EXPECT_EQ(card.Call("GT_ProfileScale", {2, 2, 1}), 0);
  EXPECT_EQ(card.Call("GT_GoHome", {2, &parameters}), 0);
}

TEST(GantryCommand, ChecksParametersAndState) {
  AxisCommandCard card;
  const struct {
    Argument master, slave, master_kp, slave_kp;
    int code;
  } cases[] = {{0, 1, 0, 0, 7},  {1, 9, 0, 0, 7},     {1, 1, 0, 0, 7},      {1, 2, -1, 0, 7},
               {1, 2, 0, -1, 7}, {1, 2, 32768, 0, 7}, {8, 1, 32767, 0.5, 0}};
  for (const auto& c : cases) {
    if (c.code != 0) {
      card.ExpectRefused(c.code, "GT_EnableGantry", {c.master, c.slave, c.master_kp, c.slave_kp});
    } else {
      EXPECT_EQ(card.Call("GT_EnableGantry", {c.master, c.slave, c.master_kp, c.slave_kp}), 0);
    }
  }
  card.ExpectRefused(1, "GT_EnableGantry", {2, 3, 0, 0});
  EXPECT_EQ(card.Call("GT_AxisOn", {8}), 0);
  card.MoveTo(8, 1000, 1);
  card.Cycle();
  card.ExpectRefused(1, "GT_DisableGantry", {});
  card.CyclesToRest(8);
  EXPECT_EQ(card.Call("GT_DisableGantry", {}), 0);
  EXPECT_EQ(card.Call("GT_DisableGantry", {}), 0);
  card.MoveTo(8, 0, 1);
  card.Cycle();
  card.ExpectRefused(1, "GT_EnableGantry", {8, 1, 0, 0});
  card.ExpectRefused(1, "GT_EnableGantry", {1, 8, 0, 0});
}

TEST(GantryCommand, KeepsTheLargestSkew) {
  AxisCommandCard card;
  Cells limit(1);
  EXPECT_EQ(card.Call("GT_GetGantryErrLmt", {&limit}), 0);
  EXPECT_EQ(limit[0], 32767);
  card.ExpectRefused(7, "GT_SetGantryErrLmt", {0});
  EXPECT_EQ(card.Call("GT_SetGantryErrLmt", {20}), 0);
  EXPECT_EQ(card.Call("GT_EnableGantry", {1, 2, 0, 0}), 0);
  EXPECT_EQ(card.Call("GT_GetGantryErrLmt", {&limit}), 0);
  EXPECT_EQ(limit[0], 20);
  // The slave's drive is off, so it does not follow.
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.MoveTo(1, 1000, 1);
  card.CyclesToRest(1);
  EXPECT_LT(card.Read("GT_GetPrfPos", 1), 30);
  EXPECT_EQ(card.Status(1) & kServoOn, 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
