// Positions of a motor: switches and index marks. The expected numbers follow from the intervals.
#include "motion/mechanics/switches_and_marks.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace oncard::motion {
namespace {

std::vector<double> MarksBetween(const IndexMarks& marks, double from, double to) {
  std::vector<double> passed;
  ForEachMark(marks, from, to, [&](double position) {
    passed.push_back(position);
    return true;
  });
  return passed;
}

PositionSwitch SwitchBetween(double first, double last) {
  PositionSwitch contact;
  contact.first = first;
  contact.last = last;
  return contact;
}

TEST(PositionSwitch, IsClosedOnItsBoundsAndBetweenThem) {
  const PositionSwitch contact = SwitchBetween(-10, 20);
  EXPECT_FALSE(contact.Level(-10.5));
  EXPECT_TRUE(contact.Level(-10));
  EXPECT_TRUE(contact.Level(20));
  EXPECT_FALSE(contact.Level(20.5));
}

TEST(PositionSwitch, ActiveLowInvertsAndACutWireIsInactive) {
  PositionSwitch contact = SwitchBetween(0, 10);
  contact.active_low = true;
  EXPECT_FALSE(contact.Level(5));
  EXPECT_TRUE(contact.Level(11));
  contact.connected = false;
  EXPECT_TRUE(contact.Level(5));
  contact.active_low = false;
  EXPECT_FALSE(contact.Level(5));
}

TEST(PassSwitch, EntersAtTheNearBoundAndLeavesAtTheFarOne) {
  const PositionSwitch contact = SwitchBetween(10, 20);
  const SwitchPassage up = PassSwitch(contact, 0, 30);
  EXPECT_TRUE(up.enters && up.leaves);
  EXPECT_EQ(up.entry, 10);
  EXPECT_EQ(up.exit, 20);
  const SwitchPassage down = PassSwitch(contact, 30, 0);
  EXPECT_TRUE(down.enters && down.leaves);
  EXPECT_EQ(down.entry, 20);
  EXPECT_EQ(down.exit, 10);
}

TEST(PassSwitch, CountsABoundOnce) {
  const PositionSwitch contact = SwitchBetween(10, 20);
  EXPECT_TRUE(PassSwitch(contact, 0, 10).enters);
  EXPECT_FALSE(PassSwitch(contact, 10, 15).enters);
  EXPECT_FALSE(PassSwitch(contact, 15, 20).leaves);
  EXPECT_TRUE(PassSwitch(contact, 20, 21).leaves);
  EXPECT_FALSE(PassSwitch(contact, 15, 15).enters);
}

TEST(PassSwitch, AnInfiniteBoundIsNeverPassed) {
  const PositionSwitch limit = SwitchBetween(100, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(PassSwitch(limit, 0, 1e9).enters);
  EXPECT_FALSE(PassSwitch(limit, 0, 1e9).leaves);
  EXPECT_FALSE(PassSwitch(limit, 1e9, 0).enters);
  EXPECT_TRUE(PassSwitch(limit, 1e9, 0).leaves);
}

TEST(ForEachMark, VisitsInOrderWithoutTheFirstPlaceAndWithTheLast) {
  const IndexMarks marks{.offset = 30, .period = 100};
  EXPECT_EQ(MarksBetween(marks, -70, 130), (std::vector<double>{30, 130}));
  EXPECT_EQ(MarksBetween(marks, 130, -70), (std::vector<double>{30, -70}));
  EXPECT_TRUE(MarksBetween(marks, 31, 129).empty());
  EXPECT_TRUE(MarksBetween(marks, 30, 30).empty());
}

TEST(ForEachMark, AnEncoderWithoutIndexHasNoMarks) {
  EXPECT_TRUE(MarksBetween({.offset = 0, .period = 0}, -1e6, 1e6).empty());
}

TEST(ForEachMark, StopsWhenTheVisitorSaysSo) {
  int visits = 0;
  ForEachMark({.offset = 0, .period = 1}, 0, 100, [&](double) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

}  // namespace
}  // namespace oncard::motion
