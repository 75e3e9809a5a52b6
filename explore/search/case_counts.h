// Joins the explorations of several cases of one scenario, so that they are reported as one. Plain
// values. Tested by tests/explore/case_exploration_test.cc.
#pragma once

#include "explore/search/explorer.h"

namespace oncard::explore {

/// Adds the exploration of one more case: sums of the counts, the weakest verdict, and the failure
/// that was found first. Both are of the same engine and the same program; `why` is that of the
/// weakest verdict.
void AddCase(Exploration next, Exploration* all);

/// What a search has used up of ExploreOptions::execution_limit and ExploreOptions::state_limit.
/// Executions that were counted without being executed are none.
int64_t ExecutionsUsed(const Exploration& exploration);
int64_t StatesUsed(const Exploration& exploration);

}  // namespace oncard::explore
