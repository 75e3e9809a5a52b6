// The laser signals: modes and their ranges, commands between segments, a power that follows a
// path.
#include <gtest/gtest.h>

#include "tests/gtcalls/crd_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

class LaserCard : public CrdCommandCard {
 public:
  const motion::Laser& Laser(size_t channel = 0) { return motion.state().lasers.channels[channel]; }
  double Power(size_t channel = 0) { return motion.readings().LaserPower(channel); }
  int ReadSwitch(int channel) {
    std::vector<double> value(1, -1);
    EXPECT_EQ(Call("GT_GetHSIOOpt", {&value, channel}), 0);
    return static_cast<int>(value[0]);
  }
};

TEST(Laser, EachChannelIsSwitched) {
  LaserCard card;
  EXPECT_EQ(card.ReadSwitch(0), 0);
  card.Expect(0, "GT_SetHSIOOpt", {1, 1});
  EXPECT_EQ(card.ReadSwitch(0), 0);
  EXPECT_EQ(card.ReadSwitch(1), 1);
  card.Expect(0, "GT_SetHSIOOpt", {0, 1});
  EXPECT_EQ(card.ReadSwitch(1), 0);
}

TEST(Laser, EveryCommandChecksItsRanges) {
  LaserCard card;
  card.SetUp();
  struct {
    const char* name;
    std::vector<Argument> arguments;
    int16_t code;
  } const cases[] = {{"GT_SetHSIOOpt", {2, 0}, 7},
                     {"GT_SetHSIOOpt", {1, 2}, 7},
                     {"GT_LaserPowerMode", {3, 100, 0, 0, 0}, 7},
                     {"GT_LaserPowerMode", {0, 10, 20, 0, 0}, 7},
                     {"GT_LaserPowerMode", {0, 100, -1, 0, 0}, 7},
                     {"GT_LaserPowerMode", {0, 100, 0, 0, 1}, 7},
                     {"GT_LaserPrfCmd", {100, 0}, 0},
                     {"GT_LaserPrfCmd", {100.5, 0}, 7},
                     {"GT_LaserOutFrq", {-1, 0}, 7},
                     {"GT_BufLaserOn", {1, 0, 2}, 7},
                     {"GT_BufLaserOn", {3, 0, 0}, 7},
                     {"GT_BufLaserPrfCmd", {1, 101, 0, 0}, 7},
                     {"GT_BufLaserFollowRatio", {1, 0.1, 10, 5, 0, 0}, 7},
                     {"GT_BufLaserFollowRatio", {1, -0.1, 0, 5, 0, 0}, 7},
                     {"GT_BufLaserFollowMode", {1, 2, 0, 0, 0}, 7},
                     {"GT_BufLaserFollowMode", {1, 0, 0, 0, 1}, 7}};
  for (const auto& c : cases) card.Expect(c.code, c.name, c.arguments);
}

TEST(Laser, BufferedCommandsNeedACoordinateSystem) {
  LaserCard card;
  card.ExpectRefused(1, "GT_BufLaserOn", {1, 0, 0});
  card.ExpectRefused(1, "GT_BufLaserFollowRatio", {1, 1, 0, 5, 0, 0});
}

TEST(Laser, APowerIsInTheRangeOfItsMode) {
  LaserCard card;
  card.Expect(0, "GT_LaserPowerMode", {2, 10, 1, 0, 0});
  EXPECT_EQ(card.Laser().mode, motion::LaserMode::kVoltage);
  // The least power until a command sets another one.
  EXPECT_EQ(card.Power(), 1);
  card.Expect(7, "GT_LaserPrfCmd", {0.5, 0});
  card.Expect(7, "GT_LaserPrfCmd", {10.5, 0});
  card.Expect(0, "GT_LaserPrfCmd", {7.5, 0});
  EXPECT_EQ(card.Power(), 7.5);
  EXPECT_EQ(card.Power(1), 0);
}

TEST(Laser, CommandsActBetweenSegments) {
  LaserCard card;
  card.SetUp();
  card.Expect(0, "GT_BufLaserPrfCmd", {1, 40, 0, 0});
  card.Expect(0, "GT_BufLaserOn", {1, 0, 0});
  EXPECT_EQ(card.Line(100, 0), 0);
  card.Expect(0, "GT_BufLaserOff", {1, 0, 0});
  EXPECT_EQ(card.Line(200, 0), 0);
  EXPECT_FALSE(card.Laser().on);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  // 100 pulses with 10 pulse/ms and 1 pulse/ms^2 take 20 ms.
  card.Cycles(19);
  EXPECT_TRUE(card.Laser().on);
  EXPECT_EQ(card.Power(), 40);
  card.Cycle();
  EXPECT_FALSE(card.Laser().on);
  EXPECT_EQ(card.Power(), 40);
}

TEST(Laser, ThePowerFollowsTheVelocityAlongThePathWithinItsBounds) {
  LaserCard card;
  card.SetUp();
  card.Expect(0, "GT_LaserPowerMode", {2, 10, 0, 0, 0});
  card.Expect(0, "GT_BufLaserFollowMode", {1, 0, 0, 0, 0});
  card.Expect(0, "GT_BufLaserFollowRatio", {1, 0.5, 1, 4, 0, 0});
  EXPECT_EQ(card.Line(300, 0), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  // The velocity grows by 1 pulse/ms in each ms, to 10 pulse/ms.
  const double expected[] = {1, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4, 4};
  for (const double power : expected) {
    card.Cycle();
    EXPECT_DOUBLE_EQ(card.Power(), power) << card.motion.state().crds[0].run.velocity;
  }
  card.CyclesToEnd();
  EXPECT_EQ(card.Power(), 1);
  // A command ends it.
  card.Expect(0, "GT_LaserPrfCmd", {2, 0});
  EXPECT_EQ(card.Power(), 2);
}

TEST(Laser, ThePowerCanFollowTheMeasuredVelocity) {
  LaserCard card;
  card.SetUp();
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  EXPECT_EQ(card.Call("GT_AxisOn", {2}), 0);
  card.Expect(0, "GT_BufLaserFollowMode", {1, 1, 0, 0, 0});
  card.Expect(0, "GT_BufLaserFollowRatio", {1, 2, 0, 100, 0, 0});
  // 6 and 8 pulse/ms: whole pulses in every cycle.
  EXPECT_EQ(card.Line(300, 400), 0);
  EXPECT_EQ(card.Call("GT_CrdStart", {1, 0}), 0);
  card.Cycles(15);
  EXPECT_DOUBLE_EQ(card.Power(), 20);
}

TEST(Laser, ResetSwitchesEverythingOff) {
  LaserCard card;
  const uint64_t before = card.Hash();
  card.Expect(0, "GT_SetHSIOOpt", {1, 0});
  card.Expect(0, "GT_LaserPowerMode", {1, 96, 0, 1, 0});
  EXPECT_NE(card.Hash(), before);
  card.motion.Reset();
  EXPECT_FALSE(card.Laser().on);
  EXPECT_EQ(card.Laser(1), motion::Laser());
}

}  // namespace
}  // namespace oncard::gtcalls::gts
