// Look-ahead: corners, curves, chains of segments, and the resulting runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/common/state_hash.h"
#include "motion/paths/path_planner.h"
#include "tests/motion/crd_run.h"

namespace oncard::motion {
namespace {

TEST(CornerSpeed, IsLimitedByTheChangeOfDirection) {
  // accMax * T / (2 sin(angle / 2)) with T 5 and accMax 1.
  struct {
    double degrees, velocity;
  } const cases[] = {{180, 2.5}, {90, 3.535534}, {60, 5}, {36.8698976458440, 7.905694}};
  for (const auto& c : cases) {
    const double angle = c.degrees * M_PI / 180;
    EXPECT_NEAR(CornerSpeed(kAllCoordinates, {1, 0}, {std::cos(angle), std::sin(angle)}, 1, 5),
                c.velocity, 1e-6);
  }
  EXPECT_EQ(CornerSpeed(kAllCoordinates, {1, 0}, {1, 0}, 1, 5), kUnlimited);
  // A coordinate that does not count.
  EXPECT_EQ(CornerSpeed(1, {1, 0}, {1, 1}, 1, 5), kUnlimited);
}

// Two buffers with the same remaining contents are equal, whatever was removed before.
TEST(SlotQueue, IsNamedByWhatItHolds) {
  const auto slot = [](int32_t number) {
    PathSlot made;
    made.user_number = number;
    return made;
  };
  SlotQueue taken;
  for (int32_t i = 0; i < 5; ++i) taken.Push(slot(i));
  taken.Pop();
  taken.Pop();
  SlotQueue fresh;
  for (int32_t i = 2; i < 5; ++i) fresh.Push(slot(i));
  EXPECT_EQ(StateHash().Add(taken).value(), StateHash().Add(fresh).value());
  fresh.Pop();
  EXPECT_NE(StateHash().Add(taken).value(), StateHash().Add(fresh).value());
}

PathPlanner Window(size_t capacity, double time, double acceleration) {
  PathLimits limits;
  limits.rule = {JointRule::kCorners, acceleration};
  limits.corner_time = time;
  return {.limits = limits, .capacity = capacity};
}

TEST(LookAhead, MatchesABackwardPassOverTheWholeWindow) {
  PathPlanner window = Window(20, 5, 1);
  std::vector<PathSlot> slots;
  Coordinates at{};
  for (int i = 0; i < 200; ++i) {
    Coordinates next = at;
    next[0] += 1 + (i * 7) % 13;
    next[1] += (i * 5) % 11 - 5;
    PathSlot slot;
    slot.is_segment = true;
    slot.segment = *MakeLine(at, next);
    slot.velocity = 5 + i % 4;
    slot.acceleration = 0.25;
    slots.push_back(slot);
    at = next;
  }
  double speed = 0;
  size_t taken = 0;
  const auto check = [&](size_t last) {
    // Calculated backwards from rest at the window's end.
    double square = 0;
    for (size_t i = last; i > taken; --i) {
      const double corner = CornerSpeed(kAllCoordinates, slots[i - 1].segment.TangentAt(0),
                                        slots[i].segment.TangentAt(0), 1, 5);
      const double junction = std::min({corner, slots[i - 1].velocity, slots[i].velocity});
      square = std::min(junction * junction, square + 0.5 * slots[i].segment.length);
    }
    speed = std::sqrt(std::min(square, speed * speed + 0.5 * slots[taken].segment.length));
    const PathSlot slot = window.Take(false);
    EXPECT_EQ(slot.segment.end, slots[taken].segment.end);
    EXPECT_NEAR(slot.end_velocity, speed, 1e-12) << taken;
    ++taken;
  };
  for (size_t i = 0; i < slots.size(); ++i) {
    if (window.Held() == 20) check(i - 1);
    window.Push(slots[i]);
  }
  while (!window.ring.empty()) check(slots.size() - 1);
  EXPECT_EQ(speed, 0);
}

void TurnOn(CrdRunTest* test, size_t capacity, double time, double acceleration) {
  test->fifo().planner.Emplace(Window(capacity, time, acceleration));
}

TEST(LookAhead, TheRingHoldsNAndPassesTheOldestOn) {
  // Example 2.1 in pulses: 300 lines, a look-ahead of 200; total 743.82 mm.
  CrdRunTest test;
  TurnOn(&test, 200, 100, 0.8);
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(test.Line({8000.0 + 1600 * i, 9000.0 + 1852 * i}, 100, 0.8));
  }
  EXPECT_EQ(test.fifo().slots.size(), 100u);
  EXPECT_EQ(test.fifo().planner->ring.size(), 200u);
  EXPECT_TRUE(test.fifo().Flush());
  EXPECT_EQ(test.fifo().slots.size(), 300u);
  test.Start();
  const int ticks = test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 486400);
  EXPECT_EQ(test.profile(1).position, 562748);
  // A single trapezoid: 125 ms acceleration and deceleration; the corner of 0.81 degrees does not
  // limit it.
  const double length =
      std::sqrt(8000.0 * 8000 + 9000.0 * 9000) + 299 * std::sqrt(1600.0 * 1600 + 1852.0 * 1852);
  EXPECT_NEAR(length, 743820, 30);
  EXPECT_EQ(ticks, std::ceil(length / 100 + 125));
}

