// Configuration files: reading, remarks, the effect of each key, GT_LoadConfig.
#include "gtcalls/gts/card_config.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::DiType;
using motion::DoType;

/// A card with a configuration applied to it.
class ConfiguredCard : public CommandTestCard {
 public:
  explicit ConfiguredCard(std::string_view text) {
    ApplyCardConfig(ParseCardConfig(text), &motion);
  }
  const motion::MotionState& state() const { return motion.state(); }
};

TEST(CardConfig, AnEmptyFileIsTheStateAfterReset) {
  const motion::MotionConfig config = GtsFamily().Configured({});
  motion::MotionCore reset(config);
  motion::MotionCore configured(config);
  ApplyCardConfig(ParseCardConfig(""), &configured);
  EXPECT_EQ(configured.Hash(), reset.Hash());
}

TEST(CardConfig, IsReadWhateverTheLinesLookLike) {
  const CardConfig config = ParseCardConfig(
      "; comment\r\n# comment\r\nlost=1\r\n[profile2]\r\n  decSmoothStop = 0.0625  \r\n"
      "garbage\r\n=\r\ndecAbruptStop=2");
  EXPECT_EQ(config.profiles[1].smooth_stop, 0.0625);
  EXPECT_EQ(config.profiles[1].abrupt_stop, 2);
  EXPECT_EQ(config.profiles[0].smooth_stop, 1);
}

