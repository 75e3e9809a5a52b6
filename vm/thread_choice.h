// The next thread out of those that can run: what the policies of a run (scheduler.h) and the
// explorer's random schedules have in common. Sets of threads have a bit for each of them and are
// never empty.
// Tested by tests/vm/scheduler_test.cc and tests/explore/sampler_test.cc.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/random.h"

namespace oncard::vm {

/// Maximum depth of probabilistic concurrency testing.
inline constexpr int kPctDepthMax = 64;

/// A thread drawn uniformly.
inline int RandomThread(uint64_t& random, uint32_t runnable) {
  uint64_t skip = RandomBelow(random, static_cast<uint64_t>(std::popcount(runnable)));
  while (skip-- > 0) runnable &= runnable - 1;
  return std::countr_zero(runnable);
}

/// The thread with the largest priority, the first of equal ones.
template <typename Priority, size_t count>
int HighestThread(uint32_t runnable, const std::array<Priority, count>& priorities) {
  int highest = std::countr_zero(runnable);
  for (uint32_t rest = runnable & (runnable - 1); rest != 0; rest &= rest - 1) {
    const int thread = std::countr_zero(rest);
    if (priorities[static_cast<size_t>(thread)] > priorities[static_cast<size_t>(highest)]) {
      highest = thread;
    }
  }
  return highest;
}

}  // namespace oncard::vm
