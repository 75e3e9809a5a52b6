// Captures and triggers through their commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls {
namespace {

using Cells = std::vector<double>;

/// Axis 1 goes to `target` at up to 100 pulse/ms.
void Move(CommandTestCard& card, int target) {
  motion::Profile& profile = card.motion.state().profiles[0];
  profile.trap.target = target;
  profile.trap.velocity = 100;
  card.motion.StartProfile(0);
  while (profile.now.moving) card.motion.Tick();
}

void AddHome(CommandTestCard& card, double first, double last) {
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.state().switches.push_back({.axis = 0, .first = first, .last = last});
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
    card.motion.state().index_marks[0] = {.offset = 7, .period = 100};
    ASSERT_EQ(card.Call("GT_SetCaptureRepeat", {1, 3}), 0);
    ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 2}), 0);
    Move(card, 20000);
    Cells count(1), positions(3);
    ASSERT_EQ(card.Call("GT_GetCaptureRepeatStatus", {1, &count}), 0);
    EXPECT_EQ(count[0], 3);
    ASSERT_EQ(card.Call("GT_GetCaptureRepeatPos", {1, &positions, 0, 3}), 0);
    EXPECT_EQ(positions, (Cells{7, 107, 207}));
    EXPECT_EQ(card.Call("GT_GetCaptureRepeatPos", {1, &positions, 1, 3}), 7);
  }
}

TEST(Capture, APinDrivenByTimeIsLatchedAtItsTick) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_SetCaptureSense", {1, 3, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 3}), 0);
  card.motion.state().encoders[0].position = 55;
  card.motion.state().io.SetPin(motion::DiType::kGpi, 0, true);
  card.motion.Tick();
  EXPECT_EQ(Captured(card), (std::pair{1.0, 55.0}));
  ASSERT_EQ(card.Call("GT_ClearCaptureStatus", {1}), 0);
  EXPECT_EQ(Captured(card).first, 0);
}

TEST(Capture, OffsetsAreAddedToSuccessiveCaptures) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.state().index_marks[0] = {.offset = 0, .period = 1000};
  Cells offsets = {10, 20};
  ASSERT_EQ(card.Call("GT_SetCaptureOffset", {1, &offsets, 2, 1}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureRepeat", {1, 3}), 0);
  ASSERT_EQ(card.Call("GT_SetCaptureMode", {1, 2}), 0);
  Move(card, 20000);
  Cells positions(3), used(1), loops(1), raw(1);
  ASSERT_EQ(card.Call("GT_GetCaptureRepeatPos", {1, &positions, 0, 3}), 0);
  EXPECT_EQ(positions, (Cells{1010, 2020, 3000}));
  ASSERT_EQ(card.Call("GT_GetCaptureOffsetStatus", {1, &used, &loops, &raw}), 0);
  EXPECT_EQ(loops[0], 1);
  EXPECT_EQ(raw[0], 3000);
}

TEST(Trigger, IgnoresEdgesOutsideItsWindow) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.state().index_marks[0] = {.offset = 0, .period = 1000};
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
                                    {0, 9},
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
  EXPECT_EQ(card.Call("GT_SetCaptureEncoder", {1, 9}), 7);
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
  EXPECT_EQ(card.Call("GT_SetCaptureRepeat", {1, 2}), 1);
  EXPECT_EQ(card.Call("GT_SetCaptureRepeat", {2, 257}), 7);
  EXPECT_EQ(card.Call("GT_LinkCaptureOffset", {1, 9}), 7);
  EXPECT_EQ(card.Call("GT_LinkCaptureOffset", {1, 8}), 0);
}

}  // namespace
}  // namespace oncard::gtcalls
