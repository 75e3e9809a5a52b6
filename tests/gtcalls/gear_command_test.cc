// The commands of electronic gear: what they refuse, and the manual's example through them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

using ::testing::HasSubstr;

class GearCommandTest : public ::testing::Test {
 protected:
  void StartJog(int profile) {
    std::vector<double> prm = {1, 1, 0};
    ASSERT_EQ(card_.Call("GT_PrfJog", {profile}), 0);
    ASSERT_EQ(card_.Call("GT_SetJogPrm", {profile, &prm}), 0);
    ASSERT_EQ(card_.Call("GT_SetVel", {profile, 100.0}), 0);
    ASSERT_EQ(card_.Call("GT_Update", {1 << (profile - 1)}), 0);
  }
  void StartGear(int profile) {
    ASSERT_EQ(card_.Call("GT_PrfGear", {profile, 0}), 0);
    ASSERT_EQ(card_.Call("GT_SetGearMaster", {profile, 1, 2, 0}), 0);
    ASSERT_EQ(card_.Call("GT_SetGearRatio", {profile, 2, 1, 0}), 0);
    ASSERT_EQ(card_.Call("GT_GearStart", {1 << (profile - 1)}), 0);
  }

  CommandTestCard card_;
};

TEST_F(GearCommandTest, RegistersReadBack) {
  std::vector<double> a(1);
  std::vector<double> b(1);
  std::vector<double> c(1);
  card_.Expect(0, "GT_PrfGear", {2, 0});
  card_.Expect(0, "GT_GetGearMaster", {2, &a, &b, &c});
  EXPECT_EQ(a[0], 0) << "none has been set";
  card_.Expect(0, "GT_SetGearMaster", {2, 3, 3, 1});
  card_.Expect(0, "GT_GetGearMaster", {2, &a, &b, &c});
  EXPECT_EQ((std::vector{a[0], b[0], c[0]}), (std::vector<double>{3, 3, 1}));
  card_.Expect(0, "GT_SetGearRatio", {2, 4, -3, 1000});
  card_.Expect(0, "GT_GetGearRatio", {2, &a, &b, &c});
  EXPECT_EQ((std::vector{a[0], b[0], c[0]}), (std::vector<double>{4, -3, 1000}));
  card_.Expect(0, "GT_SetGearEvent", {2, 5, 10, 20});
  card_.Expect(0, "GT_GetGearEvent", {2, &a, &b, &c});
  EXPECT_EQ((std::vector{a[0], b[0], c[0]}), (std::vector<double>{5, 10, 20}));
}

TEST_F(GearCommandTest, ParametersOutOfRange) {
  card_.Expect(0, "GT_PrfGear", {2, 0});
  card_.Expect(7, "GT_PrfGear", {2, 2});
  card_.Expect(7, "GT_SetGearMaster", {2, 0, 2, 0});
  card_.Expect(7, "GT_SetGearMaster", {2, 9, 2, 0});
  card_.Expect(7, "GT_SetGearMaster", {2, 1, 4, 0});
  card_.Expect(7, "GT_SetGearMaster", {2, 2, 2, 0});  // its own master
  card_.Expect(7, "GT_SetGearRatio", {2, 0, 1, 0});
  card_.Expect(7, "GT_SetGearRatio", {2, 1, 1, -1});
  card_.Expect(7, "GT_SetGearRatio", {2, 1, 1, 1});
  card_.Expect(0, "GT_SetGearRatio", {2, 1, 1, 2});
  card_.Expect(7, "GT_SetGearEvent", {2, 3, 0, 0});
  card_.Expect(7, "GT_SetGearEvent", {2, 6, 0, 0});
}

TEST_F(GearCommandTest, OtherModesRefuse) {
  std::vector<double> a(1);
  card_.Expect(1, "GT_SetGearMaster", {2, 1, 2, 0});
  card_.Expect(1, "GT_GetGearMaster", {2, &a, &a, &a});
  card_.Expect(1, "GT_SetGearRatio", {2, 1, 1, 0});
  card_.Expect(1, "GT_GetGearRatio", {2, &a, &a, &a});
  card_.Expect(1, "GT_SetGearEvent", {2, 1, 0, 0});
  card_.Expect(1, "GT_GetGearEvent", {2, &a, &a, &a});
  card_.Expect(1, "GT_GearStart", {2});
}

TEST_F(GearCommandTest, AnotherDirectionNeedsAnotherModeBetween) {
  card_.Expect(0, "GT_PrfGear", {2, 1});
  card_.Expect(0, "GT_PrfGear", {2, 1});
  card_.Expect(1, "GT_PrfGear", {2, -1});
  card_.Expect(0, "GT_PrfTrap", {2});
  card_.Expect(0, "GT_PrfGear", {2, -1});
}

TEST_F(GearCommandTest, StartNeedsMasterAndRatio) {
  card_.Expect(1, "GT_GearStart", {0});
  card_.Expect(0, "GT_PrfGear", {2, 0});
  card_.Expect(1, "GT_GearStart", {2});
  EXPECT_THAT(card_.reason.en, HasSubstr("GT_SetGearMaster"));
  card_.Expect(0, "GT_SetGearMaster", {2, 1, 2, 0});
  card_.Expect(1, "GT_GearStart", {2});
  EXPECT_THAT(card_.reason.en, HasSubstr("GT_SetGearRatio"));
  card_.Expect(0, "GT_SetGearRatio", {2, 1, 1, 0});
  card_.Expect(1, "GT_GearStart", {2 | 4});  // profile 3 is in mode Trap: nothing starts
  EXPECT_FALSE(card_.motion.state().profiles[1].now.moving);
  card_.Expect(0, "GT_GearStart", {2});
}

TEST_F(GearCommandTest, AMovingSlaveTakesRatiosOnly) {
  StartJog(1);
  StartGear(2);
  card_.Cycles(10);
  card_.Expect(1, "GT_GearStart", {2});
  card_.Expect(1, "GT_PrfTrap", {2});
  card_.Expect(1, "GT_SetGearMaster", {2, 1, 2, 0});
  card_.Expect(1, "GT_SetGearEvent", {2, 1, 0, 0});
  card_.Expect(0, "GT_SetGearRatio", {2, 1, 1, 0});
}

// Manual example 7-5, then the ratios of 7.5.2.
TEST_F(GearCommandTest, TheSlaveRunsAtTheRatio) {
  StartJog(1);
  StartGear(2);
  card_.Cycles(4 * 200);
  std::vector<double> velocity(2);
  card_.Expect(0, "GT_GetPrfVel", {1, &velocity, 2, nullptr});
  EXPECT_EQ(velocity, (std::vector<double>{100, 50}));
  card_.Expect(0, "GT_SetGearRatio", {2, 4, 3, 0});
  card_.Cycles(1);
  card_.Expect(0, "GT_GetPrfVel", {1, &velocity, 2, nullptr});
  EXPECT_EQ(velocity, (std::vector<double>{100, 75}));
  std::vector<double> mode(1);
  card_.Expect(0, "GT_GetPrfMode", {2, &mode, 1, nullptr});
  EXPECT_EQ(mode[0], 3);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