TEST(LookAhead, AFullFifoRefusesAndNothingIsLost) {
  CrdRunTest test;
  TurnOn(&test, 10, 5, 1);
  for (int i = 1; i <= 4106; ++i) ASSERT_TRUE(test.Line({1.0 * i, 0}, 10, 1)) << i;
  EXPECT_FALSE(test.Line({5000, 0}, 10, 1));
  EXPECT_EQ(test.fifo().tail[0], 4106);
  EXPECT_FALSE(test.fifo().Flush());
  test.Start();
  test.core.Tick();
  while (!test.fifo().Flush()) test.core.Tick();
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 4106);
}

TEST(LookAhead, ADelayForcesRest) {
  CrdRunTest test;
  TurnOn(&test, 10, 5, 1);
  ASSERT_TRUE(test.Line({100, 0}, 10, 1));
  ASSERT_TRUE(test.Delay(50));
  ASSERT_TRUE(test.Line({200, 0}, 10, 1));
  EXPECT_TRUE(test.fifo().Flush());
  EXPECT_EQ(test.fifo().slots.At(0).end_velocity, 0);
}

TEST(LookAhead, ShortSegmentsKeepTheirBoundsAtEveryAngle) {
  // Segments of one pulse that turn by 0 to 180 degrees: path velocity, acceleration and position
  // are checked in every cycle.
  CrdRunTest test(250);
  constexpr double kTime = 5;
  constexpr double kAccMax = 1;
  TurnOn(&test, 200, kTime, kAccMax);
  constexpr int kCount = 10000;
  double heading = 0;
  Coordinates at{};
  int sent = 0;
  const auto feed = [&] {
    for (; sent < kCount; ++sent) {
      const double turn = (sent % 181) * M_PI / 180 * (sent % 2 == 0 ? 1 : -1);
      const double next = sent % 7 == 0 ? heading + turn : heading;
      const Coordinates end = {at[0] + std::cos(next), at[1] + std::sin(next)};
      if (!test.Line(end, 8, 0.5)) return;
      heading = next;
      at = end;
    }
  };
  feed();
  test.Start();
  double speed = 0;
  Coordinates last{};
  bool flushed = false;
  int ticks = 0;
  while (test.running() && ticks < 1'000'000) {
    feed();
    if (sent == kCount && !flushed) flushed = test.fifo().Flush();
    test.core.Tick();
    ++ticks;
    const double now = test.crd().run.velocity;
    ASSERT_LE(now, 8 + 1e-9);
    ASSERT_LE(std::fabs(now - speed), 0.5 * 0.25 + 1e-9);
    const Coordinates position = test.core.CrdPosition(0);
    const double step = std::hypot(position[0] - last[0], position[1] - last[1]);
    ASSERT_LE(step, (std::max(now, speed) + 0.5 * 0.25) * 0.25 + 1e-9);
    speed = now;
    last = position;
  }
  EXPECT_EQ(test.fifo().done, kCount);
  EXPECT_NEAR(last[0], at[0], 1e-9);
}

TEST(LookAhead, ALongPathNeedsNoMoreMemoryThanTheBuffers) {
  CrdRunTest test(1000);
  TurnOn(&test, 500, 5, 1);
  constexpr int kCount = 50000;
  int sent = 0;
  const auto feed = [&] {
    while (sent < kCount && test.Line({sent + 1.0, (sent + 1) % 2 * 0.1}, 100, 1)) ++sent;
  };
  feed();
  test.Start();
  bool flushed = false;
  while (test.running()) {
    feed();
    if (sent == kCount && !flushed) flushed = test.fifo().Flush();
    test.core.Tick();
    ASSERT_LE(test.fifo().slots.slots.size(), 2 * kCrdFifoSize);
    ASSERT_LE(test.fifo().planner->ring.slots.size(), 1002u);
  }
  EXPECT_EQ(test.fifo().done, kCount);
}

}  // namespace
}  // namespace oncard::motion
