// Reading and setting positions, velocities and accelerations through their commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/axis_command_support.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

/// Axis 1, enabled, 10 ms after the start of a move at 1 pulse/ms^2 with a 1 ms cycle: 50 pulses,
/// 10 pulse/ms.
class Moving : public testing::Test {
 protected:
  Moving() {
    EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
    card.MoveTo(1, 10000, 100);
    card.Cycles(10);
  }
  AxisCommandCard card;
};

TEST_F(Moving, EveryValueIsRead) {
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 50);
  EXPECT_EQ(card.Read("GT_GetPrfVel"), 10);
  EXPECT_EQ(card.Read("GT_GetPrfAcc"), 1);
  EXPECT_EQ(card.Read("GT_GetPrfMode"), 0);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos"), 50);
  EXPECT_EQ(card.Read("GT_GetAxisPrfVel"), 10);
  EXPECT_EQ(card.Read("GT_GetAxisPrfAcc"), 1);
  // The 40.5 pulses one cycle before are counted as 41; two cycles before there were 32.
  EXPECT_EQ(card.Read("GT_GetEncPos"), 50);
  EXPECT_EQ(card.Read("GT_GetEncPosPre"), 41);
  EXPECT_EQ(card.Read("GT_GetEncVel"), 9);
  EXPECT_EQ(card.Read("GT_GetAxisEncPos"), 50);
  EXPECT_EQ(card.Read("GT_GetAxisEncVel"), 9);
  EXPECT_EQ(card.Read("GT_GetAxisEncAcc"), 0);
  EXPECT_EQ(card.Read("GT_GetAxisError"), 0);
  card.Cycle();
  EXPECT_EQ(card.Read("GT_GetAxisError"), -0.5) << "60.5 pulses planned, 61 counted";
  EXPECT_EQ(card.Read("GT_GetAxisEncAcc"), 2);
}

TEST_F(Moving, ConsecutiveOnesAreReadWithTheClock) {
  card.MoveTo(3, 10000, 100);
  card.Cycles(10);
  for (const char* command : {"GT_GetPrfPos", "GT_GetAxisPrfPos"}) {
    std::vector<double> values(3, -1);
    std::vector<double> clock(1);
    EXPECT_EQ(card.Call(command, {1, &values, 3, &clock}), 0);
    EXPECT_EQ(values, (std::vector<double>{200, 0, 50})) << command;
    EXPECT_EQ(clock[0], 20);
  }
}

TEST(PositionCommand, CountsStayOnTheCard) {
  for (const char* command :
       {"GT_GetPrfPos", "GT_GetPrfVel", "GT_GetPrfAcc", "GT_GetPrfMode", "GT_GetAxisPrfPos",
        "GT_GetAxisPrfVel", "GT_GetAxisPrfAcc", "GT_GetAxisEncPos", "GT_GetAxisEncVel",
        "GT_GetAxisEncAcc", "GT_GetAxisError"}) {
    AxisCommandCard card;
    std::vector<double> values(12);
    for (const auto& [first, count, code] :
         {std::tuple{1, 8, 0}, {1, 9, 7}, {1, 0, 7}, {8, 1, 0}, {8, 2, 7}, {0, 1, 7}, {9, 1, 7}}) {
      EXPECT_EQ(card.Call(command, {first, &values, count, nullptr}), code)
          << command << " " << first << " " << count;
    }
  }
}

TEST(GetPrfMode, NumbersTheModes) {
  using motion::ProfileMode;
  AxisCommandCard card;
  const ProfileMode modes[] = {ProfileMode::kTrap, ProfileMode::kJog,    ProfileMode::kPt,
                               ProfileMode::kGear, ProfileMode::kFollow, ProfileMode::kCrd,
                               ProfileMode::kPvt};
  for (size_t i = 0; i < std::size(modes); ++i) {
    ChangeState(card.motion).profiles[0].mode = modes[i];
    EXPECT_EQ(card.Read("GT_GetPrfMode"), static_cast<double>(i));
  }
}

// --- Setting -----------------------------------------------------------------------------------

TEST(SetPrfPos, ChangesTheProfileAndLeavesTheAxis) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_SetPrfPos", {1, 5000}), 0);
  card.Cycles(2);
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 5000);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos"), 0);
  EXPECT_EQ(card.Call("GT_SynchAxisPos", {1}), 0);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos"), 5000);
  EXPECT_EQ(card.Read("GT_GetAxisEncPos"), 0);
  EXPECT_EQ(card.Read("GT_GetEncPos"), 0);
}

