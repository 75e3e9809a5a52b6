// A core with a coordinate system that uses the first profiles, for tests of paths.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

namespace oncard::motion {

class CrdRunTest {
 public:
  explicit CrdRunTest(int64_t cycle_us = 1000, int dimension = 2, int16_t even_time = 0)
      : core({.axis_count = 8, .cycle_us = cycle_us}) {
    CrdParameters parameters;
    parameters.dimension = static_cast<int16_t>(dimension);
    for (int i = 0; i < dimension; ++i) {
      parameters.coordinates[static_cast<size_t>(i)] = static_cast<int16_t>(i + 1);
    }
    parameters.velocity_max = 1000;
    parameters.acceleration_max = 100;
    parameters.even_time = even_time;
    core.CrdAt(0).SetUp(parameters);
  }

  Crd& crd() { return ChangeState(core).crds[0]; }
  CrdFifo& fifo(size_t index = 0) { return crd().fifos[index]; }
  const Sample& profile(size_t index) { return core.state().profiles[index].now; }

  bool Line(const Coordinates& end, double velocity, double acceleration, double end_velocity = 0,
            size_t to = 0) {
    PathSlot slot;
    slot.is_segment = true;
    slot.segment = *MakeLine(fifo(to).idle() ? core.CrdPosition(0) : fifo(to).tail, end);
    slot.velocity = velocity;
    slot.acceleration = acceleration;
    slot.end_velocity = end_velocity;
    return core.CrdAt(0).Append(to, slot);
  }
  bool Command(const BufferedCommand& command, size_t to = 0) {
    PathSlot slot;
    slot.command = command;
    return core.CrdAt(0).Append(to, slot);
  }
  bool Delay(double ms) { return Command({BufferedKind::kDelay, 0, 0, {ms}}); }
  void Start(size_t from = 0) { core.CrdAt(0).Start(from, false); }
  bool running() { return crd().run.running; }
  /// Ticks until `ms` after power-on.
  void RunUntil(double ms) {
    while (static_cast<double>(core.now()) / 1000 < ms - 1e-9) core.Tick();
  }
  /// The number of ticks until the run ends, at most ten million.
  int TicksToEnd() {
    int ticks = 0;
    for (; running() && ticks < 10'000'000; ++ticks) core.Tick();
    return ticks;
  }

  MotionCore core;
};

}  // namespace oncard::motion
