#include "runtime/observe/motion_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "base/files.h"
#include "tests/motion/change_state.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

class MotionValuesTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(controller_.Load(CompileForTest(kProgram)).ok()); }
  double Read(const std::string& name) {
    const auto found = ResolveQuantity(name, controller_);
    EXPECT_TRUE(found.ok()) << name;
    return found.ok() ? ReadQuantity(found.value().front(), controller_) : -1;
  }
  motion::MotionState& state() { return ChangeState(controller_.motion()); }
  static constexpr const char* kProgram = "int f()\n{\n  return 0;\n}\n";
  Controller controller_;
};

TEST_F(MotionValuesTest, ReadsAxes) {
  motion::Axis& axis = state().axes[1];
  axis.profile.position = 100.25;
  axis.profile.velocity = 2;
  axis.profile.acceleration = 0.5;
  axis.encoder.position = 90;
  axis.encoder.velocity = 1.5;
  axis.encoder.acceleration = 0.25;
  EXPECT_EQ(Read("axis2.prfPos"), 100.25);
  EXPECT_EQ(Read("axis2.prfVel"), 2);
  EXPECT_EQ(Read("axis2.prfAcc"), 0.5);
  EXPECT_EQ(Read("axis2.encPos"), 90);
  EXPECT_EQ(Read("axis2.encVel"), 1.5);
  EXPECT_EQ(Read("axis2.encAcc"), 0.25);
  EXPECT_EQ(Read("axis2.error"), 10.25);
  EXPECT_EQ(Read("axis1.prfPos"), 0);
}

TEST_F(MotionValuesTest, ReadsAuxiliaryEncodersAndHighSpeedOutputs) {
  state().encoders[8].position = 12;
  state().compare.SetLevel(1, true);
  EXPECT_EQ(Read("encoder9.pos"), 12);
  EXPECT_EQ(Read("hsio0"), 0);
  EXPECT_EQ(Read("hsio1"), 1);
  for (const char* name : {"encoder12.pos", "hsio2", "axis9.prfPos"}) {
    EXPECT_FALSE(ResolveQuantity(name, controller_).ok()) << name;
  }
  ControllerOptions options;
  options.motion.axis_count = 4;
  const Controller small(options);
  EXPECT_TRUE(ResolveQuantity("encoder9.pos", small).ok());
  EXPECT_FALSE(ResolveQuantity("encoder5.pos", small).ok());
}

TEST_F(MotionValuesTest, ReadsLasers) {
  motion::Laser& laser = state().lasers.channels[1];
  laser.on = true;
  laser.power = 40;
  laser.pulse_frequency = 10;
  EXPECT_EQ(Read("laser0.on"), 0);
  EXPECT_EQ(Read("laser1.on"), 1);
  EXPECT_EQ(Read("laser1.power"), 40);
  EXPECT_EQ(Read("laser1.frequency"), 10);
  // The frequency itself is the power.
  laser.mode = motion::LaserMode::kFrequency;
  EXPECT_EQ(Read("laser1.frequency"), 40);
}

struct FlagCase {
  const char* name;
  uint32_t latched;
  int bit;
};

TEST_F(MotionValuesTest, NamesTheBitsOfTheStatusWord) {
  for (const FlagCase& c : {
           FlagCase{"axis1.alarm", motion::kAlarmBit, 1},
           FlagCase{"axis1.followingError", motion::kFollowingErrorBit, 4},
           FlagCase{"axis1.posLimit", motion::kPositiveLimitBit, 5},
           FlagCase{"axis1.negLimit", motion::kNegativeLimitBit, 6},
           FlagCase{"axis1.smoothStop", motion::kSmoothStopBit, 7},
           FlagCase{"axis1.abruptStop", motion::kAbruptStopBit, 8},
       }) {
    state().axes[0].latched = 0;
    EXPECT_EQ(Read(c.name), 0) << c.name;
    state().axes[0].latched = c.latched;
    EXPECT_EQ(Read(c.name), 1) << c.name;
    EXPECT_EQ(Read("axis1.sts"), 1 << c.bit) << c.name;
  }
  state().axes[0].latched = 0;
  state().axes[0].servo_on = true;
  EXPECT_EQ(Read("axis1.servoOn"), 1);
  EXPECT_EQ(Read("axis1.sts"), 1 << 9);
  state().axes[0].in_position = true;
  EXPECT_EQ(Read("axis1.inPosition"), 1);
  EXPECT_EQ(Read("axis1.sts"), 5 << 9);
  state().profiles[0].now.moving = true;
  EXPECT_EQ(Read("axis1.moving"), 1);
  EXPECT_EQ(Read("axis1.sts"), 3 << 9);
}