TEST(CardConfig, RemarksOnceOnWhatItDoesNotKnow) {
  const CardConfig config = ParseCardConfig(R"([axis1]
colour=1
alarmIndex=two
[axis2]
colour=2
[pulse1]
active=1
[pulse1]
[axis13]
[axis0]
[axis
[]
)");
  std::vector<std::string> remarks;
  for (const Message& remark : config.remarks) remarks.push_back(remark.en);
  EXPECT_EQ(remarks, (std::vector<std::string>{
                         "key 'colour' of sections 'axis' is unknown and has no effect",
                         "key 'alarmIndex' of sections 'axis' is 'two', which is not a number",
                         "section 'pulse1' is unknown and has no effect",
                         "section 'axis13' is unknown and has no effect",
                         "section 'axis0' is unknown and has no effect",
                         "section 'axis' is unknown and has no effect",
                         "section '' is unknown and has no effect"}));
  EXPECT_EQ(config.axes[0].alarm_index, 1);
}

TEST(CardConfig, KnownKeysWithoutEffectAreNotRemarkedOn) {
  const CardConfig config = ParseCardConfig(R"([encoder1]
captureSource=1
captureHomeSense=1
captureIndexSense=1
[control1]
encoder2=-1
filterType1=0
filterType4=0
encoderSmooth=8
controlSmooth=8
[enable1]
axisItem=-1
[axis1]
prfMapAlpha2=1
encMapBeta2=1
)");
  EXPECT_TRUE(config.remarks.empty());
}

TEST(CardConfig, AxesGetTheirInputsMapsAndScales) {
  ConfiguredCard card(R"([axis1]
alarmType=4
alarmIndex=16
limitPositiveIndex=-1
limitNegativeType=0
limitNegativeIndex=8
smoothStopIndex=1
abruptStopType=3
abruptStopIndex=17
prfMap=0x3
encMap=0x80
prfMapAlpha1=4
prfMapBeta1=-2
encMapAlpha1=1
encMapBeta1=2
)");
  const motion::Axis& axis = card.state().axes[0];
  EXPECT_EQ(axis.alarm, (motion::InputChoice{DiType::kGpi, 15}));
  EXPECT_EQ(axis.positive_limit.bit, -1);
  EXPECT_EQ(axis.negative_limit, (motion::InputChoice{DiType::kLimitPositive, 7}));
  EXPECT_EQ(axis.smooth_stop, (motion::InputChoice{DiType::kGpi, 0}));
  EXPECT_EQ(axis.abrupt_stop.bit, -1);  // no word has so many bits
  EXPECT_EQ(axis.profile_map, 3u);
  EXPECT_EQ(axis.encoder_map, 0x80u);
  EXPECT_EQ(axis.profile_scale, (motion::Scale{4, -2}));
  EXPECT_EQ(axis.encoder_scale, (motion::Scale{1, 1}));  // |alpha| < |beta| is invalid
}

TEST(CardConfig, AlarmAndLimitsWithoutAnInputCannotBeSwitchedOn) {
  ConfiguredCard card("[axis1]\nalarmIndex=-1\n");
  EXPECT_EQ(card.Call("GT_AlarmOn", {1}), 1);
  EXPECT_EQ(card.Call("GT_AlarmOn", {2}), 0);
}

TEST(CardConfig, EncodersGetTheirSenseAndSourceAndTheMachineFits) {
  ConfiguredCard card("[encoder1]\nreverse=0\n[encoder2]\nfilterType=1\nactive=0\n");
  EXPECT_FALSE(card.state().encoders[0].reversed);
  EXPECT_FALSE(card.state().encoders[0].wired_reversed);
  EXPECT_TRUE(card.state().encoders[0].external);
  EXPECT_FALSE(card.state().encoders[1].external);
  EXPECT_FALSE(card.state().encoders[1].active);
  EXPECT_TRUE(card.state().encoders[2].reversed);
}

TEST(CardConfig, InputsGetSenseFilterAndActivity) {
  ConfiguredCard card("[home2]\nreverse=1\nfilterTime=1\n[gpi1]\nactive=0\n");
  auto& io = ChangeState(card.motion).io;
  EXPECT_EQ(io.Read(DiType::kHome), 0u);  // not driven: never active
  io.SetPin(DiType::kHome, 1, false);
  io.SetPin(DiType::kGpi, 0, true);
  io.SetPin(DiType::kGpi, 1, true);
  card.Cycle();
  EXPECT_EQ(io.Read(DiType::kHome), 2u);
  card.Cycles(3);
  EXPECT_EQ(io.Read(DiType::kGpi), 2u);
}

TEST(CardConfig, OutputsGetReversalActivityAndTheAxisTheyEnable) {
  ConfiguredCard card(R"([enable1]
reverse=1
axis=2
[enable2]
axis=2
[enable3]
axis=-1
[gpo1]
active=0
)");
  EXPECT_EQ(card.Call("GT_AxisOn", {2}), 0);
  EXPECT_EQ(card.Call("GT_AxisOn", {3}), 0);
  const motion::DigitalIo& io = card.state().io;
  EXPECT_EQ(io.Register(DoType::kEnable), 3u);
  EXPECT_EQ(io.OutputPins(DoType::kEnable) & 0xFF, 2u);
  EXPECT_EQ(card.Call("GT_SetDo", {12, 3}), 0);
  EXPECT_EQ(io.OutputPins(DoType::kGpo), 2u);
}

TEST(CardConfig, TheLoopIsClosedWhereControllerEncoderAndDacAre) {
  struct {
    const char* text;
    bool closed;
  } const cases[] = {
      {"[dac1]\ncontrol=1\n", true},
      {"", false},
      {"[dac1]\ncontrol=1\nactive=0\n", false},
      {"[dac1]\ncontrol=1\n[control1]\nactive=0\n", false},
      {"[dac1]\ncontrol=1\n[control1]\naxis=-1\n", false},
      {"[dac1]\ncontrol=1\n[control1]\nencoder1=-1\n", false},
      {"[dac1]\ncontrol=1\n[encoder1]\nfilterType=1\n", false},
  };
  for (const auto& c : cases) {
    ConfiguredCard card(c.text);
    EXPECT_EQ(card.motion.InClosedLoop(0), c.closed) << c.text;
    EXPECT_EQ(card.state().dacs[0].control, c.closed ? 0 : -1) << c.text;
    EXPECT_FALSE(card.motion.InClosedLoop(1));
  }
}

TEST(CardConfig, AnInactiveControllerWatchesNoFollowingError) {
  ConfiguredCard card("[control1]\nactive=0\n[control2]\nerrorLimit=10\n");
  EXPECT_FALSE(card.state().controls[0].active);
  EXPECT_EQ(card.state().controls[1].error_limit, 10);
}

TEST(CardConfig, StepsDacsAndProfilesGetTheirRegisters) {
  ConfiguredCard card(R"([step1]
active=0
[step2]
axis=1
mode=1
[dac2]
bias=-5
limit=1000
reverse=1
[profile1]
decSmoothStop=0.5
)");
  EXPECT_FALSE(card.state().steps[0].active);
  EXPECT_EQ(card.state().steps[1].axis, 0);
  EXPECT_EQ(card.state().steps[1].mode, 1);
  EXPECT_EQ(card.state().plants[0].axis, -1);
  EXPECT_EQ(card.state().plants[1].axis, 0);
  EXPECT_EQ(card.state().dacs[1].bias, -5);
  EXPECT_EQ(card.state().dacs[1].limit, 1000);
  EXPECT_TRUE(card.state().dacs[1].reversed);
  EXPECT_EQ(card.state().profiles[0].smooth_stop, 0.5);
}

TEST(CardConfig, InactiveAxesAndProfilesDoNothing) {
  ConfiguredCard card("[axis1]\nactive=0\n[profile2]\nactive=0\n");
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 1);
  EXPECT_EQ(card.Call("GT_AxisOn", {2}), 0);
  EXPECT_EQ(card.Call("GT_PrfJog", {2}), 0);
  EXPECT_EQ(card.Call("GT_SetVel", {2, 1}), 0);
  EXPECT_EQ(card.Call("GT_Update", {2}), 1);
  EXPECT_EQ(card.Call("GT_PrfJog", {1}), 0);
  EXPECT_EQ(card.Call("GT_SetVel", {1, 1}), 0);
  EXPECT_EQ(card.Call("GT_Update", {1}), 0);
  card.Cycles(40);
  EXPECT_GT(card.state().profiles[0].now.position, 0);
  EXPECT_EQ(card.state().axes[0].profile.position, 0);
}

