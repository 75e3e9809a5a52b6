// Captures and triggers through their commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using Cells = std::vector<double>;

/// Moves axis 1 to `target` at up to 100 pulse/ms.
void Move(CommandTestCard& card, int target) {
  motion::Profile& profile = ChangeState(card.motion).profiles[0];
  profile.trap.target = target;
  profile.trap.velocity = 100;
  card.motion.ProfileAt(0).Start();
  while (profile.now.moving) card.motion.Tick();
}

void AddHome(CommandTestCard& card, double first, double last) {
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.AddSwitch({.axis = 0, .first = first, .last = last});
  card.motion.Tick();
}

std::pair<double, double> Captured(CommandTestCard& card) {
  Cells status(1), value(1);
  EXPECT_EQ(card.Call("GT_GetCaptureStatus", {1, &status, &value, 1, nullptr}), 0);
  return {status[0], value[0]};
}

TEST(Capture, IsExactWhateverTheCycle) {
  for (const int64_t cycle_us : {125, 250, 1000, 4000}) {
    CommandTestCard card({.cycle_us = cycle_us});
    AddHome(card, 3333, 4444);
    ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 1}), 0);
    Move(card, 20000);
    EXPECT_EQ(Captured(card), (std::pair{1.0, 4444.0})) << cycle_us;
    ASSERT_EQ(card.Call("GT_SetCaptureSense", {1, 1, 1}), 0);
    ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 1}), 0);
    EXPECT_EQ(Captured(card).first, 0);
    Move(card, 0);
    EXPECT_EQ(Captured(card), (std::pair{1.0, 4444.0})) << cycle_us;
  }
}

TEST(Capture, IndexMarksRepeatInOrder) {
  for (const int64_t cycle_us : {125, 4000}) {
    CommandTestCard card({.cycle_us = cycle_us});
    ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
    card.motion.SetIndexMarks(0, {.offset = 7, .period = 100});
    ASSERT_EQ(card.Call("GT_SetCaptureRepeat", {1, 3}), 0);
    ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 2}), 0);
    Move(card, 20000);
    Cells count(1), positions(3);
    ASSERT_EQ(card.Call("GT_GetCaptureRepeatStatus", {1, &count}), 0);
    EXPECT_EQ(count[0], 3);
    ASSERT_EQ(card.Call("GT_GetCaptureRepeatPos", {1, &positions, 1, 3}), 0);
    EXPECT_EQ(positions, (Cells{7, 107, 207}));
    EXPECT_EQ(card.Call("GT_GetCaptureRepeatPos", {1, &positions, 0, 3}), 7);
    EXPECT_EQ(card.Call("GT_GetCaptureRepeatPos", {1, &positions, 2, 3}), 7);
  }
}

motion::WorldEvent Pin(motion::Micros at, motion::DiType type, uint16_t bit, bool level) {
  return {.at = at, .item = static_cast<uint8_t>(type), .index = bit, .value = level ? 1.0 : 0.0};
}

void PowerOn(CommandTestCard& card, motion::WorldEvents events) {
  card.motion.PowerOn(std::make_shared<const motion::WorldEvents>(std::move(events)));
}

// 5000 pulses in 100 ms, then 100 pulse/ms: the probe's pulse from 150.3 to 150.4 ms begins at
// 10030 and ends at 10040. A pulse from 152 to 156 ms begins and ends at a cycle, whatever its
// length.
TEST(Capture, AnEdgeOfTheWorldIsLatchedAtItsInstant) {
  const struct {
    motion::Micros rise, fall;
    int rising;
    double position;
  } cases[] = {{150'300, 150'400, 1, 10030},
               {150'300, 150'400, 0, 10040},
               {152'000, 156'000, 1, 10200},
               {152'000, 156'000, 0, 10600}};
  for (const auto& c : cases) {
    for (const int64_t cycle_us : {125, 250, 1000, 4000}) {
      CommandTestCard card({.cycle_us = cycle_us});
      PowerOn(card, {Pin(c.rise, motion::DiType::kGpi, 0, true),
                     Pin(c.fall, motion::DiType::kGpi, 0, false)});
      ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
      ASSERT_EQ(card.Call("GT_SetCaptureSense", {1, 3, c.rising}), 0);
      ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 3}), 0);
      Move(card, 20000);
      EXPECT_EQ(Captured(card), (std::pair{1.0, c.position})) << cycle_us;
    }
  }
}

TEST(Capture, IsForgottenWhenItsStatusIsCleared) {
  CommandTestCard card;
  PowerOn(card, {Pin(100, motion::DiType::kGpi, 0, true)});
  ASSERT_EQ(card.Call("GT_SetCaptureSense", {1, 3, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 3}), 0);
  card.motion.Tick();
  EXPECT_EQ(Captured(card).first, 1);
  ASSERT_EQ(card.Call("GT_ClearCaptureStatus", {1}), 0);
  EXPECT_EQ(Captured(card).first, 0);
}

