// The log lines about what a card does by itself, each caused on a card.
#include "runtime/sim/card_event_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gtcalls/gts/family.h"
#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

using motion::MotionCore;

/// A card with 1 ms cycles and its log lines.
struct TalkingCard {
  explicit TalkingCard(bool errors_stop = true) : core(ConfigOf(errors_stop)) {
    core.Observe([this](const motion::CardEvent& event) {
      const Message message = DescribeCardEvent(event, gtcalls::GtsFamily().advised);
      EXPECT_EQ(message.zh.empty(), message.en.empty());
      said.push_back(message.en);
    });
    for (const size_t axis : {size_t{0}, size_t{1}}) core.AxisAt(axis).ServoOn();
  }
  void Jog(size_t profile, double velocity) {
    motion::Profile& jogging = ChangeState(core).profiles[profile];
    jogging.mode = motion::ProfileMode::kJog;
    jogging.jog.parameters = {1000, 1000, 0};
    jogging.jog.velocity = velocity;
    core.ProfileAt(profile).Start();
  }
  void Ticks(int count) {
    for (int i = 0; i < count; ++i) core.Tick();
  }
  void SetUpPath() {
    motion::CrdParameters parameters;
    parameters.dimension = 2;
    parameters.coordinates = {1, 2};
    parameters.velocity_max = 1000;
    parameters.acceleration_max = 100;
    core.CrdAt(0).SetUp(parameters);
  }
  bool Line(const motion::Coordinates& end, double end_velocity) {
    motion::PathSlot slot;
    slot.is_segment = true;
    slot.segment = *motion::MakeLine(core.state().crds[0].fifos[0].tail, end);
    slot.velocity = 100;
    slot.acceleration = 1;
    slot.end_velocity = end_velocity;
    return core.CrdAt(0).Append(0, slot);
  }

  static motion::MotionConfig ConfigOf(bool errors_stop) {
    motion::MotionConfig config;
    config.axis_count = 8;
    config.cycle_us = 1000;
    config.defaults.following_error_stops = errors_stop;
    return config;
  }

  MotionCore core;
  std::vector<std::string> said;
};

using Lines = std::vector<std::string>;

TEST(CardEvent, ASoftLimitIsSaidOnce) {
  TalkingCard card;
  ChangeState(card.core).axes[0].soft_positive = 95;
  card.Jog(0, 10);
  card.Ticks(100);
  EXPECT_EQ(card.said, (Lines{"axis 1 passed its positive soft limit 95 at 99.95: no motion in "
                              "that direction until GT_ClrSts"}));
  ChangeState(card.core).axes[1].soft_negative = -5;
  card.said.clear();
  card.Jog(1, -1000);
  card.Ticks(10);
  EXPECT_EQ(card.said, (Lines{"axis 2 passed its negative soft limit -5 at -500: no motion in that "
                              "direction until GT_ClrSts"}));
}

TEST(CardEvent, InputsThatStopAnAxis) {
  struct Case {
    motion::DiType type;
    std::string_view line;
  };
  const Case cases[] = {
      {motion::DiType::kLimitPositive,
       "axis 1 reached its positive limit switch at 0: no motion in that direction until "
       "GT_ClrSts"},
      {motion::DiType::kLimitNegative,
       "axis 1 reached its negative limit switch at 0: no motion in that direction until "
       "GT_ClrSts"},
      {motion::DiType::kAlarm, "the drive of axis 1 reports an alarm at 0: it is switched off"},
      {motion::DiType::kGpi,
       "axis 1 was stopped by its smooth stop input at 0: no motion until GT_ClrSts"},
      {motion::DiType::kArrive,
       "axis 1 was stopped by its abrupt stop input at 0: no motion until GT_ClrSts"}};
  for (const Case& c : cases) {
    TalkingCard card;
    ChangeState(card.core).axes[0].smooth_stop = {motion::DiType::kGpi, 0};
    ChangeState(card.core).axes[0].abrupt_stop = {motion::DiType::kArrive, 0};
    card.core.digital_io().SetPin(c.type, 0, true);
    card.Ticks(10);
    EXPECT_EQ(card.said, Lines{std::string(c.line)});
  }
}

