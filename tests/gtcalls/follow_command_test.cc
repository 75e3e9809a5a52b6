// The commands of Follow: FIFOs, what they refuse, and the manual's example through them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

using ::testing::HasSubstr;

class FollowCommandTest : public ::testing::Test {
 protected:
  FollowCommandTest() {
    card_.Expect(0, "GT_PrfFollow", {2, 0});
    card_.Expect(0, "GT_SetFollowMaster", {2, 1, 2, 0});
  }

  double Space(int fifo) {
    std::vector<double> space(1);
    card_.Expect(0, "GT_FollowSpace", {2, &space, fifo});
    return space[0];
  }
  void StartJog() {
    std::vector<double> prm = {1, 1, 0};
    card_.Expect(0, "GT_PrfJog", {1});
    card_.Expect(0, "GT_SetJogPrm", {1, &prm});
    card_.Expect(0, "GT_SetVel", {1, 50.0});
    card_.Expect(0, "GT_Update", {1});
  }

  CommandTestCard card_;
};

TEST_F(FollowCommandTest, RegistersReadBack) {
  std::vector<double> a(1);
  std::vector<double> b(1);
  std::vector<double> c(1);
  card_.Expect(0, "GT_GetFollowMaster", {2, &a, &b, &c});
  EXPECT_EQ((std::vector{a[0], b[0], c[0]}), (std::vector<double>{1, 2, 0}));
  card_.Expect(0, "GT_SetFollowLoop", {2, -5});
  card_.Expect(0, "GT_GetFollowLoop", {2, &a});
  EXPECT_EQ(a[0], 0) << "passes done";
  card_.Expect(0, "GT_SetFollowEvent", {2, 2, -1, 777});
  card_.Expect(0, "GT_GetFollowEvent", {2, &a, &b, &c});
  EXPECT_EQ((std::vector{a[0], b[0], c[0]}), (std::vector<double>{2, -1, 777}));
  card_.Expect(0, "GT_SetFollowMemory", {2, 1});
  card_.Expect(0, "GT_GetFollowMemory", {2, &a});
  EXPECT_EQ(a[0], 1);
  EXPECT_EQ(Space(0), 512);
}

TEST_F(FollowCommandTest, AFifoHoldsSixteenSegments) {
  for (int i = 1; i <= 16; ++i) {
    EXPECT_EQ(Space(0), 17 - i);
    card_.Expect(0, "GT_FollowData", {2, 100 * i, 50.0 * i, 0, 0});
  }
  EXPECT_EQ(Space(0), 0);
  EXPECT_EQ(Space(1), 16);
  card_.Expect(1, "GT_FollowData", {2, 1700, 850.0, 0, 0});
  card_.Expect(0, "GT_FollowClear", {2, 0});
  EXPECT_EQ(Space(0), 16);
}

TEST_F(FollowCommandTest, ParametersOutOfRange) {
  card_.Expect(7, "GT_PrfFollow", {2, -2});
  card_.Expect(7, "GT_SetFollowMaster", {2, 2, 2, 0});
  card_.Expect(7, "GT_SetFollowMaster", {2, 2, 3, 0});
  card_.Expect(7, "GT_SetFollowMaster", {2, 13, 1, 0});
  card_.Expect(7, "GT_SetFollowLoop", {2, 32768});
  card_.Expect(0, "GT_SetFollowLoop", {2, -32768});
  card_.Expect(7, "GT_SetFollowEvent", {2, 3, 1, 0});
  card_.Expect(7, "GT_SetFollowMemory", {2, 2});
  card_.Expect(7, "GT_FollowData", {2, 0, 50.0, 0, 0});
  card_.Expect(7, "GT_FollowData", {2, 100, 50.0, 4, 0});
  card_.Expect(7, "GT_FollowData", {2, 100, 50.0, 0, 2});
  card_.Expect(0, "GT_FollowData", {2, 100, 50.0, 0, 0});
  card_.Expect(7, "GT_FollowData", {2, 100, 60.0, 0, 0});  // does not go on
  card_.Expect(7, "GT_FollowData", {2, -100, 60.0, 0, 0});
}

// The manual has 1 and -1 for both events.
TEST_F(FollowCommandTest, TheMasterMovesForwardOrBackward) {
  for (const int event : {1, 2}) {
    card_.Expect(7, "GT_SetFollowEvent", {2, event, 0, 100});
    EXPECT_EQ(card_.reason.en, "masterDir is 0; 1 is forward, -1 backward");
    EXPECT_EQ(card_.reason.zh, "masterDir 为 0；1 为正向，-1 为负向");
    for (const int direction : {1, -1}) {
      card_.Expect(0, "GT_SetFollowEvent", {2, event, direction, 100});
    }
  }
}