TEST(Capture, WhatIsHighAtPowerOnOrRestsByItsSenseMakesNoEdge) {
  CommandTestCard card;
  card.motion.AddSwitch({.axis = 0, .first = 10, .last = 20, .active_low = true});
  PowerOn(card, {Pin(0, motion::DiType::kGpi, 0, true)});
  for (const int source : {1, 3}) ASSERT_EQ(card.Call("GT_SetCaptureSense", {1, source, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureSense", {2, 1, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {2, 1}), 0);
  Cells trigger = {1, 3, 1, 1, 0, 0, 0, 0, 0};
  ASSERT_EQ(card.Call("GT_SetTrigger", {1, &trigger}), 0);
  // Home input 2 is not connected.
  card.motion.digital_io().SetInverted(motion::DiType::kHome, 2);
  card.Cycles(3);
  Cells status(2), values(2), triggered(3);
  ASSERT_EQ(card.Call("GT_GetCaptureStatus", {1, &status, &values, 2, nullptr}), 0);
  EXPECT_EQ(status, (Cells{0, 0}));
  ASSERT_EQ(card.Call("GT_GetTriggerStatus", {1, &triggered, 1}), 0);
  EXPECT_EQ(triggered[1], 0);
}

/// Axes 1 and 2 move to 3000 at 10 pulse/ms, after an acceleration of 40 ms and 200 pulses. Axis 1
/// outputs pulses of 500 us at the points on HSIO0; they are captured on encoder 2.
void MoveAndCompare(CommandTestCard& card, Cells points, int rising) {
  ASSERT_EQ(card.Call("GT_CompareData",
                      {1, 1, 0, 0, 500, &points, static_cast<int>(points.size()), nullptr, 0}),
            0);
  ASSERT_EQ(card.Call("GT_SetCaptureSense", {2, 6, rising}), 0);
  for (const int axis : {1, 2}) {
    ASSERT_EQ(card.Call("GT_AxisOn", {axis}), 0);
    motion::Profile& profile = ChangeState(card.motion).profiles[static_cast<size_t>(axis - 1)];
    profile.trap.target = 3000;
    profile.trap.velocity = 10;
    profile.trap.parameters.acc = 0.25;
    card.motion.ProfileAt(static_cast<size_t>(axis - 1)).Start();
  }
}

TEST(Capture, AHighSpeedOutputCapturesAnotherEncoder) {
  for (const int64_t cycle_us : {125, 250, 1000, 4000}) {
    // The pulse begins at 1000 and ends 5 pulses later.
    for (const auto& [rising, position] : {std::pair{1, 1000.0}, {0, 1005.0}}) {
      CommandTestCard card({.cycle_us = cycle_us});
      ASSERT_EQ(card.Call("GT_SetCaptureMode", {2, 6}), 0);
      MoveAndCompare(card, {1000}, rising);
      for (int64_t us = 0; us < 400'000; us += cycle_us) card.motion.Tick();
      Cells status(1), value(1);
      ASSERT_EQ(card.Call("GT_GetCaptureStatus", {2, &status, &value, 1, nullptr}), 0);
      EXPECT_EQ(status[0], 1) << cycle_us;
      EXPECT_EQ(value[0], position) << cycle_us;
    }
  }
}

TEST(Capture, PulsesAreCapturedInARow) {
  CommandTestCard card;
  // The number is set after the capture has been armed.
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {2, 6}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureRepeat", {2, 5}), 0);
  MoveAndCompare(card, {1000, 1100, 1200, 1300, 1400, 1500}, 1);
  Cells count(1), positions(5);
  for (int i = 0; i < 1600; ++i) card.motion.Tick();
  ASSERT_EQ(card.Call("GT_GetCaptureRepeatStatus", {2, &count}), 0);
  EXPECT_EQ(count[0], 5);
  ASSERT_EQ(card.Call("GT_GetCaptureRepeatPos", {2, &positions, 1, 5}), 0);
  EXPECT_EQ(positions, (Cells{1000, 1100, 1200, 1300, 1400}));
}

TEST(Capture, ASmallerNumberThanIsCapturedEndsIt) {
  CommandTestCard card;
  PowerOn(card, {Pin(100, motion::DiType::kGpi, 0, true), Pin(600, motion::DiType::kGpi, 0, false),
                 Pin(1100, motion::DiType::kGpi, 0, true)});
  ASSERT_EQ(card.Call("GT_SetCaptureSense", {1, 3, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 3}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureRepeat", {1, 5}), 0);
  card.Cycles(2);
  ASSERT_EQ(card.Call("GT_SetCaptureRepeat", {1, 1}), 0);
  card.Cycles(5);
  Cells count(1);
  ASSERT_EQ(card.Call("GT_GetCaptureRepeatStatus", {1, &count}), 0);
  EXPECT_EQ(count[0], 1);
}

TEST(Capture, OffsetsAreAddedToSuccessiveCaptures) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.SetIndexMarks(0, {.offset = 0, .period = 1000});
  Cells offsets = {10, 20};
  ASSERT_EQ(card.Call("GT_SetCaptureOffset", {1, &offsets, 2, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureRepeat", {1, 3}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 2}), 0);
  Move(card, 20000);
  Cells positions(3), used(1), loops(1), raw(1);
  ASSERT_EQ(card.Call("GT_GetCaptureRepeatPos", {1, &positions, 1, 3}), 0);
  EXPECT_EQ(positions, (Cells{1010, 2020, 3000}));
  ASSERT_EQ(card.Call("GT_GetCaptureOffsetStatus", {1, &used, &loops, &raw}), 0);
  EXPECT_EQ(loops[0], 1);
  EXPECT_EQ(raw[0], 3000);
}

TEST(Trigger, IgnoresEdgesOutsideItsWindow) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.SetIndexMarks(0, {.offset = 0, .period = 1000});
  Cells trigger = {1, 2, 1, 0, 5, 0, 1, 2500, 9000};
  ASSERT_EQ(card.Call("GT_SetTrigger", {2, &trigger}), 0);
  Move(card, 20000);
  Cells status(3), read(9);
  ASSERT_EQ(card.Call("GT_GetTriggerStatus", {2, &status, 1}), 0);
  EXPECT_EQ(status, (Cells{0, 1, 3005}));
  ASSERT_EQ(card.Call("GT_GetTrigger", {2, &read}), 0);
  EXPECT_EQ(read, trigger);
}

TEST(Trigger, MembersAreChecked) {
  for (const auto& [cell, value] : {std::pair<size_t, double>{0, 0},
                                    {0, 12},
                                    {1, 0},
                                    {1, 4},
                                    {1, 9},
                                    {2, 0},
                                    {3, 2},
                                    {6, 2},
                                    {7, 10000}}) {
    CommandTestCard card;
    Cells trigger = {1, 2, 1, 0, 5, 0, 1, 2500, 9000};
    trigger[cell] = value;
    EXPECT_EQ(card.Call("GT_SetTrigger", {2, &trigger}), 7) << cell;
  }
}

TEST(Capture, TheModeReadsBackUntilItHasCaptured) {
  CommandTestCard card;
  AddHome(card, 3333, 4444);
  Cells modes(2);
  ASSERT_EQ(card.Call("GT_GetCaptureMode", {1, &modes, 2}), 0);
  EXPECT_EQ(modes, (Cells{0, 0}));
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {2, 2}), 0);
  ASSERT_EQ(card.Call("GT_GetCaptureMode", {1, &modes, 2}), 0);
  EXPECT_EQ(modes, (Cells{1, 2}));
}

TEST(Capture, ATriggerCanLatchAnotherEncoder) {
  CommandTestCard card;
  AddHome(card, 3333, 4444);
  ASSERT_EQ(card.Call("GT_SetEncPos", {2, 777}), 0);
  EXPECT_EQ(card.Call("GT_SetCaptureEncoder", {1, 12}), 7);
  EXPECT_EQ(card.Call("GT_SetCaptureEncoder", {9, 1}), 7);
  ASSERT_EQ(card.Call("GT_SetCaptureEncoder", {1, 2}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 1}), 0);
  EXPECT_EQ(card.Call("GT_SetCaptureEncoder", {1, 1}), 1);
  Move(card, 20000);
  EXPECT_EQ(Captured(card), (std::pair{1.0, 777.0}));
}

TEST(Capture, SourcesAreChecked) {
  CommandTestCard card;
  for (const auto& [mode, code] :
       {std::pair{0, 7}, {1, 0}, {3, 0}, {4, 7}, {5, 7}, {6, 0}, {8, 0}, {9, 7}}) {
    EXPECT_EQ(card.Call("GT_SetCaptureMode", {1, mode}), code) << mode;
    EXPECT_EQ(card.Call("GT_SetCaptureSense", {1, mode, 1}), code) << mode;
  }
  EXPECT_EQ(card.Call("GT_SetCaptureRepeat", {2, 257}), 7);
  EXPECT_EQ(card.Call("GT_LinkCaptureOffset", {1, 12}), 7);
  EXPECT_EQ(card.Call("GT_LinkCaptureOffset", {1, 8}), 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
