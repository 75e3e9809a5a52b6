#include "runtime/observe/row_log.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace oncard::runtime {
namespace {

// A row as text, so that a difference can be read: `250: 1 2`, `250 inside: 1 2`.
std::vector<std::string> RowsOf(RowLog::Reader reader) {
  std::vector<std::string> rows;
  while (reader.Next()) {
    std::string text = std::to_string(reader.row().time_us);
    text += reader.row().inside_cycle ? " inside:" : ":";
    for (const double value : reader.row().values) {
      text += ' ' + std::to_string(static_cast<int>(value));
    }
    rows.push_back(text);
  }
  return rows;
}

std::vector<std::string> RowsOf(const RowLog& log) { return RowsOf(RowLog::Reader(log)); }

using Rows = std::vector<std::string>;

void Add(RowLog* log, int64_t time_us, const std::vector<double>& values) {
  log->Add(time_us, values);
}

TEST(RowLog, IsEmptyAtFirst) {
  const RowLog log(2);
  EXPECT_TRUE(log.empty());
  EXPECT_EQ(RowsOf(log), Rows{});
}

TEST(RowLog, GivesBackItsRowsInOrder) {
  RowLog log(2);
  Add(&log, 0, {1, 5});
  EXPECT_EQ(RowsOf(log), Rows{"0: 1 5"});
  Add(&log, 250, {2, 5});
  Add(&log, 500, {2, 6});
  Add(&log, 10'000, {2, 5});
  EXPECT_EQ(RowsOf(log), (Rows{"0: 1 5", "250: 2 5", "500: 2 6", "10000: 2 5"}));
}

TEST(RowLog, RepeatsTheLastRowInsideACycle) {
  RowLog log(2);
  Add(&log, 250, {1, 5});
  log.Repeat(300, true);
  log.SetLast(1, 6);
  log.Repeat(500, false);
  EXPECT_EQ(RowsOf(log), (Rows{"250: 1 5", "300 inside: 1 6", "500: 1 6"}));
}

TEST(RowLog, KnowsItsFirstAndItsLastRow) {
  RowLog log(1);
  Add(&log, 250, {1});
  log.SetLast(0, 2);
  EXPECT_EQ(log.front().values, std::vector{2.0}) << "the first row may still change";
  Add(&log, 500, {3});
  Add(&log, 750, {4});
  EXPECT_EQ(log.front().time_us, 250);
  EXPECT_EQ(log.front().values, std::vector{2.0});
  EXPECT_EQ(log.last().time_us, 750);
  EXPECT_EQ(log.last().values, std::vector{4.0});
}

TEST(RowLog, KnowsTheRangeOfAColumn) {
  RowLog log(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Add(&log, 0, {1, 1, nan});
  EXPECT_EQ(log.RangeOf(0).greatest, 1);
  Add(&log, 1, {7, nan, 1});
  Add(&log, 2, {-3, 2, 1});
  EXPECT_EQ(log.RangeOf(0).least, -3) << "of the last row, too";
  Add(&log, 3, {0, 0, 1});
  EXPECT_EQ(log.RangeOf(0).least, -3);
  EXPECT_EQ(log.RangeOf(0).greatest, 7);
  EXPECT_EQ(log.RangeOf(1).least, 0) << "without NaNs";
  EXPECT_EQ(log.RangeOf(1).greatest, 2);
  EXPECT_TRUE(std::isnan(log.RangeOf(2).least)) << "there is nothing to compare with";
}

TEST(RowLog, KeepsTheSignOfAZero) {
  RowLog log(1);
  Add(&log, 0, {0.0});
  Add(&log, 1, {-0.0});
  Add(&log, 2, {0.0});
  RowLog::Reader reader(log);
  for (const bool negative : {false, true, false}) {
    ASSERT_TRUE(reader.Next());
    EXPECT_EQ(std::signbit(reader.row().values[0]), negative);
  }
}

TEST(RowLog, ReadsSomeColumnsInAnyOrder) {
  RowLog log(3);
  Add(&log, 0, {1, 2, 3});
  Add(&log, 1, {1, 5, 6});
  EXPECT_EQ(RowsOf(RowLog::Reader(log, {2, 0})), (Rows{"0: 3 1", "1: 6 1"}));
}

TEST(RowLog, KeepsRowsThatDifferInTheKeptColumns) {
  RowLog log(3);
  Add(&log, 0, {1, 2, 3});
  Add(&log, 1, {1, 9, 3});
  log.Repeat(2, true);
  log.SetLast(2, 4);
  Add(&log, 3, {1, 7, 4});
  log.Keep({0, 2});
  EXPECT_EQ(RowsOf(log), (Rows{"0: 1 3", "2 inside: 1 4", "3: 1 4"})) << "the last one remains";
  Add(&log, 4, {2, 4});
  EXPECT_EQ(RowsOf(log).back(), "4: 2 4");
  EXPECT_EQ(log.RangeOf(0).greatest, 2);
}

TEST(RowLog, KeepsEveryRowWhenAllDiffer) {
  RowLog log(3);
  Add(&log, 0, {1, 2, 3});
  Add(&log, 1, {1, 9, 4});
  Add(&log, 2, {1, 9, 5});
  log.Keep({2});
  EXPECT_EQ(RowsOf(log), (Rows{"0: 3", "1: 4", "2: 5"}));
  EXPECT_EQ(log.RangeOf(0).least, 3);
  Add(&log, 3, {6});
  EXPECT_EQ(RowsOf(log).back(), "3: 6");
  EXPECT_EQ(log.front().values, std::vector{3.0});
}

TEST(RowLog, KeepsOneRowOfTheLastInstant) {
  RowLog log(2);
  Add(&log, 0, {1, 2});
  Add(&log, 1, {2, 2});
  Add(&log, 1, {2, 3});
  log.Keep({0});
  EXPECT_EQ(RowsOf(log), (Rows{"0: 1", "1: 2"}));
  log.Repeat(2, false);
  log.Keep({0});
  EXPECT_EQ(RowsOf(log), (Rows{"0: 1", "1: 2", "2: 2"}));
}

TEST(RowLog, KeepsColumnsOfNoRowAndOfOne) {
  RowLog log(2);
  log.Keep({1});
  Add(&log, 0, {7});
  EXPECT_EQ(RowsOf(log), Rows{"0: 7"});
  log.Keep({});
  EXPECT_EQ(RowsOf(log), Rows{"0:"});
}

// Eight axes that always move, for 100 s: with their parabolas and lines, jerks from one to the
// next, and what rounding adds to both.
TEST(RowLog, TakesAFewBytesForEveryValueOfMovingAxes) {
  constexpr size_t kAxes = 8;
  constexpr int kRows = 100'000;
  RowLog log(2 * kAxes);
  std::vector<double> values(2 * kAxes);
  for (int row = 0; row < kRows; ++row) {
    for (size_t axis = 0; axis < kAxes; ++axis) {
      double& position = values[2 * axis];
      double& velocity = values[2 * axis + 1];
      const double acceleration = row / 100 % 2 == 0 ? 0.1 : -0.1;
      position += velocity + acceleration / 2;
      velocity += acceleration;
    }
    log.Add(row * int64_t{1000}, values);
  }
  EXPECT_LE(log.bytes(), kRows * 2 * kAxes * 4);
}

}  // namespace
}  // namespace oncard::runtime