TEST_F(FollowCommandTest, OtherModesRefuse) {
  std::vector<double> a(1);
  card_.Expect(1, "GT_SetFollowMaster", {3, 1, 2, 0});
  card_.Expect(1, "GT_GetFollowMaster", {3, &a, &a, &a});
  card_.Expect(1, "GT_SetFollowLoop", {3, 1});
  card_.Expect(1, "GT_GetFollowLoop", {3, &a});
  card_.Expect(1, "GT_SetFollowEvent", {3, 1, 1, 0});
  card_.Expect(1, "GT_GetFollowEvent", {3, &a, &a, &a});
  card_.Expect(1, "GT_SetFollowMemory", {3, 1});
  card_.Expect(1, "GT_GetFollowMemory", {3, &a});
  card_.Expect(1, "GT_FollowSpace", {3, &a, 0});
  card_.Expect(1, "GT_FollowData", {3, 100, 50.0, 0, 0});
  card_.Expect(1, "GT_FollowClear", {3, 0});
  card_.Expect(1, "GT_FollowStart", {4, 0});
  card_.Expect(1, "GT_FollowSwitch", {4});
  card_.Expect(1, "GT_GetFollowStatus", {3, &a, &a});
}

TEST_F(FollowCommandTest, StartNeedsMasterAndData) {
  card_.Expect(1, "GT_FollowStart", {0, 0});
  card_.Expect(1, "GT_FollowStart", {2, 0});
  card_.Expect(0, "GT_FollowData", {2, 100, 50.0, 0, 1});
  card_.Expect(1, "GT_FollowStart", {2, 0});
  card_.Expect(0, "GT_PrfFollow", {3, 0});
  card_.Expect(0, "GT_FollowData", {3, 100, 50.0, 0, 0});
  card_.Expect(1, "GT_FollowStart", {4, 0});
  EXPECT_THAT(card_.reason.en, HasSubstr("GT_SetFollowMaster"));
  card_.Expect(0, "GT_FollowStart", {2, 2});  // FIFO 1
  std::vector<double> fifo(1);
  std::vector<double> switching(1);
  card_.Expect(0, "GT_GetFollowStatus", {2, &fifo, &switching});
  EXPECT_EQ(fifo[0], 1);
}

TEST_F(FollowCommandTest, WhileFollowing) {
  card_.Expect(0, "GT_FollowData", {2, 1000, 500.0, 1, 0});
  card_.Expect(1, "GT_FollowSwitch", {2});  // not moving
  StartJog();
  card_.Expect(0, "GT_FollowStart", {2, 0});
  card_.Cycles(10);
  card_.Expect(1, "GT_FollowStart", {2, 0});
  card_.Expect(1, "GT_SetFollowMaster", {2, 3, 2, 0});
  card_.Expect(1, "GT_SetFollowMemory", {2, 1});
  card_.Expect(1, "GT_FollowClear", {2, 0});
  card_.Expect(0, "GT_FollowClear", {2, 1});
  card_.Expect(1, "GT_FollowSwitch", {0});
  card_.Expect(1, "GT_FollowSwitch", {2});  // the other FIFO is empty
  card_.Expect(0, "GT_FollowData", {2, 1000, 500.0, 1, 1});
  card_.Expect(0, "GT_FollowSwitch", {2});
  card_.Expect(1, "GT_FollowClear", {2, 1});  // it is switched to
  std::vector<double> fifo(1);
  std::vector<double> switching(1);
  card_.Expect(0, "GT_GetFollowStatus", {2, &fifo, &switching});
  EXPECT_EQ(switching[0], 1);
}

// Manual example 7-7.
TEST_F(FollowCommandTest, TheSlaveFollowsTheTable) {
  card_.Expect(0, "GT_FollowData", {2, 20000, 10000.0, 0, 0});
  EXPECT_EQ(Space(0), 15);
  card_.Expect(0, "GT_FollowData", {2, 40000, 30000.0, 0, 0});
  EXPECT_EQ(Space(0), 14);
  card_.Expect(0, "GT_FollowData", {2, 60000, 40000.0, 0, 0});
  EXPECT_EQ(Space(0), 13);
  card_.Expect(0, "GT_SetFollowLoop", {2, 0});
  card_.Expect(0, "GT_SetFollowEvent", {2, 2, 1, 50000});
  card_.Expect(0, "GT_FollowStart", {2, 0});
  StartJog();
  card_.Cycles(4 * (1025 + 1200 + 600));
  std::vector<double> position(1);
  card_.Expect(0, "GT_GetPrfPos", {2, &position, 1, nullptr});
  EXPECT_NEAR(position[0], 40000 + 20000, 1e-6);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