TEST(CardEvent, AFollowingErrorAndASkew) {
  TalkingCard card;
  card.core.ControlAt(0).SetErrorLimit(25);
  ChangeState(card.core).plants[0].stalled = true;
  card.Jog(0, 1000);
  card.Ticks(5);
  EXPECT_EQ(card.said, (Lines{"axis 1 has a following error of 500, its limit is 25 "
                              "(GT_SetPosErr): the drive is switched off"}));
  TalkingCard gantry;
  gantry.core.EnableGantry(0, 1, 0, 0);
  gantry.core.SetGantryErrorLimit(20);
  ChangeState(gantry.core).plants[1].stalled = true;
  gantry.Jog(0, 1000);
  gantry.Ticks(5);
  EXPECT_EQ(gantry.said, (Lines{"the gantry of axis 1 has a skew of -500, its limit is 20 "
                                "(GT_SetGantryErrLmt): both drives are switched off"}));
}

TEST(CardEvent, AFollowingErrorThatStopsNothingIsToldOnce) {
  TalkingCard card(/*errors_stop=*/false);
  card.core.ControlAt(0).SetErrorLimit(25);
  ChangeState(card.core).plants[0].stalled = true;
  card.Jog(0, 1000);
  card.Ticks(5);
  const std::string line = "axis 1 has a following error of 500, its limit is 25 (GT_SetPosErr)";
  EXPECT_EQ(card.said, Lines{line});
  EXPECT_TRUE(card.core.axis(0).servo_on);
}

TEST(CardEvent, ASlaveThatIsHeld) {
  TalkingCard card;
  ChangeState(card.core).axes[1].latched = motion::kPositiveLimitBit;
  motion::Profile& slave = ChangeState(card.core).profiles[1];
  slave.mode = motion::ProfileMode::kGear;
  slave.gear.master = {true, motion::MasterType::kProfile, 0, false};
  card.core.ProfileAt(1).Start();
  card.Jog(0, 10);
  card.Ticks(10);
  EXPECT_EQ(card.said, (Lines{"profile 2 is held at 0: it would move towards a latched limit"}));
}

TEST(CardEvent, APathThatRunsDryAndAPathThatWaits) {
  TalkingCard card;
  card.SetUpPath();
  ASSERT_TRUE(card.Line({1000, 0}, 5));
  card.core.CrdAt(0).Start(0, false);
  card.Ticks(200);
  EXPECT_EQ(
      card.said,
      (Lines{"coordinate system 1 stops at once from 5 pulse/ms: the FIFO is empty and velEnd of "
             "the last segment is not 0, append segments sooner or end with velEnd 0"}));
  card.said.clear();
  card.core.AxisAt(4).ServoOn();
  motion::PathSlot move;
  move.command = {motion::BufferedKind::kMove, 4, 1, {1000, 10, 1}};
  ASSERT_TRUE(card.core.CrdAt(0).Append(0, move));
  card.core.CrdAt(0).Start(0, false);
  card.Ticks(20);
  const double place = card.core.state().profiles[4].now.position;
  ChangeState(card.core).profiles[4].abrupt_stop = 1e9;
  card.core.ProfileAt(4).Stop(true);
  card.Ticks(2);
  EXPECT_EQ(card.said.size(), 1u);
  EXPECT_EQ(card.said.at(0).substr(0, 67),
            "coordinate system 1 pauses: axis 5 of a modal GT_BufMove was stoppe");
  EXPECT_NEAR(card.core.state().profiles[4].now.position, place, 1);
}

TEST(CardEvent, AnAxisThatAPathMovesWhileItsDriveIsOff) {
  TalkingCard card;
  card.SetUpPath();
  motion::PathSlot command;
  command.command = {motion::BufferedKind::kMove, 4, 0, {1000, 10, 1}};
  ASSERT_TRUE(card.core.CrdAt(0).Append(0, command));
  command.command = {motion::BufferedKind::kGear, 5, 0, {1000}};
  ASSERT_TRUE(card.core.CrdAt(0).Append(0, command));
  ASSERT_TRUE(card.Line({1000, 0}, 0));
  card.core.CrdAt(0).Start(0, false);
  card.Ticks(200);
  EXPECT_EQ(card.said, (Lines{"GT_BufMove or GT_BufGear of coordinate system 1 moves axis 5 while "
                              "its drive is off, call GT_AxisOn first",
                              "GT_BufMove or GT_BufGear of coordinate system 1 moves axis 6 while "
                              "its drive is off, call GT_AxisOn first"}));
}

