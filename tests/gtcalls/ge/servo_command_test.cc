// Servo controllers of GE axes: U = Kp E + bias within the limit of the output (GE manual 8.2), and
// what the following error does (8.1).
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/ge_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ge {
namespace {

/// An enabled axis whose motor is 100 pulses behind its plan.
class LaggingCard : public GeTestCard {
 public:
  LaggingCard() : GeTestCard("GE-400-PV") {
    Do("GT_AxisOn", {1});
    ChangeState(motion).plants[0].stalled = true;
    MoveT(1, 100, 10, 1);
    RunToRest(1);
    EXPECT_EQ(Read("GT_GetAtlErr", {1}), 100);
  }
};

TEST(GeServo, TakesItsRegistersWithAnUpdate) {
  LaggingCard card;
  EXPECT_EQ(card.Read("GT_GetMtrCmd", {1}), 0);
  card.Do("GT_SetKp", {1, 10});
  card.Run(1);
  EXPECT_EQ(card.Read("GT_GetMtrCmd", {1}), 0);
  card.Do("GT_Update", {1});
  card.Run(1);
  EXPECT_EQ(card.Read("GT_GetMtrCmd", {1}), 1000);
  card.Do("GT_SetMtrBias", {1, -200});
  card.Do("GT_Update", {1});
  card.Run(1);
  EXPECT_EQ(card.Read("GT_GetMtrCmd", {1}), 800);
  card.Do("GT_SetMtrLmt", {1, 500});
  card.Do("GT_Update", {1});
  card.Run(1);
  EXPECT_EQ(card.Read("GT_GetMtrCmd", {1}), 500);
}

TEST(GeServo, LimitsTheSumOfErrors) {
  LaggingCard card;
  card.Do("GT_SetILmt", {1, 12345});
  card.Do("GT_Update", {1});
  card.Run(100);
  EXPECT_EQ(card.Read("GT_GetIntgr", {1}), 12345);
}

TEST(GeServo, PutsOutAVoltageInOpenLoop) {
  GeTestCard card("GE-400-PV");
  card.Refuses(1, kModeInUse, "GT_SetMtrCmd", {1, 9828});
  card.Do("GT_OpenLp", {1});
  EXPECT_FALSE(card.StatusBit(1, 8));
  card.Do("GT_SetMtrCmd", {1, 9828});
  EXPECT_EQ(card.Read("GT_GetMtrCmd", {1}), 9828);
  card.Do("GT_CloseLp", {1});
  EXPECT_TRUE(card.StatusBit(1, 8));
  EXPECT_EQ(card.Read("GT_GetMtrCmd", {1}), 0);
}

TEST(GeServo, HasNoEffectOnACardWithPulses) {
  GeTestCard card("GE-400-PG");
  card.Do("GT_SetMtrBias", {1, 100});
  card.Do("GT_Update", {1});
  EXPECT_EQ(card.Read("GT_GetMtrBias", {1}), 100);
  EXPECT_EQ(card.Read("GT_GetMtrCmd", {1}), 0);
}

TEST(GeFollowingError, SetsItsBitAndStopsWithAutoStop) {
  for (const bool stops : {false, true}) {
    GeTestCard card("GE-400-PV");
    card.Do("GT_AxisOn", {1});
    card.Do("GT_SetPosErr", {1, 50});
    card.Do(stops ? "GT_AuStpOn" : "GT_AuStpOff", {1});
    ChangeState(card.motion).plants[0].stalled = true;
    card.MoveT(1, 1000, 10, 1);
    card.Run(20);
    EXPECT_TRUE(card.StatusBit(1, 4));
    EXPECT_TRUE(card.StatusBit(1, 9)) << "the drive stays enabled";
    EXPECT_EQ(card.StatusBit(1, 10), !stops);
    card.RunToRest(1);
    // 10 ms and 50 pulses up: the limit is passed within the next cycle.
    EXPECT_NEAR(card.Read("GT_GetPrfPos", {1}), stops ? 52.5 : 1000, stops ? 0.5 : 0);
  }
}

TEST(GeFollowingError, IsNotJudgedWithPulses) {
  GeTestCard card("GE-400-PV");
  card.Do("GT_CtrlMode", {1, 1});
  card.Do("GT_EncOn", {1});
  card.Do("GT_SetPosErr", {1, 50});
  card.Do("GT_AxisOn", {1});
  ChangeState(card.motion).plants[0].stalled = true;
  card.MoveT(1, 1000, 10, 1);
  card.RunToRest(1);
  EXPECT_EQ(card.Read("GT_GetAtlErr", {1}), 1000);
  EXPECT_FALSE(card.StatusBit(1, 4));
}

}  // namespace
}  // namespace oncard::gtcalls::ge