/// A file that is deleted at the end of the test.
class ConfigFile {
 public:
  explicit ConfigFile(std::string_view text, const std::string& name = "test.cfg")
      : path_((std::filesystem::path(testing::TempDir()) / name).string()) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~ConfigFile() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

TEST(LoadConfig, ConfiguresTheCardAndRemarksInTheLog) {
  CommandTestCard card;
  const ConfigFile file("[profile1]\ndecSmoothStop=3\nnews=1\n[rubbish]\n");
  EXPECT_EQ(card.Call("GT_LoadConfig", {file.path()}), 0);
  EXPECT_EQ(card.motion.state().profiles[0].smooth_stop, 3);
  EXPECT_EQ(card.reason.en,
            "key 'news' of sections 'profile' is unknown and has no effect; section 'rubbish' is "
            "unknown and has no effect");
}

TEST(LoadConfig, AMissingFileIs2007AndALongNameIs7) {
  CommandTestCard card;
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_LoadConfig", {std::string("/nowhere/at/all.cfg")}), 2007);
  EXPECT_EQ(card.Call("GT_LoadConfig", {std::string(125, 'x')}), 2007);
  EXPECT_EQ(card.Call("GT_LoadConfig", {std::string(126, 'x')}), 7);
  EXPECT_EQ(card.Hash(), before);
}

TEST(LoadConfig, IsRefusedWhileAnythingMoves) {
  CommandTestCard card;
  const ConfigFile file("[profile1]\ndecSmoothStop=3\n");
  EXPECT_EQ(card.Call("GT_PrfJog", {8}), 0);
  EXPECT_EQ(card.Call("GT_SetVel", {8, 1}), 0);
  EXPECT_EQ(card.Call("GT_Update", {128}), 0);
  card.Cycle();
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_LoadConfig", {file.path()}), 1);
  EXPECT_EQ(card.Hash(), before);
}

TEST(LoadConfig, LatchedBitsStayUntilTheyAreCleared) {
  CommandTestCard card;
  card.motion.digital_io().SetPin(DiType::kAlarm, 0, true);
  card.Cycles(4);
  EXPECT_TRUE(card.motion.Conditions(0) & motion::kAlarmBit);
  const ConfigFile file("[axis1]\nalarmIndex=-1\n");
  EXPECT_EQ(card.Call("GT_LoadConfig", {file.path()}), 0);
  card.Cycle();
  EXPECT_TRUE(card.motion.Conditions(0) & motion::kAlarmBit);
  EXPECT_EQ(card.Call("GT_ClrSts", {1, 1}), 0);
  EXPECT_FALSE(card.motion.Conditions(0) & motion::kAlarmBit);
}

TEST(LoadConfig, MovesNoMachineAndKeepsEncoders) {
  CommandTestCard card;
  card.motion.AxisAt(0).ServoOn();
  EXPECT_EQ(card.Call("GT_SetPos", {1, 1000}), 0);
  EXPECT_EQ(card.Call("GT_SetVel", {1, 10}), 0);
  EXPECT_EQ(card.Call("GT_Update", {1}), 0);
  card.Cycles(2000);
  const ConfigFile file("[encoder1]\nreverse=0\n[dac1]\ncontrol=1\n[step1]\nactive=0\n");
  EXPECT_EQ(card.Call("GT_LoadConfig", {file.path()}), 0);
  card.Cycles(10);
  EXPECT_EQ(card.motion.state().plants[0].position, 1000);
  EXPECT_EQ(card.motion.state().encoders[0].position, 1000);
  EXPECT_EQ(card.motion.state().axes[0].profile.position, 1000);
  EXPECT_TRUE(card.motion.InClosedLoop(0));
}

}  // namespace
}  // namespace oncard::gtcalls::gts
