// Makes a failing schedule easier to read: fewer preemptions, then fewer steps.
// Deterministic. Tested by tests/explore/shrink_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "explore/problem.h"

namespace oncard::explore {

/// Preemptions of a schedule: changes of threads while the one before could have gone on.
int CountPreemptions(Model* model, const std::vector<uint8_t>& steps);

/// A schedule that still leads to a fault, with as few preemptions as merging a thread's turns one
/// by one can reach. `steps` leads to a fault. Where the state graph is known, FewestPreemptions()
/// (state_graph.h) is exact instead.
std::vector<uint8_t> Shrink(const Problem& problem, const std::vector<uint8_t>& steps);

}  // namespace oncard::explore