TEST_F(MotionValuesTest, ReadsProfilesEncodersAndTheMachine) {
  state().profiles[7].now = {5, 6, 7, true};
  state().profiles[7].mode = motion::ProfileMode::kPvt;
  EXPECT_EQ(Read("profile8.pos"), 5);
  EXPECT_EQ(Read("profile8.vel"), 6);
  EXPECT_EQ(Read("profile8.acc"), 7);
  EXPECT_EQ(Read("profile8.mode"), 6);
  state().encoders[0].position = -3;
  state().encoders[0].velocity = 4;
  EXPECT_EQ(Read("encoder1.pos"), -3);
  EXPECT_EQ(Read("encoder1.vel"), 4);
  state().plants[0].position = 12.5;
  EXPECT_EQ(Read("plant1.pos"), 12.5);
  state().crds[1].run.velocity = 9;
  EXPECT_EQ(Read("crd2.vel"), 9);
  EXPECT_EQ(Read("crd2.x"), 0);
  EXPECT_EQ(Read("crd2.run"), 0);
  state().steps[1].position = 8;
  EXPECT_EQ(Read("step2.pos"), 8);
  state().dacs[0].value = 32767;
  EXPECT_EQ(Read("dac1"), 32767);
  EXPECT_EQ(Read("dac1.volts"), 10);
  EXPECT_EQ(Read("adc8"), 0);
}

TEST_F(MotionValuesTest, KnowASpindleOnlyOnCardsThatHaveOne) {
  const Controller controller;
  EXPECT_EQ(ResolveQuantity("spindle.volts", controller).error().message.en,
            "'spindle.volts': this card has no spindle");
  state().spindle.Emplace().value = -32767;
  EXPECT_EQ(Read("spindle.volts"), -10);
}

TEST(MotionValues, NeedNoProgram) {
  const Controller controller;
  EXPECT_TRUE(ResolveQuantity("axis1.prfPos", controller).ok());
  EXPECT_TRUE(ResolveQuantity("gpo[1]", controller).ok());
  EXPECT_FALSE(ResolveQuantity("sum", controller).ok());
  EXPECT_EQ(ResolveQuantity("page0.i", controller).error().message.en,
            "no program is downloaded, so it has no variables");
  EXPECT_TRUE(GlobalQuantities(controller).empty());
}

TEST(MotionParts, AreDocumented) {
  const std::string page = ReadFile(ONCARD_SOURCE_DIR "/docs/scenarios.md").value();
  for (const MotionPart& part : MotionParts()) {
    const std::string first = MotionValueName(part, part.first, {});
    const size_t begin = page.find(fmt::format("| `{}`", first));
    const size_t other = page.find(fmt::format(" `{}` |", first));
    const size_t row = std::min(begin, other);
    ASSERT_NE(row, std::string::npos) << part.name;
    const std::string text = page.substr(row, page.find('\n', row) - row);
    for (const MotionValue& value : part.values) {
      if (value.name.empty()) continue;
      EXPECT_THAT(text, HasSubstr(fmt::format("`{}`", value.name)))
          << part.name << '.' << value.name;
    }
  }
}

TEST(MotionParts, HaveUniqueNames) {
  std::set<std::string_view> parts;
  for (const MotionPart& part : MotionParts()) {
    EXPECT_TRUE(parts.insert(part.name).second) << part.name;
    std::set<std::string_view> values;
    for (const MotionValue& value : part.values) {
      EXPECT_TRUE(values.insert(value.name).second) << part.name << '.' << value.name;
    }
  }
}

}  // namespace
}  // namespace oncard::runtime
