// Paths of segments for tests of the path planner, in mm and s.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "motion/paths/crd.h"
#include "tests/motion/path_reference.h"

namespace oncard::motion {

class PlannedPath {
 public:
  PathLimits limits;
  double velocity = 100;
  double acceleration = 500;
  std::vector<PathSlot> slots;

  PlannedPath& Line(const Coordinates& end) {
    Add(*MakeLine(at_, end));
    return *this;
  }
  PlannedPath& Arc(const Coordinates& end, double first, double second, bool counter_clockwise,
                   ArcPlane plane = kXyPlane) {
    Add(*MakeArcAroundCentre(at_, end, plane, first, second, counter_clockwise));
    return *this;
  }
  /// The last segment ends at rest.
  PlannedPath& Rest() {
    slots.back().ends_at_rest = true;
    return *this;
  }
  const Coordinates& end() const { return at_; }

  /// What leaves a window of `capacity` segments, in order.
  std::vector<PathSlot> Planned(size_t capacity) const {
    CrdFifo fifo;
    fifo.planner.Emplace({.limits = limits, .capacity = capacity});
    std::vector<PathSlot> planned;
    const auto drain = [&] {
      for (; !fifo.slots.empty(); fifo.slots.Pop()) planned.push_back(fifo.slots.front());
    };
    for (const PathSlot& slot : slots) {
      EXPECT_TRUE(fifo.Append(slot));
      EXPECT_LE(fifo.planner->spans.size(), capacity);
      drain();
    }
    EXPECT_TRUE(fifo.Flush());
    drain();
    return planned;
  }
  /// The time of the path through a window.
  double Time(size_t capacity) const {
    CrdFifo fifo;
    fifo.planner.Emplace({.limits = limits, .capacity = capacity});
    fifo.planner->virtual_run.on = true;
    for (const PathSlot& slot : slots) EXPECT_TRUE(fifo.Append(slot));
    EXPECT_TRUE(fifo.Flush());
    return fifo.planner->virtual_run.time;
  }
  double ShortestTime(double grid) const {
    return ReferencePath{limits, slots, grid}.ShortestTime();
  }

 private:
  void Add(Segment segment) {
    MeasureLength(limits.length_axes, &segment);
    PathSlot slot;
    slot.is_segment = true;
    slot.segment = segment;
    slot.velocity = velocity;
    slot.acceleration = acceleration;
    slots.push_back(slot);
    at_ = segment.end;
  }

  Coordinates at_{};
};

/// Numbers for random paths.
class RandomNumbers {
 public:
  explicit RandomNumbers(uint32_t seed) : engine_(seed) {}
  double Between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }

 private:
  std::mt19937 engine_;
};

}  // namespace oncard::motion
