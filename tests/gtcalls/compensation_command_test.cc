// Compensation of backlash and pitch error through its commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/axis_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

using Cells = std::vector<double>;

constexpr int kLongMax = 2147483647;
constexpr int kBacklashMax = 1073741824;

/// The values of GT_GetCompensate: pitch, cross, backlash, encoder, profile.
Cells Compensate(AxisCommandCard& card, int axis = 1) {
  Cells pitch(1, -1), cross(1, -1), backlash(1, -1), encoder(1, -1), profile(1, -1);
  EXPECT_EQ(card.Call("GT_GetCompensate", {axis, &pitch, &cross, &backlash, &encoder, &profile}),
            0);
  return {pitch[0], cross[0], backlash[0], encoder[0], profile[0]};
}

TEST(BacklashCommand, KeepsWhatWasSet) {
  AxisCommandCard card;
  Cells value(1), change(1), direction(1);
  EXPECT_EQ(card.Call("GT_GetBacklash", {2, &value, &change, &direction}), 0);
  EXPECT_EQ((Cells{value[0], change[0], direction[0]}), (Cells{0, 0, 0}));
  EXPECT_EQ(card.Call("GT_SetBacklash", {2, 30, 1.5, 1}), 0);
  EXPECT_EQ(card.Call("GT_GetBacklash", {2, &value, &change, &direction}), 0);
  EXPECT_EQ((Cells{value[0], change[0], direction[0]}), (Cells{30, 1.5, 1}));
}

TEST(BacklashCommand, ChecksItsParameters) {
  AxisCommandCard card;
  const struct {
    int axis, value;
    double change;
    int direction, code;
  } cases[] = {
      {1, 0, 0, 0, 0},      {8, kBacklashMax, double{kBacklashMax}, 1, 0},
      {0, 1, 1, 0, 7},      {9, 1, 1, 0, 7},
      {1, -1, 1, 0, 7},     {1, kBacklashMax + 1, 1, 0, 7},
      {1, 1, -0.001, 0, 7}, {1, 1, kBacklashMax + 1.0, 0, 7},
      {1, 1, 1, -1, 7},     {1, 1, 1, 2, 7},
  };
  for (const auto& c : cases) {
    card.Expect(static_cast<int16_t>(c.code), "GT_SetBacklash",
                {c.axis, c.value, c.change, c.direction});
  }
}

TEST(BacklashCommand, MovesTheMachineAndNotTheProfile) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  EXPECT_EQ(card.Call("GT_SetBacklash", {1, 30, 0, 1}), 0);
  card.MoveTo(1, 100, 5);
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetPrfPos"), 100);
  EXPECT_EQ(card.Read("GT_GetAxisPrfPos"), 100);
  EXPECT_EQ(card.Read("GT_GetEncPos"), 130);
  EXPECT_EQ(Compensate(card), (Cells{0, 0, 30, 130, 100}));
  card.MoveTo(1, 50, 5);
  card.CyclesToRest();
  EXPECT_EQ(card.Read("GT_GetEncPos"), 50);
  EXPECT_EQ(Compensate(card), (Cells{0, 0, 0, 50, 50}));
}

TEST(BacklashCommand, DoesNotKeepAnAxisOutOfItsBand) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  EXPECT_EQ(card.Call("GT_SetAxisBand", {1, 5, 4}), 0);
  EXPECT_EQ(card.Call("GT_SetBacklash", {1, 30, 0, 1}), 0);
  card.MoveTo(1, 100, 5);
  card.CyclesToRest();
  card.Cycles(5);
  EXPECT_NE(card.Status() & kInPosition, 0);
}

TEST(LeadScrewCommand, CorrectsByPositionAndDirection) {
  AxisCommandCard card;
  EXPECT_EQ(card.Call("GT_AxisOn", {1}), 0);
  Cells positive = {0, 8, 12};
  Cells negative = {-3, -5, -9};
  EXPECT_EQ(card.Call("GT_SetLeadScrewComp", {1, 3, 100, 200, &positive, &negative}), 0);
  card.MoveTo(1, 150, 5);
  card.CyclesToRest();
  EXPECT_EQ(Compensate(card), (Cells{0, 0, 0, 150, 150}));
  EXPECT_EQ(card.Call("GT_EnableLeadScrewComp", {1, 1}), 0);
  card.MoveTo(1, 250, 5);
  card.CyclesToRest();
  // Half-way between the points at 200 and 300.
  EXPECT_EQ(Compensate(card), (Cells{10, 0, 0, 260, 250}));
  card.MoveTo(1, 150, 5);
  card.CyclesToRest();
  EXPECT_EQ(Compensate(card), (Cells{-4, 0, 0, 146, 150}));
  card.MoveTo(1, 50, 5);
  card.CyclesToRest();
  EXPECT_EQ(Compensate(card), (Cells{0, 0, 0, 50, 50}));
  card.MoveTo(1, 200, 5);
  card.CyclesToRest();
  EXPECT_EQ(Compensate(card)[0], 8);
  EXPECT_EQ(card.Call("GT_EnableLeadScrewComp", {1, 0}), 0);
  card.Cycle();
  EXPECT_EQ(Compensate(card), (Cells{0, 0, 0, 200, 200}));
}

TEST(LeadScrewCommand, ChecksItsParameters) {
  AxisCommandCard card;
  const struct {
    int axis, count, start, length, code;
  } cases[] = {
      {1, 2, 1, 1, 0}, {8, 256, kLongMax, kLongMax, 0},
      {0, 2, 1, 1, 7}, {9, 2, 1, 1, 7},
      {1, 1, 1, 1, 7}, {1, 257, 1, 1, 7},
      {1, 2, 0, 1, 7}, {1, 2, -1, 1, 7},
      {1, 2, 1, 0, 7}, {1, 2, 1, -5, 7},
  };
  for (const auto& c : cases) {
    Cells points(static_cast<size_t>(c.count));
    card.Expect(static_cast<int16_t>(c.code), "GT_SetLeadScrewComp",
                {c.axis, c.count, c.start, c.length, &points, &points});
  }
  Cells points(2);
  card.Expect(7, "GT_SetLeadScrewComp", {1, 2, 1, 1, nullptr, &points});
  card.Expect(7, "GT_SetLeadScrewComp", {1, 2, 1, 1, &points, nullptr});
}

TEST(LeadScrewCommand, NeedsATableToBeEnabled) {
  AxisCommandCard card;
  card.Expect(1, "GT_EnableLeadScrewComp", {1, 1});
  card.Expect(0, "GT_EnableLeadScrewComp", {1, 0});
  card.Expect(7, "GT_EnableLeadScrewComp", {1, -1});
  card.Expect(7, "GT_EnableLeadScrewComp", {1, 2});
  Cells points(2);
  card.Expect(0, "GT_SetLeadScrewComp", {1, 2, 1, 1, &points, &points});
  card.Expect(0, "GT_EnableLeadScrewComp", {1, 1});
  card.Expect(1, "GT_EnableLeadScrewComp", {2, 1});
}

}  // namespace
}  // namespace oncard::gtcalls::gts
