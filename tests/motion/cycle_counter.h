// How many cycles a card passes in lanes.
#pragma once

#include <cstdint>

#include "motion/motion_core.h"

namespace oncard::motion {

/// Counts the cycles that kernels advance; there is one at a time.
class CycleCounter {
 public:
  CycleCounter() { cycles_ = 0; }

  void Count(MotionCore& core, LaneKernel kernel = LaneKernels().front().run) {
    kernel_ = kernel;
    core.UseKernel(Run);
  }
  int64_t cycles() const { return cycles_; }

 private:
  static int64_t Run(const LaneConstants& constants, LaneStates& states, int64_t cycles) {
    const int64_t done = kernel_(constants, states, cycles);
    cycles_ += done;
    return done;
  }

  static inline LaneKernel kernel_ = nullptr;
  static inline int64_t cycles_ = 0;
};

}  // namespace oncard::motion