TEST(CardEvent, ASegmentThatMovesAnAxisThatIsOff) {
  TalkingCard card;
  card.core.AxisAt(1).ServoOff();
  card.SetUpPath();
  ASSERT_TRUE(card.Line({1000, 0}, 0));
  card.core.CrdAt(0).Start(0, false);
  card.Ticks(50);
  EXPECT_EQ(card.said, Lines{});
  ASSERT_TRUE(card.Line({1000, 1000}, 0));
  card.Ticks(100);
  EXPECT_EQ(card.said, (Lines{"a segment of coordinate system 1 moves axis 2 while its drive is "
                              "off, call GT_AxisOn first"}));
}

TEST(CardEvent, WhatLookAheadDoes) {
  TalkingCard card;
  card.SetUpPath();
  card.core.CrdAt(0).BeginLookAhead(0, 5, 1, 2);
  ASSERT_TRUE(card.Line({1000, 0}, 0));
  EXPECT_TRUE(card.said.empty());
  // A right angle: 1 * 5 / (2 sin 45 degrees).
  ASSERT_TRUE(card.Line({1000, 1000}, 0));
  ASSERT_EQ(card.said.size(), 1u);
  EXPECT_EQ(card.said[0].substr(0, 82),
            "coordinate system 1 passes the corner before this segment with at most 3.535533905");
  EXPECT_THAT(card.said[0], HasSubstr(" of 100 pulse/ms, limited by"));
  // A straight continuation: no corner.
  ASSERT_TRUE(card.Line({1000, 3000}, 0));
  ASSERT_EQ(card.said.size(), 1u);
  // One segment has been passed to the FIFO, two are still in the look-ahead buffer.
  card.core.CrdAt(0).Start(0, false);
  card.Ticks(500);
  ASSERT_EQ(card.said.size(), 2u);
  EXPECT_EQ(card.said[1],
            "coordinate system 1 ends its run: the FIFO is empty while 2 segments wait in the "
            "look-ahead buffer, call GT_CrdData with NULL until it returns 0");
}

TEST(CardEvent, WhatTheMultiAxisLookAheadDoes) {
  TalkingCard card;
  card.SetUpPath();
  motion::PathLimits limits;
  limits.corner_time = 5;
  ChangeState(card.core).crds[0].fifos[0].planner.Emplace({.limits = limits, .capacity = 20});
  ASSERT_TRUE(card.Line({1000, 0}, 0));
  ASSERT_TRUE(card.Line({2000, 0}, 0));
  EXPECT_TRUE(card.said.empty());
  ASSERT_TRUE(card.Line({2000, 1000}, 0));
  ASSERT_EQ(card.said.size(), 1u);
  // 1 * 5 / (2 sin 45 degrees).
  EXPECT_THAT(card.said[0], HasSubstr("before this segment with at most 3.5355339"));
  EXPECT_THAT(card.said[0], HasSubstr("of 100 pulse/ms, limited by synAcc or DVMax"));
}

TEST(CardEvent, AdvisesCommandsOfTheFamily) {
  const Message message = DescribeCardEvent({.kind = motion::CardEventKind::kFollowingError},
                                            {.following_error_limit = "TT_SetLimit"});
  EXPECT_THAT(message.en, HasSubstr("its limit is 0 (TT_SetLimit)"));
  EXPECT_THAT(message.zh, HasSubstr("超过 TT_SetLimit 设定的极限"));
}

TEST(CardEvent, IsNoPartOfTheState) {
  TalkingCard card;
  MotionCore silent({.axis_count = 8, .cycle_us = 1000});
  for (const size_t axis : {size_t{0}, size_t{1}}) silent.AxisAt(axis).ServoOn();
  for (MotionCore* core : {&card.core, &silent}) {
    ChangeState(*core).axes[0].soft_positive = 95;
    motion::Profile& jogging = ChangeState(*core).profiles[0];
    jogging.mode = motion::ProfileMode::kJog;
    jogging.jog.velocity = 10;
    core->ProfileAt(0).Start();
    for (int i = 0; i < 100; ++i) core->Tick();
  }
  EXPECT_FALSE(card.said.empty());
  EXPECT_EQ(card.core.Hash(), silent.Hash());
}

}  // namespace
}  // namespace oncard::runtime
