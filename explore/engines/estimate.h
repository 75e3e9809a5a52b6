// Estimates how many traces a program has before they are searched, from a few random descents in
// the tree of different executions, by Knuth's estimate of the size of a search tree (D. E. Knuth,
// "Estimating the efficiency of backtrack programs", 1975). Tested by
// tests/explore/estimate_test.cc.
#pragma once

#include <atomic>
#include <cstdint>

#include "explore/models/model.h"

namespace oncard::explore {

struct TraceEstimate {
  double traces = 0;  ///< unbiased; 0 if a descent did not end
  double error = 0;   ///< its standard error, from the spread of the descents
};

/// Executes `descents` descents from the model's current state, and leaves the model in that state.
/// The estimate is abandoned if a descent exceeds `depth` statements, or `stop` is set from another
/// thread.
TraceEstimate EstimateTraces(Model* model, int descents, uint64_t seed, int64_t depth,
                             const std::atomic<bool>* stop = nullptr);

}  // namespace oncard::explore
