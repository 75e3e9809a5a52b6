// How many traces a program has, before they are searched: from a few random descents in the tree
// of executions that differ, as Knuth estimates the size of a search tree (D. E. Knuth, "Estimating
// the efficiency of backtrack programs", 1975).
// Tested by tests/explore/estimate_test.cc.
#pragma once

#include <cstdint>

#include "explore/models/model.h"

namespace oncard::explore {

struct TraceEstimate {
  double traces = 0;  ///< unbiased; 0 when a descent did not end
  double error = 0;   ///< standard error of it, from the spread of the descents
};

/// Executes `descents` times, from the model's present state, and leaves it there. A descent is
/// given up, and with it the estimate, after `depth` statements.
TraceEstimate EstimateTraces(Model* model, int descents, uint64_t seed, int64_t depth);

}  // namespace oncard::explore