TEST_F(Moving, PrfPosCannotBeSet) {
  card.ExpectRefused(1, "GT_SetPrfPos", {1, 0});
  EXPECT_EQ(card.Call("GT_SetPrfPos", {2, 0}), 0);
}

TEST(SetEncPos, ChangesTheEncoderAndLeavesTheAxis) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_SetEncPos", {1, -700}), 0);
  card.Cycles(2);
  EXPECT_EQ(card.Read("GT_GetEncPos"), -700);
  EXPECT_EQ(card.Read("GT_GetEncPosPre"), -700);
  EXPECT_EQ(card.Read("GT_GetAxisEncPos"), 0);
  EXPECT_EQ(card.Call("GT_SynchAxisPos", {1}), 0);
  EXPECT_EQ(card.Read("GT_GetAxisEncPos"), -700);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos"), 0);
  EXPECT_EQ(card.Call("GT_SetEncPos", {1, 2147483647.0}), 0);
  EXPECT_EQ(card.Call("GT_SetEncPos", {1, 2147483648.0}), 7);
}

TEST(SynchAxisPos, WorksOnTheMaskedAxes) {
  AxisCommandCard card;
  for (const int axis : {1, 2, 3}) EXPECT_EQ(card.Call("GT_SetPrfPos", {axis, 100 * axis}), 0);
  EXPECT_EQ(card.Call("GT_SynchAxisPos", {0b101}), 0);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos", 1), 100);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos", 2), 0);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos", 3), 300);
  card.ExpectRefused(1, "GT_SynchAxisPos", {0});
}

TEST(SynchAxisPos, WorksOnTheAxesOfTheMaskedCoordinateSystems) {
  const struct {
    int axes;
    int bit;
  } rows[] = {{4, 12}, {8, 12}, {12, 12}, {4, 8}, {8, 8}};
  for (const auto& [axes, bit] : rows) {
    SCOPED_TRACE(testing::Message() << axes << " axes, bit " << bit);
    AxisCommandCard card({.axis_count = axes, .cycle_us = 1000});
    std::vector<double> parameters(21);
    parameters[0] = 2;    // dimension
    parameters[2] = 1;    // profile 2 is x
    parameters[4] = 2;    // profile 4 is y
    parameters[9] = 500;  // synVelMax
    parameters[10] = 10;  // synAccMax
    EXPECT_EQ(card.Call("GT_SetCrdPrm", {2, &parameters}), 0);
    for (int axis = 1; axis <= 4; ++axis) {
      EXPECT_EQ(card.Call("GT_SetPrfPos", {axis, 100 * axis}), 0);
    }
    EXPECT_EQ(card.Call("GT_SynchAxisPos", {1 << (bit + 1)}), 0);
    EXPECT_EQ(card.Read("GT_GetAxisPrfPos", 1), 0);
    EXPECT_EQ(card.Read("GT_GetAxisPrfPos", 2), 200);
    EXPECT_EQ(card.Read("GT_GetAxisPrfPos", 3), 0);
    EXPECT_EQ(card.Read("GT_GetAxisPrfPos", 4), 400);
  }
}

TEST(ZeroPos, SetsEverythingOfItsAxesToZero) {
  AxisCommandCard card;
  for (const int axis : {1, 2, 3}) {
    EXPECT_EQ(card.Call("GT_SetPrfPos", {axis, 100}), 0);
    EXPECT_EQ(card.Call("GT_SetEncPos", {axis, 200}), 0);
  }
  EXPECT_EQ(card.Call("GT_SynchAxisPos", {0b111}), 0);
  EXPECT_EQ(card.Call("GT_ZeroPos", {1, 2}), 0);
  card.Cycle();
  for (const int axis : {1, 2}) {
    for (const char* command :
         {"GT_GetPrfPos", "GT_GetEncPos", "GT_GetAxisPrfPos", "GT_GetAxisEncPos"}) {
      EXPECT_EQ(card.Read(command, axis), 0) << command << " " << axis;
    }
  }
  EXPECT_EQ(card.Read("GT_GetPrfPos", 3), 100);
  EXPECT_EQ(card.Call("GT_ZeroPos", {1, 9}), 7);
  EXPECT_EQ(card.Call("GT_ZeroPos", {8, 2}), 7);
}

TEST_F(Moving, NoneOfItsAxesIsZeroedWhileOneMoves) {
  EXPECT_EQ(card.Call("GT_SetPrfPos", {2, 77}), 0);
  card.ExpectRefused(1, "GT_ZeroPos", {1, 2});
  EXPECT_EQ(card.Call("GT_ZeroPos", {2, 7}), 0);
  EXPECT_EQ(card.Read("GT_GetPrfPos", 2), 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
