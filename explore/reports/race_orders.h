// The results of the two orders of a data race. Deterministic. Tested by
// tests/explore/failure_test.cc.
#pragma once

#include <vector>

#include "explore/engines/failure.h"
#include "explore/reports/trail.h"

namespace oncard::explore {

/// Executes the two statements of a data race in both orders, each time followed by the rest of the
/// threads one after the other, of which at most 500 statements are noted. The order of the failing
/// run comes first. Empty if there is no data race, or if the other order is not possible.
std::vector<RaceOrder> BothOrders(const Problem& problem, const Failure& failure);

}  // namespace oncard::explore
